set(
  DOCUMENTATION
  "Guaranteed quality Delaunay meshing of segmented images: turns a labelled
3D image into a tetrahedral mesh with bounded radius-edge ratios and boundary
angles."
)

# The tests of wrapping are run by ITK's own driver.
set(_wrapping_test_depends)
if(ITK_SOURCE_DIR AND ITK_WRAP_PYTHON)
  set(_wrapping_test_depends ITKTestKernel)
endif()

itk_module(
  DelaunayRefinement
  DEPENDS
    ITKCommon
    ITKImageFunction
    ITKMesh
  TEST_DEPENDS
    ITKGoogleTest
    ITKIONIFTI
    ITKThresholding
    ${_wrapping_test_depends}
  DESCRIPTION "${DOCUMENTATION}"
  EXCLUDE_FROM_DEFAULT
  ENABLE_SHARED
)
