# SPDX-License-Identifier: MIT
#
# Models of formats that carry colours of faces, pictures and units, written here byte by byte; and what is seen of them
# through a camera whose rays are computed here. Nothing of the program is known but its command line.
#
#     python3 formats.py LIMNER CASE
#
# writes into the working folder and fails with words if what is drawn, or said, is not what the file has.
import struct
import subprocess
import sys
import zipfile
import zlib
from math import radians, tan

W, H, FAR_M = 160, 80, 4.0  # of the picture; the eye is FAR_M in front of the plane z = 0
LEFT, RIGHT = -1.5, 1.5
COLOURS = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 128, 0)]
GREY, BLACK = (200, 200, 200), (0, 0, 0)
ROW = [-1.5, -0.5, 0.5, 1.5]  # the middles of four squares of 1 m, from left to right


# -- Looking ------------------------------------------------------------------------------------------------------------

def unfiltered(kind, row, above, step):
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        guess = left + above[i] - corner
        paeth = min((abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]), (abs(guess - corner), 2, corner))[2]
        row[i] = (row[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) & 255
    return row


def png_read(path):
    data, at, packed, palette = open(path, "rb").read(), 8, b"", b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b"IHDR":
            w, h, depth, colours = struct.unpack(">IIBB", body[:10])
        if kind == b"PLTE":
            palette = body
        if kind == b"IDAT":
            packed += body
    channels = {0: 1, 2: 3, 3: 1, 6: 4}[colours]
    row_b, step, raw = (w * channels * depth + 7) // 8, max(1, channels * depth // 8), zlib.decompress(packed)
    rows, above = [], bytearray(row_b)
    for y in range(h):
        begin = y * (row_b + 1)
        above = unfiltered(raw[begin], bytearray(raw[begin + 1:begin + 1 + row_b]), above, step)
        rows.append(above)

    def pixel(x, y):
        if colours == 3:
            index = rows[y][x * depth // 8] >> (8 - depth - x * depth % 8) & (1 << depth) - 1
            return tuple(palette[3 * index:3 * index + 3])
        return tuple(rows[y][x * channels:x * channels + 3])
    return pixel


def png(rows):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    raw = b"".join(b"\0" + b"".join(bytes(pixel) for pixel in row) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b"")


def run(path, *options, far_m=FAR_M, look=(0, 0)):
    open("front.cam", "w").write("%.9g %.9g %.9g %.9g %.9g 0\n" % (look[0], look[1], far_m, look[0], look[1]))
    command = [LIMNER, "render", path, "--camera", "front.cam", "-o", "seen.png", "--size", "%dx%d" % (W, H), "--fov", "60",
               "--unlit", *options]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
    return done.returncode, done.stderr.decode(errors="replace")


class Seen:
    """What is drawn of a file, and what is said."""

    def __init__(self, path, *options, far_m=FAR_M, look=(0, 0)):
        status, self.said = run(path, *options, far_m=far_m, look=look)
        if status:
            sys.exit("%s is refused: %s" % (path, self.said))
        self.pixel, self.per_m, self.look = png_read("seen.png"), H / 2 / (far_m * tan(radians(30))), look

    def at(self, x_m, y_m=0.0):
        x, y = W / 2 + (x_m - self.look[0]) * self.per_m, H / 2 - (y_m - self.look[1]) * self.per_m
        return self.pixel(int(x), int(y))

    def shows(self, *expected):
        """(x_m, y_m, colour); displays have 5 or 6 bits a channel."""
        for x_m, y_m, colour in expected:
            seen = self.at(x_m, y_m)
            if any(abs(a - b) > 9 for a, b in zip(seen, colour)):
                sys.exit("at %g, %g m there is %s instead of %s; %s" % (x_m, y_m, seen, colour, self.said))
        return self

    def row(self, colours):
        return self.shows(*((x_m, 0.0, colour) for x_m, colour in zip(ROW, colours)))

    def says(self, *lines):
        for line in lines:
            if line not in self.said:
                sys.exit("not said: %s; but: %s" % (line, self.said))
        return self

    def is_quiet(self):
        return self if not self.said else sys.exit("said: " + self.said)


def refused(path, *words):
    status, said = run(path)
    if not status or said.count("\n") != 1 or not all(word in said for word in words):
        sys.exit("status %d: %s" % (status, said))


# -- Four squares in a row ----------------------------------------------------------------------------------------------

POINTS = [(x - 2.0, y, 0.0) for y in (-0.5, 0.5) for x in range(5)]
SQUARES = [(i, i + 1, i + 6, i + 5) for i in range(4)]
OWN_POINTS = [POINTS[k] for square in SQUARES for k in square]  # no two squares share one
OWN_SQUARES = [tuple(range(4 * i, 4 * i + 4)) for i in range(4)]
CORNERS_UV = [(0, 0), (1, 0), (1, 1), (0, 1)]  # from the bottom
FOUR = [[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 255)]]  # a picture, its rows from the top
QUARTERS = [(-0.25, 0.25, FOUR[0][0]), (0.25, 0.25, FOUR[0][1]), (-0.25, -0.25, FOUR[1][0]), (0.25, -0.25, FOUR[1][1])]


def four_png(path="four.png"):
    open(path, "wb").write(png([[pixel for pixel in row for _ in range(8)] for row in FOUR for _ in range(8)]))


def quarters(x_m):
    return [(x_m + x, y, colour) for x, y, colour in QUARTERS]


# -- PLY ----------------------------------------------------------------------------------------------------------------

CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}


