# SPDX-License-Identifier: MIT
#
# A map of Doom: a room before the eye of tests/formats/formats.py, 7 m wide, whose northern wall is the plane z = 0 and has
# a picture of 1 m in squares about the origin.
import struct

import formats

UNITS = 32  # a metre
PALETTE = [(0, 0, 0), *formats.FOUR[0], *formats.FOUR[1], (255, 128, 0)]
CLEAR = -1


def name(text):
    return text.encode().ljust(8, b"\0")


def patch(columns):
    """Columns of colours from the top; runs of those that are not clear are posts."""
    head, body, at = b"", b"", 8 + 4 * len(columns)
    for column in columns:
        head += struct.pack("<I", at + len(body))
        y = 0
        while y < len(column):
            end = y
            while end < len(column) and column[end] != CLEAR:
                end += 1
            if end > y:
                body += bytes([y, end - y, 0, *column[y:end], 0])
            y = max(end, y + 1)
        body += b"\xff"
    return struct.pack("<HHhh", len(columns), len(columns[0]), 0, 0) + head + body


def four(upper_left):
    """PALETTE has the picture's colours from 1 on."""
    return [[(upper_left, 2, 3, 4)[x // 16 + 2 * (y // 16)] for y in range(32)] for x in range(32)]


def write_wad(t):
    pictures = {"FOUR": four(CLEAR if t.has("holes in pictures") else 1), "DARK": [[0] * 32] * 32, "WHITE": [[4] * 32] * 32, "SKY1": [[4] * 32] * 32}
    shown = "FOUR"
    if t.feature == "pictures" and not t.said:
        shown = "WHITE"
    if t.feature == "lights":
        shown = "WHITE"
    if t.has("missing pictures"):
        shown = "NONE"
    lumps = [("PLAYPAL", b"".join(map(bytes, PALETTE)).ljust(768, b"\0")),
             ("COLORMAP", b"".join(bytes(i if row < 16 else 0 for i in range(256)) for row in range(34))),
             ("PNAMES", struct.pack("<I", len(pictures)) + b"".join(name("P" + n) for n in pictures))]
    entries = [name(n) + struct.pack("<IHHIH", 0, 32, 32, 0, 1) + struct.pack("<hhHHH", 0, 0, i, 0, 0) for i, n in enumerate(pictures)]
    places = [4 + 4 * len(entries) + 32 * i for i in range(len(entries))]
    lumps.append(("TEXTURE1", struct.pack("<I", len(entries)) + struct.pack("<%dI" % len(places), *places) + b"".join(entries)))
    lumps += [("P" + n, patch(columns)) for n, columns in pictures.items()]
    lumps += [("F_START", b""), ("FLAT", b"\5" * 4096), ("F_END", b"")]
    lumps += room(t, shown)
    write("a.wad", lumps)
    return "a.wad:MAP01"


def room(t, shown):
    """Two sectors if the wall is to be seen through."""
    is_open = t.feature == "holes in pictures"
    side, south, north = 112, -160, 64
    corners = [(-side, south), (-side, 0), (side, 0), (side, south), (-side, north), (side, north)]
    sides, lines = [], []

    def add(first, second, right, left=None):
        """right, left: the sector, and the texture of the middle."""
        numbers = [0xFFFF, 0xFFFF]
        for i, what in enumerate((right, left)):
            if what:
                numbers[i] = len(sides)
                sides.append(struct.pack("<hh", 0, 0) + name("-") + name("-") + name(what[1]) + struct.pack("<H", what[0]))
        lines.append(struct.pack("<7H", first, second, 4 if left else 1, 0, 0, *numbers))
    add(0, 1, (0, "WHITE"))
    add(1, 2, (0, shown), (1, "-") if is_open else None)
    add(2, 3, (0, "WHITE"))
    add(3, 0, (0, "WHITE"))
    if is_open:
        add(1, 4, (1, "DARK"))
        add(4, 5, (1, "DARK"))
        add(5, 2, (1, "DARK"))
    light = 0 if t.feature == "lights" and not t.said else 255
    sector = struct.pack("<hh", -48, 16) + name("FLAT") + name("FLAT") + struct.pack("<HHH", light, 0, 0)
    used = corners if is_open else corners[:4]
    if t.has("other kinds"):
        return [("MAP01", b""), ("TEXTMAP", b'namespace = "doom";'), ("ENDMAP", b"")]
    return [("MAP01", b""), ("THINGS", struct.pack("<hhHHH", 0, -128, 90, 1, 7)), ("LINEDEFS", b"".join(lines)),
            ("SIDEDEFS", b"".join(sides)), ("VERTEXES", b"".join(struct.pack("<hh", *c) for c in used)),
            ("SECTORS", sector * (2 if is_open else 1))]


def write(path, lumps):
    body, directory = b"", b""
    for lump, data in lumps:
        directory += struct.pack("<II", 12 + len(body), len(data)) + name(lump)
        body += data
    open(path, "wb").write(b"PWAD" + struct.pack("<II", len(lumps), 12 + len(body)) + body + directory)
