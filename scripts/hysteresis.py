#!/usr/bin/env python3
"""Draw the stick-slip loop of a run with load steps: tangential force over the displacement of the driven face.

    python scripts/hysteresis.py DIRECTORY BODY PICTURE.png

BODY is the body whose upper face (largest y in the plane, largest z in space) is driven along x. Reads the
`.vtu` files with `meshio` and the forces from `summary.json`; needs matplotlib.
"""

import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np


def main(directory, body, picture):
    steps = json.loads((directory / "summary.json").read_text())["steps"]
    travel, force, work, share = [], [], [], []
    for step in steps:
        mesh = meshio.read(directory / f"{body}_{step['step']:04}.vtu")
        height = mesh.points[:, 2] if np.ptp(mesh.points[:, 2]) > 0 else mesh.points[:, 1]
        driven = height > height.max() - 1e-9 * np.ptp(height)
        travel.append(mesh.point_data["displacement"][driven, 0].mean())
        force.append(step["resultants"][0]["force"][0])
        work.append(step["contact"]["dissipation"])
        contact = meshio.read(directory / f"contact_{step['step']:04}.vtu").point_data
        closed, sticking = (np.ravel(contact[name]) == 1 for name in ("closed", "sticking"))
        share.append((closed & sticking).sum() / max(closed.sum(), 1))

    figure, (loop, history) = plt.subplots(1, 2, figsize=(10, 4), width_ratios=[1, 1.2])
    loop.plot(travel, force, "-", lw=1.2, color="tab:blue")
    loop.scatter(travel, force, c=share, s=14, cmap="viridis", zorder=3)
    loop.set(xlabel="displacement of the driven face", ylabel="tangential force", title="stick–slip loop")
    loop.grid(alpha=0.3)
    times = [step["time"] for step in steps]
    history.bar(times, work, width=0.8 * np.diff(times).min(), color="tab:red", label="dissipation of the step")
    history.set(xlabel="time", ylabel="dissipation", title="work of friction, step by step")
    sticking = history.twinx()
    sticking.plot(times, share, ".-", lw=0.8, ms=3, color="tab:green")
    sticking.set(ylabel="part of the closed pairs that sticks", ylim=(0, 1.05))
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], sys.argv[3])
