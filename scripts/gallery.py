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
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

WINDOW = (1100, 850)


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
    shown = grid.extract_surface(nonlinear_subdivision=2)
    edges = grid.separate_cells().extract_surface(nonlinear_subdivision=2)
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
            halves += [tuple(half.reflect({"x": (1, 0, 0), "y": (0, 1, 0)}[case.mirror]) for half in halves[0])]
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


def surface(pair=None, towards=(0, 0, 1), up=(1, 0, 0), title="contact pressure in MPa", arrows=False, step=None):
    """The contact surface of some pairs, coloured by the pressure."""

    def draw(axes, run, case):
        grid = run.grid("contact", case.step if step is None else step)
        if pair is not None:
            grid = grid.extract_points(np.isin(grid["pair"], pair), adjacent_cells=False)
        plotter = pyvista.Plotter(off_screen=True, window_size=WINDOW)
        plotter.set_background("white")
        shown, edges = flat(grid)
        largest = max(float(grid["contact_pressure"].max()), np.finfo(float).tiny)
        plotter.add_mesh(
            shown, scalars="contact_pressure", cmap="magma_r", clim=(0, largest), show_scalar_bar=False, lighting=False
        )
        plotter.add_mesh(edges, color="black", line_width=0.6, opacity=0.4)
        if arrows:
            closed = grid.extract_points(grid["closed"] == 1, include_cells=False)
            slip = np.linalg.norm(closed["slip"], axis=1)
            if slip.max() > 0:
                length = 0.08 * grid.length / slip.max()
                plotter.add_mesh(closed.glyph(orient="slip", scale="slip", factor=length), color="#1f77b4")
        plotter.view_vector(towards, viewup=up)
        plotter.camera.parallel_projection = True
        plotter.enable_anti_aliasing("ssaa")
        axes.imshow(trimmed(plotter.screenshot(return_img=True)))
        plotter.close()
        axes.set_axis_off()
        axes.set_title(title, fontsize=10)
        bar(axes, Normalize(0, largest), "magma_r")

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


def hysteresis(axes, run, case):
    """Tangential force over the way of the grip."""
    way = [run.grid("pad", number + 1) for number in range(len(run.steps))]
    grip = [1e3 * grid["displacement"][np.argmax(grid.points[:, 1]), 0] for grid in way]
    axes.plot(grip, -run.forces(0)[:, 0], "o-", ms=3, label="tangential force")
    axes.set_title("the cycle", fontsize=10)
    tidy(axes, "displacement of the grip in µm", "N per mm of thickness")


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
    "lap-joint": Case(-1, (0.35, -1, 0.45), 10, joint_forces, 1.0),
    "hip": Case(-1, (0.1, -1, 0.3), 1, surface(towards=(-0.55, 0, 0.8), up=(0, 1, 0), arrows=True)),
    "press-fit": Case(-1, (1, 0.6, 1.1), 100, surface(towards=(-1, -1, 0.35), up=(0, 0, 1))),
    "punch": Case(-1, (0.3, -1, 0.6), 1, surface(arrows=True), mirror=""),
    "fretting": Case(2, (0, 0, 1), 20, hysteresis, focus=(0, 0, 3)),
    "dovetail": Case(1, (0.25, 0.2, 1), 20, flank_forces, mirror="x"),
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
        print(path)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", choices=[*CASES, []], metavar="NAME")
    parser.add_argument("--results", type=Path, default=Path("out"))
    parser.add_argument("--pictures", type=Path, default=Path("gallery"))
    arguments = parser.parse_args()
    main(arguments.names, arguments.results, arguments.pictures)
