#!/usr/bin/env python3
"""Draw the pictures of the gallery from the result files of its cases.

    python scripts/gallery.py [--results out] [--pictures gallery] [NAME...]

Reads `RESULTS/NAME/*.vtu` and `summary.json`, writes `PICTURES/NAME/NAME.png`; without a name, all cases. On the
left the bodies, deformed and coloured by the von Mises stress, the elements' edges as curved as the elements; on the
right what the case is about. Needs `gallery/requirements.txt`.
"""

import argparse
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pyvista
import vtk
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from PIL import Image

WINDOW = (1100, 850)
NORMALS = {"x": (1, 0, 0), "y": (0, 1, 0)}

# Lines lie on the surfaces that they are the edges of.
vtk.vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
vtk.vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(-2.0, -2.0)


@dataclass
class Run:
    """The files of a run."""

    directory: Path
    summary: dict

    @classmethod
    def of(cls, directory):
        return cls(directory, json.loads((directory / "summary.json").read_text()))

    @property
    def steps(self):
        return self.summary["steps"]

    def grid(self, name, step):
        """The grid `name` (a body or `contact`) at the end of a step, counted from 1 or, from the end, from -1."""
        number = self.steps[step - 1 if step > 0 else step]["step"]
        suffix = "" if self.summary["planned_steps"] == 1 else f"_{number:04}"
        return pyvista.read(self.directory / f"{name}{suffix}.vtu")

    def bodies(self, step):
        names = [body["name"] for body in self.steps[step]["certificate"]["bodies"]]
        return [self.grid(name, step) for name in names]

    def forces(self, pair):
        """Resultants of a contact pair over the steps, on its slave: one row per step."""
        return np.array([step["resultants"][pair]["force"] for step in self.steps])


@dataclass
class Case:
    """How a case is drawn: which step, seen from where, deformed how much, and what stands on the right."""

    step: int
    towards: tuple  # from the bodies to the eye
    warp: float
    right: Callable
    zoom: float = 1.0
    mirror: str = ""  # normal of the plane of symmetry that the whole is drawn across: "x", "y"
    focus: tuple | None = None  # x, y and half height of what is seen of a plane case


def flat(grid):
    """Surface of a grid through its mid nodes, and the edges of its elements as lines."""
    outside = {"nonlinear_subdivision": 2, "algorithm": "dataset_surface"}
    shown = grid.extract_surface(**outside)
    edges = grid.separate_cells().extract_surface(**outside)
    return shown, edges.extract_feature_edges(feature_angle=89.0, manifold_edges=False, non_manifold_edges=False)


def camera(plotter, case):
    if case.focus:
        x, y, half = case.focus
        plotter.view_xy()
        plotter.camera.parallel_projection = True
        plotter.camera.focal_point = (x, y, 0.0)
        plotter.camera.position = (x, y, 10.0)
        plotter.camera.parallel_scale = half
    else:
        plotter.view_vector(case.towards, viewup=(0, 1, 0) if case.mirror == "x" else (0, 0, 1))
        plotter.camera.parallel_projection = True
        plotter.camera.zoom(1.25 * case.zoom)


def picture_of_bodies(axes, run, case):
    plotter = pyvista.Plotter(off_screen=True, window_size=WINDOW)
    plotter.set_background("white")
    bodies = run.bodies(case.step)
    stress = np.concatenate([body["von_mises_stress"] for body in bodies])
    colours = Normalize(0, np.quantile(stress, 0.998))
    for body in bodies:
        body.points = body.points + case.warp * body["displacement"]
        shown, edges = flat(body)
        halves = [(shown, edges)]
        if case.mirror:
            halves += [tuple(part.reflect(NORMALS[case.mirror]) for part in halves[0])]
        for surface, lines in halves:
            plotter.add_mesh(
                surface, scalars="von_mises_stress", cmap="viridis", clim=(0, colours.vmax), show_scalar_bar=False,
                lighting=case.focus is None, ambient=0.25, diffuse=0.8, smooth_shading=False,
            )
            plotter.add_mesh(lines, color="black", line_width=0.6, opacity=0.35)
    camera(plotter, case)
    plotter.enable_anti_aliasing("ssaa")
    axes.imshow(trimmed(plotter.screenshot(return_img=True)))
    plotter.close()
    axes.set_axis_off()
    moved = "" if case.warp == 1 else f", displacement × {case.warp:g}"
    axes.set_title(f"von Mises stress in MPa{moved}", fontsize=10)
    bar(axes, colours, "viridis")


def bar(axes, colours, cmap):
    axes.figure.colorbar(ScalarMappable(colours, cmap), ax=axes, shrink=0.6, pad=0.02).ax.tick_params(labelsize=8)


def trimmed(image, margin=12):
    """Without the white border."""
    rows, columns = np.nonzero((image < 250).any(axis=2))
    window = [slice(max(index.min() - margin, 0), index.max() + margin) for index in (rows, columns)]
    return image[tuple(window)]


