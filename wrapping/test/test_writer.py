import itk
import meshio
import numpy as np
import pytest
import pyvista
from conftest import ball


@pytest.fixture(scope="module")
def filter():
    filter = itk.DelaunayRefinementMeshFilter.New(ball(value=7), delta=2.0)
    filter.Update()
    return filter


@pytest.mark.parametrize("ending", ["vtu", "vtk"])
@pytest.mark.parametrize("mesh_type", [itk.Mesh[itk.F, 3], itk.Mesh[itk.D, 3]])
def test_tetrahedra(tmp_path, ending, mesh_type):
    image = ball(value=7)
    mesh = itk.delaunay_refinement_mesh_filter(image, delta=2.0, ttype=(type(image), mesh_type))
    arrays = itk.arrays_from_tetrahedral_mesh(mesh)
    name = str(tmp_path / f"ball.{ending}")
    itk.tetrahedral_mesh_writer(mesh, file_name=name)
    for points, cells, labels in (
        (lambda m: (m.points, m.cells_dict["tetra"], m.cell_data["label"][0]))(meshio.read(name)),
        (lambda m: (m.points, m.cells_dict[10], m.cell_data["label"]))(pyvista.read(name)),
    ):
        assert np.array_equal(points, arrays.points)
        assert np.array_equal(cells, arrays.cells)
        assert np.array_equal(np.ravel(labels), arrays.labels)


@pytest.mark.parametrize("ending", ["vtp", "vtk", "stl", "ply"])
def test_triangles(tmp_path, filter, ending):
    name = str(tmp_path / f"ball.{ending}")
    itk.tetrahedral_mesh_writer(filter.GetBoundaryOutput(), file_name=name)
    surface = pyvista.read(name)
    assert surface.n_cells == filter.GetBoundaryOutput().GetNumberOfCells()
    assert surface.is_manifold


def test_class_form_brings_its_input_up_to_date(tmp_path):
    filter = itk.DelaunayRefinementMeshFilter.New(ball(), delta=2.0)
    writer = itk.TetrahedralMeshWriter[itk.Mesh[itk.D, 3]].New()
    writer.SetInput(filter.GetOutput())
    writer.SetFileName(str(tmp_path / "a.vtu"))
    writer.Write()
    assert pyvista.read(tmp_path / "a.vtu").n_cells == filter.GetOutput().GetNumberOfCells() > 0


def test_one_line_to_meshio_and_to_pyvista(filter):
    points, tetrahedra, labels = itk.arrays_from_tetrahedral_mesh(filter)
    a = meshio.Mesh(points, {"tetra": tetrahedra}, cell_data={"label": [labels]})
    b = pyvista.UnstructuredGrid({pyvista.CellType.TETRA: tetrahedra}, points)
    assert len(a.cells_dict["tetra"]) == b.n_cells == len(labels)
    assert b.compute_cell_sizes()["Volume"].min() > 0.0


@pytest.mark.parametrize(
    "name, sentence",
    [("a.obj", "obj"), ("missing/a.vtu", "missing"), ("", "no file name"), ("a.stl", "stl")],
)
def test_bad_name(tmp_path, filter, name, sentence):
    path = str(tmp_path / name) if name else ""
    with pytest.raises(RuntimeError, match=sentence):
        itk.tetrahedral_mesh_writer(filter.GetOutput(), file_name=path)
    assert list(tmp_path.iterdir()) == []
