#!/usr/bin/env python3
"""Read result files with two readers that are not ours, and print what they hold.

    python scripts/check_vtu.py FILE...

FILE is a .vtu, or a .pvd whose parts are then read. Every grid is read by `meshio` and by `vtk`
(both from PyPI); the two must agree on points, cells and every value of every field, and no value
may be NaN or infinite. Prints one JSON object, by file: number of points, cells by type, and for
each field its components, minimum, maximum and sum (lists by component). Exit code 1 and a line on
stderr when a file cannot be read or the readers disagree.
"""

import json
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


class Disagreement(Exception):
    """The files do not hold what they should."""


def demand(condition, message):
    if not condition:
        raise Disagreement(message)


def read_with_vtk(path):
    """The grid; VTK reports errors to an observer instead of raising them."""
    errors = []
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error event"))
    reader.SetFileName(str(path))
    reader.Update()
    demand(not errors and reader.GetErrorCode() == 0, f"{path}: vtk cannot read it")
    return reader.GetOutput()


def arrays_of(data):
    """Arrays of VTK's point, cell or field data, by name."""
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): array for array in arrays}


def compare(path, place, ours, theirs):
    demand(set(ours) == set(theirs), f"{path}: {place}: {sorted(ours)} and {sorted(theirs)}")
    for name, array in ours.items():
        a, b = vtk_to_numpy(array), np.asarray(theirs[name])
        same = a.size == b.size and np.array_equal(a.ravel(), b.ravel())
        demand(same, f"{path}: {place}: the readers disagree on `{name}`")
        demand(np.isfinite(a).all(), f"{path}: {place}: `{name}` is not finite")


def describe(array):
    """Components, and extremes and sum of each."""
    values = vtk_to_numpy(array)
    count = array.GetNumberOfComponents()
    values = values.reshape(-1, count)
    entry = {"components": count}
    if count > 1:
        entry["names"] = [array.GetComponentName(i) for i in range(count)]
    if values.size:
        for key, of in (("min", np.min), ("max", np.max), ("sum", np.sum)):
            result = of(values, axis=0).tolist()
            entry[key] = result if count > 1 else result[0]
    return entry


def check_grid(path):
    grid, mesh = read_with_vtk(path), meshio.read(path)

    points = grid.GetPoints()
    points = vtk_to_numpy(points.GetData()) if points else np.zeros((0, 3))
    demand(np.array_equal(points, mesh.points), f"{path}: the readers disagree on the points")
    demand(np.isfinite(points).all(), f"{path}: a point is not finite")

    start = 0
    for block in mesh.cells:
        for cell, nodes in enumerate(block.data, start):
            ids = grid.GetCell(cell).GetPointIds()
            found = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
            if block.type == "wedge":
                # meshio turns linear wedges, whose order in VTK's files it takes to be the other way round.
                found = [found[i] for i in (0, 2, 1, 3, 5, 4)]
            demand(found == nodes.tolist(), f"{path}: the readers disagree on cell {cell}")
        start += len(block.data)
    demand(start == grid.GetNumberOfCells(), f"{path}: the readers count cells differently")

    fields = {}
    for place, ours, theirs in (
        ("point_data", grid.GetPointData(), mesh.point_data or {}),
        (
            "cell_data",
            grid.GetCellData(),
            {name: np.concatenate(parts) for name, parts in mesh.cell_data.items()},
        ),
        ("field_data", grid.GetFieldData(), mesh.field_data),
    ):
        arrays = arrays_of(ours)
        compare(path, place, arrays, theirs)
        fields[place] = {name: describe(array) for name, array in arrays.items()}

    cells = {}
    for block in mesh.cells:
        cells[block.type] = cells.get(block.type, 0) + len(block.data)
    return {"points": len(points), "cells": cells, **fields}


def grids_of(path):
    """The file itself, or the parts of a collection."""
    if path.suffix != ".pvd":
        return [path]
    parts = [path.parent / part.attrib["file"] for part in ET.parse(path).iter("DataSet")]
    demand(parts, f"{path}: the collection is empty")
    return parts


def main(arguments):
    if not arguments:
        print(__doc__, file=sys.stderr)
        return 2
    report = {}
    try:
        for argument in arguments:
            for path in grids_of(Path(argument)):
                demand(path.is_file(), f"{path}: there is no such file")
                report[str(path)] = check_grid(path)
    except (Disagreement, meshio.ReadError, ET.ParseError) as error:
        print(f"check_vtu: {error}", file=sys.stderr)
        return 1
    print(json.dumps(report, indent=2))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
