"""Parts written by Open Cascade, and what it says of our reading of them.

`open_cascade.py make FOLDER` writes STEP files of several schemas and units, and `expected.json`: for each
file its faces by their numbers, with types and areas. `open_cascade.py judge FOLDER` reads `found.json`, points of
each face, and prints, for each file and face, how far the worst point lies from the trimmed face, in millimetres.

Needs the wheel `cadquery-ocp`.
"""

import json
import math
import os
import re
import sys

from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRep import BRep_Builder, BRep_Tool
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert
from OCP.BRepClass import BRepClass_FaceClassifier
from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
from OCP.BRepGProp import BRepGProp
from OCP.BRepLib import BRepLib
from OCP.BRepOffsetAPI import BRepOffsetAPI_MakePipeShell, BRepOffsetAPI_ThruSections
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCone, BRepPrimAPI_MakeCylinder
from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere, BRepPrimAPI_MakeTorus
from OCP.Geom import Geom_CylindricalSurface
from OCP.Geom2d import Geom2d_Line
from OCP.GeomAPI import GeomAPI_ProjectPointOnSurf
from OCP.gp import gp_Ax2, gp_Ax3, gp_Circ, gp_Dir, gp_Dir2d, gp_Pnt, gp_Pnt2d
from OCP.GProp import GProp_GProps
from OCP.Interface import Interface_Static
from OCP.Message import Message, Message_Gravity
from OCP.ShapeCustom import ShapeCustom
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Reader, STEPControl_Writer
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_IN, TopAbs_ON
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS, TopoDS_Compound

UP = gp_Dir(0, 0, 1)


def at(x, y, z, along=UP):
    return gp_Ax2(gp_Pnt(x, y, z), along)


def pieces(shape, kind):
    found, explorer = [], TopExp_Explorer(shape, kind)
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def edge_of(shape):
    return TopoDS.Edge(shape) if hasattr(TopoDS, "Edge") else TopoDS.Edge_s(shape)


def face_of(shape):
    return TopoDS.Face(shape) if hasattr(TopoDS, "Face") else TopoDS.Face_s(shape)


def cut(a, b):
    return BRepAlgoAPI_Cut(a, b).Shape()


def together(*shapes):
    builder, whole = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(whole)
    for shape in shapes:
        builder.Add(whole, shape)
    return whole


def box(x, y, z, dx, dy, dz):
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape()


def cylinder(axes, radius, height):
    return BRepPrimAPI_MakeCylinder(axes, radius, height).Shape()


def bracket():
    """A box with a hole, every edge of it rounded."""
    whole = cut(box(0, 0, 0, 30, 20, 10), cylinder(at(15, 10, -1), 4, 20))
    maker, known = BRepFilletAPI_MakeFillet(whole), []
    for edge in pieces(whole, TopAbs_EDGE):
        if not any(edge.IsSame(other) for other in known):
            known.append(edge)
            maker.Add(1, edge_of(edge))
    return maker.Shape()


def spheres():
    ball = lambda x, along=UP: BRepPrimAPI_MakeSphere(at(x, 0, 0, along), 10).Shape()
    return together(
        ball(0),
        cut(ball(30, gp_Dir(1, 1, 1)), box(20, -20, 5, 20, 40, 40)),
        cut(ball(60), cylinder(at(60, 0, -20), 3, 40)),
        cut(ball(90), cylinder(at(93, -20, 0, gp_Dir(0, 1, 0)), 3, 40)),
        cut(ball(120), box(105, -3, -3, 7, 6, 6)),
    )


def tori():
    ring = lambda x: BRepPrimAPI_MakeTorus(at(x, 0, 0), 10, 3).Shape()
    return together(
        ring(0),
        cut(ring(40), box(20, -20, 0, 40, 40, 40)),
        cut(ring(80), box(60, 0, -20, 40, 40, 40)),
        cut(ring(120), cylinder(at(130, 0, -10), 2, 20)),
        cut(ring(160), box(172, -2, -2, 10, 4, 4)),
    )


def cones():
    cone = lambda x, top: BRepPrimAPI_MakeCone(at(x, 0, 0), 6, top, 12).Shape()
    return together(cone(0, 0), cut(cone(20, 0), box(22, -9, -1, 9, 18, 20)), cut(cone(40, 3), cylinder(at(30, 0, 6, gp_Dir(1, 0, 0.3)), 2, 30)))


