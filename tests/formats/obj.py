# SPDX-License-Identifier: MIT
#
# OBJ and MTL as people and programs write them, and names of files in models, as formats.py does it:
#
#     python3 obj.py LIMNER CASE
import os
import sys

import formats
from formats import BLACK, COLOURS, CORNERS_UV, FOUR, POINTS, SQUARES, Seen, four_png, png, quarters, refused

GREY = (200, 200, 200)  # of what has no material
RED, GREEN, BLUE, ORANGE = COLOURS
PLACES = ["vt %d %d" % uv for uv in CORNERS_UV]
NAMES = ["a", "b", "c", "d"]


# -- Writing ------------------------------------------------------------------------------------------------------------

def put(path, text):
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    open(path, "wb").write(text if isinstance(text, bytes) else text.encode())
    return path


def obj(libraries=("mtllib a.mtl",), materials=NAMES, corner="%d", vertices="v %g %g %g", places=(), end="\n", extra=()):
    """Four squares from left to right, a material each (None: nothing is said)."""
    lines = list(libraries) + [vertices % p for p in POINTS] + list(places)
    for material, square in zip(materials, SQUARES):
        lines += ["usemtl " + material] if material is not None else []
        lines.append("f " + " ".join(corner.replace("%d", str(v + 1)).replace("%t", str(t + 1)) for t, v in enumerate(square)))
    return end.join(lines + list(extra) + [""])


def mtl(*statements, colours=COLOURS):
    """Each statement is in each material: {kd} is its colour."""
    lines = []
    for name, colour in zip(NAMES, colours):
        lines += ["newmtl " + name] + [s.replace("{kd}", "%.6g %.6g %.6g" % tuple(c / 255 for c in colour)) for s in statements]
    return "\n".join(lines + [""])


def squares(statements, colours=COLOURS, **of_obj):
    put("a.mtl", statements if isinstance(statements, str) else mtl(*statements))
    put("a.obj", obj(**of_obj))
    return Seen("a.obj").row(colours)


def textured(*maps, uvs=PLACES):
    """Four squares, with a map_Kd line each, or with none."""
    four_png()
    put("a.mtl", "".join("newmtl %s\nKd 1 1 1\n%s\n" % pair for pair in zip(NAMES, maps)))
    put("a.obj", obj(places=uvs, corner="%d/%t"))
    return Seen("a.obj")


def only(line):
    """A square whose material has this statement."""
    put("a.mtl", "newmtl a\n%s\n" % line)
    put("a.obj", obj(materials=["a"], places=PLACES, corner="%d/%t").replace("f 2", "# 2").replace("f 3", "# 3").replace("f 4", "# 4"))
    return Seen("a.obj")


MIDDLES = [-1.5, -0.5, 0.5, 1.5]


def quarters_at(places, scale=(1, 1), offset=(0, 0)):
    """What picture four.png shows of itself at each quarter's middle, where u goes as u * scale + offset."""
    out = []
    for x_m in places:
        for dx, dy in ((-0.31, 0.31), (0.31, 0.31), (-0.31, -0.31), (0.31, -0.31)):
            u, v = ((0.5 + dx) * scale[0] + offset[0]) % 1, ((0.5 + dy) * scale[1] + offset[1]) % 1
            out.append((x_m + dx, dy, FOUR[v < 0.5][u >= 0.5]))
    return out


# -- Statements of MTL --------------------------------------------------------------------------------------------------

def colours():
    squares(["Kd {kd}"]).is_quiet()
    squares(["KD {kd}"]).is_quiet()
    squares(["\tKd\t{kd}  # a colour"]).is_quiet()
    grey = [(51, 51, 51), (102, 102, 102), (204, 204, 204), (255, 255, 255)]
    put("a.mtl", "".join("newmtl %s\nKd %g\n" % (n, c[0] / 255) for n, c in zip(NAMES, grey)))
    Seen("a.obj").row(grey).is_quiet()
    squares(["Kd {kd}", "Kd 3 -1 0"], [RED] * 4).says("colours beyond 0..1 are drawn as the nearest ones within", "'d' (4)")
    for words in ("spectral red.rfl", "xyz 0.4 0.2 0.1"):
        squares(["Kd " + words], [(153,) * 3] * 4).says("colours that are no RGB are left out, of materials: 'a', 'b', 'c', 'd' (4)")


