# SPDX-License-Identifier: MIT
#
# PLY: in its three codings, with all types of numbers, colours of faces and of vertices, texture coordinates.
import struct

import numpy as np

import rays
import things
from judge import Input

LETTERS = {'char': 'b', 'uchar': 'B', 'short': 'h', 'ushort': 'H', 'int': 'i', 'uint': 'I', 'float': 'f', 'double': 'd',
           'int8': 'b', 'uint8': 'B', 'int16': 'h', 'uint16': 'H', 'int32': 'i', 'uint32': 'I', 'float32': 'f', 'float64': 'd'}


class Ply:
    """Elements are [name, properties, rows]: a property is (name, type) or (name, type of count, type); a row has a value,
    or a list, for each."""

    def __init__(self, coding, comments=()):
        self.coding, self.comments, self.elements = coding, comments, []

    def _value(self, kind, value):
        if self.coding == 'ascii':
            return ('%.9g ' % value).encode()
        letter = LETTERS[kind]
        order = '<' if self.coding == 'binary_little_endian' else '>'
        return struct.pack(order + letter, value if letter in 'fd' else int(value))

    def bytes(self):
        head = ['ply', 'format %s 1.0' % self.coding, *('comment ' + c for c in self.comments)]
        body = b''
        for name, properties, rows in self.elements:
            head.append('element %s %d' % (name, len(rows)))
            for p in properties:
                head.append('property %s %s' % (p[1], p[0]) if len(p) == 2 else 'property list %s %s %s' % (p[1], p[2], p[0]))
            for row in rows:
                for p, value in zip(properties, row):
                    if len(p) == 2:
                        body += self._value(p[1], value)
                    else:
                        body += self._value(p[1], len(value)) + b''.join(self._value(p[2], v) for v in value)
                body += b'\n' if self.coding == 'ascii' else b''
        return '\n'.join(head + ['end_header', '']).encode() + body


def _pick(random, *names):
    return str(random.choice(names))


def _colour_properties(random, names):
    kind = _pick(random, 'uchar', 'uint8', 'ushort', 'float')
    most = {'uchar': 255, 'uint8': 255, 'ushort': 65535, 'float': 1}[kind]
    return [(name, kind) for name in names], lambda colour: [c * most / 255 for c in colour]


def _boxes(random, where):
    """A box with colours of faces, of vertices, or of none."""
    coding = _pick(random, 'ascii', 'binary_little_endian', 'binary_big_endian')
    ply = Ply(coding, ['made for a test'])
    number = _pick(random, 'float', 'double', 'float32', 'float64')
    names = ['red', 'green', 'blue'] if random.random() < 0.8 or where == 'faces' else ['diffuse_red', 'diffuse_green', 'diffuse_blue']
    colours, coded = _colour_properties(random, names)
    vertex, face = [(n, number) for n in 'xyz'], [('vertex_indices' if random.random() < 0.5 else 'vertex_index', _pick(random, 'uchar', 'int', 'ushort'), _pick(random, 'int', 'uint', 'ushort', 'uchar'))]
    if random.random() < 0.4:
        vertex += [(n, 'float') for n in ('nx', 'ny', 'nz')]
    extra = len(vertex) - 3
    vertex_rows, face_rows, triangles = [], [], []
    for part in things.box((-1, -0.5, -0.5), (2, 1, 1.5), int(random.integers(0, 6))):
        first = len(vertex_rows)
        own = coded(part.colour)
        vertex_rows += [list(p) + [0] * extra + (own if where == 'vertices' else []) for p in part.points]
        face_rows.append([[first + i for i in range(4)]] + (own if where == 'faces' else []))
        triangles += part.seen()
    if where == 'none':
        triangles = [rays.Triangle(t.points, (200, 200, 200)) for t in triangles]
    ply.elements = [['vertex', vertex + (colours if where == 'vertices' else []), vertex_rows],
                    ['face', face + (colours if where == 'faces' else []), face_rows]]
    has_edge = random.random() < 0.3
    if has_edge:
        ply.elements.append(['edge', [('vertex1', 'int'), ('vertex2', 'int')], [[0, 1]]])
    return Input('colours of %s, %s, %s' % (where, coding, colours[0][1]), {'it.ply': ply.bytes()}, triangles,
                 says=': 1 lines and points are not drawn' if has_edge else None)


def _strip(random):
    coding = _pick(random, 'ascii', 'binary_little_endian', 'binary_big_endian')
    ply, rows, strip, triangles = Ply(coding), [], [], []
    for part in things.box((-1, -0.5, -0.5), (2, 1, 1.5)):
        first = len(rows)
        rows += [list(p) for p in part.points]
        strip += ([-1] if strip else []) + [first + 1, first + 2, first, first + 3]
        triangles += [rays.Triangle(t.points, (200, 200, 200)) for t in part.seen()]
    ply.elements = [['vertex', [(n, 'float') for n in 'xyz'], rows],
                    ['tristrips', [('vertex_indices', 'int', 'int')], [[strip]]]]
    return Input('strips, %s' % coding, {'it.ply': ply.bytes()}, triangles)


def _textured(random, names, comment):
    coding = _pick(random, 'ascii', 'binary_little_endian', 'binary_big_endian')
    part = things.panel((-1, -1, 0), 2, things.quarters())
    ply = Ply(coding, [comment])  # its faces have two sides: which way corners run, the format does not say
    rows = [[*p, uv[0], 1 - uv[1]] for p, uv in zip(part.points, part.uvs)]
    ply.elements = [['vertex', [(n, 'float') for n in ('x', 'y', 'z', *names)], rows],
                    ['face', [('vertex_indices', 'uchar', 'int')], [[[0, 1, 2, 3]]]]]
    files = {'it.ply': ply.bytes(), 'it.png': things.png(part.texture.rows)}
    return Input('a texture by %s, %s, "%s"' % ('/'.join(names), coding, comment), files, part.seen())


def inputs(random):
    for where in ('faces', 'vertices', 'none'):
        for _ in range(10):
            yield _boxes(random, where)
    for _ in range(4):
        yield _strip(random)
    for names in (('s', 't'), ('u', 'v'), ('texture_u', 'texture_v')):
        for comment in ('TextureFile it.png', 'TextureFile it.png '):
            yield _textured(random, names, comment)
