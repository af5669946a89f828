"""What an ITK build tree runs: meshes a box and writes it to the file that is named. ITK itself imports NumPy."""

import itertools
import os
import sys

import itk

image = itk.Image[itk.UC, 3].New()
image.SetRegions([12, 12, 12])
image.Allocate(True)
for index in itertools.product(range(3, 9), repeat=3):
    image.SetPixel(list(index), 1)

mesh = itk.delaunay_refinement_mesh_filter(image, delta=1.5)
assert mesh.GetNumberOfCells() > 100
for i in range(mesh.GetNumberOfPoints()):
    assert all(2.4 < x < 8.6 for x in mesh.GetPoint(i))

itk.tetrahedral_mesh_writer(mesh, file_name=sys.argv[1])
assert os.path.getsize(sys.argv[1]) > 1000

try:
    itk.delaunay_refinement_mesh_filter(image, delta=-1.0)
except RuntimeError as error:
    assert "Delta is -1; it must be a positive, finite length" in str(error)
else:
    raise AssertionError("A negative delta was taken")
