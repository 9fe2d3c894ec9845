# SPDX-License-Identifier: MIT
#
# Writes pairs of models that show the same, NAME.gltf or NAME.glb and NAME.obj, into the folder that it is given: a solid
# in one of the ways that glTF has, and its corners, colours and texture coordinates as Python's own numbers have them.
# Needs the standard library alone.
import base64
import json
import math
import os
import struct
import sys
import zlib

KINDS = {'i8': (5120, 'b', 127), 'u8': (5121, 'B', 255), 'i16': (5122, 'h', 32767), 'u16': (5123, 'H', 65535),
         'u32': (5125, 'I', None), 'f32': (5126, 'f', None)}
TYPES = {1: 'SCALAR', 2: 'VEC2', 3: 'VEC3', 4: 'VEC4'}
REPEAT, CLAMP, MIRROR = 10497, 33071, 33648

# A wedge: no two of its corners, and no two of its sides, can be taken for each other.
CORNERS = [(0, 0, 0), (4, 0, 0), (0, 0, 2), (4, 0, 2), (0, 3, 0), (3, 1, 1)]
FACES = [(0, 1, 3), (0, 3, 2), (0, 4, 1), (1, 4, 5), (1, 5, 3), (3, 5, 2), (2, 5, 4), (0, 2, 4)]
PALETTE = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 1.0, 0.0), (0.0, 1.0, 1.0), (1.0, 0.0, 1.0),
           (1.0, 1.0, 1.0), (0.25, 0.25, 0.25)]
# An upright square that faces +z, its corners from the lower left one on; glTF counts v from the top.
SQUARE = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)]
SQUARE_FACES = [(0, 1, 2), (0, 2, 3)]
WHOLE = [(0, 1), (1, 1), (1, 0), (0, 0)]


def srgb(light):
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055


def png(rows):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    raw = b''.join(b'\0' + bytes(c for pixel in row for c in pixel) for row in rows)
    head = struct.pack('>IIBBBBB', len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(raw)) + chunk(b'IEND', b'')


def picture(side=16):
    """No two texels that are near have one colour, and all colours fit a texture's palette, with those of its smaller levels."""
    colours = [(255 * (i % 3) // 2, 255 * (i // 3 % 3) // 2, 255 * (i // 9) // 2) for i in range(1, 26)]
    return [[colours[(x * 7 + y * 4) % len(colours)] for x in range(side)] for y in range(side)]


def wrapped(rows, modes, first, count):
    """What a picture shows from `first` sides left of and above it on, `count` sides far, by the words of the specification."""
    def at(i, side, mode):
        if mode == CLAMP:
            return min(max(i, 0), side - 1)
        whole, rest = divmod(i, side)
        return side - 1 - rest if mode == MIRROR and whole % 2 else rest
    h, w = len(rows), len(rows[0])
    xs = range(int(first * w), int((first + count) * w))
    ys = range(int(first * h), int((first + count) * h))
    return [[rows[at(y, h, modes[1])][at(x, w, modes[0])] for x in xs] for y in ys]


class File:
    def __init__(self):
        self.bytes = b''
        self.root = {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0}],
                     'meshes': [{'primitives': []}], 'materials': [], 'accessors': [], 'bufferViews': []}

    def add(self, name, what):
        self.root.setdefault(name, []).append(what)
        return len(self.root[name]) - 1

    def view(self, data, **fields):
        self.bytes += b'\0' * (-len(self.bytes) % 4)
        number = self.add('bufferViews', dict(buffer=0, byteOffset=len(self.bytes), byteLength=len(data), **fields))
        self.bytes += data
        return number

    def list(self, rows, kind='f32', share=False, gap_b=0, sparse=()):
        """rows: of what is meant. share: normalised. sparse: elements that are stored apart."""
        number, letter, most = KINDS[kind]
        width = len(rows[0])
        form = '<%d%s' % (width, letter)

        def packed(some):
            return b''.join(struct.pack(form, *[v if kind == 'f32' else round(v * (most if share else 1)) for v in row]) +
                            b'\xEE' * gap_b for row in some)
        base = [tuple(1 for _ in row) if i in sparse else row for i, row in enumerate(rows)]
        fields = {'byteStride': struct.calcsize(form) + gap_b} if gap_b else {}
        what = {'bufferView': self.view(packed(base), **fields), 'componentType': number, 'count': len(rows),
                'type': TYPES[width], 'normalized': share}
        if sparse:
            places = self.view(b''.join(struct.pack('<H', i) for i in sparse))
            gap_b = 0
            what['sparse'] = {'count': len(sparse), 'indices': {'bufferView': places, 'componentType': 5123},
                              'values': {'bufferView': self.view(packed([rows[i] for i in sparse]))}}
        return self.add('accessors', what)

    def need(self, *names):
        self.root['extensionsUsed'] = self.root['extensionsRequired'] = list(names)

    def texture(self, rows, modes=(REPEAT, REPEAT)):
        image = self.add('images', {'bufferView': self.view(png(rows)), 'mimeType': 'image/png'})
        sampler = self.add('samplers', {'wrapS': modes[0], 'wrapT': modes[1]})
        return self.add('textures', {'source': image, 'sampler': sampler})

    def material(self, colour=(1, 1, 1), texture=None, **fields):
        pbr = {'baseColorFactor': list(colour) + [1], 'metallicFactor': 0}
        if texture is not None:
            pbr['baseColorTexture'] = texture
        return self.add('materials', dict(pbrMetallicRoughness=pbr, **fields))

    def primitive(self, material, indices=None, mode=4, **attributes):
        what = {'attributes': attributes, 'material': material, 'mode': mode}
        if indices is not None:
            what['indices'] = indices
        self.root['meshes'][0]['primitives'].append(what)

    def write(self, path, how='inline'):
        self.root['buffers'] = [{'byteLength': len(self.bytes)}]
        if how == 'inline':
            self.root['buffers'][0]['uri'] = 'data:application/octet-stream;base64,' + base64.b64encode(self.bytes).decode()
        text = json.dumps(self.root).encode()
        if how == 'inline':
            data = text
        else:
            text += b' ' * (-len(text) % 4 + (3 if how == 'unpadded' else 0))
            body = self.bytes + b'\0' * (-len(self.bytes) % 4)
            data = struct.pack('<II', len(text), 0x4E4F534A) + text + struct.pack('<II', len(body), 0x004E4942) + body
            data = struct.pack('<III', 0x46546C67, 2, 12 + len(data)) + data
        with open(path, 'wb') as out:
            out.write(data)


