"""Meshes many subjects with Dask, a task each, and tabulates sizes and qualities.

python mesh_subjects.py /usr/share/mricron/templates/ch2*.nii.gz --output study --between 1 255 --delta 6

A subject that fails has its reason in the table and stops no other. One that is finished is skipped when the study is
run again. By default the tasks run on this machine; --scheduler takes the address of any Dask cluster that has this
package installed and shares the files.
"""

import argparse
import csv
import math
import pathlib
import sys
import time

from dask.distributed import Client, as_completed

COLUMNS = (
    "subject status seconds delta points tetrahedra triangles volume smallest_dihedral_angle largest_dihedral_angle "
    "largest_radius_edge_ratio smallest_triangle_angle reason"
).split()


def measure(points, tetrahedra, boundary_points, triangles):
    """What the table says of a mesh: volume (mm^3), angles (degrees) and the radius-edge ratio."""
    import numpy as np

    p = points.astype(float)[tetrahedra]
    edges = p[:, 1:] - p[:, :1]
    centers = np.linalg.solve(2.0 * edges, (edges**2).sum(axis=2)[..., None])[..., 0]
    pairs = [(i, j) for i in range(4) for j in range(i)]
    shortest = np.min([np.linalg.norm(p[:, i] - p[:, j], axis=1) for i, j in pairs], axis=0)
    # Outward normals of the faces opposite each corner.
    faces = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]
    normals = [np.cross(p[:, b] - p[:, a], p[:, c] - p[:, a]) for a, b, c in faces]
    normals = [n / np.linalg.norm(n, axis=1)[:, None] for n in normals]
    dihedral = [180.0 - np.degrees(np.arccos(np.clip((normals[i] * normals[j]).sum(1), -1, 1))) for i, j in pairs]
    t = boundary_points.astype(float)[triangles]
    sides = [t[:, (i + 1) % 3] - t[:, i] for i in range(3)]
    sides = [s / np.linalg.norm(s, axis=1)[:, None] for s in sides]
    angles = [np.degrees(np.arccos(np.clip((-sides[i] * sides[i - 1]).sum(1), -1, 1))) for i in range(3)]
    return {
        "points": len(points),
        "tetrahedra": len(tetrahedra),
        "triangles": len(triangles),
        "volume": np.linalg.det(edges).sum() / 6.0,
        "smallest_dihedral_angle": np.min(dihedral),
        "largest_dihedral_angle": np.max(dihedral),
        "largest_radius_edge_ratio": (np.linalg.norm(centers, axis=1) / shortest).max(),
        "smallest_triangle_angle": np.min(angles),
    }


def mesh_subject(subject, image_name, mesh_name, delta, between):
    """One task: a row of the table, whatever happens."""
    import itk

    start = time.perf_counter()
    row = {"subject": subject, "status": "done"}
    try:
        image = itk.imread(image_name)
        thresholds = dict(zip(("lower_threshold", "upper_threshold"), between)) if between else {}
        filter = itk.DelaunayRefinementMeshFilter.New(image, largest_component_only=True, **thresholds)
        if delta is not None:
            filter.SetDelta(delta)
        filter.Update()
        points, tetrahedra, _ = itk.arrays_from_tetrahedral_mesh(filter.GetOutput())
        boundary_points, triangles, _ = itk.arrays_from_tetrahedral_mesh(filter.GetBoundaryOutput())
        row["delta"] = filter.GetEffectiveDelta()
        row.update(measure(points, tetrahedra, boundary_points, triangles))
        itk.tetrahedral_mesh_writer(filter.GetOutput(), file_name=mesh_name)
    except Exception as error:
        row.update(status="failed", reason=" ".join(str(error).split()))
    row["seconds"] = time.perf_counter() - start
    return {key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}


def name_subjects(images):
    """The files' names, with as many folders before them as tell all apart."""
    for count in range(1, max(len(image.parts) for image in images) + 1):
        names = ["_".join(part for part in image.parts[-count:] if part != "/") for image in images]
        if len(set(names)) == len(images):
            return dict(zip(names, images))
    raise SystemExit("An image is named twice")


def read_table(name):
    if not name.exists():
        return {}
    with name.open(newline="") as file:
        return {row["subject"]: row for row in csv.DictReader(file)}


def write_table(name, rows):
    # At once whole or not at all: a study may be stopped at any time.
    new = name.with_suffix(".new")
    with new.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, restval="")
        writer.writeheader()
        writer.writerows(rows[subject] for subject in sorted(rows))
    new.replace(name)


def show(done, failed, total):
    width = 40
    filled = math.floor(width * done / total) if total else width
    end = "" if done < total else "\n"
    print(f"\r[{'#' * filled}{'.' * (width - filled)}] {done}/{total}, {failed} failed", end=end, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("images", nargs="+", help="a subject each")
    parser.add_argument("--output", type=pathlib.Path, default="study", help="folder of meshes and of study.csv")
    parser.add_argument("--delta", type=float, help="mm; default: chosen for each image")
    parser.add_argument("--between", type=float, nargs=2, metavar=("LOWER", "UPPER"), help="grey values of the object")
    parser.add_argument("--scheduler", help="address of a Dask scheduler; default: this machine")
    arguments = parser.parse_args()

    arguments.output.mkdir(parents=True, exist_ok=True)
    table = arguments.output / "study.csv"
    rows = read_table(table)

    tasks = {}
    for subject, image in name_subjects([pathlib.Path(name).resolve() for name in arguments.images]).items():
        mesh = arguments.output.resolve() / f"{subject}.vtu"
        if rows.get(subject, {}).get("status") == "done" and mesh.exists():
            continue
        tasks[subject] = (subject, str(image), str(mesh), arguments.delta, arguments.between)
    skipped = len(arguments.images) - len(tasks)
    print(f"{len(tasks)} subjects to mesh, {skipped} finished before")
    if not tasks:
        return 0

    failed = 0
    # A process for each worker: a crash takes one with it and no more.
    with Client(arguments.scheduler) if arguments.scheduler else Client(threads_per_worker=1) as client:
        futures = {client.submit(mesh_subject, *task, pure=False): subject for subject, task in tasks.items()}
        show(0, 0, len(tasks))
        for done, future in enumerate(as_completed(futures), start=1):
            subject = futures[future]
            if future.status == "finished":
                rows[subject] = future.result()
            else:
                reason = " ".join(str(future.exception()).split())
                rows[subject] = {"subject": subject, "status": "failed", "reason": reason}
            failed += rows[subject]["status"] == "failed"
            write_table(table, rows)
            show(done, failed, len(tasks))
    for subject in tasks:
        if rows[subject]["status"] == "failed":
            print(f"{subject}: {rows[subject]['reason']}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
