# SPDX-License-Identifier: MIT
#
# glTF that stands still: each input draws its ways of saying the same parts from a seed.
import numpy as np

import gltf
import rays
import things
from judge import Input

UNLIT = {'KHR_materials_unlit': {}}


def _positions(out, points, random, fields):
    """An accessor, and the transform that a quantised one wants."""
    kind = random.choice(['f32', 'f32', 'i16', 'u16', 'i8', 'u8'])
    sparse = sorted(random.choice(len(points), size=random.integers(1, len(points)), replace=False)) if random.random() < 0.3 else ()
    gap_b = int(random.choice([0, 0, 4, 8]))
    if kind == 'f32':
        return out.accessor(points, kind, gap_b=gap_b, sparse=sparse, is_position=True, **fields), np.eye(4)
    out.need('KHR_mesh_quantization')
    low, most = points.min(0), gltf.KINDS[kind][2]
    reach = max((points.max(0) - low).max(), 1e-9)
    coded = np.rint((points - low) / reach * most)
    normalized = bool(random.random() < 0.5)
    matrix = np.eye(4)
    matrix[:3, :3] *= reach if normalized else reach / most
    matrix[:3, 3] = low
    values = coded / most if normalized else coded
    return out.accessor(values, kind, normalized, gap_b, sparse, is_position=True, **fields), matrix


def _uvs(out, uvs, random):
    """TEXCOORD_0, and the extension that puts it right where the type holds 0..1 alone."""
    low, high = uvs.min(0), uvs.max(0)
    kind = random.choice(['f32', 'u8', 'u16'])
    if kind == 'f32' and random.random() < 0.5:
        return out.accessor(uvs, kind, gap_b=int(random.choice([0, 4]))), None
    turned = random.choice([0.0, np.pi / 2, 0.3])
    scale, offset = np.maximum(high - low, 1e-3) * 1.5, low
    c, s = np.cos(turned), np.sin(turned)
    # u = T R S x, R as the extension has it: cos sin -sin cos
    inside = ((uvs - offset) @ np.linalg.inv(np.array([[c, s], [-s, c]])).T) / scale
    if kind != 'f32' and (inside.min() < 0 or inside.max() > 1):
        kind = 'f32'
    out.need('KHR_texture_transform')
    transform = {'offset': offset.tolist(), 'rotation': float(turned), 'scale': scale.tolist()}
    return out.accessor(inside, kind, kind != 'f32'), {'KHR_texture_transform': transform}


def _indices(out, part, primitive, attributes, random):
    """As an index array, or without one; triangles, a strip or a fan where they are one."""
    triangles = part.triangles
    is_quad = len(triangles) == 2 and len(part.points) == 4
    mode = random.choice(['list', 'strip', 'fan']) if is_quad else 'list'
    order = {'list': triangles.ravel(), 'strip': np.array([1, 2, 0, 3]), 'fan': np.array([0, 1, 2, 3])}[mode]
    if mode != 'list':
        primitive['mode'] = {'strip': 5, 'fan': 6}[mode]
    if random.random() < 0.2:
        return order
    primitive['indices'] = out.accessor(order, random.choice(['u8', 'u16', 'u32']))
    return None


def _material(out, part, random, extensions):
    base = things.linear_of(part.colour).tolist() + [1.0]
    pbr = {'baseColorFactor': base, 'metallicFactor': 0}
    if part.texture is not None:
        wraps = [{'repeat': 10497, 'clamp': 33071, 'mirror': 33648}[w] for w in part.texture.wraps]
        sampler = out.add('samplers', {'wrapS': wraps[0], 'wrapT': wraps[1]})
        source = out.image(things.png(part.texture.rows))
        pbr['baseColorTexture'] = {'index': out.add('textures', {'source': source, 'sampler': sampler})}
        if extensions:
            pbr['baseColorTexture']['extensions'] = extensions
    return out.add('materials', {'pbrMetallicRoughness': pbr, 'doubleSided': part.two_sided, 'extensions': UNLIT})