def obj(name, faces, rows=None):
    """faces: (corners, colour, uvs) each, v from the top."""
    lines, colours, count = ['mtllib %s.mtl' % name], [], 0
    if rows:
        with open(name + '.png', 'wb') as out:
            out.write(png(rows))
    for corners, colour, uvs in faces:
        if colour not in colours:
            colours.append(colour)
        lines += ['v %r %r %r' % tuple(float(c) for c in corner) for corner in corners]
        lines += ['vt %r %r' % (float(u), 1 - float(v)) for u, v in uvs or [(0, 0)] * len(corners)]
        lines.append('usemtl m%d' % colours.index(colour))
        lines.append('f ' + ' '.join('%d/%d' % (count + k, count + k) for k in range(1, len(corners) + 1)))
        count += len(corners)
    with open(name + '.obj', 'w') as out:
        out.write('\n'.join(lines) + '\n')
    with open(name + '.mtl', 'w') as out:
        for i, colour in enumerate(colours):
            out.write('newmtl m%d\nKd %r %r %r\n' % ((i,) + tuple(srgb(c) for c in colour)))
            if rows:
                out.write('map_Kd %s.png\n' % name)


def wedge(out, kind='f32', share=False, gap_b=0, sparse=(), index_kind='u16', colour_kind=None, how=None):
    """Its faces are primitives that share their corners; positions are eighths where they are shares."""
    most = KINDS[kind][2]
    corners = [tuple(c / most for c in corner) for corner in CORNERS] if share else CORNERS
    if share:
        out.root['nodes'][0]['scale'] = [most] * 3
    positions = out.list(corners, kind, share, gap_b, sparse)
    for face, colour in zip(FACES, PALETTE):
        if colour_kind:
            material = out.material()
            colours = {'COLOR_0': out.list([colour] * len(CORNERS), colour_kind, colour_kind != 'f32')}
        else:
            material, colours = out.material(colour), {}
        out.primitive(material, out.list([(i,) for i in face], index_kind), POSITION=positions, **colours)


