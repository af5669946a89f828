"""What the shape of tetrahedra costs a finite-element solver.

    solver_study.py [NAME=]MESH ... [--json FILE]

Each MESH (.vtu or .vtk) gives one row of a Markdown table: tetrahedra, smallest dihedral angle, and for two problems
with linear elements the condition number of the stiffness matrix and the iterations of conjugate gradients.

- Poisson: -div grad u = 1, u = 0 on the whole boundary.
- Linear elasticity: E = 1, nu = 0.3, a body force of 1 along the last axis; the boundary nodes in the lowest tenth of
  the mesh's extent along that axis are fixed.

Matrices are those left after fixed nodes are eliminated; a condition number is the largest eigenvalue over the
smallest. Conjugate gradients start at zero and end when the residual is 1e-8 of the right-hand side, without a
preconditioner and with the matrix's diagonal.

Only the largest component of the mesh is used, tetrahedra joined over faces, because a piece that no fixed node holds
would make the matrix of elasticity singular. The counts and angles are of that component.

Needs numpy, scipy, meshio and scikit-fem 12 or later.
"""

import argparse
import itertools
import json

import meshio
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.csgraph as csgraph
import scipy.sparse.linalg as linalg
import skfem
from skfem.helpers import dot, grad
from skfem.models.elasticity import lame_parameters, linear_elasticity

YOUNGS_MODULUS, POISSONS_RATIO = 1.0, 0.3
RESIDUAL = 1e-8
# Looser than the default of machine precision: condition numbers are told in three digits.
EIGENVALUE_TOLERANCE = 1e-5
MAXIMUM_ITERATIONS = 100_000


def largest_component(mesh):
    """The largest set of tetrahedra joined over faces, with the nodes that it uses."""
    first, second = mesh.f2t[:, mesh.f2t[1] >= 0]
    pairs = sparse.coo_matrix((np.ones(first.size), (first, second)), shape=2 * (mesh.nelements,))
    _, component = csgraph.connected_components(pairs, directed=False)
    return mesh.restrict(np.flatnonzero(component == np.bincount(component).argmax()))


def read_mesh(file):
    """The tetrahedra of a file as a scikit-fem mesh; triangles and nodes beside them are left out."""
    source = meshio.read(file)
    tetrahedra = np.vstack([block.data for block in source.cells if block.type == "tetra"])
    used, nodes = np.unique(tetrahedra, return_inverse=True)
    points, corners = source.points[used].T.astype(float), nodes.reshape(tetrahedra.shape).T
    return largest_component(skfem.MeshTet(np.ascontiguousarray(points), np.ascontiguousarray(corners)))


def smallest_dihedral_angle(mesh):
    """In degrees."""
    corners = mesh.p[:, mesh.t]
    smallest = np.pi
    for a, b in itertools.combinations(range(4), 2):
        c, d = set(range(4)) - {a, b}
        edge = corners[:, b] - corners[:, a]
        normals = [np.cross(edge, corners[:, k] - corners[:, a], axis=0) for k in (c, d)]
        # atan2 keeps its digits where the cosine of a small angle has none left.
        sine = np.linalg.norm(np.cross(*normals, axis=0), axis=0)
        smallest = min(smallest, np.arctan2(sine, (normals[0] * normals[1]).sum(axis=0)).min())
    return np.degrees(smallest)


def poisson(mesh):
    """Matrix and right-hand side without the fixed nodes."""
    basis = skfem.Basis(mesh, skfem.ElementTetP1())
    matrix = skfem.BilinearForm(lambda u, v, w: dot(grad(u), grad(v))).assemble(basis)
    force = skfem.LinearForm(lambda v, w: 1.0 * v).assemble(basis)
    return skfem.condense(matrix, force, D=basis.get_dofs(), expand=False)


def elasticity(mesh):
    """Matrix and right-hand side without the fixed nodes."""
    basis = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementTetP1()))
    matrix = linear_elasticity(*lame_parameters(YOUNGS_MODULUS, POISSONS_RATIO)).assemble(basis)
    force = skfem.LinearForm(lambda v, w: v[2]).assemble(basis)
    nodes = mesh.boundary_nodes()
    height = mesh.p[2]
    fixed = nodes[height[nodes] <= height.min() + 0.1 * np.ptp(height)]
    return skfem.condense(matrix, force, D=basis.nodal_dofs[:, fixed].ravel(), expand=False)


def condition_number(matrix):
    """Largest eigenvalue over smallest, the latter by the inverse."""
    start = np.random.default_rng(1).normal(size=matrix.shape[0])
    largest = linalg.eigsh(matrix, 1, which="LA", v0=start, tol=EIGENVALUE_TOLERANCE, return_eigenvectors=False)[0]
    # COLAMD, the default order, fills a symmetric matrix several times as much.
    factors = linalg.splu(
        matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
    )
    inverse = linalg.LinearOperator(matrix.shape, factors.solve, dtype=float)
    reciprocal = linalg.eigsh(inverse, 1, which="LA", v0=start, tol=EIGENVALUE_TOLERANCE, return_eigenvectors=False)[0]
    return largest * reciprocal


def iterations(matrix, force, preconditioner=None):
    """Of conjugate gradients."""
    count = itertools.count()
    _, failed = linalg.cg(
        matrix, force, rtol=RESIDUAL, maxiter=MAXIMUM_ITERATIONS, M=preconditioner, callback=lambda _: next(count)
    )
    return np.nan if failed else next(count)


def diagonal(matrix):
    """The Jacobi preconditioner."""
    return sparse.diags(1 / matrix.diagonal())


def study(file):
    """One mesh's figures, in the order of the table."""
    mesh = read_mesh(file)
    row = {"tetrahedra": mesh.nelements, "smallest dihedral angle": smallest_dihedral_angle(mesh)}
    for name, problem in (("Poisson", poisson), ("elasticity", elasticity)):
        matrix, force = problem(mesh)[:2]
        row[name + " unknowns"] = matrix.shape[0]
        row[name + " condition"] = condition_number(matrix)
        row[name + " CG"] = iterations(matrix, force)
        row[name + " CG Jacobi"] = iterations(matrix, force, diagonal(matrix))
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+", metavar="[NAME=]MESH", help=".vtu or .vtk")
    parser.add_argument("--json", help="also write the rows to this file")
    arguments = parser.parse_args()
    rows = {}
    for argument in arguments.meshes:
        name, _, file = argument.rpartition("=")
        row = rows[name or file] = study(file)
        if len(rows) == 1:
            print("| mesh |", " | ".join(row), "|")
            print("|---" * (len(row) + 1) + "|")
        figures = (format(value, ",d" if isinstance(value, int) else ".3g") for value in row.values())
        print("|", name or file, "|", " | ".join(figures), "|", flush=True)
    if arguments.json:
        with open(arguments.json, "w") as out:
            json.dump(rows, out, indent=2)


if __name__ == "__main__":
    main()
