import inspect
import math
import re

import itk
import numpy as np
import pytest
from conftest import ball, ball_values, make_image
from mesh_checks import FACES, assert_guarantees, boundary_triangles, enclosed_volume, volumes

MESHES = [itk.Mesh[itk.F, 3], itk.Mesh[itk.D, 3]]
INTEGERS = [np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.uint64]
PARAMETERS = {
    "delta": ("Delta", 2.5),
    "cell_size": ("CellSize", 4.0),
    "radius_edge_ratio_bound": ("RadiusEdgeRatioBound", 2.5),
    "minimum_dihedral_angle": ("MinimumDihedralAngle", 8.0),
    "paper_slivers": ("PaperSlivers", True),
    "manifold": ("Manifold", False),
    "hausdorff_bound": ("HausdorffBound", 1.5),
    "preserve_topology": ("PreserveTopology", True),
    "minimum_delta": ("MinimumDelta", 1.5),
    "refine_outside": ("RefineOutside", True),
    "maximum_number_of_vertices": ("MaximumNumberOfVertices", 100000),
    "iso_value": ("IsoValue", 0.5),
    "lower_threshold": ("LowerThreshold", 0.5),
    "upper_threshold": ("UpperThreshold", 1.5),
    "labels": ("Labels", [1]),
    "merge_labels": ("MergeLabels", True),
    "largest_component_only": ("LargestComponentOnly", True),
    "minimum_component_size": ("MinimumComponentSize", 5),
    "smoothing": ("Smoothing", 0.5),
    "strict": ("Strict", True),
}


def arrays(mesh):
    return itk.arrays_from_tetrahedral_mesh(mesh)


def same(a, b):
    return all(np.array_equal(x, y) for x, y in zip(arrays(a), arrays(b)))


def test_function_returns_a_mesh_of_the_ball():
    mesh = itk.delaunay_refinement_mesh_filter(ball(), delta=2.0)
    assert isinstance(mesh, itk.Mesh[itk.D, 3])
    assert_guarantees(arrays(mesh))
    assert volumes(*arrays(mesh)[:2]).sum() == pytest.approx(4 / 3 * math.pi * 8**3, rel=0.1)


def test_class_does_what_the_function_does():
    image = ball()
    filter = itk.DelaunayRefinementMeshFilter[type(image), itk.Mesh[itk.D, 3]].New()
    filter.SetInput(image)
    filter.SetDelta(2.0)
    filter.Update()
    assert same(filter.GetOutput(), itk.delaunay_refinement_mesh_filter(image, delta=2.0))
    assert filter.GetEffectiveDelta() == 2.0
    assert list(filter.GetWarnings()) == []


@pytest.mark.parametrize("mesh_type", MESHES)
@pytest.mark.parametrize("dtype", INTEGERS + [np.float32, np.float64])
def test_all_types(dtype, mesh_type):
    image = ball(value=5, dtype=dtype)
    definition = {"lower_threshold": 1.0} if np.dtype(dtype).kind == "f" else {}
    mesh = itk.delaunay_refinement_mesh_filter(image, delta=2.0, ttype=(type(image), mesh_type), **definition)
    assert isinstance(mesh, mesh_type)
    assert_guarantees(arrays(mesh))
    assert set(arrays(mesh).labels) == {1 if definition else 5}
    reference = itk.delaunay_refinement_mesh_filter(ball(), delta=2.0)
    assert np.array_equal(arrays(mesh).points, arrays(reference).points)


def test_types_are_those_of_this_itk():
    """Every scalar type of which PyPI's itk has 3D images, but for bool, which it can't make from NumPy."""
    scalars = {itk.template(i)[1][0] for i in itk.Image.values() if itk.template(i)[1][1] == 3}
    scalars = {t for t in scalars if isinstance(t, itk.itkCType)} - {itk.B}
    taken = {itk.template(key[0])[1][0] for key in itk.DelaunayRefinementMeshFilter.keys()}
    assert taken == scalars
    assert {key[1] for key in itk.DelaunayRefinementMeshFilter.keys()} == set(MESHES)


@pytest.mark.parametrize("keyword", PARAMETERS)
def test_keyword_sets_the_parameter(keyword):
    name, value = PARAMETERS[keyword]
    filter = itk.DelaunayRefinementMeshFilter.New(ball(), **{keyword: value})
    got = getattr(filter, f"Get{name}")()
    assert (list(got) if keyword == "labels" else got) == value