def contact(pairs=None, towards=(0, 0, 1), up=(0, 1, 0), mirror="", step=None, note=""):
    """The contact surface of some pairs, coloured by the pressure; nodes that stick are dots, slip is arrows."""

    def draw(axes, run, case):
        grid = run.grid("contact", case.step if step is None else step)
        if pairs is not None:
            grid = grid.extract_points(np.isin(grid["pair"], pairs), adjacent_cells=False)
        plotter = pyvista.Plotter(off_screen=True, window_size=WINDOW)
        plotter.set_background("white")
        largest = max(float(grid["contact_pressure"].max()), np.finfo(float).tiny)
        towards_eye = 0.02 * grid.length * np.array(towards) / np.linalg.norm(towards)
        halves = [grid, grid.reflect(NORMALS[mirror], transform_all_input_vectors=True)] if mirror else [grid]
        longest = max(np.linalg.norm(grid["slip"][grid["status"] == 2], axis=1), default=0.0)
        for half in halves:
            shown, edges = flat(half)
            plotter.add_mesh(
                shown, scalars="contact_pressure", cmap="YlOrRd", clim=(0, largest), show_scalar_bar=False, lighting=False
            )
            plotter.add_mesh(edges, color="black", line_width=0.6, opacity=0.35)
            # In front of the surface, seen from the eye.
            points = pyvista.PolyData(half.points + towards_eye)
            points["slip"], points["status"] = half["slip"], half["status"]
            sticking, slipping = (
                points.extract_points(points["status"] == status, adjacent_cells=False) for status in (1, 2)
            )
            if sticking.n_points:
                plotter.add_mesh(sticking, style="points", color="black", point_size=18, render_points_as_spheres=True)
            if slipping.n_points and longest > 0:
                arrows = slipping.glyph(orient="slip", scale="slip", factor=0.09 * grid.length / longest)
                plotter.add_mesh(arrows, color="#1f4e9c", lighting=False)
        plotter.view_vector(towards, viewup=up)
        plotter.camera.parallel_projection = True
        plotter.enable_anti_aliasing("ssaa")
        axes.imshow(trimmed(plotter.screenshot(return_img=True)))
        plotter.close()
        axes.set_axis_off()
        axes.set_title(f"contact pressure in MPa{note}", fontsize=10)
        bar(axes, Normalize(0, largest), "YlOrRd")

    return draw


def tidy(axes, x, y):
    axes.set_xlabel(x, fontsize=9)
    axes.set_ylabel(y, fontsize=9)
    axes.tick_params(labelsize=8)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, frameon=False)


def joint_forces(axes, run, case):
    """What the plates pass on to each other over the way of the end: by friction, and through the bolt."""
    way = [run.grid("upper", number + 1) for number in range(len(run.steps))]
    pull = [grid["displacement"][np.argmax(grid.points[:, 0]), 0] for grid in way]
    by_friction, by_bearing = run.forces(0)[:, 0], run.forces(3)[:, 0]
    axes.plot(pull, 2e-3 * np.abs(by_friction), "o-", label="friction between the plates")
    axes.plot(pull, 2e-3 * np.abs(by_bearing), "s-", label="shank on the hole")
    normal = np.array([step["resultants"][0]["normal_force_sum"] for step in run.steps])
    axes.plot(pull, 2e-3 * 0.2 * normal, "k:", label="0.2 × pressing force")
    axes.set_title("forces in kN, whole joint", fontsize=10)
    tidy(axes, "displacement of the end in mm", "kN")


def lame(axes, run, case):
    """Radial and hoop stress over the radius, beside Lamé's."""
    a, b, interference = 20.0, 40.0, 0.02
    (shaft, nu), (hub, mu) = (2.1e5, 0.3), (7.0e4, 0.33)
    of_hub = (1 + mu) / hub * ((1 - 2 * mu) * a**2 + b**2) / (b**2 - a**2)
    pressure = interference / a / (of_hub + (1 + nu) * (1 - 2 * nu) / shaft)
    for grid, label in zip(run.bodies(-1), ("finite elements", None)):
        x, y, _ = grid.points.T
        radius = np.hypot(x, y)
        inner = radius > 1e-9
        c, s = x[inner] / radius[inner], y[inner] / radius[inner]
        xx, yy, _, xy, _, _ = grid["stress"][inner].T
        radial, hoop = c * c * xx + s * s * yy + 2 * c * s * xy, s * s * xx + c * c * yy - 2 * c * s * xy
        axes.plot(radius[inner], radial, ".", ms=3, color="tab:blue", label=label and "radial stress")
        axes.plot(radius[inner], hoop, ".", ms=3, color="tab:orange", label=label and "hoop stress")
    ring = np.linspace(a, b, 100)
    factor = pressure * a**2 / (b**2 - a**2)
    axes.plot([0, a], [-pressure] * 2, "k-", lw=1, label="Lamé")
    axes.plot(ring, factor * (1 - (b / ring) ** 2), "k-", lw=1)
    axes.plot(ring, factor * (1 + (b / ring) ** 2), "k-", lw=1)
    axes.set_title("stress in MPa over the radius, all nodes", fontsize=10)
    tidy(axes, "radius in mm", "MPa")


