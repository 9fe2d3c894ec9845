# SPDX-License-Identifier: MIT
#
# glTF whose nodes move rigidly: keys of all types and interpolations, nested, mirrored, scaled, of one name. The truth is
# the specification's arithmetic in doubles, at each frame's time.
import numpy as np

import gltf
import kind_gltf
import things
from judge import Input

FRAMES, FPS, END_S = 5, 10, 0.6


class Track:
    """Keys of one path of a node: times, values, and how to go between them."""

    def __init__(self, path, times_s, values, how='LINEAR', tangents=None):
        self.path, self.times_s, self.values, self.how = path, np.asarray(times_s), np.asarray(values, float), how
        self.tangents = tangents

    def at(self, time_s):
        times, values = self.times_s, self.values
        if time_s <= times[0] or len(times) == 1:
            return values[0]
        if time_s >= times[-1]:
            return values[-1]
        i = int(np.searchsorted(times, time_s, side='right')) - 1
        span = times[i + 1] - times[i]
        t = (time_s - times[i]) / span
        if self.how == 'STEP':
            return values[i]
        if self.how == 'CUBICSPLINE':
            into, out = self.tangents
            t2, t3 = t * t, t * t * t
            value = ((2 * t3 - 3 * t2 + 1) * values[i] + span * (t3 - 2 * t2 + t) * out[i] +
                     (3 * t2 - 2 * t3) * values[i + 1] + span * (t3 - t2) * into[i + 1])
            return value / np.linalg.norm(value) if self.path == 'rotation' else value
        if self.path == 'rotation':
            return _slerp(values[i], values[i + 1], t)
        return (1 - t) * values[i] + t * values[i + 1]

    def stored(self):
        if self.how != 'CUBICSPLINE':
            return self.values
        into, out = self.tangents
        return np.stack([into, self.values, out], 1).reshape(-1, self.values.shape[1])


def _slerp(a, b, t):
    dot = float(a @ b)
    if dot < 0:
        b, dot = -b, -dot
    angle = np.arccos(min(dot, 1.0))
    if angle < 1e-9:
        return a
    return (np.sin((1 - t) * angle) * a + np.sin(t * angle) * b) / np.sin(angle)


class Node:
    """A box, perhaps, that is at, turned and scaled; tracks move it; children move with it."""

    def __init__(self, at=(0, 0, 0), q=(0, 0, 0, 1), scale=(1, 1, 1), tracks=(), parts=(), children=(), name=None):
        self.at, self.q, self.scale, self.tracks = at, q, scale, tracks
        self.parts, self.children, self.name = parts, children, name

    def matrix(self, time_s):
        own = {'translation': self.at, 'rotation': self.q, 'scale': self.scale}
        for track in self.tracks:
            own[track.path] = track.at(time_s)
        return things.matrix_of(own['translation'], own['rotation'], own['scale'])

    def seen(self, time_s, above=np.eye(4)):
        here = above @ self.matrix(time_s)
        out = [t for part in self.parts for t in part.seen(here)]
        for child in self.children:
            out += child.seen(time_s, here)
        return out

    def write(self, out, animation, random, below=None):
        fields = {'translation': list(map(float, self.at)), 'rotation': list(map(float, self.q)), 'scale': list(map(float, self.scale))}
        if self.name:
            fields['name'] = self.name
        number = out.node(below, **fields)
        for part in self.parts:
            primitive = {'attributes': {'POSITION': out.accessor(part.points, is_position=True)},
                         'indices': out.accessor(part.triangles.ravel(), 'u16'),
                         'material': kind_gltf._material(out, part, random, None)}
            out.node(number, mesh=out.add('meshes', {'primitives': [primitive]}))
        for track in self.tracks:
            kind = str(random.choice(['f32', 'i16', 'i8'])) if track.path == 'rotation' and track.how == 'LINEAR' else 'f32'
            if kind != 'f32':  # what such numbers say, not what was meant
                most = gltf.KINDS[kind][2]
                track.values = np.rint(track.values * most) / most
            stored = track.stored()
            if kind != 'f32':
                track.values = track.values / np.linalg.norm(track.values, axis=1)[:, None]
            sampler = {'input': out.accessor(track.times_s), 'output': out.accessor(stored, kind, kind != 'f32'), 'interpolation': track.how}
            animation['samplers'].append(sampler)
            animation['channels'].append({'sampler': len(animation['samplers']) - 1,
                                          'target': {'node': number, 'path': track.path}})
        for child in self.children:
            child.write(out, animation, random, number)


def _times(random, count):
    """Off the frames' times, where a step has no side."""
    return np.concatenate([[0.0], np.sort(random.choice(np.arange(0.03, 0.57, 0.06), count - 2, replace=False)), [END_S]])


def _track(random, path, how, reach=1.0):
    count = int(random.integers(2, 6))
    times = _times(random, count)
    if path == 'rotation':
        axis = random.normal(size=3)
        values = np.array([things.turn(axis, a) for a in np.cumsum(random.uniform(-1, 1, count))])
    else:
        values = random.uniform(-reach, reach, (count, 3))
    tangents = None
    if how == 'CUBICSPLINE':
        tangents = random.normal(size=(2, *values.shape)) * (0.5 if path == 'rotation' else reach)
    return Track(path, times, values, how, tangents)