def two_tissues():
    values = ball_values(size=24, radius=9.0, value=7, dtype=np.uint16)
    values[:, :, :12][values[:, :, :12] > 0] = 300
    return make_image(values)


def test_labels_are_tissues_that_share_triangles():
    image = two_tissues()
    filter = itk.DelaunayRefinementMeshFilter.New(image, delta=2.0, labels=[7, 300])
    filter.Update()
    mesh = arrays(filter.GetOutput())
    assert_guarantees(mesh)
    assert set(mesh.labels) == {7, 300}
    assert list(filter.GetMissingLabels()) == []
    boundary = arrays(filter.GetBoundaryOutput())
    others = itk.array_from_vector_container(filter.GetBoundaryOtherLabels()).astype(int)
    assert len(others) == len(boundary.labels)
    assert set(zip(boundary.labels, others)) == {(7, 0), (300, 0), (300, 7)}
    assert set(arrays(itk.delaunay_refinement_mesh_filter(image, delta=2.0, labels=[300])).labels) == {300}


def test_label_deltas_and_smoothing():
    image = two_tissues()
    coarse = arrays(itk.delaunay_refinement_mesh_filter(image, delta=3.0))
    fine = arrays(itk.delaunay_refinement_mesh_filter(image, delta=3.0, label_deltas={300: 1.0}, smoothing=0.8))
    assert_guarantees(fine)
    assert (fine.labels == 300).sum() > 4 * (coarse.labels == 300).sum()
    assert (fine.labels == 7).sum() < (fine.labels == 300).sum()


def test_size_field_has_a_grid_of_its_own():
    image = ball(size=32, radius=12.0)
    lengths = np.full((8, 8, 8), 6.0, np.float32)
    lengths[:, :, :3] = 1.5
    field = make_image(lengths, spacing=(4.5, 4.5, 4.5))
    mesh = arrays(itk.delaunay_refinement_mesh_filter(image, delta=6.0, size_field=field))
    assert_guarantees(mesh)
    centers = mesh.points[mesh.cells].mean(axis=1)
    assert (centers[:, 0] < 12).sum() > 3 * (centers[:, 0] > 19).sum()
    lengths[1, 2, 3] = np.nan
    with pytest.raises(RuntimeError, match="SizeField"):
        itk.delaunay_refinement_mesh_filter(image, delta=6.0, size_field=make_image(lengths))


def smallest_dihedral_angle(mesh):
    p = mesh.points.astype(np.float64)[mesh.cells]
    normals = [np.cross(p[:, b] - p[:, a], p[:, c] - p[:, a]) for a, b, c in FACES]
    normals = [n / np.linalg.norm(n, axis=1, keepdims=True) for n in normals]
    cosines = [-(normals[i] * normals[j]).sum(axis=1) for i in range(4) for j in range(i)]
    return np.degrees(np.arccos(np.max(cosines)))


def test_slivers_are_removed():
    image = ball(size=32, radius=12.0)
    assert smallest_dihedral_angle(arrays(itk.delaunay_refinement_mesh_filter(image, delta=2.0))) < 10.0
    mesh = arrays(itk.delaunay_refinement_mesh_filter(image, delta=2.0, minimum_dihedral_angle=15.0))
    assert_guarantees(mesh)
    assert smallest_dihedral_angle(mesh) >= 15.0
    with pytest.raises(RuntimeError, match="MinimumDihedralAngle"):
        itk.delaunay_refinement_mesh_filter(image, delta=4.0, minimum_dihedral_angle=55.0, strict=True)
    with pytest.raises(RuntimeError, match="PaperSlivers"):
        itk.delaunay_refinement_mesh_filter(image, delta=4.0, paper_slivers=True)


