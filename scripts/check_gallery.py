#!/usr/bin/env python3
"""Compare the results of the gallery with the closed forms and laws of gallery/README.md.

    python scripts/check_gallery.py [--results out] [NAME...]

Reads the contact grids and `summary.json` of `RESULTS/NAME`; without a name, all cases. What the case files say (radii,
moduli, loads) stands here once more, on purpose: a case that computes something else is found. Prints one line per
figure; exit code 1 when one is further from its closed form than the mesh explains. Needs numpy and meshio.
"""

import argparse
import json
import sys
from pathlib import Path

import meshio
import numpy as np


class Run:
    """The files of a run, and what its figures are held against."""

    def __init__(self, results, name):
        self.name, self.directory, self.failures = name, results / name, 0
        self.summary = json.loads((self.directory / "summary.json").read_text())
        self.steps = self.summary["steps"]
        planned = self.summary["planned_steps"]
        self.hold("load steps that converged", sum(s["status"] == "converged" for s in self.steps), planned, 0)

    def contact(self, step):
        """Points and fields of the contact grid of a step, counted from 1."""
        suffix = "" if self.summary["planned_steps"] == 1 else f"_{step:04}"
        grid = meshio.read(self.directory / f"contact{suffix}.vtu")
        return grid.points, {name: np.squeeze(values) for name, values in grid.point_data.items()}

    def normal(self, step, pair=0):
        return self.steps[step - 1]["resultants"][pair]["normal_force_sum"]

    def force(self, step, pair=0):
        return np.array(self.steps[step - 1]["resultants"][pair]["force"])

    def hold(self, figure, found, expected, tolerance, scale=None):
        """`found` is `expected` but for `tolerance` times `scale`, by default the expected value."""
        off = abs(found - expected) / (abs(expected) if scale is None else scale)
        held = off <= tolerance
        self.failures += not held
        print(
            f"{self.name:<10} {figure:<52} {found:12.6g} expected {expected:12.6g}, off by {off:.2g} of {tolerance:.2g}"
            + ("" if held else "   FAILS")
        )


def press_fit(run):
    """Lamé, plane strain."""
    a, b, interference = 20.0, 40.0, 0.02
    (shaft, nu), (hub, mu) = (2.1e5, 0.3), (7.0e4, 0.33)
    of_hub = (1 + mu) / hub * ((1 - 2 * mu) * a**2 + b**2) / (b**2 - a**2)
    lame = interference / a / (of_hub + (1 + nu) * (1 - 2 * nu) / shaft)
    _, fields = run.contact(1)
    pressure, area = fields["contact_pressure"], fields["normal_force"] / fields["contact_pressure"]
    run.hold("mean pressure, Lamé", np.average(pressure, weights=area), lame, 0.01)
    run.hold("root mean square of the error over Lamé", np.sqrt(np.average((pressure - lame) ** 2, weights=area)), 0, 0.015, lame)
    run.hold("largest pressure", pressure.max(), lame, 0.02)
    run.hold("smallest pressure", pressure.min(), lame, 0.03)


def hip(run):
    """The contact carries the load; an elastic foundation."""
    load = run.steps[0]["certificate"]["bodies"][0]["load"]
    run.hold("load, half of 2000 N", load[2], -1000.0, 1e-4)
    run.hold("contact force on the head against the load", run.force(1)[2], -load[2], 1e-10)
    run.hold("contact force across the load", np.abs(run.force(1)[0]), 0, 1e-10, -load[2])
    # Springs with the modulus of confined plastic per thickness of the wall, by bisection for the load.
    radius, clearance, wall, young, nu = 14.0, 0.1, 8.0, 1.0e3, 0.45
    stiffness = young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / wall
    low, high = clearance, 10.0
    for _ in range(100):
        d = 0.5 * (low + high)
        t = clearance / d
        carried = 2 * np.pi * radius**2 * stiffness * (d / 3 * (1 - t**3) - clearance / 2 * (1 - t**2))
        low, high = (d, high) if carried < 2000.0 else (low, d)
    points, fields = run.contact(1)
    away = points - np.array([0, 0, clearance])
    angle = np.degrees(np.arccos(-away[:, 2] / np.linalg.norm(away, axis=1)))
    run.hold("largest pressure, elastic foundation", fields["contact_pressure"].max(), stiffness * (d - clearance), 0.25)
    run.hold("angle of the edge of contact, the same", angle[fields["closed"] == 1].max(), np.degrees(np.arccos(t)), 0.15)


