// What SWIG adds to the classes of this module.

%{
#include "itkDelaunayRefinementPythonRun.h"
%}

// Both classes run with Python's lock released and heed its signals, Ctrl-C for one. A run that starts at the end of a
// longer pipeline of other classes stops as well, but ends in that class's RuntimeError.
%define DECL_DELAUNAY_REFINEMENT_RUN(swig_name)
%feature("pythonappend") swig_name::New %{
        val._WatchSignals()
%}
%extend swig_name
{
  void
  _WatchSignals()
  {
    itk::DelaunayRefinementPythonSignalWatch::Attach(self);
  }

  PyObject *
  _Run(bool largestRegion)
  {
    return itk::RunForPython(self, [self, largestRegion] {
      if (largestRegion)
      {
        self->UpdateLargestPossibleRegion();
      }
      else
      {
        self->Update();
      }
    });
  }

  %pythoncode %{
    def Update(self):
        """Bring the output up to date. Ctrl-C raises KeyboardInterrupt within a second."""
        self._Run(False)

    def UpdateLargestPossibleRegion(self):
        """Bring the output up to date, as Update() does."""
        self._Run(True)
  %}
}
%enddef

%define DECL_TETRAHEDRAL_MESH_WRITER(swig_name, swig_mesh_name)
DECL_DELAUNAY_REFINEMENT_RUN(swig_name)
%feature("docstring") swig_name "
Writes a mesh of tetrahedra, or of triangles, to a file.

    itk.tetrahedral_mesh_writer(mesh, file_name='mesh.vtu')

file_name : str
    Its ending is the format. Tetrahedra: .vtu or .vtk; triangles: .vtp, .vtk,
    .stl or .ply.

Points are written in double precision (in .stl and .ply in single precision),
whole numbers in the cell data as the array 'label'. A run that fails or is
stopped leaves no file behind, and a file of that name as it was. RuntimeError
says what to change.
"
%extend swig_name
{
  static PyObject *
  _CopyCells(const swig_mesh_name * mesh)
  {
    return itk::CopyCellsForPython(mesh);
  }

  %pythoncode %{
    def Write(self):
        """Bring the mesh up to date and write it."""
        self._Run(False)
  %}
}
%enddef

%define DECL_DELAUNAY_REFINEMENT_MESH_FILTER(swig_name)
DECL_DELAUNAY_REFINEMENT_RUN(swig_name)
%feature("docstring") swig_name "
Turns a segmented 3D image into a tetrahedral mesh of guaranteed quality.

    mesh = itk.delaunay_refinement_mesh_filter(image, delta=3.0)

returns an itk.Mesh[itk.D, 3] in the image's physical space (spacing, origin
and direction apply), with the label inside each tetrahedron as cell data.
ttype=(type(image), itk.Mesh[itk.F, 3]) asks for the other type of mesh; both
store coordinates as float, and the guarantees hold for the stored points.
The class, itk.DelaunayRefinementMeshFilter, also has the triangles of the
boundary and of the interfaces between labels (GetBoundaryOutput, whose cell
data are the larger one of the two labels that a triangle parts, and
GetBoundaryOtherLabels, the smaller one, 0 outside) and what happened
(GetWarnings, GetMissingLabels, GetEffectiveDelta).
itk.arrays_from_tetrahedral_mesh(mesh) gives NumPy arrays.

Lengths are in the image's physical unit, mm as a rule.

What is the object (by default: every voxel of an image of integers but 0):

labels : list of int, default: all but 0
    Only voxels with these labels. Several labels are tissues of one mesh that
    share the triangles between them.
merge_labels : bool, default: False
    Several labels become one object, with the label 1.
lower_threshold, upper_threshold : float, pixel values, default: unset
    Voxels in the range, ends included; one end may be left out.
iso_value : float, pixel value, default: unset
    All points where the interpolated value is at or above it.
interpolator : itk.InterpolateImageFunction, default: linear
    Where the surface runs between the centers of voxels.
largest_component_only : bool, default: False
    Only the 18-connected component with the most voxels.
minimum_component_size : int, voxels, default: 1
    Smaller components are left out.
smoothing : float, mm, default: 0.0 (off)
    Width by which the steps of labels' voxels are smoothed; 0.5 to 1 voxel
    takes most of them away. Volumes are kept.
strict : bool, default: False
    A label, a component or a cavity that is missing in the mesh is an error.

How fine:

delta : float, mm, default: from the spacing and the size of the object
    Density of vertices on the surface: every point of it has one within
    delta. The default makes some 300,000 tetrahedra at most.
label_deltas : dict of float by label, mm, default: none
    Another delta for some labels.
cell_size : float, mm, default: inf
    Upper bound on the circumradius of tetrahedra.
radius_edge_ratio_bound : float, default: 2.0, at least 1
    Upper bound on circumradius over shortest edge. Below 2 the boundary may
    leave the surface.
minimum_dihedral_angle : float, degrees, default: 0.0 (off), below 60
    Lower bound on all dihedral angles: slivers are removed, by vertices
    inserted and moved. 10 to 15 is a good one. A warning says if some are left.
paper_slivers : bool, default: False
    Rule R4' of the paper is applied against smaller dihedral angles instead; it
    leaves some.
manifold : bool, default: True
    The boundary, and that of each label, is made a 2-manifold.
hausdorff_bound : float, mm, default: 0.0 (off)
    Upper bound on the distance between the boundary and the surface in the
    image, both ways; delta is lowered where that takes it.
preserve_topology : bool, default: False
    Delta is lowered until the mesh has as many components, cavities and
    handles as the object in the image; a warning says if it has not. For one
    object.
minimum_delta : float, mm, default: 0.0 (off)
    Delta is lowered down to this where the surface is bent or parts are thin.
size_field : itk.Image[itk.F, 3] of lengths in mm, default: none
    Delta is no larger at any point; it has a grid of its own.
refine_outside : bool, default: False
    Rule R2 of the paper for all intersecting tetrahedra, outside the object
    too; no guarantee needs it, and it takes twice as long.
maximum_number_of_vertices : int, default: no limit
    Gives up, without a mesh, before there are more vertices.

RuntimeError says what to change. Ctrl-C raises KeyboardInterrupt.
"
// Plain structures, which ITK's wrapping does not know.
%ignore swig_name::GetStatistics;
%ignore swig_name::GetComponents;
%ignore swig_name::GetLoweredSmoothings;
%extend swig_name
{
  %pythoncode %{
    def __internal_call__(self):
        """Run, and return the mesh of tetrahedra alone."""
        self.UpdateLargestPossibleRegion()
        return self.GetOutput()

    def SetLabelDeltas(self, deltas):
        """Another delta for some labels: a dict, by label."""
        self.UnsetLabelDeltas()
        for label, delta in deltas.items():
            self.SetLabelDelta(label, delta)
  %}
}
%enddef
