import time

import itk
import numpy as np
import pytest
from conftest import ball
from mesh_checks import assert_guarantees


def test_arrays_are_those_of_the_mesh():
    mesh = itk.delaunay_refinement_mesh_filter(ball(value=4), delta=2.0)
    points, cells, labels = itk.arrays_from_tetrahedral_mesh(mesh)
    assert points.shape == (mesh.GetNumberOfPoints(), 3) and points.dtype == np.float32
    assert cells.shape == (mesh.GetNumberOfCells(), 4) and cells.dtype == np.int64
    assert labels.shape == (mesh.GetNumberOfCells(),) and labels.dtype == np.int64
    for i in (0, len(points) - 1):
        assert tuple(points[i]) == tuple(mesh.GetPoint(i))
    for i in (0, len(cells) // 2, len(cells) - 1):
        ids = mesh.GetCells().GetElement(i).GetPointIdsContainer()
        assert [ids.GetElement(k) for k in range(4)] == list(cells[i])


def test_arrays_outlive_the_mesh():
    mesh = itk.delaunay_refinement_mesh_filter(ball(), delta=2.0)
    arrays = itk.arrays_from_tetrahedral_mesh(mesh)
    copies = [a.copy() for a in arrays]
    del mesh
    itk.delaunay_refinement_mesh_filter(ball(), delta=2.5)
    assert all(np.array_equal(a, b) for a, b in zip(arrays, copies))
    assert all(a.flags.writeable for a in arrays)


def test_filters_are_taken():
    filter = itk.DelaunayRefinementMeshFilter.New(ball(), delta=2.0)
    filter.Update()
    assert_guarantees(itk.arrays_from_tetrahedral_mesh(filter))


def test_half_a_million_tetrahedra_in_a_fifth_of_a_second(brain):
    mesh = itk.delaunay_refinement_mesh_filter(brain, lower_threshold=1, delta=3.0, cell_size=2.1)
    assert mesh.GetNumberOfCells() > 500_000
    seconds = []
    for _ in range(3):
        start = time.perf_counter()
        itk.arrays_from_tetrahedral_mesh(mesh)
        seconds.append(time.perf_counter() - start)
    print(f"{mesh.GetNumberOfCells()} tetrahedra in {min(seconds):.3f} s")
    assert min(seconds) < 0.2


def test_other_meshes_are_refused():
    with pytest.raises(ValueError, match="no cells"):
        itk.arrays_from_tetrahedral_mesh(itk.Mesh[itk.D, 3].New())
    mesh = itk.Mesh[itk.D, 3].New()
    mesh.SetPoints(itk.vector_container_from_array(np.zeros(12, np.float32)))
    # A tetrahedron (type 5) and a triangle (type 2).
    cells = np.array([5, 4, 0, 1, 2, 3, 2, 3, 0, 1, 2], np.uint64)
    mesh.SetCellsArray(itk.vector_container_from_array(cells))
    with pytest.raises(ValueError, match="neither all tetrahedra nor all triangles"):
        itk.arrays_from_tetrahedral_mesh(mesh)