def wedge_faces(matrix=None):
    moved = [tuple(sum(row[k] * p[k] for k in range(3)) + row[3] for row in matrix) if matrix else p for p in CORNERS]
    return [([moved[i] for i in face], colour, None) for face, colour in zip(FACES, PALETTE)]


def accessors():
    for kind in ('i8', 'u8', 'i16', 'u16', 'f32'):
        for share in (False, True) if kind != 'f32' else (False,):
            name = 'positions_%s%s' % (kind, '_normalised' if share else '')
            out = File()
            out.need('KHR_mesh_quantization')
            wedge(out, kind, share, index_kind={'i8': 'u8', 'f32': 'u32'}.get(kind, 'u16'))
            out.write(name + '.gltf')
            obj(name, wedge_faces())
    ways = {'strided': dict(kind='i16', gap_b=2), 'sparse': dict(sparse=(1, 4, 5)),
            'sparse_strided': dict(kind='u8', gap_b=1, sparse=(0, 5)), 'colours_u8': dict(colour_kind='u8'),
            'colours_u16': dict(colour_kind='u16'), 'colours_f32': dict(colour_kind='f32')}
    for name, way in ways.items():
        out = File()
        wedge(out, **way)
        out.write(name + '.gltf')
        colours = [tuple(round(c * 255) / 255 for c in colour) if way.get('colour_kind') == 'u8' else colour for colour in PALETTE]
        obj(name, [(f[0], c, None) for f, c in zip(wedge_faces(), colours)])
    for name, how in (('padded', 'glb'), ('unpadded', 'unpadded')):
        out = File()
        wedge(out)
        out.write(name + '.glb', how)
        obj(name, wedge_faces())


def square(out, uvs, kind='f32', texture=None, material=None, set_number=0, others=None):
    positions = out.list(SQUARE)
    lists = {'TEXCOORD_%d' % set_number: out.list(uvs, kind, kind != 'f32')}
    if others:
        lists.update(others)
    out.primitive(out.material(texture=texture) if material is None else material,
                  out.list([(i,) for face in SQUARE_FACES for i in face], 'u8'), POSITION=positions, **lists)


def square_faces(uvs):
    return [(SQUARE, (1.0, 1.0, 1.0), uvs)]


def textures():
    rows = picture()
    for kind in ('u8', 'u16', 'f32'):
        out = File()
        square(out, WHOLE, kind, {'index': out.texture(rows)})
        out.write('uvs_%s.gltf' % kind)
        obj('uvs_%s' % kind, square_faces(WHOLE), rows)
    transforms = {'offset': {'offset': [0.25, 0.5]}, 'scale': {'scale': [0.5, 2]}, 'turn': {'rotation': math.pi / 2},
                  'all': {'offset': [0.125, -0.25], 'rotation': 0.35, 'scale': [0.75, 0.5]},
                  'set': {'texCoord': 1, 'scale': [0.5, 0.5]}}
    for name, transform in transforms.items():
        out = File()
        out.need('KHR_texture_transform')
        info = {'index': out.texture(rows), 'extensions': {'KHR_texture_transform': transform}}
        other = {'TEXCOORD_0': out.list([(0, 0)] * 4)} if 'texCoord' in transform else None
        square(out, WHOLE, 'f32', info, set_number=transform.get('texCoord', 0), others=other)
        out.write('transform_%s.gltf' % name)
        (du, dv), (su, sv), turn = transform.get('offset', (0, 0)), transform.get('scale', (1, 1)), transform.get('rotation', 0)
        c, s = math.cos(turn), math.sin(turn)
        uvs = [(c * su * u + s * sv * v + du, -s * su * u + c * sv * v + dv) for u, v in WHOLE]
        obj('transform_%s' % name, square_faces(uvs), rows)
    for across in (REPEAT, CLAMP, MIRROR):
        for down in (REPEAT, CLAMP, MIRROR):
            name = 'wrap_%d_%d' % (across, down)
            out = File()
            square(out, [(2 * u - 0.5, 2 * v - 0.5) for u, v in WHOLE], 'f32', {'index': out.texture(rows, (across, down))})
            out.write(name + '.gltf')
            obj(name, square_faces(WHOLE), wrapped(rows, (across, down), -0.5, 2))


