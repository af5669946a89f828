"""Draws a slice of an image off screen with the outlines of meshes on it, a panel for each mesh.

python draw_slice.py brain.nii.gz sulci.png coarse.vtu fine.vtu
python draw_slice.py brain.nii.gz sulci.png coarse.vtu --axis y --position -20 --threshold 1
"""

import argparse

import itk
import numpy as np
import pyvista

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("image", help="3D, with axes along those of space")
parser.add_argument("picture", help="to write")
parser.add_argument("meshes", nargs="+", help="of tetrahedra, as the filter's writer writes them")
parser.add_argument("--axis", choices="xyz", default="z", help="across the slice; default: z")
parser.add_argument("--position", type=float, help="of the slice along the axis, in mm; default: the image's middle")
parser.add_argument("--threshold", type=float, help="shows values from here on in one color")
arguments = parser.parse_args()

image = itk.imread(arguments.image)
values = itk.array_view_from_image(image).transpose()
if arguments.threshold is not None:
    values = (values >= arguments.threshold).astype(np.uint8)
directions = np.array(image.GetDirection()).reshape(3, 3)
if not np.allclose(np.abs(directions), np.eye(3)):
    raise SystemExit(f"{arguments.image} has oblique axes: resample it")
signs = np.diag(directions)
spacing = np.array(image.GetSpacing())
origin = np.array(image.GetOrigin())
values = values[tuple(slice(None, None, int(sign)) for sign in signs)]
origin = np.where(signs > 0, origin, origin - (np.array(values.shape) - 1) * spacing)
grid = pyvista.ImageData(dimensions=values.shape, spacing=spacing, origin=origin)
grid["values"] = values.ravel(order="F")

place = np.array(grid.center)
axis = "xyz".index(arguments.axis)
if arguments.position is not None:
    place[axis] = arguments.position
cut = {"normal": arguments.axis, "origin": place}

plotter = pyvista.Plotter(
    off_screen=True, shape=(1, len(arguments.meshes)), window_size=(700 * len(arguments.meshes), 700)
)
for i, name in enumerate(arguments.meshes):
    plotter.subplot(0, i)
    plotter.add_mesh(grid.slice(**cut), cmap="gray", show_scalar_bar=False, lighting=False)
    outline = pyvista.read(name).extract_surface(algorithm="dataset_surface").slice(**cut)
    plotter.add_mesh(outline, color="#ff6020", line_width=3, lighting=False)
    plotter.view_vector(np.eye(3)[axis], viewup=np.eye(3)[2 if axis < 2 else 1])
    plotter.enable_parallel_projection()
    plotter.reset_camera(bounds=outline.bounds)
    plotter.camera.zoom(1.3)
plotter.screenshot(arguments.picture)
