"""Solves Poisson's equation in a mesh: -div grad u = 1 inside, u = 0 on the boundary.

python solve_poisson.py brain.vtu u.vtu --picture u.png
"""

import argparse

import meshio
import numpy as np
import pyvista
from skfem import Basis, ElementTetP1, MeshTet, condense, solve
from skfem.models.poisson import laplace, unit_load

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("mesh", help="of tetrahedra, as the filter's writer writes it")
parser.add_argument("output", help="the mesh with the solution, for example u.vtu")
parser.add_argument("--picture", help="a cut through the solution, for example u.png")
arguments = parser.parse_args()

grid = meshio.read(arguments.mesh)
points, tetrahedra = grid.points, grid.cells_dict["tetra"]
basis = Basis(MeshTet(points.T, tetrahedra.T), ElementTetP1())
matrix, load = laplace.assemble(basis), unit_load.assemble(basis)
boundary = basis.get_dofs()
u = solve(*condense(matrix, load, D=boundary))

inside = np.setdiff1d(np.arange(len(u)), boundary.all())
residual = np.linalg.norm((matrix @ u - load)[inside]) / np.linalg.norm(load)
print(f"{len(u)} unknowns, largest value {u.max():.1f} mm^2, residual {residual:.1e}")
assert residual < 1e-8

grid.point_data["u"] = u
grid.write(arguments.output)
if arguments.picture:
    plotter = pyvista.Plotter(off_screen=True, window_size=(900, 700))
    cut = pyvista.from_meshio(grid).clip("x", crinkle=True)
    plotter.add_mesh(cut, scalars="u", cmap="viridis", scalar_bar_args={"title": "u (mm^2)", "vertical": True})
    plotter.view_yz(negative=False)
    plotter.camera.zoom(1.4)
    plotter.screenshot(arguments.picture)
