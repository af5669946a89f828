"""Grows a region from a seed, by connected threshold or as a basin of a watershed, and meshes it.

python grow_and_mesh.py /usr/share/mricron/templates/ch2bet.nii.gz white.vtu --seed -26 -20 26 --between 90 130
"""

import argparse

import itk
import numpy as np

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("image", help="any 3D image that ITK reads")
parser.add_argument("output", help="ends in .vtu or .vtk")
parser.add_argument("--seed", type=float, nargs=3, required=True, metavar=("X", "Y", "Z"), help="mm, physical space")
parser.add_argument("--between", type=float, nargs=2, metavar=("LOWER", "UPPER"), help="grey values of the region")
parser.add_argument("--level", type=float, default=0.1, help="of the watershed, used without --between; default: 0.1")
parser.add_argument("--delta", type=float, default=2.0, help="mm, default: 2")
arguments = parser.parse_args()

image = itk.imread(arguments.image, itk.F)
seed = image.TransformPhysicalPointToIndex(arguments.seed)
if arguments.between:
    lower, upper = arguments.between
    region = itk.connected_threshold_image_filter(image, seed=seed, lower=lower, upper=upper, replace_value=1)
    # Its values are of the image's type; labels are integers.
    region = region.astype(itk.UC)
    label = 1
else:
    edges = itk.gradient_magnitude_recursive_gaussian_image_filter(image, sigma=1.5)
    # Watersheds are slow: half the resolution, an eighth of the time.
    edges = itk.shrink_image_filter(edges, shrink_factors=[2, 2, 2])
    seed = edges.TransformPhysicalPointToIndex(arguments.seed)
    region = itk.watershed_image_filter(edges, threshold=0.01, level=arguments.level)
    label = int(region.GetPixel(seed))
share = np.mean(itk.array_view_from_image(region) == label)
print(f"The region is {share:.1%} of the image")
mesh = itk.delaunay_refinement_mesh_filter(region, labels=[label], delta=arguments.delta, largest_component_only=True)
itk.tetrahedral_mesh_writer(mesh, file_name=arguments.output)
print(f"{mesh.GetNumberOfCells()} tetrahedra with the label {label} in {arguments.output}")
