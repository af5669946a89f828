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

    points : float32, n x 3
        In the image's physical space, mm as a rule.
    cells : int64, m x 4 (triangles: m x 3)
        Indices of points. Tetrahedra are positively oriented, triangles
        counterclockwise as seen from outside.
    labels : m
        The label inside each cell: of the integer type int64.

    The three come as a named tuple, for example:

        points, tetrahedra, labels = itk.arrays_from_tetrahedral_mesh(mesh)
    """
    import itk
    import numpy as np

    mesh = itk.output(mesh)
    number_of_cells = mesh.GetNumberOfCells()
    if number_of_cells == 0:
        raise ValueError("The mesh has no cells")
    points = itk.array_from_vector_container(mesh.GetPoints()).reshape(-1, 3)
    # For each cell its type, its number of points, and their indices.
    flat = itk.array_from_vector_container(mesh.GetCellsArray())
    step = int(flat[1]) + 2
    if flat.size != number_of_cells * step or step not in (5, 6):
        raise ValueError("The mesh has cells that are neither all tetrahedra nor all triangles")
    table = flat.reshape(-1, step)
    if (table[:, :2] != table[0, :2]).any():
        raise ValueError("The mesh has cells that are neither all tetrahedra nor all triangles")
    cells = table[:, 2:].astype(np.int64)
    labels = itk.array_from_vector_container(mesh.GetCellData()).astype(np.int64)
    return TetrahedralMeshArrays(points, cells, labels)


for _public in (TetrahedralMeshArrays, arrays_from_tetrahedral_mesh):
    # As if they were itk's own: so they pickle.
    _public.__module__ = "itk"
    setattr(sys.modules["itk"], _public.__name__, _public)
