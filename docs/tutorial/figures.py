#!/usr/bin/env python3
"""Prints figures of the tutorial's runs side by side.

    python figures.py RESULTS…

Each RESULTS is a directory that `tresca solve` wrote. Needs meshio and NumPy (scripts/requirements.txt).
"""

import json
import sys
from pathlib import Path

import meshio
import numpy as np


def figures(directory):
    """Names and values of the figures of a run, in N, mm and MPa."""
    step = json.loads((directory / "summary.json").read_text())["steps"][-1]
    pin, lug, contact = (meshio.read(directory / f"{name}.vtu") for name in ("pin", "lug", "contact"))
    height = contact.points[:, 2]
    pressure = np.ravel(contact.point_data["contact_pressure"])
    return {
        "contact force along x": abs(step["resultants"][0]["force"][0]),
        "sum of the normal forces": step["contact"]["normal_force_sum"],
        "displacement of the pin's end": -pin.point_data["displacement"][:, 0].min(),
        "largest pressure at z = 0": pressure[height < 1e-6].max(),
        "largest pressure": pressure.max(),
        "    at the height z": height[pressure.argmax()],
        "largest von Mises stress, pin": pin.point_data["von_mises_stress"].max(),
        "largest von Mises stress, lug": lug.point_data["von_mises_stress"].max(),
    }


def main(directories):
    runs = [figures(directory) for directory in directories]
    print(f"{'':<30}" + "".join(f"{str(directory):>12}" for directory in directories))
    for name in runs[0]:
        print(f"{name:<30}" + "".join(f"{run[name]:>12.5g}" for run in runs))


if __name__ == "__main__":
    main([Path(argument) for argument in sys.argv[1:]])