def shine_changes_nothing():
    words = ["Ka 1 1 1", "Ks 1 1 1", "Ns 250", "Ni 1.45", "illum 2", "Tf 1 1 1", "sharpness 60", "Pr 0.5", "Pm 0", "Ps 0", "Pc 0",
             "Pcr 0.03", "aniso 0.5", "anisor 0.25", "norm n.png", "bump -bm 2 b.png", "map_Bump b.png", "disp d.png", "refl r.png",
             "map_Pr r.png", "map_Pm m.png", "map_Ks s.png", "map_Ns n.png", "map_Ka k.png", "map_aat on"]
    squares(["Kd {kd}"] + words).is_quiet()


def unknown_statements():
    squares(["Kd {kd}", "frobnicate 3", "Kx nan", "decal d.png"]).says(
        "statements of MTL files are left out, as they are not known: 'frobnicate', 'Kx', 'decal' (12)")
    squares("Kd 0 0 0\nd 0.5\nmap_Kd nowhere.png\n" + mtl("Kd {kd}")).says(
        "statements of MTL files before the first newmtl are left out: 'Kd', 'd', 'map_Kd' (3)")
    squares("", [GREY] * 4).says("(4)")
    squares("Kd 1 0 0\n", [GREY] * 4).says("before the first newmtl")
    squares(mtl("Kd {kd}") + "newmtl b\nKd 0 0 0\n").says("materials are defined twice, and the first definition is taken: 'b' (1)")


def transparency():
    told = "Tr is taken for an opacity, as MeshLab writes it"
    squares(["Kd {kd}", "Tr 1"]).says(told, "'a', 'b', 'c', 'd' (4)")
    for words in (["d 1", "Tr 1"], ["Tr 1", "d 1"]):
        squares(["Kd {kd}"] + words).says("Tr and d contradict each other, and d is taken, of materials: 'a', 'b', 'c', 'd' (4)")
    squares(["Kd {kd}", "Tr 0"]).is_quiet()
    squares(["Kd {kd}", "d 1", "Tr 0"]).is_quiet()
    squares(["Kd {kd}", "d -halo 1"]).says("options of pictures are left out: '-halo' (4)")
    clear = "newmtl a\nKd 1 0 0\nTr 0\nnewmtl b\nKd 0 1 0\nTr 1\nnewmtl c\nKd 0 0 1\nd 0\nTr 1\nnewmtl d\nKd 1 .5 0\nTr .0\n"
    squares(clear, [RED, BLACK, BLACK, ORANGE]).is_quiet()


def damage():
    for text, words in (("Kd 1 nan 0", "a.mtl:2: 'nan' is not a decimal number"), ("Kd 1 0", "a.mtl:2: a colour of 2 numbers"),
                        ("Kd", "a.mtl:2: a colour of 0 numbers"), ("Kd 0,5 0,5 0,5", "a.mtl:2: '0,5' is not a decimal number"),
                        ("d", "a.mtl:2: d without a number"), ("Tr x", "a.mtl:2: 'x' is not a decimal number"),
                        ("map_Kd " + 1100 * "x" + ".png", "a.mtl:2: it names a file by a path that is too long")):
        put("a.mtl", "newmtl a\n%s\n" % text)
        put("a.obj", obj())
        refused("a.obj", words)
    for line, words in (("v 1 nan 0", "'nan' is not a decimal number"), ("v 1 2", "a vertex of 2 numbers"),
                        ("f 1 2 11", "vertex index 11 of a face is out of range, there are 10"),
                        ("f 1 2 -11", "vertex index -11 of a face is out of range"), ("f 0 1 2", "vertex index 0 of a face"),
                        ("f 1 2 x", "'x' is no corner of a face"), ("f 1 2 3.5", "'3.5' is no corner of a face")):
        put("a.mtl", mtl("Kd {kd}"))
        put("a.obj", obj(extra=["# here", line, "f 1 2 7"]))
        refused("a.obj", "a.obj:21: ", words)


