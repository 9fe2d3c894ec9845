# SPDX-License-Identifier: MIT
#
# Holds the table of `limner formats` to what is drawn and said of a square of one_square.py:
#
#     python3 what_is_read.py LIMNER FORMAT    each cell of the format, as TAP without a plan
#
# A cell without a file that has the feature is a failure, and so is a file's feature without a cell.
import subprocess
import sys

import formats
import one_square
from formats import BLACK, FOUR, QUARTERS

LIT = "lit"  # any colour but the background's
(RED, GREEN), (BLUE, WHITE) = FOUR
QUICK = ("--method", "nearest", "--frames", "1")


def whole(colour):
    return [(0.0, 0.0, colour), (0.2, 0.4, colour), (-0.3, -0.2, colour)]


# Where it is drawn as the file says: places in metres, and their colours.
DRAWN = {
    "faces of many corners": [(-0.25, -0.25, LIT), (-0.25, 0.25, LIT), (0.25, -0.25, LIT), (0.25, 0.25, BLACK)],
    "bent faces": [(0.58, 0.58, LIT), (0.2, -0.2, LIT), (-0.2, 0.2, LIT), (0.0, 0.0, LIT)],
    "colours of faces": whole(one_square.ORANGE),
    "colours of corners": whole(one_square.ORANGE),
    "pictures": QUARTERS,
    "clamped pictures": [(0.125, -0.375, WHITE), (0.375, -0.375, WHITE), (-0.375, -0.375, BLUE)],
    "mirrored pictures": [(0.125, -0.375, WHITE), (0.375, -0.375, BLUE), (-0.375, -0.375, BLUE)],
    "parts of pictures": [(-x, y, colour) for x, y, colour in QUARTERS],
    "opacity": whole((128, 128, 128)),
    "lights": whole(WHITE),  # of a WAD, whose wall is white
    "holes in pictures": [(-0.25, 0.25, BLACK)] + QUARTERS[1:],
    "light of faces": whole(one_square.ORANGE),
    "pictures of light": QUARTERS,
    "faces with two sides": whole(LIT),
    "units": [(0.0, 0.0, LIT), (0.45, 0.45, LIT), (0.55, 0.0, BLACK), (0.0, -0.55, BLACK)],
    "up axis": whole(LIT),
    "nodes and instances": [(-1.0, 0.3, LIT), (1.0, 0.3, LIT), (0.0, 0.0, BLACK)],
    "animated nodes": [(1.0, 0.3, LIT), (0.0, 0.0, BLACK)],
}
# What is drawn instead: the mean of red and blue of a square's corners, or of each of its triangles'.
MEAN = [(0.25, 0.0, (128, 0, 128))]
MEANS = [(0.25, -0.25, (85, 0, 170)), (-0.25, 0.25, (170, 0, 85))]
LIGHTS_MEANS = [(0.25, -0.25, (156, 0, 213)), (-0.25, 0.25, (213, 0, 156))]  # a third and two thirds of linear light, as sRGB
REPEATED = [(0.125, -0.375, BLUE), (0.375, -0.375, WHITE), (-0.375, -0.375, BLUE)]
INSTEAD = {"colours that change": lambda name: {"glTF": LIGHTS_MEANS, "3MF": MEANS}.get(name, MEAN),
           "clamped pictures": lambda name: REPEATED, "mirrored pictures": lambda name: REPEATED,
           "up axis": lambda name: whole(LIT), "missing pictures": lambda name: whole(formats.GREY)}

# Nothing in the file says it, but its format: with this option it is as if it did not.
BY_FORMAT = {("STL", "up axis"): ("--up", "y"), ("3MF", "up axis"): ("--up", "y")}


