# What all three ways to build share.

macro(delaunay_refinement_project_defaults)
  set(CMAKE_CXX_STANDARD 17)
  set(CMAKE_CXX_STANDARD_REQUIRED ON)
  set(CMAKE_CXX_EXTENSIONS OFF)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  option(BUILD_SHARED_LIBS "Build shared libraries" OFF)
  # First of all, as packages found later have a default of their own for it.
  option(BUILD_TESTING "Build the tests" ON)

  get_property(_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  if(NOT CMAKE_BUILD_TYPE AND NOT _multi_config)
    # Release comes with -O3 and NDEBUG, which CGAL's own checks heed.
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
  endif()

  find_program(CCACHE_PROGRAM ccache)
  mark_as_advanced(CCACHE_PROGRAM)
  if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_C_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
  endif()
endmacro()

macro(delaunay_refinement_find_third_party)
  set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
  find_package(CGAL 5.5 REQUIRED)
  find_package(
    VTK
    9.1
    REQUIRED
    COMPONENTS
      CommonCore
      CommonDataModel
      IOLegacy
      IOXML
  )
endmacro()

# Warnings for a target of ours; never PUBLIC, users choose their own.
function(delaunay_refinement_warnings target)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(
      ${target}
      PRIVATE
        -Wall
        -Wextra
    )
    if(DelaunayRefinement_WARNINGS_AS_ERRORS)
      # GCC 12 sees ghosts in inlined containers at -O3: a warning, no error.
      target_compile_options(
        ${target}
        PRIVATE
          -Werror
          -Wno-error=array-bounds
      )
    endif()
  elseif(MSVC AND DelaunayRefinement_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE /WX)
  endif()
endfunction()

# The programs of examples/ need modules of ITK that an ITK of one's own may
# lack, so that they are built with these only when asked for.
macro(delaunay_refinement_add_examples default)
  option(
    DelaunayRefinement_BUILD_EXAMPLES
    "Build the programs in examples/, mesh-image among them"
    ${default}
  )
  if(DelaunayRefinement_BUILD_EXAMPLES)
    add_subdirectory(examples)
  endif()
endmacro()
