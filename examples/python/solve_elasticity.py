"""Solves linear elasticity in a mesh: a soft body under its own weight, held where it is lowest.

python solve_elasticity.py brain.vtu sagging.vtu --picture sagging.png
"""

import argparse

import meshio
import numpy as np
import pyvista
from scipy.sparse import diags
from scipy.sparse.linalg import cg
from skfem import Basis, ElementTetP1, ElementVector, LinearForm, MeshTet, condense, solve
from skfem.models.elasticity import lame_parameters, linear_elasticity

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("mesh", help="of tetrahedra, as the filter's writer writes it")
parser.add_argument("output", help="the mesh with the displacement, for example sagging.vtu")
parser.add_argument("--picture", help="the deformed surface, for example sagging.png")
parser.add_argument("--stiffness", type=float, default=30000.0, help="Young's modulus in Pa, default: 30000")
arguments = parser.parse_args()

grid = meshio.read(arguments.mesh)
points, tetrahedra = grid.points, grid.cells_dict["tetra"]
basis = Basis(MeshTet(points.T, tetrahedra.T), ElementVector(ElementTetP1()))

# Lengths in mm and forces in uN: then stresses are in Pa, and water weighs 9.81 uN per mm^3.
matrix = linear_elasticity(*lame_parameters(arguments.stiffness, 0.45)).assemble(basis)
weight = LinearForm(lambda v, _: -9.81 * v[2]).assemble(basis)
height = np.ptp(points[:, 2])
held = basis.get_dofs(lambda x: x[2] < points[:, 2].min() + 0.15 * height)


def conjugate_gradients(a, b):
    # A direct solver would need far more memory.
    u, failed = cg(a, b, rtol=1e-8, M=diags(1.0 / a.diagonal()), maxiter=10000)
    assert not failed
    return u


u = solve(*condense(matrix, weight, D=held), solver=conjugate_gradients)
free = np.setdiff1d(np.arange(len(u)), held.all())
residual = np.linalg.norm((matrix @ u - weight)[free]) / np.linalg.norm(weight)
displacement = u[basis.nodal_dofs].T
largest = np.linalg.norm(displacement, axis=1).max()
print(f"{len(u)} unknowns, largest displacement {largest:.1f} mm, residual {residual:.1e}")
assert residual < 1e-6 and 0.0 < largest < height

grid.point_data["displacement"] = displacement
grid.write(arguments.output)
if arguments.picture:
    deformed = pyvista.from_meshio(grid).warp_by_vector("displacement")
    deformed["sag (mm)"] = np.linalg.norm(displacement, axis=1)
    plotter = pyvista.Plotter(off_screen=True, window_size=(900, 700))
    plotter.add_mesh(
        deformed.extract_surface(algorithm="dataset_surface"),
        scalars="sag (mm)",
        cmap="magma",
        scalar_bar_args={"vertical": True},
    )
    plotter.view_yz()
    plotter.camera.zoom(1.4)
    plotter.screenshot(arguments.picture)