def test_topology_is_that_of_the_image():
    values = np.ones((9, 20, 20), np.uint8)
    values[:, 9:11, 9:11] = 0
    image = make_image(np.pad(values, 2))
    triangles = [
        boundary_triangles(
            arrays(itk.delaunay_refinement_mesh_filter(image, delta=8.0, preserve_topology=wanted)).cells
        )
        for wanted in (False, True)
    ]
    euler = [len(np.unique(t)) - len(t) // 2 for t in triangles]
    assert euler == [2, 0]


def test_keywords_are_all_the_setters():
    cls = itk.DelaunayRefinementMeshFilter.values()[0]
    setters = {name[3:] for name in vars(cls) if name.startswith("Set")}
    assert setters == {name for name, _ in PARAMETERS.values()} | {
        "Interpolator",
        "LabelDelta",
        "LabelDeltas",
        "SizeField",
    }


def test_help_has_parameters_units_and_defaults():
    text = inspect.getdoc(itk.delaunay_refinement_mesh_filter)
    filter = itk.DelaunayRefinementMeshFilter.New(ball())
    entries = {}
    for names, about in re.findall(r"^([a-z_, ]+) : (.*default: .*)$", text, flags=re.MULTILINE):
        entries.update({name: about for name in names.split(", ")})
    assert set(entries) == set(PARAMETERS) | {"interpolator", "label_deltas", "size_field"}
    for keyword, about in entries.items():
        default = re.search(r"default: ([^, ]+)", about).group(1)
        if re.fullmatch(r"[\d.]+|inf", default):
            assert float(default) == getattr(filter, f"Get{PARAMETERS[keyword][0]}")()
        elif default in ("True", "False"):
            assert (default == "True") == getattr(filter, f"Get{PARAMETERS[keyword][0]}")()
    for keyword in ("delta", "cell_size"):
        assert " mm," in entries[keyword]
    assert "degrees" in entries["minimum_dihedral_angle"]
    assert inspect.getdoc(type(filter)) == text


def test_parameters_matter():
    image = ball()

    def count(**keywords):
        return len(arrays(itk.delaunay_refinement_mesh_filter(image, **keywords)).cells)

    assert count(delta=2.0, cell_size=1.5) > 2 * count(delta=2.0)
    assert count(delta=1.5) > 2 * count(delta=3.0)
    values = np.zeros((24, 24, 48), np.uint8)
    values[:, :, :24] = ball_values(value=3)
    values[:, :, 24:] = ball_values(radius=4.0, value=7)
    two = make_image(values)

    def labels_and_volume(**keywords):
        points, cells, labels = arrays(itk.delaunay_refinement_mesh_filter(two, delta=2.0, **keywords))
        return set(labels), volumes(points, cells).sum()

    large, small = 4 / 3 * math.pi * 8**3, 4 / 3 * math.pi * 4**3
    assert labels_and_volume(labels=[3]) == ({3}, pytest.approx(large, rel=0.1))
    assert labels_and_volume(labels=[7]) == ({7}, pytest.approx(small, rel=0.2))
    assert labels_and_volume(merge_labels=True) == ({1}, pytest.approx(large + small, rel=0.1))
    assert labels_and_volume(merge_labels=True, largest_component_only=True)[1] == pytest.approx(large, rel=0.1)
    assert labels_and_volume(merge_labels=True, minimum_component_size=1000)[1] == pytest.approx(large, rel=0.1)
    assert labels_and_volume(upper_threshold=6.5, lower_threshold=2.0)[1] == pytest.approx(large, rel=0.1)


def test_interpolators_of_itk_are_taken():
    grid = np.indices((24, 24, 24)) - 11.5
    distance = (8.0 - np.sqrt((grid**2).sum(axis=0))).astype(np.float32)
    image = make_image(distance)
    interpolator = itk.BSplineInterpolateImageFunction[type(image), itk.D, itk.F].New()
    linear = itk.delaunay_refinement_mesh_filter(image, iso_value=0.0, delta=2.0)
    smooth = itk.delaunay_refinement_mesh_filter(image, iso_value=0.0, delta=2.0, interpolator=interpolator)
    assert_guarantees(arrays(smooth))
    assert not same(linear, smooth)
    points = arrays(smooth).points
    boundary = np.unique(boundary_triangles(arrays(smooth).cells))
    assert np.abs(np.linalg.norm(points[boundary] - 11.5, axis=1) - 8.0).max() < 0.01


def test_nearest_neighbor_gives_the_voxels():
    values = np.zeros((12, 12, 12), np.uint8)
    values[3:9, 3:9, 3:9] = 1
    image = make_image(values)
    interpolator = itk.NearestNeighborInterpolateImageFunction[type(image), itk.D].New()
    mesh = itk.delaunay_refinement_mesh_filter(image, delta=0.7, interpolator=interpolator)
    assert volumes(*arrays(mesh)[:2]).sum() == pytest.approx(216.0, rel=0.05)


@pytest.mark.parametrize("mesh_type", MESHES)
@pytest.mark.parametrize("shift", [300.0, 1e5])
def test_guarantees_hold_for_stored_points_far_from_the_origin(shift, mesh_type):
    image = ball(origin=(shift, -shift, shift))
    mesh = itk.delaunay_refinement_mesh_filter(image, delta=2.0, ttype=(type(image), mesh_type))
    assert arrays(mesh).points.dtype == np.float32
    assert_guarantees(arrays(mesh))
    assert arrays(mesh).points.mean(axis=0) == pytest.approx([shift + 11.5, -shift + 11.5, shift + 11.5], abs=0.5)


def test_physical_space():
    """Points follow spacing, origin and an oblique direction."""
    angle = math.radians(30.0)
    direction = [
        [math.cos(angle), -math.sin(angle), 0.0],
        [math.sin(angle), math.cos(angle), 0.0],
        [0.0, 0.0, -1.0],
    ]
    spacing, origin = np.array([0.8, 1.2, 2.0]), np.array([10.0, -20.0, 30.0])
    values = np.zeros((14, 26, 30), np.uint8)
    values[4:9, 5:20, 6:12] = 1
    image = make_image(values, spacing.tolist(), origin.tolist(), direction)
    mesh = itk.delaunay_refinement_mesh_filter(image, delta=1.5)
    assert_guarantees(arrays(mesh))
    indices = (arrays(mesh).points - origin) @ np.asarray(direction) / spacing
    assert indices.min(axis=0) == pytest.approx([5.5, 4.5, 3.5], abs=0.3)
    assert indices.max(axis=0) == pytest.approx([11.5, 19.5, 8.5], abs=0.3)
    triangles = boundary_triangles(arrays(mesh).cells)
    assert enclosed_volume(arrays(mesh).points, triangles) == pytest.approx(volumes(*arrays(mesh)[:2]).sum(), rel=1e-4)


def test_array_is_taken_as_an_image():
    mesh = itk.delaunay_refinement_mesh_filter(ball_values(), delta=2.0)
    assert same(mesh, itk.delaunay_refinement_mesh_filter(ball(), delta=2.0))


def test_chain_after_a_filter():
    image = ball(value=100)
    threshold = itk.BinaryThresholdImageFilter.New(image, lower_threshold=50, inside_value=1)
    filter = itk.DelaunayRefinementMeshFilter.New(threshold, delta=2.0)
    filter.Update()
    assert same(filter.GetOutput(), itk.delaunay_refinement_mesh_filter(ball(), delta=2.0))


def test_boundary_output():
    filter = itk.DelaunayRefinementMeshFilter.New(ball(value=9), delta=2.0)
    filter.Update()
    tetrahedra = arrays(filter.GetOutput())
    boundary = arrays(filter.GetBoundaryOutput())
    assert boundary.cells.shape[1] == 3
    assert set(boundary.labels) == {9}
    assert len(boundary.cells) == len(boundary_triangles(tetrahedra.cells))
    assert enclosed_volume(boundary.points, boundary.cells) == pytest.approx(volumes(*tetrahedra[:2]).sum(), rel=1e-4)


def test_warnings_name_what_is_missing():
    values = np.zeros((24, 24, 30), np.uint8)
    values[:, :, :24] = ball_values()
    values[12, 12, 27] = 1
    filter = itk.DelaunayRefinementMeshFilter.New(make_image(values), delta=2.0)
    filter.Update()
    (warning,) = filter.GetWarnings()
    assert warning.endswith("too small for Delta 2 mm and missing in the mesh: 1 voxel at (27, 12, 12)")


def test_progress_rises_to_1():
    seen = []
    filter = itk.DelaunayRefinementMeshFilter.New(ball(), delta=0.7)
    filter.AddObserver(itk.ProgressEvent(), lambda: seen.append(filter.GetProgress()))
    filter.Update()
    assert len(seen) > 2 and seen == sorted(seen) and seen[-1] == 1.0


def test_abort_from_an_observer():
    filter = itk.DelaunayRefinementMeshFilter.New(ball(), delta=0.7)
    tag = filter.AddObserver(itk.ProgressEvent(), filter.AbortGenerateDataOn)
    with pytest.raises(RuntimeError, match="aborted"):
        filter.Update()
    filter.RemoveObserver(tag)
    filter.Update()
    assert_guarantees(arrays(filter.GetOutput()))


def test_brain(brain):
    mesh = itk.delaunay_refinement_mesh_filter(brain, lower_threshold=1, delta=3.0, largest_component_only=True)
    assert_guarantees(arrays(mesh))
    assert volumes(*arrays(mesh)[:2]).sum() == pytest.approx(1.737e6, rel=0.03)
