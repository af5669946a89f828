import itk
import numpy as np
import pytest
from conftest import ball, make_image

BAD = [
    ({"delta": -1.0}, "Delta is -1; it must be a positive, finite length"),
    ({"delta": float("nan")}, "Delta is nan; it must be a positive, finite length"),
    ({"delta": 2.0, "radius_edge_ratio_bound": 0.5}, "RadiusEdgeRatioBound is 0.5; it must be finite and at least 1"),
    ({"delta": 2.0, "cell_size": 0.0}, "CellSize is 0; it must be a positive length"),
    ({"minimum_dihedral_angle": 70.0}, "MinimumDihedralAngle is 70; it must be at least 0 and below 60 degrees"),
    ({"maximum_number_of_vertices": 0}, "MaximumNumberOfVertices is 0; it must be positive"),
    ({"delta": 1.0, "maximum_number_of_vertices": 20}, "set a larger Delta or a larger MaximumNumberOfVertices"),
    ({"iso_value": float("inf")}, "IsoValue is inf; it must be finite"),
    ({"lower_threshold": 2.0, "upper_threshold": 1.0}, "the lower one not above the upper one"),
    ({"lower_threshold": 1.0, "iso_value": 0.5}, "set only one of them"),
    ({"labels": [4]}, "No voxel has the label 4 of Labels; the image has 1 label: 1"),
    ({"lower_threshold": 100.0}, "no voxel is between LowerThreshold 100"),
]


@pytest.mark.parametrize("keywords, sentence", BAD)
def test_bad_parameter(keywords, sentence):
    with pytest.raises(RuntimeError) as error:
        itk.delaunay_refinement_mesh_filter(ball(), **keywords)
    assert sentence in str(error.value)
    assert str(error.value).startswith("DelaunayRefinementMeshFilter: ")


@pytest.mark.parametrize(
    "values, sentence",
    [
        (np.zeros((8, 8, 8), np.uint8), "There is no object to mesh: no voxel has a label"),
        (np.full((8, 8, 8), np.nan, np.float32), "pixels that are NaN"),
        (np.ones((8, 8, 8), np.float32), "floating-point values, which are no labels"),
        (np.arange(512, dtype=np.int16).reshape(8, 8, 8), "seems to hold grey values, not labels"),
    ],
)
def test_bad_image(values, sentence):
    with pytest.raises(RuntimeError, match=sentence):
        itk.delaunay_refinement_mesh_filter(make_image(values), delta=2.0)


def test_wrong_label():
    values = np.ones((8, 8, 8), np.uint8)
    values[:4] = 2
    with pytest.raises(RuntimeError, match="No voxel has the label 3 of Labels; the image has 2 labels: 1, 2"):
        itk.delaunay_refinement_mesh_filter(make_image(values), delta=2.0, labels=[1, 3])


def test_origin_too_far_for_float():
    with pytest.raises(RuntimeError, match="a larger Delta .*or an origin nearer to 0"):
        itk.delaunay_refinement_mesh_filter(ball(origin=(1e8, 0.0, 0.0)), delta=2.0)


@pytest.mark.parametrize(
    "image_type",
    [itk.Image[itk.UC, 2], itk.Image[itk.RGBPixel[itk.UC], 3], itk.Image[itk.UC, 4]],
)
def test_wrong_type_of_image_says_what_is_possible(image_type):
    image = image_type.New()
    with pytest.raises(Exception) as error:
        itk.delaunay_refinement_mesh_filter(image, delta=2.0)
    text = str(error.value)
    assert "DelaunayRefinementMeshFilter is not wrapped for input type" in text
    for possible in ("itk.Image[itk.UC,3]", "itk.Image[itk.F,3]", "itk.Image[itk.SI,3]"):
        assert possible in text


def test_unknown_keyword():
    with pytest.raises(AttributeError, match="SetDleta"):
        itk.delaunay_refinement_mesh_filter(ball(), dleta=2.0)


def test_filter_is_usable_after_an_error():
    filter = itk.DelaunayRefinementMeshFilter.New(ball(), delta=-1.0)
    with pytest.raises(RuntimeError):
        filter.Update()
    filter.SetDelta(2.0)
    filter.Update()
    assert filter.GetOutput().GetNumberOfCells() > 0
