"""What the module DelaunayRefinement adds to the package itk beside its classes."""

import sys
from typing import NamedTuple


class TetrahedralMeshArrays(NamedTuple):
    """NumPy arrays of a mesh whose cells are all tetrahedra, or all triangles."""

    points: "numpy.ndarray"
    cells: "numpy.ndarray"
    labels: "numpy.ndarray"


def arrays_from_tetrahedral_mesh(mesh):
    """NumPy arrays of a mesh of tetrahedra, or of triangles: copies that outlive the mesh.

    The mesh, or the filter that makes it, is one of itk.Mesh[itk.D, 3] and
    itk.Mesh[itk.F, 3].

    points : float32, n x 3
        In the image's physical space, mm as a rule.
    cells : int64, m x 4 (triangles: m x 3)
        Indices of points. Tetrahedra are positively oriented, triangles
        counterclockwise as seen from outside.
    labels : int64, m
        The label inside each cell.

    The three come as a named tuple, for example:

        points, tetrahedra, labels = itk.arrays_from_tetrahedral_mesh(mesh)
    """
    import itk
    import numpy as np

    mesh = itk.down_cast(itk.output(mesh))
    cells = np.frombuffer(itk.TetrahedralMeshWriter[type(mesh)]._CopyCells(mesh), np.int64)
    cells = cells.reshape(mesh.GetNumberOfCells(), -1)
    points = itk.array_from_vector_container(mesh.GetPoints()).reshape(-1, 3)
    labels = itk.array_from_vector_container(mesh.GetCellData()).astype(np.int64)
    return TetrahedralMeshArrays(points, cells, labels)


for _public in (TetrahedralMeshArrays, arrays_from_tetrahedral_mesh):
    # As if they were itk's own: so they pickle.
    _public.__module__ = "itk"
    setattr(sys.modules["itk"], _public.__name__, _public)
