# SPDX-License-Identifier: MIT
#
# A square of 1 m about the origin that faces +z, written in every format with one feature of that format, or as the same
# file without the statement of it. Nothing of the program is known here.
import json
import os
import struct

import formats
import one_square_xml as xml
from one_square_fbx import write_fbx
from one_square_wad import write_wad

ORANGE = (255, 128, 0)
SQUARE = [(-0.5, -0.5, 0.0), (0.5, -0.5, 0.0), (0.5, 0.5, 0.0), (-0.5, 0.5, 0.0)]
WITHOUT_A_CORNER = [(-0.5, -0.5, 0.0), (0.5, -0.5, 0.0), (0.5, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.5, 0.0), (-0.5, 0.5, 0.0)]
UVS = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]  # from the bottom
PICTURED = {"pictures", "clamped pictures", "mirrored pictures", "parts of pictures", "holes in pictures", "pictures of light",
            "missing pictures"}


class Thing:
    """feature: what the file is about; said: the file has the statement of it."""

    def __init__(self, feature, said):
        self.feature, self.said = feature, said
        self.points = WITHOUT_A_CORNER if self.has("faces of many corners") else list(SQUARE)
        if self.has("bent faces"):
            self.points[2] = (0.5, 0.5, 1.0)
        if feature == "up axis":
            self.points = [(x, 0.0, y) for x, y, _ in SQUARE]
        if feature == "faces with two sides":
            self.points.reverse()
        self.face = list(range(len(self.points)))
        reach = 2.0 if feature in ("clamped pictures", "mirrored pictures") else 1.0
        self.uvs = [(u * reach, v * reach) for u, v in UVS] if feature in PICTURED else None
        self.has_picture = feature in PICTURED and (said or feature not in ("pictures", "pictures of light"))
        self.colour = ORANGE if self.has("colours of faces") else None
        self.ends = [ORANGE] * 4 if self.has("colours of corners") else None
        if self.has("colours that change"):
            self.ends = [(255, 0, 0), (0, 0, 255), (0, 0, 255), (255, 0, 0)]
        if self.has_picture:
            formats.four_png()
            if self.has("holes in pictures"):
                holed_png("four.png")
            if self.has("missing pictures"):
                os.remove("four.png")

    def has(self, feature):
        return self.said and self.feature == feature

    def scaled(self, factor):
        return [tuple(c * factor for c in p) for p in self.points]

    def triangles(self):
        return [(0, i, i + 1) for i in self.face[1:-1]]