def ply(path, coding, elements, comments=()):
    """elements: (name, [(type, name) or (count type, type, name)], [[value or list of values]])"""
    order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[coding]
    head = ["ply", "format %s 1.0" % coding] + ["comment " + text for text in comments]
    body = b""
    for name, properties, instances in elements:
        head.append("element %s %d" % (name, len(instances)))
        head += ["property " + ("list " if len(p) == 3 else "") + " ".join(p) for p in properties]
        for instance in instances:
            words = []
            for p, value in zip(properties, instance):
                if len(p) == 3:
                    words.append((p[0], len(value)))
                words += [(p[-2], number) for number in (value if len(p) == 3 else [value])]
            if order:
                body += b"".join(struct.pack(order + CODES[kind], number) for kind, number in words)
            else:
                body += (" ".join(repr(number) for _, number in words) + "\n").encode()
    open(path, "wb").write(("\n".join(head) + "\nend_header\n").encode() + body)


XYZ = [("float", axis) for axis in "xyz"]
CORNERS = ("uchar", "int", "vertex_indices")


def ply_vertices(points=POINTS):
    return ("vertex", XYZ, [list(p) for p in points])


def ply_face_colours():
    kinds = [("ascii", "uchar", "", 1), ("binary_big_endian", "ushort", "", 257), ("binary_little_endian", "float", "", 1 / 255),
             ("ascii", "float", "diffuse_", 1 / 255), ("ascii", "int", "", 1), ("binary_big_endian", "uchar", "diffuse_", 1)]
    for coding, kind, prefix, scale in kinds:
        names = [(kind, prefix + name) for name in ("red", "green", "blue")]
        turn = float if kind == "float" else int
        faces = [[list(s)] + [turn(c * scale) for c in colour] for s, colour in zip(SQUARES, COLOURS)]
        ply("a.ply", coding, [ply_vertices(), ("face", [CORNERS] + names, faces)])
        Seen("a.ply").row(COLOURS).is_quiet()


def ply_alpha():
    names = [("uchar", name) for name in ("red", "green", "blue", "alpha")]
    faces = [[list(s), 255, 255, 255, alpha] for s, alpha in zip(SQUARES, (255, 128, 64, 255))]
    ply("a.ply", "ascii", [ply_vertices(), ("face", [CORNERS] + names, faces)])
    Seen("a.ply").row([(a, a, a) for a in (255, 128, 64, 255)]).is_quiet()
    ply("a.ply", "ascii", [ply_vertices(), ("face", [CORNERS] + names, [f[:-1] + [0] for f in faces])])
    Seen("a.ply").row([(255, 255, 255)] * 4).says("the alpha of all its colours is 0; they are drawn as opaque")


def ply_faces_come_first():
    names = [("uchar", name) for name in ("red", "green", "blue")]
    faces = [[list(s), *colour] for s, colour in zip(SQUARES, COLOURS)]
    for coding in ("ascii", "binary_little_endian"):
        ply("a.ply", coding, [("face", [CORNERS] + names, faces), ply_vertices()])
        Seen("a.ply").row(COLOURS)


def ply_strips():
    for coding in ("ascii", "binary_little_endian", "binary_big_endian"):
        strip = [0, 1, 5, 6, -1, 7, 8, 2, 3, -1, -1, 3]
        ply("a.ply", coding, [ply_vertices(), ("tristrips", [("int", "int", "vertex_indices")], [[strip], [[3, 4, 8, 9]]])])
        Seen("a.ply", "--compare").row([GREY, BLACK, GREY, GREY])
        Seen("a.ply").shows((-1.9, 0.4, GREY), (-1.1, -0.4, GREY), (-1.1, 0.4, GREY), (-0.9, 0.4, BLACK))


