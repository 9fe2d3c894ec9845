# SPDX-License-Identifier: MIT
#
# STL and OFF: text and binary, in the dialects that carry colours.
import struct

import numpy as np

import rays
import things
from judge import Input

GREY = (200, 200, 200)
UP = ('--up', 'y')


def _box(random):
    return things.box((-1, -0.5, -0.5), (2, 1, 1.5), int(random.integers(0, 6)))


def _grey(triangles):
    return [rays.Triangle(t.points, GREY) for t in triangles]


def _five(colour):
    """Of 5 bits, as bytes: what a reader makes of it."""
    return [int(c) >> 3 for c in colour], [round((int(c) >> 3) * 255 / 31) for c in colour]


def _binary_stl(triangles, head, word):
    out = head.ljust(80, b'\0') + struct.pack('<I', len(triangles))
    for t in triangles:
        out += struct.pack('<12fH', 0, 0, 0, *t.points.ravel(), word(t))
    return out


def _text_stl(triangles, name='it', upper=False, end='\n'):
    lines = ['solid ' + name]
    for t in triangles:
        lines += ['facet normal 0 0 0', 'outer loop', *('vertex %.9g %.9g %.9g' % tuple(p) for p in t.points), 'endloop', 'endfacet']
    text = end.join(lines + ['endsolid ' + name, ''])
    return (text.upper() if upper else text).encode()


def _stl(random):
    plain = _grey([t for part in _box(random) for t in part.seen()])
    coloured = [t for part in _box(random) for t in part.seen()]
    for t in coloured:
        t.five, t.colour = _five(t.colour)
        t.colour = np.array(t.colour, float)
    yield 'binary', _binary_stl(plain, b'a box', lambda t: 0), plain
    yield 'binary that begins as text', _binary_stl(plain, b'solid box', lambda t: 0), plain
    yield 'binary with bytes behind', _binary_stl(plain, b'a box', lambda t: 0) + b'more' * 9, plain
    yield 'VisCAM', _binary_stl(coloured, b'a box', lambda t: 0x8000 | t.five[0] << 10 | t.five[1] << 5 | t.five[2]), coloured
    yield 'Magics', _binary_stl(coloured, b'COLOR=\xC8\xC8\xC8\xFF', lambda t: t.five[2] << 10 | t.five[1] << 5 | t.five[0]), coloured
    yield 'Magics, of one colour', _binary_stl(plain, b'COLOR=\xC8\xC8\xC8\xFF', lambda t: 0x8000), plain
    yield 'text', _text_stl(plain), plain
    yield 'text in capitals', _text_stl(plain, upper=True), plain
    yield 'text, CRLF', _text_stl(plain, end='\r\n'), plain
    yield 'two solids', _text_stl(plain[:6], 'a') + _text_stl(plain[6:], 'b'), plain


def _off(random):
    parts = _box(random)
    points = np.concatenate([p.points for p in parts])
    faces = [[4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3] for i in range(len(parts))]
    seen = [t for part in parts for t in part.seen()]
    for t in seen:
        t.two_sided = True
    grey = [rays.Triangle(t.points, GREY, True) for t in seen]
    vertices = ['%.9g %.9g %.9g' % tuple(p) for p in points]

    def text(colour, head='OFF', behind='', before=''):
        rows = ['4 %d %d %d %d%s' % (*f, ' ' + colour(p) if colour else '') for f, p in zip(faces, parts)]
        return '\n'.join([before + head, '%d %d 0%s' % (len(points), len(faces), behind), *vertices, *rows, '']).encode()
    yield 'plain', text(None), grey
    yield 'comments', text(None, behind=' # many', before='# a box\n'), grey
    yield 'colours of 0..255', text(lambda p: '%d %d %d' % p.colour), seen
    yield 'colours and opacity', text(lambda p: '%d %d %d 255' % p.colour), seen
    yield 'colours of 0..1', text(lambda p: '%.4f %.4f %.4f' % tuple(np.array(p.colour) / 255)), seen
    yield 'colours of 0..1 with opacity', text(lambda p: '%.4f %.4f %.4f 1.0' % tuple(np.array(p.colour) / 255)), seen


def inputs(random):
    for _ in range(2):
        for name, data, triangles in _stl(random):
            yield Input('STL: ' + name, {'it.stl': data}, triangles, UP)
        for name, data, triangles in _off(random):
            yield Input('OFF: ' + name, {'it.off': data}, triangles, UP)
