# Keeps the layers apart (docs/architecture.md): fails if a file includes what
# its layer may not know. Run with -D SOURCE_DIR=<top of the sources> -P.

set(third_party "(CGAL|boost|gmp|mpfr|vtk)")
set(
  pipeline
  "itk(Image|Mesh|ProcessObject|DataObject|ObjectFactory|Interpolate)"
)
set(failures "")

# Fails every file that matches one of the globs in ARGN, but not EXCEPT, and
# includes a header that matches FORBIDDEN.
function(forbid_includes why forbidden except)
  file(GLOB files RELATIVE ${SOURCE_DIR} ${ARGN})
  if(except)
    list(FILTER files EXCLUDE REGEX "${except}")
  endif()
  if(NOT files)
    message(SEND_ERROR "${why}: no file was looked at")
  endif()
  foreach(file IN LISTS files)
    file(
      STRINGS
      ${SOURCE_DIR}/${file}
      lines
      REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]${forbidden}"
    )
    foreach(line IN LISTS lines)
      message(SEND_ERROR "${why}: ${file} has ${line}")
    endforeach()
  endforeach()
endfunction()

forbid_includes(
  "Public headers show no CGAL, Boost or VTK"
  "${third_party}"
  ""
  ${SOURCE_DIR}/include/*.h
  ${SOURCE_DIR}/include/*.hxx
)
forbid_includes(
  "The engine and what is under it know no image, no mesh and no pipeline"
  "(${pipeline}|vtk)"
  ""
  ${SOURCE_DIR}/src/itkDelaunayRefinement*.h
  ${SOURCE_DIR}/src/itkDelaunayRefinement*.cxx
  ${SOURCE_DIR}/include/itkDelaunayRefinementEngine.h
  ${SOURCE_DIR}/include/itkDelaunayRefinementOracle.h
  ${SOURCE_DIR}/include/itkDelaunayRefinementTypes.h
)
forbid_includes(
  "CGAL is known to the exact predicates and to exact geometry alone"
  "(CGAL|boost|gmp|mpfr)"
  "itkDelaunayRefinement(Predicates|ExactGeometry)"
  ${SOURCE_DIR}/src/*.h
  ${SOURCE_DIR}/src/*.cxx
)
forbid_includes(
  "Tests of the filter and of the command, and examples, see public headers"
  "(CGAL|boost|itkDelaunayRefinement(Triangulation|Predicates|Rules|Encroachment|Queue))"
  ""
  ${SOURCE_DIR}/test/*MeshFilter*.cxx
  ${SOURCE_DIR}/test/*Command*.cxx
  ${SOURCE_DIR}/examples/*.cxx
  ${SOURCE_DIR}/examples/*/*.cxx
)