def punch(run):
    """Hertz, and Coulomb's law of the whole."""
    radius, friction, effective = 50.0, 0.3, 3.0e3 / (1 - 0.38**2)
    for step in (1, len(run.steps)):
        force = 2 * run.normal(step)
        a = (3 * force * radius / (4 * effective)) ** (1 / 3)
        points, fields = run.contact(step)
        run.hold(f"step {step}: largest pressure, Hertz", fields["contact_pressure"].max(), 1.5 * force / (np.pi * a**2), 0.025)
        # Hertz's pressure has the second moment 2/5 P a² about its axis.
        weights = fields["normal_force"]
        centre = np.average(points[:, 0], weights=weights)
        second = np.average((points[:, 0] - centre) ** 2 + points[:, 1] ** 2, weights=weights)
        run.hold(f"step {step}: radius from the second moment, Hertz", np.sqrt(2.5 * second), a, 0.03)
    ratio = np.abs(run.force(step)[0]) / run.normal(step)
    run.hold("tangential over normal force at the end", ratio, friction, 0.015)
    run.hold("closed nodes that stick at the end", np.count_nonzero(fields["status"] == 1), 0, 0, 1)


def fretting(run):
    """Hertz, Cattaneo and Mindlin at the end of the first stroke, and a cycle that closes."""
    radius, friction, effective = 50.0, 0.5, 1.15e5 / (2 * (1 - 0.32**2))
    stroke, cycle = 6, len(run.steps)
    normal, tangential = run.normal(stroke), abs(run.force(stroke)[0])
    a = np.sqrt(4 * normal * radius / (np.pi * effective))
    peak = 2 * normal / (np.pi * a)
    c = a * np.sqrt(1 - tangential / (friction * normal))
    points, fields = run.contact(stroke)
    x, pressure = points[:, 0], fields["contact_pressure"]
    run.hold("largest pressure, Hertz", pressure.max(), peak, 0.01)
    second = np.average((x - np.average(x, weights=fields["normal_force"])) ** 2, weights=fields["normal_force"])
    run.hold("half-width from the second moment, Hertz", 2 * np.sqrt(second), a, 0.01)
    sticks = fields["status"] == 1
    spacing = np.diff(np.sort(x[np.abs(x) < a])).max()
    run.hold("half-width that sticks, Mindlin, in node distances", 0.5 * np.ptp(x[sticks]) / spacing, c / spacing, 1, 1)
    ellipse = lambda width: np.sqrt(np.maximum(1 - (x / width) ** 2, 0))
    shear = friction * peak * (ellipse(a) - c / a * ellipse(c))
    difference = np.abs(fields["tangential_traction"][:, 0]) - shear
    inside = np.abs(x) < 0.6 * c
    run.hold("shear where it sticks, Mindlin: mean difference", difference[inside].mean(), 0, 0.02, friction * peak)
    run.hold("tangential force after a whole cycle", abs(run.force(cycle)[0]), tangential, 0.002)


def dovetail(run):
    """Equilibrium of the root."""
    pull, friction = 7200.0, 0.25
    slipping = lambda sign: pull / (np.sqrt(0.5) * (1 + sign * friction))
    run.hold("contact force along the blade", run.force(1)[1], pull, 1e-10)
    run.hold("normal force, all of it slips outwards", run.normal(1), slipping(1), 0.005)
    run.hold("the same after unloading and loading", run.normal(len(run.steps)), slipping(1), 0.005)
    run.hold("normal force at 30 %, all of it slips back", run.normal(5), 0.3 * slipping(-1), 0.005)


def lap_joint(run):
    """Coulomb's law of whole surfaces while they slip, and a shank that bears at last."""
    faying, head, nut, upper_hole, lower_hole = range(5)
    friction, last, between = 0.2, len(run.steps), 5
    for pair, name in ((faying, "plates"), (head, "head"), (nut, "nut")):
        force = np.abs(run.force(between, pair)[0])
        run.hold(f"friction over 0.2 N while all slips: {name}", force / run.normal(between, pair), friction, 0.005)
    for step in (1, between):
        run.hold(f"step {step}: force on the shank", run.normal(step, upper_hole), 0, 0, 1)
    # The bolt is in balance with what head, nut and shank carry.
    on_bolt = sum(run.force(last, pair) for pair in (head, nut, upper_hole, lower_hole))
    run.hold("end: forces on the bolt along the pull", on_bolt[0], 0, 1e-6, run.normal(last, upper_hole))
    run.hold("end: forces on the bolt along its axis", on_bolt[2], 0, 1e-6, run.normal(last, head))
    run.hold("end: upper over lower hole", run.normal(last, upper_hole), run.normal(last, lower_hole), 0.01)


CASES = {
    "lap-joint": lap_joint,
    "hip": hip,
    "press-fit": press_fit,
    "punch": punch,
    "fretting": fretting,
    "dovetail": dovetail,
}


def main(names, results):
    failures = 0
    for name in names or CASES:
        run = Run(results, name)
        CASES[name](run)
        failures += run.failures
    return failures


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(CASES))
    parser.add_argument("--results", type=Path, default=Path("out"))
    arguments = parser.parse_args()
    unknown = set(arguments.names) - set(CASES)
    if unknown:
        parser.error(f"there is no case {', '.join(sorted(unknown))}")
    failed = main(arguments.names, arguments.results)
    if failed:
        sys.exit(f"check_gallery: {failed} figures are not what they should be")
