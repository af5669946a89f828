"""What a process sees: threads, memory, pickles, other libraries' VTK."""

import importlib.metadata
import pickle
import subprocess
import sys
import threading
import time

import itk
import numpy as np
import pytest
from conftest import ball, needed
from mesh_checks import assert_guarantees


def arrays(mesh):
    return itk.arrays_from_tetrahedral_mesh(mesh)


def same(a, b):
    return all(np.array_equal(x, y) for x, y in zip(arrays(a), arrays(b)))


@pytest.mark.parametrize("mesh_type", [itk.Mesh[itk.F, 3], itk.Mesh[itk.D, 3]])
def test_meshes_pickle(mesh_type):
    image = ball(value=3)
    mesh = itk.delaunay_refinement_mesh_filter(image, delta=2.0, ttype=(type(image), mesh_type))
    back = pickle.loads(pickle.dumps(mesh))
    assert type(back) is type(mesh)
    assert same(mesh, back)
    assert_guarantees(arrays(back))


def test_arrays_pickle():
    a = arrays(itk.delaunay_refinement_mesh_filter(ball(), delta=2.0))
    b = pickle.loads(pickle.dumps(a))
    assert type(a) is type(b) and all(np.array_equal(x, y) for x, y in zip(a, b))


def test_two_filters_in_two_threads():
    images = [ball(), ball(radius=9.0)]
    expected = [itk.delaunay_refinement_mesh_filter(i, delta=0.7) for i in images]
    results = [None, None]

    def run(k):
        results[k] = itk.delaunay_refinement_mesh_filter(images[k], delta=0.7)

    threads = [threading.Thread(target=run, args=(k,)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(same(a, b) for a, b in zip(expected, results))


def test_other_threads_go_on(brain):
    steps = []
    done = threading.Event()

    def count():
        while not done.is_set():
            steps.append(time.perf_counter())
            time.sleep(0.01)

    thread = threading.Thread(target=count)
    thread.start()
    time.sleep(0.1)
    start = time.perf_counter()
    itk.delaunay_refinement_mesh_filter(brain, lower_threshold=1, delta=2.0)
    end = time.perf_counter()
    done.set()
    thread.join()
    during = [t for t in steps if start < t < end]
    assert len(during) > 10 * (end - start)


def resident_kilobytes():
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS"))


def test_a_hundred_runs_do_not_grow_the_process():
    image = ball()

    def run(times):
        for _ in range(times):
            arrays(itk.delaunay_refinement_mesh_filter(image, delta=1.0))
            with pytest.raises(RuntimeError):
                itk.delaunay_refinement_mesh_filter(image, delta=1.0, maximum_number_of_vertices=500)
        return resident_kilobytes()

    before = run(20)
    after = run(100)
    print(f"{before} kB after 20 runs, {after} kB after 120")
    one_mesh = 4000
    assert after - before < 5 * one_mesh


def test_metadata():
    metadata = importlib.metadata.metadata("itk-delaunayrefinement")
    assert metadata["License-Expression"] == "Apache-2.0 AND BSD-3-Clause AND LGPL-3.0-or-later"
    assert metadata["Requires-Python"] == ">=3.11"
    files = importlib.metadata.files("itk-delaunayrefinement")
    assert {"LGPL-3.0.txt", "GPL-3.0.txt", "LICENSES.md", "LICENSE"} <= {file.name for file in files}
    # Under names that no other VTK in the process has.
    assert not any(file.name.endswith("-9.1.so.1") for file in files)


WRITE = """
mesh = itk.delaunay_refinement_mesh_filter(image, delta=2.0)
itk.tetrahedral_mesh_writer(mesh, file_name=folder + "/a.vtu")
"""
READ = """
reader = vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(folder + "/a.vtu")
reader.Update()
assert reader.GetOutput().GetNumberOfCells() == mesh.GetNumberOfCells()
writer = vtk.vtkXMLUnstructuredGridWriter()
writer.SetFileName(folder + "/b.vtu")
writer.SetInputData(reader.GetOutput())
writer.Write()
import pyvista
assert pyvista.read(folder + "/b.vtu").extract_surface(algorithm="dataset_surface").n_cells > 50
print(vtk.vtkVersion.GetVTKVersion())
"""


@pytest.mark.parametrize("order", ["vtk first", "ours first", "vtk after a file"])
def test_vtk_of_others_in_one_process(tmp_path, order):
    make = "import sys; folder = sys.argv[1]; import itk, numpy; a = numpy.zeros((12, 12, 12), 'uint8')\n"
    make += "a[2:9, 2:9, 2:9] = 1\nimage = itk.image_from_array(a)\n"
    ours, theirs = "itk.DelaunayRefinementMeshFilter\n", "import vtk\nvtk.vtkSphereSource().Update()\n"
    program = (
        {
            "vtk first": theirs + make + ours + WRITE,
            "ours first": make + ours + theirs + WRITE,
            "vtk after a file": make + WRITE + theirs,
        }[order]
        + READ
        + WRITE
    )
    result = subprocess.run([sys.executable, "-c", program, str(tmp_path)], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert result.stdout.strip() != "9.1.0" and result.stderr == ""


@pytest.mark.parametrize("mesh_type, name", [(itk.F, "float"), (itk.D, "double")])
def test_same_mesh_as_in_cxx(tmp_path, brain, mesh_type, name):
    """Point for point what a C++ program makes that is built with the same ITK."""
    program = needed("DELAUNAY_REFINEMENT_CXX_PROGRAM")
    subprocess.run([program, name, "/usr/share/mricron/templates/ch2bet.nii.gz", str(tmp_path / "mesh")], check=True)
    points = np.fromfile(tmp_path / "mesh.points", np.float32).reshape(-1, 3)
    cells = np.fromfile(tmp_path / "mesh.cells", np.uint64).reshape(-1, 4)
    mesh = itk.delaunay_refinement_mesh_filter(
        brain, lower_threshold=1, delta=3.0, ttype=(type(brain), itk.Mesh[mesh_type, 3])
    )
    assert np.array_equal(arrays(mesh).points, points)
    assert np.array_equal(arrays(mesh).cells, cells)