def ply_vertex_places():
    four_png()
    for u, v in (("s", "t"), ("u", "v"), ("texture_u", "texture_v")):
        vertices = [list(p) + list(CORNERS_UV[i % 4]) for i, p in enumerate(OWN_POINTS)]
        ply("a.ply", "ascii", [("vertex", XYZ + [("float", u), ("float", v)], vertices),
                               ("face", [CORNERS], [[list(s)] for s in OWN_SQUARES])], ["TextureFile four.png \t "])
        Seen("a.ply").shows(*quarters(-1.5), *quarters(0.5)).is_quiet()


def ply_corner_places():
    four_png()
    uvs = [[c for uv in CORNERS_UV for c in uv], [c for uv in CORNERS_UV[2:] + CORNERS_UV[:2] for c in uv]]
    for coding in ("ascii", "binary_little_endian"):
        faces = [[list(s), [float(c) for c in uvs[i % 2]]] for i, s in enumerate(SQUARES)]
        ply("a.ply", coding, [ply_vertices(), ("face", [CORNERS, ("uchar", "float", "texcoord")], faces)],
            ["TextureFile four.png"])
        turned = [(-0.5 - x, -y, colour) for x, y, colour in QUARTERS]
        Seen("a.ply", "--compare").shows(*quarters(-1.5), *turned)
    faces[0][1] = faces[0][1][:6]
    ply("a.ply", coding, [ply_vertices(), ("face", [CORNERS, ("uchar", "float", "texcoord")], faces)], ["TextureFile four.png"])
    Seen("a.ply").says("1 faces have lists of texture coordinates that do not fit their corners",
                       "1 faces have a texture, but no texture coordinates")


def ply_pictures_by_number():
    four_png()
    open("one.png", "wb").write(png([[(255, 128, 0)] * 8] * 8))
    uv = [float(c) for place in CORNERS_UV for c in place]
    faces = [[list(s), uv, number] for s, number in zip(SQUARES, (0, 1, -1, 2))]
    ply("a.ply", "ascii", [ply_vertices(), ("face", [CORNERS, ("uchar", "float", "texcoord"), ("int", "texnumber")], faces)],
        ["TextureFile four.png", "TextureFile one.png"])
    Seen("a.ply").shows(*quarters(-1.5), (-0.5, 0, (255, 128, 0)), (0.5, 0, GREY), (1.5, 0, GREY)).says(
        "1 faces have a picture's number beyond the 2 that it names")


def ply_corner_colours():
    ends = [(255, 0, 0), (255, 0, 0), (0, 0, 255), (0, 0, 255), (0, 255, 0)]
    vertices = [list(p) + list(ends[i % 5]) for i, p in enumerate(POINTS)]
    faces = [[list(s)] for s in SQUARES]
    rgb = [("uchar", name) for name in ("red", "green", "blue")]
    ply("a.ply", "ascii", [("vertex", XYZ + rgb, vertices), ("face", [CORNERS], faces)])
    Seen("a.ply").row([(255, 0, 0), (128, 0, 128), (0, 0, 255), (0, 128, 128)]).says(
        "2 faces have colours that change over them; each is drawn in their mean")
    own = [face + list(colour) for face, colour in zip(faces, COLOURS)]
    ply("a.ply", "ascii", [("vertex", XYZ + rgb, vertices), ("face", [CORNERS] + rgb, own)])
    Seen("a.ply").row(COLOURS).says("both its vertices and its faces have colours; it is drawn in those of the faces")


def ply_points_up_to_255():
    names = [("float", name) for name in ("red", "green", "blue")]
    faces = [[list(s)] + [float(c) for c in colour] for s, colour in zip(SQUARES, COLOURS)]
    ply("a.ply", "binary_little_endian", [ply_vertices(), ("face", [CORNERS] + names, faces)])
    Seen("a.ply").row(COLOURS).says("its colours are numbers up to 255, which are taken as parts of 255")


def ply_damage():
    text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n" \
           "property list int int vertex_indices\nend_header\n"
    for body, words in (("0 0 0\n1 0\n0 1 0\n3 0 1 2\n", ["a.ply:11: the line has fewer numbers", "vertex 2"]),
                        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ["face 1: vertex index 3 is out of range, there are 3"]),
                        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", ["face 1: vertex index -1 is out of range"]),
                        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 0.5\n", ["face 1: vertex index 0.5 is out of range"]),
                        ("0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", ["a list of face has no whole number in front"]),
                        ("0 0 0\n1 0 0\n0 1 0\n3 0 1", ["truncated: it ends within face 1 of 1"])):
        open("a.ply", "w").write(text + body)
        refused("a.ply", *words)
    for line in ("property colour red", "property list int red", "element face", "format ascii2 1.0"):
        open("a.ply", "w").write(text.replace("end_header", line + "\nend_header"))
        refused("a.ply", "a.ply:9: '%s' is not understood" % line)
    open("a.ply", "w").write(text.replace("float y", "float w"))
    refused("a.ply", "its vertices have no x, y and z")