class Picture:
    def __init__(self, name, feature, said):
        path = one_square.WRITERS[name](one_square.Thing(feature, said))
        up = () if feature == "up axis" else ("--up", "y")
        self.status, text = formats.run(path, *QUICK, *(BY_FORMAT.get((name, feature), up) if not said else up))
        self.said = [line.split("%s: " % path, 1)[-1] for line in text.splitlines()]
        self.pixel = formats.png_read("seen.png") if not self.status else None

    def pixels(self):
        return [self.pixel(x, y) for y in range(formats.H) for x in range(formats.W)]

    def misses(self, probes):
        """The first place that has another colour, in words; displays have 5 or 6 bits a channel."""
        per_m = formats.H / 2 / (formats.FAR_M * formats.tan(formats.radians(30)))
        for x_m, y_m, colour in probes:
            seen = self.pixel(int(formats.W / 2 + x_m * per_m), int(formats.H / 2 - y_m * per_m))
            if seen == BLACK if colour == LIT else any(abs(a - b) > 9 for a, b in zip(seen, colour)):
                return "at %g, %g m there is %s instead of %s" % (x_m, y_m, seen, colour)
        return ""


def told(picture, words):
    """Each in a line, behind a number if it has one; nothing else."""
    if not words:
        return "" if not picture.said else "said: %s" % picture.said
    if len(picture.said) == 1 and (picture.said[0] == words or picture.said[0].endswith((" " + words, ": " + words))):
        return ""
    return "not said: %s; but: %s" % (words, picture.said)


def shows(picture, without, probes):
    """What is expected is seen, and not of the file that does not say it."""
    if not probes:
        return "there is no case of it"
    if without.status == 0 and not without.misses(probes):
        return "without it the picture is as with it"
    return picture.misses(probes)


def wrong(name, feature, fate, words):
    picture, without = Picture(name, feature, True), Picture(name, feature, False)
    if fate == "refused":
        return told(picture, words) or ("" if picture.status == 1 and not without.status else "it is drawn")
    if picture.status or without.status:
        return "refused: %s %s" % (picture.said, without.said)
    if fate == "drawn":
        return told(picture, "") or shows(picture, without, DRAWN.get(feature))
    if fate == "instead":
        probes = INSTEAD[feature](name) if feature in INSTEAD else None
        is_same = feature in DRAWN and feature != "up axis"  # as without the statement
        return told(picture, words) or (picture.misses(probes) if is_same else shows(picture, without, probes))
    if fate == "left out":
        is_dark = feature == "faces with two sides" and all(p == BLACK for p in picture.pixels())
        return (told(picture, words) if not is_dark else "") or (
            "" if picture.pixels() == without.pixels() else "it changes the picture")
    return "there is no such fate: %s" % fate


def wrong_extension(name, fate, words):
    """What is drawn, or is not seen, may be required; its looks are those of tests/formats/gltf.py."""
    is_told = fate == "left out" and words
    path = one_square.write_gltf(one_square.Thing("extension", True), {
        "extensionsUsed": [name], "extensions": {name: {}}} if is_told else {
        "extensionsUsed": [name], "extensionsRequired": [name]})
    status, text = formats.run(path, *QUICK)
    line = "limner: note: %s: %s: %s\n" % (path, name, words) if is_told else ""
    return "" if (status, text) == (0, line) else "status %d: %s" % (status, text)


def cells(limner):
    """{format: {feature: (fate, words)}}, as printed."""
    out, name = {}, None
    for line in subprocess.run([limner, "formats"], stdout=subprocess.PIPE, check=True).stdout.decode().splitlines():
        if not line.startswith(" "):
            name = line.rstrip(":")
            out[name] = {}
            continue
        fate, _, words = line[38:].strip().partition(": ")
        out[name][line[2:38].strip()] = (fate, words)
    return out


def main(limner, name):
    formats.LIMNER = limner
    table = cells(limner).get(name, {})
    is_extensions = name == "glTF extensions"
    has = table if is_extensions else one_square.FEATURES[name]
    bad = 0 if table else 1
    for feature in sorted(set(table) | set(has)):
        if feature not in has:
            why = "no case for %s/%s" % (name, feature)
        elif feature not in table:
            why = "no cell for %s/%s" % (name, feature)
        else:
            why = wrong_extension(feature, *table[feature]) if is_extensions else wrong(name, feature, *table[feature])
        if why:
            print("%s: %s: %s" % (name, feature, why))
        bad += bool(why)
    return bad


if __name__ == "__main__":
    sys.exit(bool(main(*sys.argv[1:])))
