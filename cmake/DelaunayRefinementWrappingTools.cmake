# SWIG and CastXML are packages of PyPI; ITK would download both otherwise.

# Sets DelaunayRefinement_WRAPPING_TOOL_ARGS for the Python in
# Python3_EXECUTABLE: what ITK and a module of it need to find the tools.
function(delaunay_refinement_find_wrapping_tools)
  execute_process(
    COMMAND
      ${Python3_EXECUTABLE} -c
      "import castxml, swig; print(castxml.BIN_DIR + '/castxml', swig.BIN_DIR + '/swig', swig.SWIG_LIB_ENV['SWIG_LIB'], sep='\\n')"
    OUTPUT_VARIABLE _paths
    OUTPUT_STRIP_TRAILING_WHITESPACE
    RESULT_VARIABLE _result
  )
  if(NOT _result EQUAL 0)
    message(
      FATAL_ERROR
      "${Python3_EXECUTABLE} lacks the packages of wrapping: pip install swig==4.3.0 castxml"
    )
  endif()
  string(REPLACE "\n" ";" _paths "${_paths}")
  list(GET _paths 0 _castxml)
  list(GET _paths 1 _swig)
  list(GET _paths 2 _swig_dir)
  set(
    DelaunayRefinement_WRAPPING_TOOL_ARGS
    -DITK_USE_SYSTEM_SWIG=ON
    -DSWIG_EXECUTABLE=${_swig}
    -DSWIG_DIR=${_swig_dir}
    -DITK_USE_SYSTEM_CASTXML=ON
    -DCASTXML_EXECUTABLE=${_castxml}
    -DPython3_EXECUTABLE=${Python3_EXECUTABLE}
    PARENT_SCOPE
  )
endfunction()
