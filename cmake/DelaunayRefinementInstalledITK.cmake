# The build against an installed ITK, which ships no module macros.

include(GenerateExportHeader)
include(GNUInstallDirs)

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")

# As ITK's module macros do it, for all folders.
include_directories(
  ${PROJECT_SOURCE_DIR}/include
  ${PROJECT_BINARY_DIR}/include
)
include_directories(SYSTEM ${ITK_INCLUDE_DIRS})

add_subdirectory(src)

generate_export_header(
  DelaunayRefinement
  EXPORT_FILE_NAME "${PROJECT_BINARY_DIR}/include/DelaunayRefinementExport.h"
  EXPORT_MACRO_NAME DelaunayRefinement_EXPORT
  NO_EXPORT_MACRO_NAME DelaunayRefinement_HIDDEN
  STATIC_DEFINE DelaunayRefinement_STATIC
)
get_target_property(_type DelaunayRefinement TYPE)
if(_type STREQUAL "STATIC_LIBRARY")
  target_compile_definitions(
    DelaunayRefinement
    PUBLIC
      DelaunayRefinement_STATIC
  )
endif()

enable_testing()
set(DelaunayRefinement_IS_INSTALLABLE TRUE)
delaunay_refinement_add_examples(ON)
option(
  DelaunayRefinement_BUILD_BENCHMARK
  "Build the programs in benchmark/, which need all of CGAL"
  OFF
)
if(DelaunayRefinement_BUILD_BENCHMARK)
  add_subdirectory(benchmark)
endif()
if(BUILD_TESTING)
  add_subdirectory(test)
endif()

# For find_package(DelaunayRefinement).
include(CMakePackageConfigHelpers)
set(_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/DelaunayRefinement)
configure_package_config_file(
  cmake/DelaunayRefinementConfig.cmake.in
  ${PROJECT_BINARY_DIR}/DelaunayRefinementConfig.cmake
  INSTALL_DESTINATION ${_config_dir}
)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/DelaunayRefinementConfigVersion.cmake
  COMPATIBILITY SameMinorVersion
)
install(TARGETS DelaunayRefinement EXPORT DelaunayRefinementTargets)
install(
  EXPORT DelaunayRefinementTargets
  NAMESPACE DelaunayRefinement::
  DESTINATION ${_config_dir}
)
install(
  FILES
    ${PROJECT_BINARY_DIR}/DelaunayRefinementConfig.cmake
    ${PROJECT_BINARY_DIR}/DelaunayRefinementConfigVersion.cmake
  DESTINATION ${_config_dir}
)
install(
  DIRECTORY
    ${PROJECT_SOURCE_DIR}/include/
    ${PROJECT_BINARY_DIR}/include/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/DelaunayRefinement
  FILES_MATCHING
  PATTERN
  "*.h"
  PATTERN
  "*.hxx"
)
if(TARGET mesh-image)
  install(TARGETS mesh-image)
endif()
