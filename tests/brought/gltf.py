# SPDX-License-Identifier: MIT
#
# Writes glTF 2.0 as the specification has it, in any of its types of numbers: with the standard library alone.
import base64
import json
import struct

import numpy as np

KINDS = {'i8': (5120, 'b', 127), 'u8': (5121, 'B', 255), 'i16': (5122, 'h', 32767), 'u16': (5123, 'H', 65535),
         'u32': (5125, 'I', None), 'f32': (5126, 'f', None)}
TYPES = {1: 'SCALAR', 2: 'VEC2', 3: 'VEC3', 4: 'VEC4', 16: 'MAT4'}
ARRAY_BUFFER, ELEMENT_BUFFER = 34962, 34963


class Writer:
    def __init__(self):
        self.bytes = bytearray()
        self.root = {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': []}], 'nodes': [], 'meshes': [],
                     'materials': [], 'accessors': [], 'bufferViews': []}

    def add(self, name, what):
        self.root.setdefault(name, []).append(what)
        return len(self.root[name]) - 1

    def need(self, extension):
        for name in ('extensionsUsed', 'extensionsRequired'):
            if extension not in self.root.setdefault(name, []):
                self.root[name].append(extension)

    def view(self, data, **fields):
        self.bytes += b'\0' * (-len(self.bytes) % 4)
        at = len(self.bytes)
        self.bytes += data
        return self.add('bufferViews', {'buffer': 0, 'byteOffset': at, 'byteLength': len(data), **fields})

    def accessor(self, values, kind='f32', normalized=False, gap_b=0, sparse=(), **fields):
        """values: [count][components], as they are to be understood. gap_b: between elements. sparse: which elements are
        stored apart, in place of wrong ones."""
        values = np.asarray(values, dtype=np.float64)
        values = values.reshape(len(values), -1)
        number, letter, most = KINDS[kind]
        coded = np.rint(values * most) if normalized else values
        components = values.shape[1]

        def packed(rows, gap_b=0):
            form = '<%d%s' % (components, letter)
            return b''.join(struct.pack(form, *(r if kind == 'f32' else [int(v) for v in r])) + b'\xAA' * gap_b for r in rows)

        size_b = components * struct.calcsize(letter)
        base = coded.copy()
        base[list(sparse)] = 0 if kind[0] == 'u' else 1
        what = {'componentType': number, 'count': len(values), 'type': TYPES[components], **fields}
        if normalized:
            what['normalized'] = True
        if components == 3 and fields.get('is_position'):
            what['min'], what['max'] = coded.min(0).tolist(), coded.max(0).tolist()
        what.pop('is_position', None)
        pad_b = gap_b + (-(size_b + gap_b) % 4 if gap_b else 0)
        what['bufferView'] = self.view(packed(base, pad_b), **({'byteStride': size_b + pad_b} if gap_b else {}))
        if len(sparse):
            places = b''.join(struct.pack('<H', i) for i in sparse)
            what['sparse'] = {'count': len(sparse), 'indices': {'bufferView': self.view(places), 'componentType': 5123},
                              'values': {'bufferView': self.view(packed(coded[list(sparse)]))}}
        return self.add('accessors', what)

    def image(self, data, mime='image/png'):
        return self.add('images', {'bufferView': self.view(data), 'mimeType': mime})

    def node(self, below=None, **fields):
        number = self.add('nodes', fields)
        if below is None:
            self.root['scenes'][0]['nodes'].append(number)
        else:
            self.root['nodes'][below].setdefault('children', []).append(number)
        return number

    def files(self, name, how='inline'):
        """how: inline (base64), beside (a .bin), glb, unpadded (a .glb whose JSON has any length)."""
        root = {k: v for k, v in self.root.items() if v != [] or k == 'scenes'}
        buffer = {'byteLength': len(self.bytes)}
        if how == 'inline':
            buffer['uri'] = 'data:application/octet-stream;base64,' + base64.b64encode(bytes(self.bytes)).decode()
        if how == 'beside':
            buffer['uri'] = name + '%20data.bin'
        if self.bytes:
            root['buffers'] = [buffer]
        text = json.dumps(root).encode()
        if how == 'beside':
            return {name + '.gltf': text, name + ' data.bin': bytes(self.bytes)}
        if how == 'inline':
            return {name + '.gltf': text}
        text += b' ' * (-len(text) % 4 + (1 if how == 'unpadded' else 0))
        body = bytes(self.bytes) + b'\0' * (-len(self.bytes) % 4)
        chunks = struct.pack('<II', len(text), 0x4E4F534A) + text + struct.pack('<II', len(body), 0x004E4942) + body
        return {name + '.glb': struct.pack('<III', 0x46546C67, 2, 12 + len(chunks)) + chunks}
