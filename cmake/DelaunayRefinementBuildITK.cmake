# Builds as much of ITK, for wrapping, as the wheel needs: of the modules below
# the wrapping's interface files, which is what CastXML and SWIG make, and the
# static libraries. None of ITK's own Python libraries is compiled; at run time
# they are those of PyPI's itk.
#
#   cmake -D ITK_SOURCE_DIR=<ITK's source> -D ITK_BUILD_DIR=<new or existing>
#     -P cmake/DelaunayRefinementBuildITK.cmake
#
# Optional: ITK_MODULES (more modules), ITK_TARGETS (more targets to build),
# ITK_CMAKE_ARGS (more arguments for ITK's configuration), JOBS, and
# Python3_EXECUTABLE: a Python that has the packages swig and castxml.
# FindPython3 knows the stable ABI from 3.26 on.
cmake_minimum_required(VERSION 3.26)

foreach(_needed ITK_SOURCE_DIR ITK_BUILD_DIR)
  if(NOT ${_needed})
    message(FATAL_ERROR "-D ${_needed}=... is missing")
  endif()
endforeach()
get_filename_component(ITK_BUILD_DIR "${ITK_BUILD_DIR}" ABSOLUTE)
if(NOT Python3_EXECUTABLE)
  find_program(Python3_EXECUTABLE NAMES python3 REQUIRED)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/DelaunayRefinementWrappingTools.cmake)
delaunay_refinement_find_wrapping_tools()

find_program(CCACHE_PROGRAM ccache)
set(_launcher_args)
if(CCACHE_PROGRAM)
  set(
    _launcher_args
    -DCMAKE_C_COMPILER_LAUNCHER=${CCACHE_PROGRAM}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${CCACHE_PROGRAM}
  )
  # Another place gives the same objects, if the source moves along.
  if(NOT DEFINED ENV{CCACHE_BASEDIR})
    set(ENV{CCACHE_BASEDIR} "${ITK_BUILD_DIR}")
  endif()
  set(ENV{CCACHE_NOHASHDIR} 1)
endif()

set(_module_args)
foreach(_module ITKMesh ITKImageFunction ITKTBB ${ITK_MODULES})
  list(APPEND _module_args -DModule_${_module}=ON)
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE _result)
  if(NOT _result EQUAL 0)
    list(
      GET
      ARGN
      0
      1
      _start
    )
    message(FATAL_ERROR "Failed with ${_result}: ${_start}")
  endif()
endfunction()

# TBB: PyPI's itk makes it the threader of every ITK in the process, and an ITK
# without it refuses. The types are those that PyPI's itk wraps.
run(
  ${CMAKE_COMMAND}
  -S ${ITK_SOURCE_DIR}
  -B ${ITK_BUILD_DIR}
  -G Ninja
  -DCMAKE_BUILD_TYPE=Release
  -DBUILD_SHARED_LIBS=OFF
  -DCMAKE_POSITION_INDEPENDENT_CODE=ON
  -DBUILD_TESTING=OFF
  -DBUILD_EXAMPLES=OFF
  -DITK_BUILD_DEFAULT_MODULES=OFF
  -DITKGroup_Core=OFF
  -DITK_WRAP_PYTHON=ON
  -DITK_USE_PYTHON_LIMITED_API=ON
  -DITK_WRAP_IMAGE_DIMS=3
  -DITK_WRAP_unsigned_short=ON
  -DITK_WRAP_double=ON
  -DITK_WRAP_DOC=OFF
  ${DelaunayRefinement_WRAPPING_TOOL_ARGS}
  ${_launcher_args}
  ${_module_args}
  ${ITK_CMAKE_ARGS}
)

if(NOT JOBS)
  cmake_host_system_information(RESULT JOBS QUERY NUMBER_OF_LOGICAL_CORES)
endif()
# Of the libraries only those that a module on these links to.
run(
  ninja
  -C ${ITK_BUILD_DIR}
  -j ${JOBS}
  ITKMeshSwig
  ITKImageFunctionSwig
  ITKMesh
  ITKStatistics
  ${ITK_TARGETS}
)
