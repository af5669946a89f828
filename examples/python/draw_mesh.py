"""Draws a mesh off screen: its surface, a cut through the interior, and the cut colored by quality. Several labels have
a color each.

python draw_mesh.py brain.vtu brain     # brain-surface.png, brain-cut.png, brain-quality.png
"""

import argparse

import numpy as np
import pyvista

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("mesh", help="of tetrahedra, as the filter's writer writes it")
parser.add_argument("prefix", help="of the pictures' names")
arguments = parser.parse_args()

grid = pyvista.read(arguments.mesh)
p = grid.points[grid.cells_dict[pyvista.CellType.TETRA]].astype(float)
edges = p[:, 1:] - p[:, :1]
centers = np.linalg.solve(2.0 * edges, (edges**2).sum(axis=2)[..., None])[..., 0]
lengths = [np.linalg.norm(p[:, i] - p[:, j], axis=1) for i in range(4) for j in range(i)]
grid["radius-edge ratio"] = np.linalg.norm(centers, axis=1) / np.min(lengths, axis=0)
print(f"{grid.n_cells} tetrahedra, largest radius-edge ratio {grid['radius-edge ratio'].max():.3f}")

labels = np.unique(grid["label"])
grid["color"] = np.searchsorted(labels, grid["label"]) % 20
plain = {"color": "#e8c8b0"}
if len(labels) > 1:
    plain = {"scalars": "color", "clim": (0, 20), "cmap": "tab20", "show_scalar_bar": False}

# Whole tetrahedra on one side of the middle.
cut = grid.clip("x", crinkle=True)
surface = grid.extract_surface(algorithm="dataset_surface")
ours = {"show_edges": True, "edge_color": "#404040", "line_width": 0.5}
for name, what, options in (
    ("surface", surface, {**plain, **ours}),
    ("cut", cut, {**plain, **ours}),
    (
        "quality",
        cut,
        {
            "scalars": "radius-edge ratio",
            "clim": (0.6, 2.0),
            "cmap": "viridis",
            "scalar_bar_args": {"vertical": True},
            **ours,
        },
    ),
):
    plotter = pyvista.Plotter(off_screen=True, window_size=(900, 700))
    plotter.add_mesh(what, **options)
    plotter.view_yz(negative=False)
    plotter.camera.zoom(1.4)
    plotter.screenshot(f"{arguments.prefix}-{name}.png")
