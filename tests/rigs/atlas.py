# SPDX-License-Identifier: MIT
"""A chair of 30 boxes whose 180 faces lie on one atlas of palettes, as packs of models have it, beside its twin in flat
colours: atlas.py plain|shaded NAME SIDE_PX. Of a shaded one each swatch gets brighter downwards, and a face shows the middle of it."""
import struct
import sys
import zlib

SWATCHES = 16  # along a side


def write_png(path, rows):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    header = struct.pack('>IIBBBBB', len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    data = b''.join(b'\0' + b''.join(bytes(pixel) for pixel in row) for row in rows)
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(data)) + chunk(b'IEND', b''))


def colour_of(kind, swatch, down, swatch_px):
    """Of a row of a swatch: from 3/4 of its colour to 5/4."""
    part = 0.75 + 0.5 * (down + 0.5) / swatch_px if kind == 'shaded' else 1
    return [int(part * (swatch * prime % 160 + 40)) for prime in (73, 151, 37)]


def mean_of(kind, swatch, swatch_px):
    """Of what a face shows of it: from a quarter to three quarters of its height."""
    rows = [colour_of(kind, swatch, down, swatch_px) for down in range(swatch_px // 4, swatch_px * 3 // 4)]
    return [int(sum(row[c] for row in rows) / len(rows) + 0.5) for c in range(3)]


def boxes():
    yield from ((-0.5, 0.5, -0.5, 1, 0.1, 1), (-0.5, 0.6, -0.5, 1, 0.9, 0.1))
    yield from ((x, 0, z, 0.1, 0.5, 0.1) for x in (-0.5, 0.4) for z in (-0.5, 0.4))
    yield from ((-0.45 + 0.12 * i, 0.65, -0.38, 0.06, 0.7, 0.04) for i in range(8))
    yield from ((-0.45 + 0.12 * i, 0.61, -0.2 + 0.08 * k, 0.06, 0.03, 0.06) for i in range(8) for k in range(2))


def write_models(kind, name, side_px):
    swatch_px = side_px // SWATCHES
    points, coordinates, shown, flat, materials = [], [], [], [], []
    for number, (x, y, z, w, h, d) in enumerate(boxes()):
        (down, across), first = divmod(number * 7 % 40, 8), len(points)
        points += ['v %.9g %.9g %.9g' % (x + w * (i & 1), y + h * (i >> 1 & 1), z + d * (i >> 2)) for i in range(8)]
        materials.append('newmtl c%d\nKd %.9g %.9g %.9g' % (number, *(v / 255 for v in mean_of(kind, SWATCHES * down + across, swatch_px))))
        flat.append('usemtl c%d' % number)
        for face in ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)):
            base = len(coordinates) + 1
            coordinates += ['vt %.9g %.9g' % ((across + a) / SWATCHES, 1 - (down + b) / SWATCHES)
                            for a, b in ((0.25, 0.25), (0.75, 0.25), (0.75, 0.75), (0.25, 0.75))]
            shown.append('f ' + ' '.join('%d/%d' % (first + k + 1, base + i) for i, k in enumerate(face)))
            flat.append('f ' + ' '.join('%d' % (first + k + 1) for k in face))
    for suffix, faces, mtl in (('', ['usemtl m'] + shown, ['newmtl m\nKd 1 1 1\nmap_Kd %s.png' % name]), ('_flat', flat, materials)):
        with open(name + suffix + '.mtl', 'w') as file:
            file.write('\n'.join(mtl) + '\n')
        with open(name + suffix + '.obj', 'w') as file:
            file.write('\n'.join(['mtllib %s%s.mtl' % (name, suffix)] + points + coordinates + faces) + '\n')
    write_png(name + '.png', [[colour_of(kind, x // swatch_px + SWATCHES * (y // swatch_px), y % swatch_px, swatch_px)
                               for x in range(side_px)] for y in range(side_px)])


write_models(sys.argv[1], sys.argv[2], int(sys.argv[3]))
