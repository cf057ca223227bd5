#!/usr/bin/env python3
"""Draw a run: the deformed bodies, the contact pressure and the stick and slip zones.

    python scripts/picture.py DIRECTORY PICTURE.png

Reads the `.vtu` files with `meshio`; needs matplotlib.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.colors import ListedColormap, Normalize
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def outer_faces(cells):
    """Faces of hexahedra that belong to one cell only."""
    faces = np.concatenate([cells[:, face] for face in FACES])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]]


def main(directory, picture):
    bodies = [p for p in sorted(directory.glob("*.vtu")) if p.stem != "contact"]
    meshes = [meshio.read(path) for path in bodies]
    contact = meshio.read(directory / "contact.vtu")
    largest = max(np.abs(mesh.point_data["displacement"]).max() for mesh in meshes)
    extent = np.ptp(np.concatenate([mesh.points for mesh in meshes]), axis=0)
    factor = 0.12 * extent.max() / largest
    stress = np.concatenate([np.ravel(mesh.point_data["von_mises_stress"]) for mesh in meshes])
    colours = Normalize(0, np.quantile(stress, 0.995))

    figure = plt.figure(figsize=(12, 4.2))
    solid = figure.add_axes([0.0, 0.0, 0.42, 1.0], projection="3d", computed_zorder=False)
    for order, mesh in enumerate(meshes):
        points = mesh.points + factor * mesh.point_data["displacement"]
        faces = outer_faces(mesh.cells_dict["hexahedron"])
        value = np.ravel(mesh.point_data["von_mises_stress"])[faces].mean(axis=1)
        solid.add_collection3d(
            Poly3DCollection(points[faces], facecolors=plt.cm.viridis(colours(value)),
                             edgecolors=(0, 0, 0, 0.25), linewidths=0.2, zorder=order)
        )
    low = np.min([mesh.points.min(axis=0) for mesh in meshes], axis=0)
    solid.set(xlim=(low[0], low[0] + extent[0]), ylim=(low[1], low[1] + extent[1]), zlim=(low[2], low[2] + extent[2]))
    solid.set_box_aspect(extent)
    solid.view_init(elev=18, azim=-62)
    solid.set_axis_off()
    solid.set_title(f"von Mises stress, displacement × {factor:.0f}", y=0.92, fontsize=10)

    fields = {name: np.squeeze(values) for name, values in contact.point_data.items()}
    x, y = contact.points[:, 0], contact.points[:, 1]
    left = figure.add_axes([0.45, 0.16, 0.23, 0.66])
    pressure = left.tricontourf(x, y, fields["contact_pressure"], levels=24, cmap="magma_r")
    figure.colorbar(pressure, ax=left, orientation="horizontal", pad=0.14)
    left.set_title("contact pressure", fontsize=10)
    right = figure.add_axes([0.73, 0.16, 0.23, 0.66])
    # Two independent questions: closed or open, stick or slip.
    state = 2 * (fields["closed"] == 1) + (fields["sticking"] == 1)
    names = ["open, slips", "open, sticks", "closed, slips", "closed, sticks"]
    palette = ListedColormap(["#c6dbef", "#6baed6", "#d94801", "#7f2704"])
    right.scatter(x, y, c=state, cmap=palette, vmin=0, vmax=3, s=26, marker="s")
    moving = np.linalg.norm(fields["slip"], axis=1) > 0.02 * np.abs(fields["slip"]).max()
    right.quiver(x[moving], y[moving], fields["slip"][moving, 0], fields["slip"][moving, 1], width=0.004)
    for value in sorted(set(state)):
        right.scatter([], [], c=[palette(value)], label=names[value], marker="s")
    right.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=2, fontsize=8, frameon=False)
    right.set_title("state of the pairs, slip", fontsize=10)
    for axes in (left, right):
        axes.set_aspect("equal")
        axes.tick_params(labelsize=8)
    figure.savefig(picture, dpi=110, bbox_inches="tight")


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2])
