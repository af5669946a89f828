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
if(DelaunayRefinement_BUILD_EXAMPLES)
  add_subdirectory(examples)
endif()
if(BUILD_TESTING)
  add_subdirectory(test)
endif()