def _parts(random, at=(0, 0, 0)):
    return things.box(np.array((-0.5, -0.5, -0.5)) + at, (1, 0.75, 1.25), int(random.integers(0, 6)))


def _floor():
    return things.Part([(-2, -2, -2), (-2, -2, 2), (2, -2, 2), (2, -2, -2)], [(0, 1, 2), (0, 2, 3)], (128, 128, 128))


def _input(name, roots, random, stands=True, says=None, options=()):
    out, animation = gltf.Writer(), {'samplers': [], 'channels': []}
    roots = list(roots) + ([Node(parts=[_floor()])] if stands else [])
    for root in roots:
        root.write(out, animation, random)
    out.root['animations'] = [animation]
    still = '--movers' in options
    at = lambda time_s: [t for root in roots for t in root.seen(0.0 if still else time_s)]
    return Input(name, out.files('it'), at, options, says, 1 if still else FRAMES, FPS)


def inputs(random):
    for how in ('LINEAR', 'STEP', 'CUBICSPLINE'):
        for paths in (('translation',), ('rotation',), ('translation', 'rotation')):
            for _ in range(2):
                tracks = [_track(random, path, how) for path in paths]
                yield _input('%s %s' % (how, ' and '.join(paths)), [Node(tracks=tracks, parts=_parts(random))], random)
    for _ in range(3):
        tracks = [_track(random, 'translation', 'LINEAR'), _track(random, 'rotation', 'LINEAR')]
        yield _input('nothing stands still', [Node(tracks=tracks, parts=_parts(random))], random, stands=False)
    for how in ('LINEAR', 'STEP', 'CUBICSPLINE'):
        for depth in (2, 3):
            node = None
            for level in range(depth):
                node = Node((1.5 if node is None else 0.5, 0, 0), things.turn((1, 1, 0), 0.3),
                            tracks=[_track(random, 'rotation', how)] + ([_track(random, 'translation', how, 0.5)] if level == 1 else []),
                            parts=_parts(random) if level != 1 else [], children=[node] if node else [])
            yield _input('nested %d deep, %s' % (depth, how), [node], random)
    node = None
    for level in range(48):  # read within the importer's bound of time only if a key costs little; no two boxes meet
        turns = Track('rotation', [0.0, 0.3, END_S], [things.turn((0, 0, 1), a) for a in random.uniform(-1, 1, 3)])
        node = Node((0.1, 0, 1.5), tracks=[turns], parts=_parts(random), children=[node] if node else [])
    yield _input('nested 48 deep', [node], random)
    for scale in ((2, 2, 2), (0.5, 1, 2), (-1, 1, 1), (1, -0.5, 1)):
        node = Node(scale=scale, tracks=[_track(random, 'rotation', 'LINEAR')], parts=_parts(random))
        yield _input('scale of %s' % (scale,), [node], random)
        keyed = Track('scale', [0.0, 0.3, END_S], [scale] * 3)
        node = Node(tracks=[_track(random, 'rotation', 'LINEAR'), keyed], parts=_parts(random))
        yield _input('keys of a constant scale of %s' % (scale,), [node], random)
    for _ in range(2):
        twins = [Node((2.0 * i, 0, 0), tracks=[_track(random, 'rotation', 'LINEAR')], parts=_parts(random), name='twin') for i in range(2)]
        yield _input('two of one name', twins, random)
    below = Node((0, 0, 1), tracks=[_track(random, 'rotation', 'LINEAR')], parts=_parts(random))
    above = Node(scale=(1.5, 1.5, 1.5), q=things.turn((0, 1, 0), 1.0), tracks=[_track(random, 'translation', 'CUBICSPLINE')], children=[below])
    yield _input('below one that is scaled', [above], random)
    grows = Track('scale', [0.0, END_S], [(1, 1, 1), (2, 2, 2)])
    for name, node in (('a scale that changes', Node(tracks=[grows], parts=_parts(random))),
                       ('nested motion', Node(tracks=[_track(random, 'rotation', 'LINEAR')],
                                              children=[Node((1, 0, 0), tracks=[_track(random, 'rotation', 'STEP')], parts=_parts(random))]))):
        # The file's nodes as they are, not their first keys: those of these tracks are the same at time 0 only by luck.
        for each in (node, *node.children):
            for track in each.tracks:
                setattr(each, {'translation': 'at', 'rotation': 'q', 'scale': 'scale'}[track.path], tuple(track.at(0.0)))
        yield _input('--movers off: ' + name, [node], random, options=('--movers', 'off'), says='')
    out, animation = gltf.Writer(), {'samplers': [], 'channels': []}
    Node(tracks=[grows], parts=_parts(random), name='grower').write(out, animation, random)
    out.root['animations'] = [animation]
    yield Input('a scale that changes is refused', out.files('it'), None, says="grower.*scale.*--movers off")