# -- Pictures -----------------------------------------------------------------------------------------------------------

def map_options():
    for words in ("-blendu on -blendv off", "-bm 1", "-boost 2.5", "-cc off", "-imfchan m", "-texres 64", "-type sphere", "-clamp off",
                  "-colorspace sRGB", "-mm 0 1", "-s 1 1 1", "-o 0 0 0", "-t 0 0 0", "-s 1 -o 0", "-BLENDU on"):
        textured(*["map_Kd %s four.png" % words] * 4).shows(*quarters_at(MIDDLES)).is_quiet()
    for words, name in (("-mm 0.2 0.5", "-mm"), ("-t 1 1 1", "-t"), ("-cc on", "-cc"), ("-colorspace linear", "-colorspace"),
                        ("-whatever 3", "-whatever"), ("-whatever", "-whatever"), ("-whatever x", "-whatever"), ("-what on -bm 1", "-what")):
        textured(*["map_Kd %s four.png" % words] * 4).shows(*quarters_at(MIDDLES)).says(
            "options of pictures are left out: '%s' (4)" % name)


def scale_and_offset():
    ways = (("-s 2 2 1", (2, 2), (0, 0)), ("-s 2", (2, 1), (0, 0)), ("-o 0.25 0.5", (1, 1), (0.25, 0.5)),
            ("-s 0.5 1.5 -o -0.25 .125 0", (0.5, 1.5), (-0.25, 0.125)))
    seen = textured(*["map_Kd %s four.png" % words for words, _, _ in ways]).is_quiet()
    for x_m, (_, scale, offset) in zip(MIDDLES, ways):
        seen.shows(*quarters_at([x_m], scale, offset))


