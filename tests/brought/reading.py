# SPDX-License-Identifier: MIT
#
# Triangles of glTF 2.0, PLY and STL files of others, read by their specifications with the standard library: nothing that
# the host program reads with. Colours are the materials': textures are left out. What it does not know it refuses.
import base64
import json
import os
import struct
import urllib.parse

import numpy as np

import rays
import things

GREY = (200, 200, 200)  # sim/model/model.h: of what has neither material nor colours


class Unknown(Exception):
    pass


# glTF -----------------------------------------------------------------------------------------------------------------

NUMBERS = {5120: ('b', 127), 5121: ('B', 255), 5122: ('h', 32767), 5123: ('H', 65535), 5125: ('I', None), 5126: ('f', None)}
COUNTS = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4}


class _Gltf:
    def __init__(self, path):
        with open(path, 'rb') as file:
            data = file.read()
        self.folder, self.body = os.path.dirname(path), None
        if data[:4] == b'glTF':
            length, = struct.unpack('<I', data[12:16])
            self.root, at = json.loads(data[20:20 + length].decode()), 20 + length
            if at < len(data):
                length, = struct.unpack('<I', data[at:at + 4])
                self.body = data[at + 8:at + 8 + length]
        else:
            self.root = json.loads(data.decode('utf-8-sig'))
        if not str(self.root.get('asset', {}).get('version', '')).startswith('2'):
            raise Unknown('not of version 2')
        if self.root.get('extensionsRequired'):
            raise Unknown('extensions: %s' % self.root['extensionsRequired'])
        self.buffers = [self._buffer(b) for b in self.root.get('buffers', [])]

    def _buffer(self, buffer):
        uri = buffer.get('uri')
        if uri is None:
            return self.body
        if uri.startswith('data:'):
            return base64.b64decode(uri.split(',', 1)[1])
        with open(os.path.join(self.folder, urllib.parse.unquote(uri)), 'rb') as file:
            return file.read()

    def _rows(self, view, at, kind, components, count):
        letter, _ = NUMBERS[kind]
        what = self.root['bufferViews'][view]
        size_b = components * struct.calcsize(letter)
        stride_b, first = what.get('byteStride', size_b), what.get('byteOffset', 0) + at
        data = self.buffers[what['buffer']]
        return np.array([struct.unpack_from('<%d%s' % (components, letter), data, first + i * stride_b) for i in range(count)], float)

    def array(self, number):
        what = self.root['accessors'][number]
        kind, components, count = what['componentType'], COUNTS[what['type']], what['count']
        rows = np.zeros((count, components))
        if 'bufferView' in what:
            rows = self._rows(what['bufferView'], what.get('byteOffset', 0), kind, components, count)
        if 'sparse' in what:
            sparse = what['sparse']
            where, values = sparse['indices'], sparse['values']
            places = self._rows(where['bufferView'], where.get('byteOffset', 0), where['componentType'], 1, sparse['count'])
            rows[places[:, 0].astype(int)] = self._rows(values['bufferView'], values.get('byteOffset', 0), kind, components, sparse['count'])
        if what.get('normalized'):
            rows = np.maximum(rows / NUMBERS[kind][1], -1)
        return rows

    def matrix(self, node):
        if 'matrix' in node:
            return np.array(node['matrix'], float).reshape(4, 4).T
        return things.matrix_of(node.get('translation', (0, 0, 0)), node.get('rotation', (0, 0, 0, 1)), node.get('scale', (1, 1, 1)))

    def primitive(self, primitive, matrix):
        points = self.array(primitive['attributes']['POSITION'])
        order = self.array(primitive['indices'])[:, 0].astype(int) if 'indices' in primitive else np.arange(len(points))
        mode = primitive.get('mode', 4)
        if mode == 4:
            corners = order[:len(order) // 3 * 3].reshape(-1, 3)
        elif mode == 5:
            corners = np.array([(order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]) for i in range(len(order) - 2)])
        elif mode == 6:
            corners = np.array([(order[i + 1], order[i + 2], order[0]) for i in range(len(order) - 2)])
        else:
            return []
        material = self.root['materials'][primitive['material']] if 'material' in primitive else {}
        if material.get('alphaMode', 'OPAQUE') != 'OPAQUE' or material.get('emissiveFactor', [0, 0, 0]) != [0, 0, 0]:
            raise Unknown('opacity or emission')
        base = np.array(material.get('pbrMetallicRoughness', {}).get('baseColorFactor', (1, 1, 1, 1)), float)[:3]
        tints = self.array(primitive['attributes']['COLOR_0'])[:, :3] if 'COLOR_0' in primitive['attributes'] else None
        out = []
        for three in corners:
            shade = base * (1 if tints is None else tints[three].mean(0))
            colour = 255 * np.where(shade <= 0.0031308, 12.92 * shade, 1.055 * np.power(np.maximum(shade, 0), 1 / 2.4) - 0.055)
            out.append(rays.Triangle(points[three], colour, material.get('doubleSided', False)).moved(matrix))
        return out

    def node(self, number, above):
        node = self.root['nodes'][number]
        here = above @ self.matrix(node)
        out = []
        if 'skin' in node or 'extensions' in node:
            raise Unknown('a skin, or an extension of nodes')
        if 'mesh' in node:
            for primitive in self.root['meshes'][node['mesh']]['primitives']:
                if 'targets' in primitive or 'extensions' in primitive:
                    raise Unknown('morph targets or compression')
                out += self.primitive(primitive, here)
        for child in node.get('children', []):
            out += self.node(child, here)
        return out

    def triangles(self):
        if self.root.get('animations'):
            raise Unknown('animations')
        scene = self.root['scenes'][self.root.get('scene', 0)]
        return [t for number in scene['nodes'] for t in self.node(number, np.eye(4))]


