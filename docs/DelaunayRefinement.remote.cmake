# In ITK's Modules/Remote, a copy of this file offers the module in ITK's own
# build as Module_DelaunayRefinement. Before it goes there, the address of the
# repository and the hash of a commit take the places of the two below, and
# ITK's list of criteria is filled in: level 3, as level 4 asks for no
# requirement beyond ITK's own, and this module needs CGAL 5.5 and VTK 9.1.
#
# Without a network, a copy or a link of the repository as
# Modules/Remote/DelaunayRefinement does the same.

itk_fetch_module(
  DelaunayRefinement
  "Turns a labelled 3D image into a tetrahedral mesh of guaranteed quality by
   Delaunay refinement. Binaries hold CGAL's kernels, which are under the LGPL."
  MODULE_COMPLIANCE_LEVEL
  3
  GIT_REPOSITORY
  https://example.org/ITKDelaunayRefinement.git
  GIT_TAG
  0000000000000000000000000000000000000000
)