def no_places():
    """A face without texture coordinates has the mean of its picture; so has one whose coordinates are no numbers."""
    four_png()
    mean = tuple(sum(pixel[i] for row in FOUR for pixel in row) // 4 for i in range(3))
    put("a.mtl", "newmtl a\nmap_Kd four.png\n")
    squares_of = ["1/1 2/2 7/3 6/4", "2 3 8 7", "3/ 4/ 9/ 8/", "4/1 5/2 10/9 9/3"]
    lines = ["mtllib a.mtl", "usemtl a"] + ["v %g %g %g" % p for p in POINTS] + PLACES + ["f " + corners for corners in squares_of]
    put("a.obj", "\n".join(lines) + "\n")
    seen = Seen("a.obj").shows(*quarters_at(MIDDLES[:1]))
    seen.shows(*[(x_m, y, mean) for x_m in MIDDLES[1:] for y in (-0.3, 0.3)])
    seen.says("3 faces have a texture, but no texture coordinates; they have its mean colour")
    put("a.obj", "\n".join(lines + ["vt nan 0"]).replace("10/9", "10/5").replace("f 2 3 8 7\nf 3/ 4/ 9/ 8/\n", "") + "\n")
    Seen("a.obj").shows((1.5, 0.3, mean)).says("1 faces have texture coordinates that are not finite; they have its mean colour")


def black_pictures():
    four_png()
    put("a.mtl", "newmtl a\nKd 0 0 0\nmap_Kd four.png\n")
    put("a.obj", obj(materials=["a"], places=PLACES, corner="%d/%t"))
    Seen("a.obj", "--background", "FFFFFF").shows((-1.5, 0, BLACK)).says("pictures are black by their material's colour", "'a' (1)")
    put("a.mtl", "newmtl a\nmap_Kd four.png\n")
    Seen("a.obj").shows(*quarters_at(MIDDLES[:1])).is_quiet()


def picture_names():
    four_png()
    for said, name in (('"four.png"', "four.png"), ("four.png  ", "four.png"), ("a b.png", "a b.png"), ('"a b.png"', "a b.png"),
                       ("a%20b.png", "a b.png"), ("a%20b.png", "a%20b.png"), (".\\four.png", "four.png"), ("d/four.png", "d/four.png"),
                       ("d\\four.png", "d/four.png"), ("a #1.png", "a #1.png"), ("four.png # red", "four.png"), ("-s.png", "-s.png"),
                       ("-blendu on -s.png", "-s.png"), ("//four.png", "four.png"), ("'four.png'", "four.png")):
        put(name, open("four.png", "rb").read())
        if name != "four.png":
            os.remove("four.png")
        only("map_Kd " + said).shows(*quarters_at(MIDDLES[:1])).is_quiet()
        os.remove(name)
        four_png()


def long_names():
    """They agree in their first 150 letters."""
    stem = 50 * "abc"
    for end, colour in (("left", RED), ("right", BLUE)):
        put("%s_%s.png" % (stem, end), png([[colour] * 8] * 8))
    names = ["%s_%s.png" % (stem, end) for end in ("left", "right")]
    put("a.mtl", "".join("newmtl %s\nKd 1 1 1\nmap_Kd %s\n" % pair for pair in zip(NAMES, names)))
    put("a.obj", obj(materials=NAMES[:2], places=PLACES, corner="%d/%t"))
    Seen("a.obj").row([RED, BLUE, BLACK, BLACK])
    os.remove(names[1])
    refused("a.obj", "texture ...", "_right.png: there is no such file; --no-textures does without")


# -- Files elsewhere ----------------------------------------------------------------------------------------------------

def elsewhere():
    four_png()
    for said in ("/home/somebody/tex/four.png", "C:\\tex\\four.png", "..\\nowhere\\four.png", "../four.png", "nowhere/four.png",
                 "\\\\server\\share\\four.png", "C:/tex/FOUR.png", "/home/somebody%20else/four.png"):
        only("map_Kd " + said).shows(*quarters_at(MIDDLES[:1])).says("not found where it says, but beside it: 'four.png' for '%s'" % said)
    put("../hidden.png", open("four.png", "rb").read())
    put("a.mtl", "newmtl a\nmap_Kd ../hidden.png\n")
    refused("a.obj", "it names '../hidden.png', which lies outside of its folder; --trust-paths permits that")
    Seen("a.obj", "--trust-paths").shows(*quarters_at(MIDDLES[:1])).is_quiet()
    put("hidden.png", png([[RED] * 8] * 8))  # what the model's folder has is taken, as long as paths are not trusted
    Seen("a.obj").shows((-1.5, 0.0, RED)).says("'hidden.png' for '../hidden.png'")
    Seen("a.obj", "--trust-paths").shows(*quarters_at(MIDDLES[:1])).is_quiet()
    os.symlink("../hidden.png", "link.png")
    put("a.mtl", "newmtl a\nmap_Kd /nowhere/link.png\n")
    refused("a.obj", "lies outside of its folder")


def capitals():
    four_png()
    for said in ("FOUR.PNG", "Four.png", "./FOUR.png"):
        only("map_Kd " + said).shows(*quarters_at(MIDDLES[:1])).says("read by names that differ in capitals: 'four.png' for '%s'" %
                                                                         said if "/" not in said else "'./four.png' for './FOUR.png'")
    put("Tex/Deep/Four.png", open("four.png", "rb").read())
    only("map_Kd tex\\deep\\four.PNG").shows(*quarters_at(MIDDLES[:1])).says("'Tex/Deep/Four.png' for 'tex\\deep\\four.PNG'")
    put("one.PNG", png([[RED] * 8] * 8))
    put("One.png", png([[BLUE] * 8] * 8))
    put("a.mtl", "newmtl a\nmap_Kd one.png\n")
    refused("a.obj", "texture one.png: there is no such file")
    put("a.mtl", "newmtl a\nmap_Kd One.png\n")
    Seen("a.obj").shows((-1.5, 0, BLUE))


# -- Libraries and materials --------------------------------------------------------------------------------------------

def libraries():
    put("b.mtl", "newmtl c\nKd 0 0 1\nnewmtl d\nKd 1 .50196 0\n")
    put("my colours.mtl", mtl("Kd {kd}"))
    put("empty.mtl", "")
    half = "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n"
    for lines in (["mtllib a.mtl b.mtl"], ["mtllib b.mtl a.mtl"], ["mtllib a.mtl", "mtllib b.mtl"], ["mtllib a.mtl empty.mtl  b.mtl "],
                  ['mtllib "a.mtl" "b.mtl"'], ["mtllib a.mtl b.mtl # two"], ["mtllib a.mtl \\", "b.mtl"], ["mtllib my colours.mtl"],
                  ['mtllib "my colours.mtl"'], ["mtllib my%20colours.mtl"]):
        squares(half, libraries=lines).is_quiet()
    put("late.obj", obj(libraries=(), extra=["mtllib my colours.mtl"]))
    Seen("late.obj").row(COLOURS).is_quiet()
    put("my colours.mtl", "newmtl a\nKd 1 0 0\n")
    squares(mtl("Kd {kd}"), libraries=["mtllib my colours.mtl a.mtl"]).says("defined twice")
    squares(mtl("Kd {kd}"), libraries=["mtllib A.mtl"]).says("'a.mtl' for 'A.mtl'")
    for name in ("/nowhere/a.mtl", "C:\\x\\a.mtl", "../a.mtl"):
        squares(mtl("Kd {kd}"), libraries=["mtllib " + name]).says("beside it: 'a.mtl' for '%s'" % name)
    squares(mtl("Kd {kd}"), libraries=["mtllib b2.mtl"]).says("there is no MTL file 'b2.mtl'; 'a.mtl' is read in its place")


def missing_libraries():
    put("a.mtl", "")
    os.remove("a.mtl")
    put("a.obj", obj(libraries=["mtllib nothere.mtl"]))
    Seen("a.obj").row([GREY] * 4).says("there is no MTL file 'nothere.mtl'", "no MTL file defines their material: 'a', 'b', 'c', 'd' (4)")
    put("b.mtl", "newmtl b\nKd 0 1 0\n")
    put("a.obj", obj(libraries=["mtllib nothere.mtl b.mtl"]))
    Seen("a.obj").row([GREY, GREEN, GREY, GREY]).says("'nothere.mtl'", "'a', 'c', 'd' (3)")
    put("a.obj", obj(libraries=[]))
    Seen("a.obj").row([GREY] * 4).is_quiet()
    put("a.obj", obj(libraries=["mtllib ../b.mtl"]).replace("../b", "../c"))
    refused("a.obj", "it names '../c.mtl', which lies outside of its folder; --trust-paths permits that")


def materials():
    squares(["Kd {kd}"], [RED, GREY, BLUE, GREY], materials=["a", "nosuch", "c", "B"]).says(
        "faces are drawn in grey, as no MTL file defines their material: 'nosuch', 'B' (2)")
    squares(["Kd {kd}"], materials=["a # red", "b  ", "c", "d"]).is_quiet()
    squares(["Kd {kd}"], [GREY, GREEN, BLUE, ORANGE], materials=[None, "b", "c", "d"]).is_quiet()
    squares(["Kd {kd}"], [RED, RED, BLUE, BLUE], materials=["a", None, "c", None]).is_quiet()
    odd = ["DefaultMaterial", "two words", '"quoted"', 1100 * "x"]
    put("a.mtl", "".join("newmtl %s\nKd %g %g %g\n" % (n, *(c / 255 for c in colour)) for n, colour in zip(odd, COLOURS)))
    put("a.obj", obj(materials=odd))
    Seen("a.obj").row(COLOURS).is_quiet()
    four_png("sky.png")
    put("a.mtl", mtl("Kd {kd}").replace("newmtl a", "newmtl a b\nmap_Kd sky.png"))
    put("a.obj", obj(materials=["a b", "b", "c", "d"], places=PLACES, corner="%d/%t"))
    Seen("a.obj", "--sky", "a b").row([Seen("a.obj", "--sky", "a b").at(-1.5), GREEN, BLUE, ORANGE]).is_quiet()


# -- The text of OBJ ----------------------------------------------------------------------------------------------------

def layouts():
    put("a.mtl", mtl("Kd {kd}"))
    text = obj()
    for changed in (text.replace("\n", "\r\n"), text.replace("\n", "\r"), text.replace(" ", "\t"), text.replace("\n", "  \n"),
                    text.rstrip("\n"), "\ufeff" + text,
                    text.replace("f 1 ", "f 1 \\\n"), text.replace("f 1 2 7 6", "  f 1 2 7 6#3 4"), text.replace("v ", "v  ")):
        put("a.obj", changed)
        Seen("a.obj").row(COLOURS).is_quiet()
    for coding in ("utf-16-le", "utf-16-be"):
        put("a.obj", ("\ufeff" + text).encode(coding))
        put("a.mtl", ("\ufeff" + mtl("Kd {kd}")).encode(coding))
        Seen("a.obj").row(COLOURS).is_quiet()


def corners():
    more = ["vt 0 0"] * 10 + ["vn 0 0 1"] * 10
    for corner in ("%d/", "%d//", "%d/%d", "%d//%d", "%d/%d/%d", "%d/%d/"):
        put("a.mtl", mtl("Kd {kd}"))
        put("a.obj", obj(corner=corner, places=more).rstrip("\n"))
        Seen("a.obj").row(COLOURS).is_quiet()
    back = obj().replace("f 1 2 7 6", "f -10 -9 -4 -5")
    put("a.obj", back)
    Seen("a.obj").row(COLOURS).is_quiet()
    put("a.obj", obj(places=more).rstrip("\n") + "\nf 1/1 2/2 7/")
    refused("a.obj", "truncated")


def weights():
    squares(["Kd {kd}"], vertices="v %g %g %g 2").says("10 vertices have a weight behind x, y and z that is not 1")
    squares(["Kd {kd}"], vertices="v %g %g %g 0").says("10 vertices have a weight")
    squares(["Kd {kd}"], vertices="v %g %g %g 1.0").is_quiet()


def vertex_colours():
    for full, form in ((1, "%g"), (255, "%d")):
        own = [p for square in SQUARES for p in ["v %g %g %g " % POINTS[k] for k in square]]
        own = [p + " ".join(form % (c * full / 255) for c in COLOURS[i // 4]) for i, p in enumerate(own)]
        faces = ["f %d %d %d %d" % tuple(range(4 * i + 1, 4 * i + 5)) for i in range(4)]
        put("a.obj", "\n".join(own + faces) + "\n")
        seen = Seen("a.obj").row(COLOURS)
        seen.is_quiet() if full == 1 else seen.says("its vertices' colours are whole numbers, which are taken as parts of 255")
        own[4:8] = [" ".join(p.split()[:4]) for p in own[4:8]]  # without a colour of their own
        put("a.obj", "mtllib a.mtl\n" + "\n".join(own + faces[:1] + ["usemtl b"] + faces[1:2]) + "\n")
        put("a.mtl", mtl("Kd {kd}"))
        Seen("a.obj").row([RED, GREEN, BLACK, BLACK])


def what_is_not_drawn():
    squares(["Kd {kd}"], extra=["vp 0.1 0.2", "cstype bezier", "deg 3", "curv 0 1 1 2 3 4", "parm u 0 1", "end", "surf 0 1 0 1 1 2 3 4"]).says(
        "2 curves and surfaces are not drawn")
    squares(["Kd {kd}"], extra=["l 1 2 3", "p 1 2"]).says("2 lines and points are not drawn, only faces are")
    squares(["Kd {kd}"], extra=["g a", "o b", "s off", "vn 0 0 1", "mg 0", "lod 2", "bevel on"]).is_quiet()
    squares(["Kd {kd}"], extra=["frob 1", "call x.obj", "frob"]).says("statements are left out, as they are not known: 'frob', 'call' (3)")


if __name__ == "__main__":
    formats.LIMNER = sys.argv[1]
    globals()[sys.argv[2]]()