# -- OFF ----------------------------------------------------------------------------------------------------------------

def off(word, vertices, faces, counts=True):
    lines = ([word] if word else []) + ["# a comment", "%d %d %s" % (len(vertices), len(faces), "0" if counts else "")]
    open("a.off", "w").write("\n".join(lines + [""] + vertices + ["# faces"] + faces) + "\n")


def off_points(behind=""):
    return ["%g %g %g%s" % (*p, behind) for p in POINTS]


def off_faces(colours):
    return ["4 %d %d %d %d %s" % (*s, colour) for s, colour in zip(SQUARES, colours)]


def off_face_colours():
    whole = ["%d %d %d" % colour for colour in COLOURS]
    parts = ["%.3f %.3f %.3f # %s" % (*(c / 255 for c in colour), "b") for colour in COLOURS]
    mixed = ["1 0 0", "0 1 0", "0 0 1", "1 0.5 0"]  # as programs print whole parts
    for colours in (whole, parts, mixed):
        for word in ("OFF", None):
            off(word, off_points(), off_faces(colours), counts=word is not None)
            Seen("a.off").row(COLOURS).is_quiet()
    off("OFF", off_points(), off_faces(["255 255 255 255", "255 255 255 128", "255 255 255 64", ""]))
    Seen("a.off").row([(255,) * 3, (128,) * 3, (64,) * 3, GREY]).is_quiet()
    off("OFF", off_points(), off_faces(["3", "255 0 0", "7", ""]))
    Seen("a.off").row([GREY, (255, 0, 0), GREY, GREY]).says("2 faces have a number of a colour map, which is not in the file")


def off_vertex_colours():
    ends = [(255, 0, 0), (255, 0, 0), (0, 0, 255), (0, 0, 255), (0, 255, 0)]
    means = [(255, 0, 0), (128, 0, 128), (0, 0, 255), (0, 128, 128)]
    for word, normal, parts, place in (("COFF", "", False, ""), ("CNOFF", " 0 0 1", False, ""), ("COFF", "", True, ""),
                                       ("STCOFF", "", False, " .5 .5"), ("STCNOFF", " 0 0 1", True, " 0 1")):
        written = ["%d %d %d 255" % c if not parts else "%.2f %.2f %.2f 1.0" % tuple(v / 255 for v in c) for c in ends]
        vertices = ["%g %g %g%s %s%s" % (*p, normal, written[i % 5], place) for i, p in enumerate(POINTS)]
        off(word, vertices, off_faces([""] * 4))
        Seen("a.off").row(means).says("2 faces have colours that change over them")
    vertices = ["%g %g %g 2" % tuple(2 * c for c in p) for p in POINTS]
    off("4OFF", vertices, off_faces(["%d %d %d" % colour for colour in COLOURS]))
    Seen("a.off").row(COLOURS).is_quiet()
    off("NOFF", off_points(" 0 0 1"), off_faces(["%d %d %d" % colour for colour in COLOURS]))
    Seen("a.off").row(COLOURS).is_quiet()


def off_without_a_blank():
    off("OFF", off_points(), off_faces(["%d %d %d" % colour for colour in COLOURS]))
    text = open("a.off").read().replace("OFF\n# a comment\n", "OFF")
    open("a.off", "w").write(text)
    Seen("a.off").row(COLOURS).is_quiet()


def off_many_corners():
    from math import cos, pi, sin
    ring = [(cos(2 * pi * k / 24), sin(2 * pi * k / 24), 0) for k in range(24)]
    off("OFF", ["%.9f %.9f %.9f" % p for p in ring], ["24 " + " ".join(map(str, range(24))) + " 0 255 0"])
    Seen("a.off").shows((0, 0, (0, 255, 0)), (0.9, 0, (0, 255, 0)), (-0.6, 0.6, (0, 255, 0)), (0.8, 0.8, BLACK)).is_quiet()


def off_damage():
    for text, words in (("OFF BINARY\n\0\0", ["OFF of bytes is not read; save it as text"]),
                        ("nOFF 4\n1 1 0\n", ["vertices of 4 dimensions"]), ("OFF\n3 1 0\n0 0 0\n1 0\n", ["a.off:4: a vertex has fewer"]),
                        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", ["a.off:6: a face has fewer corners"]),
                        ("OFF\n-3 1 0\n", ["'-3' is no whole number"]), ("COFF\n1 0 0\n0 0 0 1\n", ["a.off:3: a vertex has fewer"]),
                        ("OFF\n4000000 1 0\n0 0 0\n", ["a.off:4: the file ends before its vertices"])):
        open("a.off", "w").write(text)
        refused("a.off", *words)


