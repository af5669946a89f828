"""The guarantees of docs/guarantees.md, measured on arrays as they are stored."""

import numpy as np

MARGIN = 1e-9
FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


def corners(points, cells):
    return points.astype(np.float64)[cells]


def volumes(points, tetrahedra):
    p = corners(points, tetrahedra)
    return np.linalg.det(p[:, 1:] - p[:, :1]) / 6.0


def radius_edge_ratios(points, tetrahedra):
    p = corners(points, tetrahedra)
    edges = p[:, 1:] - p[:, :1]
    centers = np.linalg.solve(2.0 * edges, (edges**2).sum(axis=2)[..., None])[..., 0]
    radii = np.linalg.norm(centers, axis=1)
    pairs = [(i, j) for i in range(4) for j in range(i)]
    shortest = np.min([np.linalg.norm(p[:, i] - p[:, j], axis=1) for i, j in pairs], axis=0)
    return radii / shortest


def boundary_triangles(tetrahedra):
    """Faces of one tetrahedron only, counterclockwise as seen from outside."""
    faces = np.concatenate([tetrahedra[:, face] for face in FACES])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    assert count.max() <= 2
    return faces[first[count == 1]]


def planar_angles(points, triangles):
    p = corners(points, triangles)
    angles = []
    for i in range(3):
        a = p[:, (i + 1) % 3] - p[:, i]
        b = p[:, (i + 2) % 3] - p[:, i]
        cosines = (a * b).sum(axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
        angles.append(np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0))))
    return np.stack(angles, axis=1)


def enclosed_volume(points, triangles):
    p = corners(points - points.mean(axis=0), triangles)
    return np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2])).sum() / 6.0


def assert_guarantees(arrays, bound=2.0):
    points, tetrahedra, _ = arrays
    assert len(tetrahedra) > 0
    assert np.array_equal(np.unique(tetrahedra), np.arange(len(points)))
    assert volumes(points, tetrahedra).min() > 0.0
    assert radius_edge_ratios(points, tetrahedra).max() <= bound * (1.0 + MARGIN)
    triangles = boundary_triangles(tetrahedra)
    assert planar_angles(points, triangles).min() >= 30.0 * (1.0 - MARGIN)
    # Closed: each edge has as many triangles on one side as on the other.
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    ways = [np.unique(way, axis=0, return_counts=True) for way in (edges, edges[:, ::-1])]
    assert all(np.array_equal(*both) for both in zip(*ways))