def tractions(axes, run, case):
    """Pressure and shear of the fretting contact beside Hertz's, Cattaneo's and Mindlin's."""
    radius, friction, effective = 50.0, 0.5, 1.15e5 / (2 * (1 - 0.32**2))
    normal = run.steps[5]["resultants"][0]["normal_force_sum"]
    a = np.sqrt(4 * normal * radius / (np.pi * effective))
    peak = 2 * normal / (np.pi * a)
    x = np.linspace(-1.1 * a, 1.1 * a, 400)
    partial = lambda c: np.sqrt(np.maximum(1 - (x / a) ** 2, 0)) - c / a * np.sqrt(np.maximum(1 - (x / c) ** 2, 0))
    largest = run.forces(0)[5, 0]
    stroke = friction * peak * partial(a * np.sqrt(1 - abs(largest) / (friction * normal)))
    turned = abs(largest - run.forces(0)[10, 0])
    back = stroke - 2 * friction * peak * partial(a * np.sqrt(1 - turned / (2 * friction * normal)))
    axes.plot(x, peak * np.sqrt(np.maximum(1 - (x / a) ** 2, 0)), "k-", lw=1, label="Hertz, Cattaneo, Mindlin")
    axes.plot(x, stroke, "k-", lw=1)
    axes.plot(x, back, "k-", lw=1)
    for step, field, mark, label in (
        (6, "contact_pressure", "o", "pressure"),
        (6, "tangential_traction", "s", "shear, end of the first stroke"),
        (11, "tangential_traction", "^", "shear, half-way back"),
    ):
        grid = run.grid("contact", step)
        inside = np.abs(grid.points[:, 0]) < 1.1 * a
        values = grid[field] if grid[field].ndim == 1 else np.sign(largest) * grid[field][:, 0]
        axes.plot(grid.points[inside, 0], values[inside], mark, ms=3.5, label=label)
    axes.set_title("tractions in MPa", fontsize=10)
    tidy(axes, "x in mm", "MPa")


def flank_forces(axes, run, case):
    """Friction against normal force on the flank of the dovetail over the load steps."""
    pull = 200 * 36 * np.array([1, 0.825, 0.65, 0.475, 0.3, 0.475, 0.65, 0.825, 1])
    normal = np.array([step["resultants"][0]["normal_force_sum"] for step in run.steps])
    axes.plot(pull / 1e3, normal / 1e3, "o-", label="normal force on the flank")
    for sign, text in ((1, "all of it slips outwards"), (-1, "all of it slips back")):
        axes.plot(pull / 1e3, pull / 1e3 / (np.sqrt(0.5) * (1 + sign * 0.25)), ":", label=text)
    axes.set_title("a quarter of the blade", fontsize=10)
    tidy(axes, "pull on the blade in kN", "kN")


CASES = {
    "lap-joint": Case(-1, (0.3, -1, 0.4), 10, joint_forces, zoom=1.9),
    "hip": Case(-1, (0.1, -1, 0.3), 1, contact(towards=(-0.15, 0, 1), up=(1, 0, 0), mirror="y", note=", slip")),
    "press-fit": Case(-1, (1, 0.6, 1.1), 1, lame),
    "punch": Case(3, (0.2, -1, 0.9), 5, contact(note="; dots stick, arrows slip"), zoom=1.15),
    "fretting": Case(6, (0, 0, 1), 20, tractions, focus=(0, 0, 2)),
    "dovetail": Case(1, (0.25, 0.2, 1), 10, flank_forces, mirror="x"),
}


def main(names, results, pictures):
    for name in names or CASES:
        case, run = CASES[name], Run.of(results / name)
        figure, (left, right) = plt.subplots(1, 2, figsize=(12.5, 4.8), width_ratios=(1.35, 1), layout="constrained")
        picture_of_bodies(left, run, case)
        case.right(right, run, case)
        figure.suptitle(run.summary["title"], fontsize=12)
        path = pictures / name / f"{name}.png"
        figure.savefig(path, dpi=90)
        plt.close(figure)
        # A palette of its own makes it half as large.
        image = Image.open(path).convert("RGB")
        palette = image.quantize(256, method=Image.Quantize.MEDIANCUT)
        image.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG).save(path, optimize=True)
        print(path)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", choices=[*CASES, []], metavar="NAME")
    parser.add_argument("--results", type=Path, default=Path("out"))
    parser.add_argument("--pictures", type=Path, default=Path("gallery"))
    arguments = parser.parse_args()
    main(arguments.names, arguments.results, arguments.pictures)
