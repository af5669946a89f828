"""Meshes a NumPy array that lies obliquely in space, and shows that the mesh lies there too.

python array_to_mesh.py torus.vtu
"""

import argparse
import math

import itk
import numpy as np

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("output", help="ends in .vtu or .vtk")
arguments = parser.parse_args()

# Index [k, j, i]: ITK counts the other way round. Anisotropic voxels.
k, j, i = np.indices((20, 64, 64))
spacing = np.array([1.0, 1.0, 1.5])
x, y, z = (i - 31.5) * spacing[0], (j - 31.5) * spacing[1], (k - 9.5) * spacing[2]
torus = (np.hypot(np.hypot(x, y) - 20.0, z) < 8.0).astype(np.uint8)

angle = math.radians(30.0)
origin = np.array([100.0, -50.0, 20.0])
direction = np.array(
    [
        [math.cos(angle), 0.0, math.sin(angle)],
        [0.0, 1.0, 0.0],
        [-math.sin(angle), 0.0, math.cos(angle)],
    ]
)
image = itk.image_from_array(torus)
image.SetSpacing(spacing)
image.SetOrigin(origin)
image.SetDirection(direction)
mesh = itk.delaunay_refinement_mesh_filter(image, delta=2.0)
points, tetrahedra, labels = itk.arrays_from_tetrahedral_mesh(mesh)
itk.tetrahedral_mesh_writer(mesh, file_name=arguments.output)

center = origin + direction @ (spacing * [31.5, 31.5, 9.5])
print(f"{len(tetrahedra)} tetrahedra around {points.mean(axis=0)}; the torus is centered at {center}")
assert np.linalg.norm(points.mean(axis=0) - center) < 0.5
