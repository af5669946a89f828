# What a build of the wheel does before it looks for ITK: sets ITK_DIR, and all
# that ITK's wrapping asks for. -D ITK_DIR=<build tree for wrapping> saves the
# build of ITK; else its source is the one that the environment variable
# ITK_SOURCE_DIR names, or fetched.

if(NOT Python3_EXECUTABLE)
  find_program(Python3_EXECUTABLE NAMES python3 REQUIRED)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/DelaunayRefinementWrappingTools.cmake)
delaunay_refinement_find_wrapping_tools()
foreach(_arg IN LISTS DelaunayRefinement_WRAPPING_TOOL_ARGS)
  if(_arg MATCHES "^-D([^=]+)=(.*)$")
    set(${CMAKE_MATCH_1} "${CMAKE_MATCH_2}" CACHE STRING "" FORCE)
  endif()
endforeach()

if(NOT ITK_DIR)
  if(DEFINED ENV{ITK_SOURCE_DIR})
    set(_itk_source "$ENV{ITK_SOURCE_DIR}")
  else()
    include(FetchContent)
    FetchContent_Declare(
      ITK
      GIT_REPOSITORY https://github.com/InsightSoftwareConsortium/ITK.git
      GIT_TAG v5.4.7
      GIT_SHALLOW ON
      # No CMakeLists.txt there: ITK is a build of its own.
      SOURCE_SUBDIR
      none
    )
    FetchContent_MakeAvailable(ITK)
    set(_itk_source "${itk_SOURCE_DIR}")
  endif()
  set(ITK_DIR "${CMAKE_BINARY_DIR}/itk-for-wrapping" CACHE PATH "" FORCE)
  execute_process(
    COMMAND
      ${CMAKE_COMMAND} -D ITK_SOURCE_DIR=${_itk_source} -D
      ITK_BUILD_DIR=${ITK_DIR} -D Python3_EXECUTABLE=${Python3_EXECUTABLE} -P
      ${CMAKE_CURRENT_LIST_DIR}/DelaunayRefinementBuildITK.cmake
    RESULT_VARIABLE _result
  )
  if(NOT _result EQUAL 0)
    message(FATAL_ERROR "ITK could not be built for wrapping")
  endif()
endif()

# The wheel holds what ITK installs as this component, and no more.
set(WRAP_ITK_INSTALL_COMPONENT_IDENTIFIER PythonWheel)
set(PY_SITE_PACKAGES_PATH . CACHE PATH "" FORCE)
set(BUILD_TESTING OFF)
set(DelaunayRefinement_BUILD_EXAMPLES OFF)

# Else ITK's build tree takes the module's library.
foreach(_kind ARCHIVE LIBRARY RUNTIME)
  set(CMAKE_${_kind}_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
endforeach()

# No path of this machine in the wheel.
set(
  CMAKE_CXX_FLAGS
  "${CMAKE_CXX_FLAGS} -ffile-prefix-map=${PROJECT_SOURCE_DIR}/="
)