# PLY ------------------------------------------------------------------------------------------------------------------

LETTERS = {'char': 'b', 'uchar': 'B', 'short': 'h', 'ushort': 'H', 'int': 'i', 'uint': 'I', 'float': 'f', 'double': 'd',
           'int8': 'b', 'uint8': 'B', 'int16': 'h', 'uint16': 'H', 'int32': 'i', 'uint32': 'I', 'float32': 'f', 'float64': 'd'}


def _ply_elements(data):
    """Dictionaries of rows by element: each row a dictionary of properties."""
    end = data.index(b'end_header')
    body = data[data.index(b'\n', end) + 1:]
    elements, coding = [], None
    for line in data[:end].decode('latin-1').splitlines():
        words = line.split()
        if words[:1] == ['format']:
            coding = words[1]
        elif words[:1] == ['element']:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ['property']:
            elements[-1][2].append(words[1:])
    words = iter(body.split()) if coding == 'ascii' else None
    at, order = 0, '>' if coding == 'binary_big_endian' else '<'

    def value(kind):
        nonlocal at
        letter = LETTERS[kind]
        if words is not None:
            return float(next(words))
        at += struct.calcsize(letter)
        return struct.unpack_from(order + letter, body, at - struct.calcsize(letter))[0]
    out = {}
    for name, count, properties in elements:
        rows = []
        for _ in range(count):
            row = {}
            for p in properties:
                row[p[-1]] = [value(p[2]) for _ in range(int(value(p[1])))] if p[0] == 'list' else value(p[0])
            rows.append(row)
        out[name] = rows
    return out, {name: {p[-1]: p[-2] for p in properties} for name, _, properties in elements}


def _ply(path):
    with open(path, 'rb') as file:
        elements, kinds = _ply_elements(file.read())
    points = np.array([[v['x'], v['y'], v['z']] for v in elements['vertex']])
    names = ('red', 'green', 'blue')
    most = 1 if kinds['vertex'].get('red', '')[:5] in ('float', 'doubl') else 255
    colours = np.array([[v[n] * 255 / most for n in names] for v in elements['vertex']]) if 'red' in kinds['vertex'] else None
    out = []
    for face in elements['face']:
        corners = [int(c) for c in face.get('vertex_indices', face.get('vertex_index'))]
        colour = GREY if colours is None else colours[corners].mean(0)
        for i in range(1, len(corners) - 1):
            out.append(rays.Triangle(points[[corners[0], corners[i], corners[i + 1]]], colour, two_sided=True))
    return out


# STL ------------------------------------------------------------------------------------------------------------------

def _stl(path):
    with open(path, 'rb') as file:
        data = file.read()
    count = struct.unpack('<I', data[80:84])[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        points = [struct.unpack_from('<9f', data, 84 + 50 * i + 12) for i in range(count)]
    else:
        words = data.split()
        numbers = [float(v) for i, w in enumerate(words) if w == b'vertex' for v in words[i + 1:i + 4]]
        points = np.array(numbers).reshape(-1, 9)
    return [rays.Triangle(np.array(p).reshape(3, 3), GREY) for p in points]


def triangles_of(path):
    suffix = os.path.splitext(path)[1].lower()
    if suffix in ('.gltf', '.glb'):
        return _Gltf(path).triangles()
    return {'.ply': _ply, '.stl': _stl}[suffix](path)