# -- STL ----------------------------------------------------------------------------------------------------------------

def triangles():
    """Two of each square, in its number."""
    for number, square in enumerate(SQUARES):
        for corners in (square[:3], (square[0], *square[2:])):
            yield number, [POINTS[k] for k in corners]


def stl(name, extras, behind=b""):
    facets = [struct.pack("<12fH", 0, 0, 1, *(c for p in points for c in p), extras[number]) for number, points in triangles()]
    open("a.stl", "wb").write(name.ljust(80, b"\0")[:80] + struct.pack("<I", len(facets)) + b"".join(facets) + behind)


def five_bits(colour):
    return [c * 31 // 255 for c in colour]


def stl_seen(*options):
    return Seen("a.stl", "--up", "y", *options)


def stl_viscam():
    def extra(colour):
        r, g, b = five_bits(colour)
        return 0x8000 | r << 10 | g << 5 | b
    stl(b"a head", [extra(c) for c in COLOURS])
    stl_seen("--compare").row(COLOURS)
    stl(b"solid though bytes", [extra(COLOURS[0]), 0x7FFF, extra(COLOURS[2]), 0], b"and more\n")
    seen = stl_seen().row([COLOURS[0], GREY, COLOURS[2], GREY])
    if "behind" in seen.said:
        sys.exit(seen.said)
    stl(b"a head", [extra(c) for c in COLOURS], b"x" * 120)
    stl_seen().row(COLOURS).says("its head counts 8 triangles; 120 bytes behind these are not read")


def stl_magics():
    def extra(colour):
        r, g, b = five_bits(colour)
        return b << 10 | g << 5 | r
    part = b"\x80\x40\x20\xff"
    stl(b"by some CAD COLOR=" + part, [extra(COLOURS[0]), extra(COLOURS[1]), 0x8000, 0xFFFF])
    stl_seen().row([COLOURS[0], COLOURS[1], (128, 64, 32), (128, 64, 32)])
    stl(b"COLOR=" + part + b",MATERIAL=" + b"\x00\xff\x00\xff" + b"\xff" * 8, [0x8000, extra(COLOURS[3]), 0x8000, 0xFFFF])
    stl_seen().row([(0, 255, 0), COLOURS[3], (0, 255, 0), (0, 255, 0)])
    stl(b"COLOR=" + part, [0] * 4)
    stl_seen().row([(128, 64, 32)] * 4)
    stl(b"COLOR=\x10\x10\x10 MATERIAL=\x80\x40\x20 \x10\x10\x10 \x10\x10\x10 ", [0] * 4)  # as MeshLab has it
    stl_seen().row([(128, 64, 32)] * 4)


def stl_text():
    def solid(name, numbers, word=str):
        lines = [word("solid ") + name]
        for number, points in triangles():
            if number not in numbers:
                continue
            lines += [word(" facet normal 0 0 1"), word("  outer loop")]
            lines += [word("   vertex %r %r %r" % p) for p in points] + [word("  endloop"), word(" endfacet")]
        return "\n".join(lines + [word("endsolid ") + name]) + "\n"
    open("a.stl", "w").write(solid("one facet", [0], str.upper) + solid("vertex 2", [1]) + solid("", []) + solid("x", [3]))
    stl_seen("--compare").row([GREY, GREY, BLACK, GREY])
    open("a.stl", "w").write("\r\n  " + solid("one", range(4)).replace("\n", "\r\n") + "\0\0\0")
    stl_seen().row([GREY] * 4)


# -- 3MF ----------------------------------------------------------------------------------------------------------------

TYPES = '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">%s</Types>' % "".join(
    '<Default Extension="%s" ContentType="%s"/>' % pair for pair in (
        ("rels", "application/vnd.openxmlformats-package.relationships+xml"), ("png", "image/png"),
        ("model", "application/vnd.ms-package.3dmanufacturing-3dmodel+xml")))
RELATIONS = '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">' \
            '<Relationship Target="%s" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/%s"/></Relationships>'
NAMES = 'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" ' \
        'xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02"'


def three_mf(resources, items, unit="meter", names="", files=()):
    model = '<?xml version="1.0"?><model unit="%s" %s %s><resources>%s</resources><build>%s</build></model>' % (
        unit, NAMES, names, resources, items)
    with zipfile.ZipFile("a.3mf", "w", zipfile.ZIP_DEFLATED) as package:
        package.writestr("[Content_Types].xml", TYPES)
        package.writestr("_rels/.rels", RELATIONS % ("/3D/3dmodel.model", "3dmodel"))
        package.writestr("3D/3dmodel.model", model)
        for name, data in files:
            package.writestr("3D/_rels/3dmodel.model.rels", RELATIONS % ("/" + name, "3dtexture"))
            package.writestr(name, data)


def square_mesh(looks=("", ""), scale=1.0):
    """A square of 1 m about the origin, seen from +z."""
    points = "".join('<vertex x="%r" y="%r" z="0"/>' % (x * scale, y * scale)
                     for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)))
    return '<mesh><vertices>%s</vertices><triangles><triangle v1="0" v2="1" v3="2" %s/><triangle v1="0" v2="2" v3="3" %s/>' \
           '</triangles></mesh>' % (points, *looks)