def thread():
    line = Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(2 * math.pi, 2))
    helix = BRepBuilderAPI_MakeEdge(line, Geom_CylindricalSurface(gp_Ax3(), 5), 0, 4 * math.hypot(2 * math.pi, 2)).Edge()
    BRepLib.BuildCurves3d_s(helix)
    corners = [(4.8, 0, -0.6), (6, 0, 0), (4.8, 0, 0.6)]
    profile = BRepBuilderAPI_MakeWire()
    for k in range(3):
        profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(*corners[k]), gp_Pnt(*corners[(k + 1) % 3])).Edge())
    sweep = BRepOffsetAPI_MakePipeShell(BRepBuilderAPI_MakeWire(helix).Wire())
    sweep.SetMode(UP)
    sweep.Add(profile.Wire())
    sweep.Build()
    sweep.MakeSolid()
    return BRepAlgoAPI_Fuse(cylinder(at(0, 0, -3), 5, 14), sweep.Shape()).Shape()


def loft():
    sections = BRepOffsetAPI_ThruSections(True, False)
    for height, radius in [(0, 4), (10, 6), (20, 3)]:
        sections.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(at(0, 0, height), radius)).Edge()).Wire())
    return sections.Shape()


def as_splines():
    return BRepBuilderAPI_NurbsConvert(together(bracket(), spheres()), True).Shape()


def as_turned():
    drilled = cut(BRepPrimAPI_MakeSphere(at(60, 0, 0), 10).Shape(), cylinder(at(60, 0, -20), 3, 40))
    return ShapeCustom.ConvertToRevolution_s(together(bracket(), drilled))


PARTS = [bracket, spheres, tori, cones, thread, loft, as_splines, as_turned]
KINDS = [("AP203", "INCH", 1), ("AP214IS", "MM", 1), ("AP242DIS", "M", 0)]


def read(path):
    """Pairs of the number of a face in the file and the face."""
    reader = STEPControl_Reader()
    reader.ReadFile(path)
    reader.TransferRoots()
    transfer, model = reader.WS().TransferReader(), reader.WS().Model()
    with open(path, encoding="latin1") as file:
        numbers = [int(number) for number in re.findall(r"#(\d+)\s*=\s*ADVANCED_FACE\s*\(", file.read())]
    entities = [model.Value(k) for k in range(1, model.NbEntities() + 1)]
    entities = [entity for entity in entities if entity.DynamicType().Name() == "StepShape_AdvancedFace"]
    known = {id(entity): number for entity, number in zip(entities, numbers, strict=True)}
    faces = [face_of(shape) for shape in pieces(reader.OneShape(), TopAbs_FACE)]

    def number_of(face):
        # A face of an assembly is known by what it was before it was put into place.
        entity = transfer.EntityFromShapeResult(face, 1) or transfer.EntityFromShapeResult(face.Located(TopLoc_Location()), 1)
        return known[id(entity)]

    return [(number_of(face), face) for face in faces]


def make(folder):
    expected = {}
    for place, part in enumerate(PARTS):
        schema, unit, curves = KINDS[place % len(KINDS)]
        Interface_Static.SetCVal_s("write.step.schema", schema)
        Interface_Static.SetCVal_s("write.step.unit", unit)
        Interface_Static.SetIVal_s("write.surfacecurve.mode", curves)
        writer, path = STEPControl_Writer(), os.path.join(folder, f"{part.__name__}.step")
        writer.Transfer(part(), STEPControl_AsIs)
        writer.Write(path)
        faces = []
        for number, face in read(path):
            whole = GProp_GProps()
            # With a bound on the error, splines are cut where they bend; other surfaces do without.
            kind = BRepAdaptor_Surface(face).GetType().name.removeprefix("GeomAbs_")
            if kind == "BSplineSurface":
                BRepGProp.SurfaceProperties_s(face, whole, 1e-6, False)
            else:
                BRepGProp.SurfaceProperties_s(face, whole)
            faces.append({"face": number, "type": kind, "area": whole.Mass()})
        expected[f"{part.__name__}.step"] = faces
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file)


def judge(folder):
    with open(os.path.join(folder, "found.json"), encoding="utf-8") as file:
        found = json.load(file)
    worst = {}
    for name, part in found.items():
        worst[name] = {}
        for number, face in read(os.path.join(folder, name)):
            surface, off = BRep_Tool.Surface_s(face), 0.0
            for point in part["faces"].get(str(number), []):
                foot = GeomAPI_ProjectPointOnSurf(gp_Pnt(*point), surface)
                u, v = foot.LowerDistanceParameters()
                near = max(1e-7, 1e-5 * part["diagonal"])
                state = BRepClass_FaceClassifier(face, gp_Pnt(*point), near).State()
                inside = state in (TopAbs_IN, TopAbs_ON) or BRepClass_FaceClassifier(face, gp_Pnt2d(u, v), 1e-7).State() == TopAbs_IN
                off = max(off, foot.LowerDistance() if inside else math.inf)
            worst[name][number] = off if math.isfinite(off) else -1
    json.dump(worst, sys.stdout)


if __name__ == "__main__":
    for printer in Message.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(Message_Gravity.Message_Fail)
    {"make": make, "judge": judge}[sys.argv[1]](sys.argv[2])
