"""The examples run, and what they make is right."""

import csv
import pathlib
import subprocess
import sys

import numpy as np
import pytest
import pyvista
from conftest import BRAIN

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"


def run(folder, name, *arguments):
    result = subprocess.run(
        [sys.executable, str(EXAMPLES / name), *map(str, arguments)], cwd=folder, capture_output=True, text=True
    )
    assert result.returncode == 0, result.stderr
    return result


@pytest.fixture(scope="module")
def brain_mesh(tmp_path_factory):
    folder = tmp_path_factory.mktemp("brain")
    run(folder, "segment_and_mesh.py", BRAIN, "brain.vtu", "--delta", 6)
    return folder / "brain.vtu"


def test_otsu(brain_mesh):
    grid = pyvista.read(brain_mesh)
    assert 1e6 < grid.volume < 2e6
    assert set(grid["label"]) == {1}


def test_binary_threshold(tmp_path):
    run(tmp_path, "segment_and_mesh.py", BRAIN, "brain.vtk", "--delta", 6, "--between", 1, 255)
    assert pyvista.read(tmp_path / "brain.vtk").volume == pytest.approx(1.737e6, rel=0.03)


@pytest.mark.parametrize("how", [["--between", 90, 130], []])
def test_grown_region(tmp_path, how):
    run(tmp_path, "grow_and_mesh.py", BRAIN, "a.vtu", "--seed", -26, -20, 26, "--delta", 3, *how)
    grid = pyvista.read(tmp_path / "a.vtu")
    assert 1e4 < grid.volume < 1.7e6
    distance = np.linalg.norm(grid.points - [-26, -20, 26], axis=1)
    assert distance.min() < 15.0


def test_array(tmp_path):
    run(tmp_path, "array_to_mesh.py", "torus.vtu")
    grid = pyvista.read(tmp_path / "torus.vtu")
    assert grid.volume == pytest.approx(2 * np.pi**2 * 20 * 8**2, rel=0.05)


def picture_is_drawn(path):
    pixels = pyvista.read(path).point_data.active_scalars
    return len(np.unique(pixels, axis=0)) > 20 and np.ptp(pixels) > 100


def test_poisson(brain_mesh, tmp_path):
    run(tmp_path, "solve_poisson.py", brain_mesh, "u.vtu", "--picture", "u.png")
    u = pyvista.read(tmp_path / "u.vtu")["u"]
    # A ball of the brain's volume has radius^2 / 6 at its center.
    assert 50.0 < u.max() < (3 * 1.74e6 / 4 / np.pi) ** (2 / 3) / 6
    assert picture_is_drawn(tmp_path / "u.png")


def test_elasticity(brain_mesh, tmp_path):
    run(tmp_path, "solve_elasticity.py", brain_mesh, "sagging.vtu", "--picture", "sagging.png")
    sag = pyvista.read(tmp_path / "sagging.vtu")["displacement"]
    assert sag[:, 2].mean() < -0.3
    assert picture_is_drawn(tmp_path / "sagging.png")


def test_pictures(brain_mesh, tmp_path):
    run(tmp_path, "draw_mesh.py", brain_mesh, "brain")
    for name in ("surface", "cut", "quality"):
        assert picture_is_drawn(tmp_path / f"brain-{name}.png")


def test_picture_of_a_slice(brain_mesh, tmp_path):
    run(tmp_path, "draw_slice.py", BRAIN, "slice.png", brain_mesh, brain_mesh, "--position", 10)
    assert picture_is_drawn(tmp_path / "slice.png")


def test_study(tmp_path):
    (tmp_path / "broken.nii.gz").write_bytes(b"no image")
    templates = BRAIN.parent
    images = [templates / "ch2bet.nii.gz", templates / "inia19-t1-brain.nii.gz", tmp_path / "broken.nii.gz"]
    options = ["--output", "study", "--between", 1, 1e9, "--delta", 6]

    def study(these):
        result = run(tmp_path, "mesh_subjects.py", *these, *options)
        with open(tmp_path / "study" / "study.csv", newline="") as file:
            return result, {row["subject"]: row for row in csv.DictReader(file)}

    result, rows = study(images)
    assert {subject: row["status"] for subject, row in rows.items()} == {
        "ch2bet.nii.gz": "done",
        "inia19-t1-brain.nii.gz": "done",
        "broken.nii.gz": "failed",
    }
    assert "broken.nii.gz" in rows["broken.nii.gz"]["reason"] and "broken.nii.gz" in result.stderr
    assert "3/3, 1 failed" in result.stdout
    for subject in ("ch2bet.nii.gz", "inia19-t1-brain.nii.gz"):
        row = rows[subject]
        grid = pyvista.read(tmp_path / "study" / f"{subject}.vtu")
        assert int(row["tetrahedra"]) == grid.n_cells
        assert float(row["volume"]) == pytest.approx(grid.volume, rel=1e-3)
        assert float(row["largest_radius_edge_ratio"]) < 2.0
        assert float(row["smallest_triangle_angle"]) > 30.0
        assert 0.0 < float(row["smallest_dihedral_angle"]) < 70.53 < float(row["largest_dihedral_angle"])

    # Only the failed one is tried again.
    result, again = study(images)
    assert "1 subjects to mesh, 2 finished before" in result.stdout
    assert again["ch2bet.nii.gz"] == rows["ch2bet.nii.gz"]