def square(number, attributes="", looks=("", ""), scale=1.0):
    return '<object id="%d" %s>%s</object>' % (number, attributes, square_mesh(looks, scale))


def item(number, x_m=0.0, y_m=0.0, turn="1 0 0 0 1 0 0 0 1", element="item"):
    return '<%s objectid="%d" transform="%s %r %r 0"/>' % (element, number, turn, x_m, y_m)


def mf_seen(*options, **where):
    return Seen("a.3mf", "--up", "y", *options, **where)


PALETTE = '<basematerials id="100">%s</basematerials>' % "".join(
    '<base name="m" displaycolor="#%02X%02X%02X"/>' % c for c in COLOURS) + '<m:colorgroup id="101">%s</m:colorgroup>' % "".join(
        '<m:color color="#%02X%02X%02XFF"/>' % c for c in COLOURS)


def mf_colours():
    whose = ['pid="100" pindex="0"', 'pid="101" pindex="1"', 'pid="100" pindex="2"', ""]
    both = ('pid="101" p1="3"', 'pid="100" p1="3"')
    objects = "".join(square(i + 1, whose[i], both if i == 3 else ("", "")) for i in range(4))
    three_mf(PALETTE + objects, "".join(item(i + 1, x) for i, x in enumerate(ROW)))
    mf_seen().row(COLOURS).is_quiet()
    three_mf(PALETTE + square(1, 'pid="101" pindex="1"', ("", 'pid="101" p1="0" p2="2" p3="2"')), item(1))
    mf_seen().shows((0.25, -0.25, (0, 255, 0)), (-0.25, 0.25, (85, 0, 170))).says(
        "1 faces have colours that change over them; each is drawn in their mean")
    # A triangle's group that is unknown leaves it to its object.
    mixed = '<m:compositematerials id="8" matid="100" matindices="0 1"><m:composite values="0.5 0.5"/></m:compositematerials>'
    for whose, colour in (('pid="101" pindex="1"', COLOURS[1]), ('pid="100" pindex="3"', COLOURS[3])):
        three_mf(PALETTE + mixed + square(1, whose, ('pid="8" p1="0"',) * 2), item(1))
        mf_seen().shows((0, 0, colour)).says("1 elements are unknown to lib3mf")
    group = '<m:colorgroup id="7"><m:color color="#FFFFFF80"/></m:colorgroup>'
    three_mf(group + square(1, 'pid="7" pindex="0"'), item(1))
    mf_seen().shows((0, 0, (128, 128, 128))).is_quiet()


def mf_pictures():
    four_png()
    data = open("four.png", "rb").read()
    places = '<m:texture2dgroup id="6" texid="5">%s</m:texture2dgroup>' % "".join(
        '<m:tex2coord u="%d" v="%d"/>' % uv for uv in CORNERS_UV + [(2, 0), (2, 2), (0, 2)])
    looks = ('pid="6" p1="0" p2="1" p3="2"', 'pid="6" p1="0" p2="2" p3="3"')
    picture = '<m:texture2d id="5" path="/3D/Textures/four.png" contenttype="image/png" %s/>'
    three_mf(picture % "" + places + square(1, "", looks), item(1, -1.5) + item(1, 0.5, turn="-1 0 0 0 1 0 0 0 1"),
             files=[("3D/Textures/four.png", data)])
    mirrored = [(0.5 - x, y, colour) for x, y, colour in QUARTERS]
    mf_seen().shows(*quarters(-1.5), *mirrored).is_quiet()
    twice = ('pid="6" p1="0" p2="4" p3="5"', 'pid="6" p1="0" p2="5" p3="6"')
    three_mf(picture % 'tilestyleu="clamp"' + places + square(1, "", twice), item(1), files=[("3D/Textures/four.png", data)])
    mf_seen().shows((-0.375, 0.375, FOUR[0][0]), (0.125, -0.125, FOUR[0][0])).says(
        "2 faces reach beyond a picture that is not to repeat; it repeats")