def holed_png(path):
    """The upper left quarter has an alpha of 0."""
    import zlib

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b""
    for y in range(16):
        rows += b"\0" + b"".join(bytes(formats.FOUR[y // 8][x // 8]) + bytes([0 if x < 8 and y < 8 else 255]) for x in range(16))
    open(path, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 16, 16, 8, 6, 0, 0, 0)) +
                           chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def parts(colour):
    return "%.6f %.6f %.6f" % tuple(c / 255 for c in colour)


# -- OBJ ----------------------------------------------------------------------------------------------------------------

def write_obj(t):
    mtl = ["newmtl m", "Kd " + parts(t.colour or ((255,) * 3 if t.feature == "opacity" else (200,) * 3))]
    statements = {"opacity": "d 0.5", "light of faces": "Ke " + parts(ORANGE), "shine": "Ks 1 1 1\nNs 90\nillum 2",
                  "bumps": "map_Bump four.png"}
    mtl += [line for feature, line in statements.items() if t.has(feature)]
    if t.feature in ("light of faces", "pictures of light"):
        mtl[1] = "Kd 0 0 0"
    if t.feature in ("pictures of light",) and t.said:
        mtl += ["map_Ke four.png", "Ke 1 1 1"]
    elif t.has_picture:
        mtl[1] = "Kd 1 1 1"
        option = {"clamped pictures": "-clamp on ", "parts of pictures": "-o 0.5 0 0 "}.get(t.feature, "") if t.said else ""
        mtl.append("map_Kd %sfour.png" % option)
    if t.has("bumps"):
        formats.four_png()
    lines = ["mtllib a.mtl"]
    lines += ["v %g %g %g %s" % (*p, parts(t.ends[i]) if t.ends else "") for i, p in enumerate(t.points)]
    lines += ["vt %g %g" % uv for uv in t.uvs or ()]
    lines += ["vn 1 0 0"] if t.has("normals") else []
    lines += ["usemtl m"] if not t.ends else []
    corner = "%d/%d" if t.uvs else "%d//1" if t.has("normals") else "%d"
    lines.append("f " + " ".join(corner % ((i + 1,) * corner.count("%d")) for i in t.face))
    if t.has("lines and points"):
        lines += ["l 1 3", "p 2"]
    if t.has("curves and surfaces"):
        lines += ["cstype bezier", "deg 3", "curv 0 1 1 2 3 4", "parm u 0 1", "end"]
    open("a.mtl", "w").write("\n".join(mtl) + "\n")
    open("a.obj", "w").write("\n".join(lines) + "\n")
    return "a.obj"


# -- PLY, OFF, STL ------------------------------------------------------------------------------------------------------

def rgb(*more):
    return [("uchar", name) for name in ("red", "green", "blue", *more)]


def write_ply(t):
    vertex, face = list(formats.XYZ), [formats.CORNERS]
    vertices, row = [list(p) for p in t.points], [t.face]
    if t.ends:
        vertex += rgb()
        vertices = [v + list(c) for v, c in zip(vertices, t.ends)]
    if t.has("normals"):
        vertex += [("float", n) for n in ("nx", "ny", "nz")]
        vertices = [v + [1.0, 0.0, 0.0] for v in vertices]
    if t.uvs:
        vertex += [("float", "s"), ("float", "t")]
        vertices = [v + list(uv) for v, uv in zip(vertices, t.uvs)]
    if t.colour:
        face, row = face + rgb(), row + list(t.colour)
    if t.feature == "opacity":
        face, row = face + rgb("alpha"), row + [255, 255, 255, 128 if t.said else 255]
    elements = [("vertex", vertex, vertices), ("face", face, [row])]
    if t.has("lines and points"):
        elements.append(("edge", [("int", "vertex1"), ("int", "vertex2")], [[0, 2]]))
    formats.ply("a.ply", "ascii", elements, ["TextureFile four.png"] if t.has_picture else ())
    return "a.ply"


def write_off(t):
    word = "COFF" if t.ends else "NOFF" if t.has("normals") else "OFF"
    behind = [" %d %d %d 255" % c for c in t.ends] if t.ends else [" 1 0 0" if t.has("normals") else ""] * len(t.points)
    colour = "%d %d %d" % t.colour if t.colour else "255 255 255 %d" % (128 if t.said else 255) if t.feature == "opacity" else ""
    faces = ["%d %s %s" % (len(t.face), " ".join(map(str, t.face)), colour)]
    if t.has("lines and points"):
        faces.append("2 0 2")
    if t.has("other kinds"):
        open("a.off", "wb").write(b"OFF BINARY\n" + bytes(12))
        return "a.off"
    formats.off(word, ["%g %g %g%s" % (*p, b) for p, b in zip(t.points, behind)], faces)
    return "a.off"


def write_stl(t):
    colour = 0x8000 | 31 << 10 | 15 << 5 if t.colour else 0
    normal = (1, 0, 0) if t.has("normals") else (0, 0, 1)
    facets = b"".join(struct.pack("<12fH", *normal, *(c for i in corners for c in t.points[i]), colour) for corners in t.triangles())
    open("a.stl", "wb").write(b"a square".ljust(80, b"\0") + struct.pack("<I", len(t.triangles())) + facets)
    return "a.stl"


# -- 3MF ----------------------------------------------------------------------------------------------------------------

def mf_mesh(t, looks, scale, inside=""):
    points = "".join('<vertex x="%r" y="%r" z="%r"/>' % tuple(c * scale for c in p) for p in t.points)
    triangles = "".join('<triangle v1="%d" v2="%d" v3="%d" %s/>' % (*corners, looks(corners)) for corners in t.triangles())
    return '<object id="1" type="%s"><mesh><vertices>%s</vertices><triangles>%s</triangles>%s</mesh></object>' % (
        "model" if inside else "surface", points, triangles, inside)


def mf_group(name, inside):
    return '<m:%s>%s</m:%s>' % (name, inside, name.split()[0])


def write_3mf(t):
    resources, files, names, inside = "", [], "", ""
    items, unit, scale = formats.item(1), "meter", 1.0

    def looks(corners):
        return ""
    colours = t.ends or [t.colour] * 4 if t.ends or t.colour else None
    if t.feature == "opacity":
        colours = [(255, 255, 255, 128 if t.said else 255)] * 4
    if colours:
        resources = mf_group('colorgroup id="7"', "".join('<m:color color="#%s"/>' % bytes(c).hex().upper() for c in colours))

        def looks(corners):
            return 'pid="7" p1="%d" p2="%d" p3="%d"' % corners
    if t.has_picture:
        style = {"clamped pictures": 'tilestyleu="clamp"', "mirrored pictures": 'tilestyleu="mirror"'}.get(t.feature, "") if t.said else ""
        resources = '<m:texture2d id="5" path="/3D/Textures/four.png" contenttype="image/png" %s/>' % style + mf_group(
            'texture2dgroup id="6" texid="5"', "".join('<m:tex2coord u="%g" v="%g"/>' % uv for uv in t.uvs))
        if os.path.exists("four.png"):
            files = [("3D/Textures/four.png", open("four.png", "rb").read())]

        def looks(corners):
            return 'pid="6" p1="%d" p2="%d" p3="%d"' % corners
    if t.feature == "units":
        unit, scale = "inch" if t.said else "meter", 1 / 0.0254
    if t.has("nodes and instances"):
        resources_behind = '<object id="2"><components>%s</components></object>' % "".join(
            formats.item(1, x, element="component") for x in (-1.0, 1.0))
        items = formats.item(2)
    else:
        resources_behind = ""
    if t.has("lines and points"):
        inside = '<b:beamlattice radius="0.1" minlength="0.01"><b:beams><b:beam v1="0" v2="1"/></b:beams></b:beamlattice>'
        names = 'xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02" requiredextensions="b"'
    formats.three_mf(resources + mf_mesh(t, looks, scale, inside) + resources_behind, items, unit=unit, names=names, files=files)
    return "a.3mf"


# -- glTF ---------------------------------------------------------------------------------------------------------------

def write_gltf(t, more=()):
    blob, root = b"", {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "bufferViews": [],
                       "accessors": []}

    def put(rows, kind="f", number=5126):
        nonlocal blob
        data = b"".join(struct.pack("<%d%s" % (len(r), kind), *r) for r in rows)
        root["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
        blob += data + b"\0" * (-len(data) % 4)
        root["accessors"].append({"bufferView": len(root["bufferViews"]) - 1, "componentType": number, "count": len(rows),
                                  "type": {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[len(rows[0])],
                                  "min": [min(c) for c in zip(*rows)], "max": [max(c) for c in zip(*rows)]})
        return len(root["accessors"]) - 1

    def linear(colour):
        return [c / 255 / 12.92 if c <= 10 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in colour]
    attributes = {"POSITION": put(t.points)}
    pbr = {"baseColorFactor": (linear(t.colour) if t.colour else [0.5] * 3) + [1]}
    material = {"pbrMetallicRoughness": pbr}
    primitive = {"attributes": attributes, "indices": put([(i,) for c in t.triangles() for i in c], "H", 5123), "material": 0}
    mesh = {"primitives": [primitive]}
    root.update(materials=[material], meshes=[mesh])
    if t.ends:
        attributes["COLOR_0"], pbr["baseColorFactor"] = put([linear(c) for c in t.ends]), [1, 1, 1, 1]
    if t.uvs:
        attributes["TEXCOORD_0"] = put([(u, 1 - v) for u, v in t.uvs])
    texture = {"index": 0}
    if t.has_picture or t.has("bumps"):
        formats.four_png() if t.has("bumps") else None
        wrap = {"clamped pictures": 33071, "mirrored pictures": 33648}.get(t.feature, 10497) if t.said else 10497
        root.update(images=[{"uri": "four.png"}], samplers=[{"wrapS": wrap, "wrapT": wrap}], textures=[{"source": 0, "sampler": 0}])
    if t.has("parts of pictures"):
        texture["extensions"] = {"KHR_texture_transform": {"offset": [0.5, 0]}}
        root["extensionsUsed"] = ["KHR_texture_transform"]
    if t.feature == "pictures of light":
        pbr["baseColorFactor"] = [0, 0, 0, 1]
        material.update({"emissiveTexture": texture, "emissiveFactor": [1, 1, 1]} if t.said else {})
    elif t.has_picture:
        pbr.update(baseColorTexture=texture, baseColorFactor=[1, 1, 1, 1])
    if t.feature == "light of faces":
        pbr["baseColorFactor"] = [0, 0, 0, 1]
    if t.has("opacity"):
        pbr["baseColorFactor"], material["alphaMode"] = [1, 1, 1, 0.5], "BLEND"
    statements = {"holes in pictures": {"alphaMode": "MASK"}, "light of faces": {"emissiveFactor": linear(ORANGE)},
                  "faces with two sides": {"doubleSided": True}, "shine": {"extensions": {"KHR_materials_sheen": {}}},
                  "bumps": {"normalTexture": texture}}
    material.update(statements.get(t.feature, {}) if t.said else {})
    used = {"shine": "KHR_materials_sheen", "lights": "KHR_lights_punctual"}
    if t.said and t.feature in used:
        root["extensionsUsed"] = [used[t.feature]]
    if t.has("nodes and instances"):
        root["nodes"] = [{"children": [1, 2]}, {"mesh": 0, "translation": [-1, 0, 0]}, {"mesh": 0, "translation": [1, 0, 0]}]
    if t.has("animated nodes"):
        root["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                               "samplers": [{"input": put([(0.0,), (1.0,)]), "output": put([(1, 0, 0), (2, 0, 0)])}]}]
    if t.has("morph targets"):
        primitive["targets"], mesh["weights"] = [{"POSITION": put([(1, 0, 0)] * 4)}], [1]
    if t.has("skins"):
        attributes["JOINTS_0"], attributes["WEIGHTS_0"] = put([(0, 0, 0, 0)] * 4, "B", 5121), put([(1, 0, 0, 0)] * 4)
        root["nodes"] = [{"mesh": 0, "skin": 0}, {"translation": [1, 0, 0]}]
        root["scenes"][0]["nodes"], root["skins"] = [0, 1], [{"joints": [1]}]
    if t.has("lights"):
        root["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}
        root["nodes"][0]["extensions"] = {"KHR_lights_punctual": {"light": 0}}
    if t.has("cameras"):
        root["cameras"] = [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]
        root["nodes"].append({"camera": 0, "translation": [0, 0, 9]})
        root["scenes"][0]["nodes"].append(1)
    if t.has("lines and points"):
        mesh["primitives"].append({"attributes": attributes, "mode": 2})
    if t.has("normals"):
        attributes["NORMAL"] = put([(1, 0, 0)] * 4)
    root.update(more)
    root["buffers"] = [{"uri": "a.bin", "byteLength": len(blob)}]
    open("a.bin", "wb").write(blob)
    json.dump(root, open("a.gltf", "w"))
    return "a.gltf"


WRITERS = {"OBJ": write_obj, "glTF": write_gltf, "PLY": write_ply, "STL": write_stl, "OFF": write_off, "3MF": write_3mf,
           "FBX": write_fbx, "Collada": xml.write_collada, "WAD": write_wad}

# What each writes something of.
COLOURED = ["colours of faces", "colours of corners", "colours that change"]
SHAPED = ["faces of many corners", "bent faces"]
SCENES = ["nodes and instances", "animated nodes", "skins", "morph targets", "lights", "cameras"]
LOOKS = ["opacity", "light of faces", "pictures of light", "shine", "bumps"]
MAPS = ["pictures", "clamped pictures", "parts of pictures", "holes in pictures", "missing pictures"]
FEATURES = {
    "OBJ": SHAPED + COLOURED + MAPS + LOOKS + ["lines and points", "curves and surfaces", "normals"],
    "glTF": COLOURED + MAPS + LOOKS + SCENES + ["mirrored pictures", "faces with two sides", "lines and points", "normals"],
    "PLY": SHAPED + COLOURED + ["pictures", "holes in pictures", "missing pictures", "opacity", "lines and points", "normals"],
    "STL": ["colours of faces", "up axis", "normals"],
    "OFF": SHAPED + COLOURED + ["opacity", "lines and points", "normals", "other kinds"],
    "3MF": COLOURED + ["pictures", "clamped pictures", "mirrored pictures", "holes in pictures", "missing pictures", "opacity", "units",
                       "up axis", "nodes and instances", "lines and points"],
    "FBX": SHAPED + COLOURED + MAPS + LOOKS + SCENES + ["faces with two sides", "units", "up axis", "lines and points", "normals"],
    "Collada": SHAPED + COLOURED + MAPS + LOOKS + SCENES + ["mirrored pictures", "faces with two sides", "units", "up axis",
                                                           "lines and points", "curves and surfaces", "normals"],
    "WAD": ["pictures", "holes in pictures", "missing pictures", "lights", "other kinds"],
}