def write_part(out, part, random):
    """A mesh of its own; and the transform that its node must have before any other."""
    primitive, points, uvs, extensions = {}, part.points, part.uvs, None
    order = _indices(out, part, primitive, None, random)
    if order is not None:
        points, uvs = points[order], None if uvs is None else uvs[order]
    position, matrix = _positions(out, points, random, {})
    primitive['attributes'] = {'POSITION': position}
    if uvs is not None:
        primitive['attributes']['TEXCOORD_0'], extensions = _uvs(out, uvs, random)
    if uvs is None and random.random() < 0.4:
        kind = random.choice(['f32', 'u8', 'u16'])
        alpha = [1.0] * int(random.choice([0, 1]))
        rows = np.tile(things.linear_of(part.colour).tolist() + alpha, (len(points), 1))
        primitive['attributes']['COLOR_0'] = out.accessor(rows, kind, kind != 'f32')
        primitive['material'] = _material(out, things.Part(points, [], (255, 255, 255), two_sided=part.two_sided), random, None)
    else:
        primitive['material'] = _material(out, part, random, extensions)
    return out.add('meshes', {'primitives': [primitive]}), matrix


def place(out, mesh, own, where, random, below=None):
    """Nodes that move a mesh by `own`, then by `where`: as matrices."""
    node = out.node(below, matrix=where.T.ravel().tolist()) if random.random() < 0.5 else None
    if node is None:
        out.node(below, mesh=mesh, matrix=(where @ own).T.ravel().tolist())
    else:
        out.node(node, mesh=mesh, matrix=own.T.ravel().tolist())


def _furniture(random):
    rows = things.quarters()
    parts = things.box((-1, -0.5, -0.5), (1, 1, 1.5), int(random.integers(0, 6)))
    uvs = np.array([(0, 1), (1, 1), (1, 0), (0, 0)]) * random.choice([1, 2]) - random.choice([0, 0.5])
    wraps = tuple(random.choice(['repeat', 'clamp', 'mirror'], size=2))
    parts.append(things.panel((0.5, -0.5, 0), 1.5, rows, uvs, wraps))
    return parts


def _plain(name, random):
    out = gltf.Writer()
    triangles = []
    for part in _furniture(random):
        mesh, own = write_part(out, part, random)
        where = np.eye(4)
        if random.random() < 0.3:
            where = things.matrix_of((0, 0, 0.25), things.turn((1, 2, 3), 0.4), (1, 1, random.choice([1, -1])))
        place(out, mesh, own, where, random)
        triangles += part.seen(where)
    how = random.choice(['inline', 'beside', 'glb', 'unpadded'])
    return Input('%s, %s' % (name, how), out.files('it', how), triangles, ('--up', 'y'))


def _instances(name, random):
    out = gltf.Writer()
    out.need('EXT_mesh_gpu_instancing')
    triangles = []
    count = int(random.integers(2, 5))
    places = [(2.5 * i, random.choice([0, 0.5]), random.choice([0, -1])) for i in range(count)]
    turns = [things.turn((0, 1, 0.2), 0.5 * i) for i in range(count)]
    scales = [(1, 1, 1 + 0.5 * i) for i in range(count)]
    kind = random.choice(['f32', 'i8', 'i16'])
    if kind != 'f32':
        most = gltf.KINDS[kind][2]
        turns = [np.rint(q * most) / most for q in turns]
    for part in things.box((-0.5, -0.5, -0.5), (1, 1, 1)):
        mesh, own = write_part(out, part, np.random.default_rng(1))
        fields = {'TRANSLATION': out.accessor(places), 'ROTATION': out.accessor(turns, kind, kind != 'f32'),
                  'SCALE': out.accessor(scales)}
        out.node(mesh=mesh, extensions={'EXT_mesh_gpu_instancing': {'attributes': fields}})
        for at, q, scale in zip(places, turns, scales):
            triangles += part.seen(things.matrix_of(at, q, scale))
    return Input('%s, %d of them, %s' % (name, count, kind), out.files('it'), triangles, ('--up', 'y'))


def inputs(random):
    for i in range(40):
        yield _plain('ways of saying the same, %d' % i, random)
    for i in range(6):
        yield _instances('instances, %d' % i, random)
