set(
  DOCUMENTATION
  "Guaranteed quality Delaunay meshing of segmented images: turns a labelled
3D image into a tetrahedral mesh with bounded radius-edge ratios and boundary
angles."
)

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
  DESCRIPTION "${DOCUMENTATION}"
  EXCLUDE_FROM_DEFAULT
  ENABLE_SHARED
)
