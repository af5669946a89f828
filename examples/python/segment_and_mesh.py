"""Finds the object in a grey image by Otsu's threshold, or between two grey values, and meshes it.

python segment_and_mesh.py /usr/share/mricron/templates/ch2bet.nii.gz brain.vtu
"""

import argparse

import itk

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("image", help="any 3D image that ITK reads")
parser.add_argument("output", help="ends in .vtu or .vtk")
parser.add_argument("--delta", type=float, default=3.0, help="mm, default: 3")
parser.add_argument("--between", type=float, nargs=2, metavar=("LOWER", "UPPER"), help="instead of Otsu's threshold")
arguments = parser.parse_args()

image = itk.imread(arguments.image)
if arguments.between:
    lower, upper = arguments.between
    types = (itk.Image[itk.F, 3], itk.Image[itk.UC, 3])
    mask = itk.binary_threshold_image_filter(
        image.astype(itk.F), lower_threshold=lower, upper_threshold=upper, inside_value=1, ttype=types
    )
else:
    # "Inside" is what is darker than the threshold.
    mask = itk.otsu_threshold_image_filter(image, inside_value=0, outside_value=1)
mesh = itk.delaunay_refinement_mesh_filter(mask, delta=arguments.delta, largest_component_only=True)
itk.tetrahedral_mesh_writer(mesh, file_name=arguments.output)
print(f"{mesh.GetNumberOfCells()} tetrahedra in {arguments.output}")
