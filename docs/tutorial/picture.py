#!/usr/bin/env python3
"""Draws the tutorial's two runs: the bodies, the contact pressure, and what a finer mesh changes of it.

    python picture.py COARSE FINE PICTURE.png

COARSE and FINE are directories with results. Needs meshio, NumPy and matplotlib (scripts/requirements.txt).
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

FACTOR = 40  # of the displacement
ELEVATION, AZIMUTH = 42, -80  # of the eye, in degrees
# Towards the eye.
EYE = np.array([np.cos(np.radians(AZIMUTH)), np.sin(np.radians(AZIMUTH)), np.tan(np.radians(ELEVATION))])

# Faces of a tetrahedron of second order as corners and mid-side nodes, and the four triangles that draw one.
FACES = np.array([(0, 2, 1, 6, 5, 4), (0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (0, 3, 2, 7, 9, 6)])
QUARTERS = np.array([(0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)])


def skin(cells):
    """The triangles of the faces that belong to one cell only."""
    faces = np.concatenate([cells[:, face] for face in FACES])
    _, first, count = np.unique(np.sort(faces[:, :3], axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]][:, QUARTERS].reshape(-1, 3)


def draw_bodies(figure, axes, directory):
    """The quarter, seen upside down: its cuts at z = 0 and y = 0 face the reader."""
    triangles, stresses = [], []
    for name in ("pin", "lug"):
        mesh = meshio.read(directory / f"{name}.vtu")
        points = (mesh.points + FACTOR * mesh.point_data["displacement"]) * (1, 1, -1)
        faces = skin(mesh.cells_dict["tetra10"])
        corners = points[faces]
        # Turning z around turned the normals around; what looks away from the eye is hidden.
        normals = -np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        seen = normals @ EYE > 0
        triangles.append(corners[seen])
        stresses.append(np.ravel(mesh.point_data["von_mises_stress"])[faces[seen]].mean(axis=1))
    colours = Normalize(0, 150)
    stress = plt.cm.viridis(colours(np.concatenate(stresses)))
    drawn = Poly3DCollection(np.concatenate(triangles), facecolors=stress, edgecolors=stress, linewidths=0.5)
    axes.add_collection3d(drawn)
    drawn.set_clip_on(False)
    axes.set(xlim=(-22, 60), ylim=(0, 22), zlim=(-16, 0))
    axes.set_box_aspect((82, 22, 16), zoom=1.25)
    axes.set_proj_type("ortho")
    axes.view_init(elev=ELEVATION, azim=AZIMUTH)
    axes.set_axis_off()
    axes.set_title(f"von Mises stress in MPa, displacement × {FACTOR}", fontsize=10, y=0.89)
    bar = figure.add_axes([0.08, 0.14, 0.26, 0.03])
    figure.colorbar(ScalarMappable(colours, "viridis"), cax=bar, orientation="horizontal", extend="max")


def contact(directory):
    """Angle from the middle of the bearing, height and pressure at the nodes of the hole."""
    grid = meshio.read(directory / "contact.vtu")
    x, y, z = grid.points.T
    return np.degrees(np.arctan2(y, -x)), z, np.ravel(grid.point_data["contact_pressure"])


def main(coarse, fine, picture):
    figure = plt.figure(figsize=(13, 4.2))
    draw_bodies(figure, figure.add_axes([0.0, 0.1, 0.42, 0.85], projection="3d"), fine)

    angle, height, pressure = contact(fine)
    unrolled = figure.add_axes([0.48, 0.16, 0.21, 0.7])
    filled = unrolled.tricontourf(angle, height, pressure, levels=np.arange(0, 121, 10), cmap="magma_r")
    figure.colorbar(filled, ax=unrolled)
    unrolled.set(xlim=(0, 90), xlabel="angle from the pull, degrees", ylabel="z in mm")
    unrolled.set_title("contact pressure in MPa, the hole unrolled", fontsize=10)

    line = figure.add_axes([0.76, 0.16, 0.22, 0.7])
    for directory, name, style in ((coarse, "small mesh", "o--"), (fine, "finer mesh", "s-")):
        angle, height, pressure = contact(directory)
        middle = (angle < 0.1) & (pressure > 0)
        order = np.argsort(height[middle])
        line.plot(height[middle][order], pressure[middle][order], style, label=name, markersize=4)
    line.set(xlabel="z in mm", ylabel="contact pressure at 0° in MPa", ylim=(0, None))
    line.legend(frameon=False)
    line.set_title("from the middle of the lug to its edge", fontsize=10)
    line.grid(alpha=0.3)
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3])
