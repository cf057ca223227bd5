"""Writes the mesh files of this directory with Gmsh: the same models in every version and encoding.

    pip install gmsh
    python generate.py

Meshes may differ from one release of Gmsh to another; the tests compare the files of one run with
each other and with measures that do not depend on the mesh.
"""

import struct
import os
from pathlib import Path

import gmsh

# Decks begin with their path: let it be a bare name.
os.chdir(Path(__file__).parent)


def solids():
    """Two boxes of tetrahedra that share a face, and one of wedges apart."""
    box = gmsh.model.occ.addBox
    left, right = box(0, 0, 0, 1, 1, 1), box(1, 0, 0, 2, 1, 1)
    gmsh.model.occ.fragment([(3, left)], [(3, right)])
    face = gmsh.model.occ.addRectangle(5, 0, 0, 1, 1)
    wedges = gmsh.model.occ.extrude([(2, face)], 0, 0, 2, numElements=[2], recombine=True)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMin", 2)
    return {
        "left": (3, [left]),
        "right": (3, [right]),
        "wedges": (3, [tag for dim, tag in wedges if dim == 3]),
        "ends": (2, surfaces(x=0) + surfaces(x=3)),
        "between": (2, surfaces(x=1)),
        "bottom plane": (2, surfaces(z=0)),
        "edge": (1, curves(x=0, z=0)),
        "corner": (0, points(x=0, y=0, z=0)),
    }


def hexes():
    """A box of eight hexahedra."""
    gmsh.model.occ.addBox(0, 0, 0, 2, 1, 1)
    gmsh.model.occ.synchronize()
    for dim, tag in gmsh.model.getEntities(1):
        gmsh.model.mesh.setTransfiniteCurve(tag, 3)
    for dim, tag in gmsh.model.getEntities(2):
        gmsh.model.mesh.setTransfiniteSurface(tag)
        gmsh.model.mesh.setRecombine(2, tag)
    gmsh.model.mesh.setTransfiniteVolume(1)
    return {"block": (3, [1]), "left": (2, surfaces(x=0)), "top": (2, surfaces(z=1))}


def ball():
    """An eighth of a ball: curved faces."""
    gmsh.model.occ.addSphere(0, 0, 0, 1, 1, 0, 3.141592653589793 / 2, 3.141592653589793 / 2)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMin", 0.8)
    flat = surfaces(x=0) + surfaces(y=0) + surfaces(z=0)
    round_ = [tag for dim, tag in gmsh.model.getEntities(2) if tag not in flat]
    return {"ball": (3, [1]), "round": (2, round_), "floor": (2, surfaces(z=0))}


def plates():
    """Two rectangles in the plane that share an edge: triangles, drawn clockwise, and quadrilaterals."""
    add = gmsh.model.geo
    p = [add.addPoint(*xy, 0, 0.6) for xy in [(0, 0), (1, 0), (1, 1), (0, 1), (2, 0), (2, 1)]]
    line = add.addLine
    bottom, common, top, left = (line(p[a], p[b]) for a, b in [(0, 1), (1, 2), (2, 3), (3, 0)])
    low, right, high = (line(p[a], p[b]) for a, b in [(1, 4), (4, 5), (5, 2)])
    turned = add.addPlaneSurface([add.addCurveLoop([-left, -top, -common, -bottom])])
    quads = add.addPlaneSurface([add.addCurveLoop([low, right, high, -common])])
    for curve in [common, low, right, high]:
        add.mesh.setTransfiniteCurve(curve, 3)
    add.mesh.setTransfiniteSurface(quads)
    add.mesh.setRecombine(2, quads)
    add.synchronize()
    return {
        "triangles": (2, [turned]),
        "squares": (2, [quads]),
        "all": (2, [turned, quads]),
        "left": (1, [left]),
        "right": (1, [right]),
        "tip": (0, [p[0]]),
    }


def near(dimension, x, y, z):
    found = []
    for _, tag in gmsh.model.getEntities(dimension):
        box = gmsh.model.getBoundingBox(dimension, tag)
        wanted = [(i, v) for i, v in enumerate((x, y, z)) if v is not None]
        if all(abs(box[i] - v) < 1e-5 and abs(box[i + 3] - v) < 1e-5 for i, v in wanted):
            found.append(tag)
    return found


def surfaces(x=None, y=None, z=None):
    return near(2, x, y, z)


def curves(x=None, y=None, z=None):
    return near(1, x, y, z)


def points(x=None, y=None, z=None):
    return near(0, x, y, z)


def write(name, model, order=1, incomplete=False, dimension=3, formats=("msh", "inp")):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", int(incomplete))
    gmsh.option.setNumber("Mesh.SaveGroupsOfElements", 1)
    gmsh.option.setNumber("Mesh.SaveGroupsOfNodes", 0)
    groups = model()
    for text, (dim, tags) in groups.items():
        tag = gmsh.model.addPhysicalGroup(dim, tags)
        gmsh.model.setPhysicalName(dim, tag, text)
    # A physical group without a name, of entities that are in another one too: users have both.
    dim, tags = list(groups.values())[0]
    gmsh.model.addPhysicalGroup(dim, tags, 70)
    gmsh.model.mesh.generate(dimension)
    gmsh.model.mesh.setOrder(order)
    for version in [2.2, 4.1]:
        for binary in [0, 1]:
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            encoding = "binary" if binary else "text"
            gmsh.write(f"{name}-{version}-{encoding}.msh")
    if "inp" in formats:
        gmsh.write(f"{name}.inp")
    gmsh.finalize()


write("solids", solids)
write("hexes", hexes)
write("hexes27", hexes, order=2, formats=("msh",))
write("hexes20", hexes, order=2, incomplete=True)
write("ball", ball, order=2)
write("plates", plates, dimension=2)
write("plates2", plates, order=2, incomplete=True, dimension=2)