def instances():
    turns = {'f32': [(0, 0, 0, 1), (0, math.sqrt(0.5), 0, math.sqrt(0.5)), (0.5, 0.5, 0.5, 0.5)],
             'i8': [(0, 0, 0, 1), (0, 1, 0, 0), (64 / 127, 64 / 127, 64 / 127, 64 / 127)],
             'i16': [(0, 0, 0, 1), (0, 0, -1, 0), (16384 / 32767, 16384 / 32767, 16384 / 32767, 16384 / 32767)]}
    places, scales = [(0, 0, 0), (9, 0.5, 0), (-2, 0, 8)], [(1, 1, 1), (0.5, 1, 2), (1, 1, -1)]
    for kind, own in turns.items():
        out = File()
        out.need('EXT_mesh_gpu_instancing')
        wedge(out)
        lists = {'TRANSLATION': out.list(places), 'ROTATION': out.list(own, kind, kind != 'f32'), 'SCALE': out.list(scales)}
        out.root['nodes'][0]['extensions'] = {'EXT_mesh_gpu_instancing': {'attributes': lists}}
        out.write('instances_%s.gltf' % kind)
        faces = []
        for at, q, scale in zip(places, own, scales):
            length = math.sqrt(sum(c * c for c in q))
            x, y, z, w = (c / length for c in q)
            turned = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
            moved = wedge_faces([[turned[i][k] * scale[k] for k in range(3)] + [at[i]] for i in range(3)])
            mirrored = scale[0] * scale[1] * scale[2] < 0
            faces += [(corners[::-1] if mirrored else corners, colour, uvs) for corners, colour, uvs in moved]
        obj('instances_%s' % kind, faces)


def emission():
    def one(name, base, factor, strength=None):
        out = File()
        fields = {'emissiveFactor': factor}
        if strength:
            out.need('KHR_materials_emissive_strength')
            fields['extensions'] = {'KHR_materials_emissive_strength': {'emissiveStrength': strength}}
        square(out, WHOLE, material=out.material(base, **fields))
        out.write(name + '.gltf')
        total = [min(1.0, b + f * (strength or 1)) for b, f in zip(base, factor)]
        obj(name, [(SQUARE, tuple(total), None)])
    one('emits_alone', (0, 0, 0), (0, 1, 0.25))
    one('emits_as_well', (0.25, 0.5, 0), (0.25, 0.75, 0.5))
    one('emits_more', (0, 0, 0), (0.125, 0.25, 0.5), 1.5)
    rows, dark = picture(), [[(0, 0, 0)] * 16 for _ in range(16)]
    for y in range(8):
        for x in range(8):
            dark[y][x] = (255, 255, 255)
    out = File()
    square(out, WHOLE, material=out.material((0, 0, 0), emissiveFactor=[1, 1, 1], emissiveTexture={'index': out.texture(rows)}))
    out.write('emits_picture.gltf')
    obj('emits_picture', square_faces(WHOLE), rows)
    out = File()
    square(out, WHOLE, material=out.material((1, 1, 1), {'index': out.texture(rows)}, emissiveFactor=[1, 1, 1],
                                             emissiveTexture={'index': out.texture(dark)}))
    out.write('emits_picture_as_well.gltf')
    obj('emits_picture_as_well', square_faces(WHOLE), [[(255, 255, 255) if x < 8 and y < 8 else rows[y][x] for x in range(16)]
                                                       for y in range(16)])


def said():
    """Files of which something is to be said: name, what is drawn being the wedge; those of foreign.sh come first."""
    out = File()
    strong = {'KHR_materials_emissive_strength': {'emissiveStrength': 5}}
    square(out, WHOLE, material=out.material((0, 0, 0), emissiveFactor=[1, 0.2, 0.2], extensions=strong))
    out.write('bright.gltf')
    out = File()
    picture_of = {'index': out.texture(picture()[:11])}  # which is resized, and told
    out.root['images'][0]['name'] = 'leaf'
    square(out, WHOLE, material=out.material((1, 1, 1), picture_of))
    out.write('named.gltf')
    out.root['images'][0]['name'] = 'nul\0'
    out.write('nul.gltf')
    out = File()
    wedge(out)
    out.root['extensionsUsed'] = ['KHR_lights_punctual', 'KHR_materials_sheen', 'KHR_materials_clearcoat', 'ACME_dust',
                                  'KHR_materials_volume', 'ACME_smoke']  # the last two are used nowhere
    out.root['extensions'] = {'KHR_lights_punctual': {'lights': []}, 'ACME_dust': {}}
    out.root['nodes'][0]['extensions'] = {'KHR_materials_sheen': {}, 'KHR_materials_clearcoat': {}}
    out.write('lights.gltf')
    out.root['extensionsRequired'] = ['ACME_dust']
    out.write('dust.gltf')
    out = File()
    wedge(out)
    out.primitive(0, None, 1, POSITION=0)
    out.primitive(0, None, 0, POSITION=0)
    out.write('lines.gltf')
    out = File()
    wedge(out)
    out.root['meshes'][0]['weights'] = [0.5]
    for primitive in out.root['meshes'][0]['primitives']:
        primitive['targets'] = [{'POSITION': 0}]
    out.root['nodes'][0]['skin'] = 0
    out.root['nodes'].append({'name': 'bone'})
    out.root['skins'] = [{'joints': [1]}]
    out.write('posed.gltf')
    for name in ('lights', 'lines', 'posed'):
        obj(name, wedge_faces())