def mf_assemblies():
    inner = '<object id="2"><components>%s</components></object>' % (
        item(1, 1.0, element="component") + item(1, -1.0, turn="-1 0 0 0 0.5 0 0 0 1", element="component"))
    outer = '<object id="3"><components>%s</components></object>' % item(2, 0.0, 0.0, "0 1 0 -1 0 0 0 0 1", "component")
    three_mf(PALETTE + square(1, 'pid="100" pindex="1"') + inner + outer, item(3, 0.25, 0.25))
    green = COLOURS[1]  # at (0.25, 1.25), 1 m wide; and at (0.25, -0.75), 0.5 m wide, 1 m high
    mf_seen().shows((0.25, 1.25, green), (-0.15, 0.9, green), (-0.4, 1.25, BLACK), (0.25, 0.25, BLACK), (0.25, -0.75, green),
                    (0.4, -0.4, green), (0.6, -0.75, BLACK), (-0.1, -0.75, BLACK)).is_quiet()


def mf_kinds():
    objects = square(1, 'type="support"') + square(2, 'type="solidsupport"') + square(3, 'type="surface"') + square(
        4, 'type="other"')
    turned = "-1 0 0 0 1 0 0 0 -1"
    three_mf(objects + square(5), item(1, -1.5) + item(2, -0.5) + item(3, 0.5, turn=turned) + item(5, 1.5) + item(4, -1.5))
    mf_seen().row([BLACK, BLACK, GREY, GREY]).says("2 objects are supports for printing, and left out",
                                                   "1 objects are of the kind 'other', and left out")
    three_mf(square(1, 'type="support"'), item(1))
    refused("a.3mf", "nothing to draw: of its objects 1 are supports")
    lattice = '<b:beamlattice radius="0.1" minlength="0.01"><b:beams><b:beam v1="0" v2="1"/></b:beams></b:beamlattice></mesh>'
    three_mf(square(1).replace("</mesh>", lattice), item(1),
             names='xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02" requiredextensions="b"')
    mf_seen().shows((0, 0, GREY)).says("1 objects have beams, which are not drawn")
    mixed = '<m:compositematerials id="8" matid="100" matindices="0 1"><m:composite values="0.5 0.5"/></m:compositematerials>'
    three_mf(PALETTE + mixed + square(1, 'pid="8" pindex="0"'), item(1))
    mf_seen().says("1 elements are unknown to lib3mf, as composite materials and multiproperties are; left out")
    three_mf(square(1), item(1), names='xmlns:zz="http://example.org/zz" requiredextensions="zz"')
    mf_seen().says("it requires an extension that is not read")


def mf_units():
    for unit, unit_m in (("micron", 1e-6), ("millimeter", 1e-3), ("centimeter", 0.01), ("inch", 0.0254), ("foot", 0.3048),
                         ("meter", 1.0)):
        three_mf(square(1, scale=1 / unit_m) + square(2, scale=0.2 / unit_m), item(1) + item(2, 1.5 / unit_m), unit=unit)
        mf_seen().shows((0, 0, GREY), (0.45, 0, GREY), (0.55, 0, BLACK), (1.5, 0, GREY), (1.7, 0, BLACK))
    three_mf(square(1, scale=1000), item(1))
    with zipfile.ZipFile("a.3mf") as package:
        model = package.read("3D/3dmodel.model").decode()
    if 'unit="meter"' not in model:
        sys.exit("the test's own file has no unit")
    with zipfile.ZipFile("a.3mf", "w") as package:
        for name, data in (("[Content_Types].xml", TYPES), ("_rels/.rels", RELATIONS % ("/3D/3dmodel.model", "3dmodel")),
                           ("3D/3dmodel.model", model.replace('unit="meter"', ""))):
            package.writestr(name, data)
    mf_seen().shows((0, 0, GREY), (0.45, 0, GREY), (0.55, 0, BLACK))


def mf_is_z_up():
    three_mf(square(1, 'type="surface"'), item(1, 0.0, 0.0, "1 0 0 0 0 1 0 -1 0"))
    Seen("a.3mf").shows((0, 0, GREY), (0.45, 0.45, GREY), (0.55, 0, BLACK)).is_quiet()


def mf_damage():
    three_mf(square(1), item(1))
    whole = open("a.3mf", "rb").read()
    for data in (whole[:-30], whole[:200], b"hello " * 40):
        open("a.3mf", "wb").write(data)
        refused("a.3mf", "a.3mf: damaged, or beyond what lib3mf reads: ")
    for resources, items in ((square(1).replace('v2="2"', 'v2="9"'), item(1)), (square(1), item(5)),
                             (square(1).replace('x="0.5"', 'x="nan"'), item(1))):
        three_mf(resources, items)
        refused("a.3mf", "a.3mf: damaged, or beyond what lib3mf reads: ")
    three_mf(square(1), "")
    refused("a.3mf", "there are no faces in it")
    chain = "".join('<object id="%d"><components>%s</components></object>' % (i, item(i - 1, element="component"))
                    for i in range(2, 200))
    three_mf(square(1) + chain, item(199))
    refused("a.3mf", "objects within objects are more than 64 deep")