def cameras():
    """look.gltf has two cameras, look.cam the same as lines; flat.gltf one that is orthographic."""
    def turned(axis, angle):
        return [math.sin(angle / 2) if i == axis else 0 for i in range(3)] + [math.cos(angle / 2)]
    out = File()
    wedge(out)
    out.write('wedge.gltf')
    root = {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
            'nodes': [{'translation': [2, 1, 0], 'rotation': turned(1, math.pi / 2), 'children': [1, 2]},
                      {'camera': 0, 'name': 'first', 'translation': [0.5, 1, 9]},
                      {'camera': 0, 'name': 'second', 'translation': [0, 8, 6], 'rotation': turned(0, -0.9), 'scale': [2, 2, 2]}],
            'cameras': [{'type': 'perspective', 'perspective': {'yfov': math.radians(45), 'znear': 0.1}}]}
    # A quarter about y takes z to x, and x to -z.
    lines = [(2 + 9, 2, -0.5, 2 + 8, 2, -0.5), (2 + 6, 9, 0, 2 + 6 - math.cos(0.9), 9 - math.sin(0.9), 0)]
    with open('look.gltf', 'w') as file:
        json.dump(root, file)
    with open('look.cam', 'w') as file:
        file.write(''.join(' '.join(map(repr, line)) + '\n' for line in lines))
    with open('turned.cam', 'w') as file: # where z is up, it becomes y
        file.write(''.join(' '.join(map(repr, (a, c, -b, d, f, -e))) + '\n' for a, b, c, d, e, f in lines))
    root['cameras'] = [{'type': 'orthographic', 'orthographic': {'xmag': 1, 'ymag': 1, 'znear': 0.1, 'zfar': 9}}]
    with open('flat.gltf', 'w') as file:
        json.dump(root, file)


def bounds():
    """NAME_n.gltf is whole; NAME_n1.gltf asks for one more than there is."""
    def pair(name, change):
        for more in (0, 1):
            out = File()
            wedge(out, sparse=(1, 5))
            change(out.root, more)
            out.write('%s_n%s.gltf' % (name, more or ''))

    def positions(root):
        return root['accessors'][0]
    pair('count', lambda root, more: root['accessors'][1].update(count=3 + more))
    pair('offset', lambda root, more: positions(root).update(byteOffset=more))
    pair('view', lambda root, more: root['bufferViews'][0].update(byteLength=72 - more))
    pair('buffer', lambda root, more: root['bufferViews'][-1].update(byteLength=root['bufferViews'][-1]['byteLength'] + more))
    pair('stride', lambda root, more: root['bufferViews'][0].update(byteStride=12 + 4 * more))
    pair('sparse_count', lambda root, more: positions(root)['sparse'].update(count=2 + more))
    pair('huge', lambda root, more: positions(root).update(count=6 + more * (2 ** 32 - 7)))
    pair('huge_zeros', lambda root, more: root['accessors'].append({'componentType': 5126, 'count': 1, 'type': 'VEC3'})
         or (more and root['meshes'][0]['primitives'][0]['attributes'].update(POSITION=len(root['accessors']) - 1)))


os.chdir(sys.argv[1])
for part in sys.argv[2:]:
    {'accessors': accessors, 'textures': textures, 'instances': instances, 'emission': emission, 'said': said, 'cameras': cameras,
     'bounds': bounds}[part]()