# -- Units --------------------------------------------------------------------------------------------------------------

FBX = """; FBX 7.3.0 project file
FBXHeaderExtension:  { FBXHeaderVersion: 1003
 FBXVersion: 7300 }
GlobalSettings:  { Version: 1000
 Properties70:  { %s } }
Objects:  {
 Geometry: 11, "Geometry::a", "Mesh" { Vertices: *12 { a: %s }
  PolygonVertexIndex: *4 { a: 0,1,2,-4 } }
 Model: 12, "Model::a", "Mesh" { Version: 232
  Shading: T
  Culling: "CullingOff" } }
Connections:  {
 C: "OO",12,0
 C: "OO",11,12 }
"""


def square_of(side):
    return [(x * side / 2, y * side / 2, 0.0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def is_one_metre(path):
    seen = Seen(path, "--two-sided", "--up", "y")
    seen.shows((0, 0, seen.at(0, 0)), (0.45, 0.45, seen.at(0, 0)), (0.55, 0, BLACK), (0, 0.55, BLACK))
    if seen.at(0, 0) == BLACK:
        sys.exit("nothing is drawn of " + path)


def fbx_units():
    for factor in (None, 1.0, 2.54, 100.0, 500.0):
        points = ",".join("%r" % c for p in square_of(100 / (factor or 1)) for c in p)
        setting = 'P: "UnitScaleFactor", "double", "Number", "",%r\n P: "UpAxis", "int", "Integer", "",1' % factor if factor else ""
        open("a.fbx", "w").write(FBX % (setting, points))
        is_one_metre("a.fbx")


def amf_units():
    for unit, unit_m in ((None, 1e-3), ("millimeter", 1e-3), ("inch", 0.0254), ("feet", 0.3048), ("meter", 1.0), ("micron", 1e-6)):
        points = "".join("<vertex><coordinates><x>%r</x><y>%r</y><z>%r</z></coordinates></vertex>" % p for p in square_of(1 / unit_m))
        open("a.amf", "w").write(
            '<?xml version="1.0" encoding="utf-8"?><amf %s><object id="1"><mesh><vertices>%s</vertices><volume>'
            "<triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle><triangle><v1>0</v1><v2>2</v2><v3>3</v3></triangle>"
            "</volume></mesh></object></amf>" % ('unit="%s"' % unit if unit else "", points))
        is_one_metre("a.amf")


def collada_units():
    for unit_m in (0.01, 0.0254, 1.0):
        numbers = " ".join("%r" % c for p in square_of(1 / unit_m) for c in p)
        open("a.dae", "w").write(
            '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>'
            '<unit name="u" meter="%r"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>'
            '<source id="p"><float_array id="pa" count="12">%s</float_array><technique_common><accessor source="#pa" count="4" '
            'stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>'
            '</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><polylist count="1">'
            '<input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 2 3</p></polylist></mesh></geometry>'
            '</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>'
            '</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>' % (unit_m, numbers))
        is_one_metre("a.dae")


# -- What is not seen, and why ------------------------------------------------------------------------------------------

def backs_are_told():
    open("a.obj", "w").write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\n")
    told = "a.obj: all its faces turn their backs to every camera, and backs are not drawn: --two-sided or --reverse-faces"
    Seen("a.obj").shows((0.2, 0.2, BLACK)).says(told)
    for option in ("--two-sided", "--reverse-faces"):
        Seen("a.obj", option).shows((0.2, 0.2, GREY)).is_quiet()
    open("a.obj", "a").write("v 0 0 -1\nf 1 2 4\n")  # the back of which is seen as well, but not from everywhere
    Seen("a.obj", "--frames", "1").says(told)
    open("a.obj", "a").write("v 0 9 1\nf 1 2 5\nf 2 1 5\n")
    Seen("a.obj").is_quiet()


def far_places_are_told():
    four_png()
    open("a.mtl", "w").write("newmtl m\nmap_Kd four.png\n")
    for number, words in (("1e5", "1 faces have texture coordinates too large to tell texels apart"), ("0.5", "")):
        open("a.obj", "w").write("mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt %s 0\nvt 1 1\nf 1/1 2/2 3/3\n" % number)
        seen = Seen("a.obj").says(words)
        if "no texture coordinates" in seen.said:
            sys.exit(seen.said)


if __name__ == "__main__":
    LIMNER = sys.argv[1]
    globals()[sys.argv[2]]()
