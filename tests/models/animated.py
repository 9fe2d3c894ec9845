# SPDX-License-Identifier: MIT
#
# Small glTF files whose nodes are animated, for cli_motion.sh: python3 animated.py FOLDER writes one of each kind.
import base64
import json
import math
import os
import random
import struct
import sys


class Scene:
    def __init__(self):
        self.bytes = b''
        self.root = {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': []}], 'nodes': [], 'meshes': [],
                     'materials': [], 'accessors': [], 'bufferViews': [], 'animations': []}

    def add(self, name, what):
        self.root.setdefault(name, []).append(what)
        return len(self.root[name]) - 1

    def accessor(self, rows, kind):
        data = b''.join(struct.pack('<%df' % len(row), *row) for row in rows)
        view = self.add('bufferViews', {'buffer': 0, 'byteOffset': len(self.bytes), 'byteLength': len(data)})
        self.bytes += data
        return self.add('accessors', {'bufferView': view, 'componentType': 5126, 'count': len(rows), 'type': kind})

    def box(self, half, middle=(0, 0, 0)):
        points = []
        for axis in range(3):
            for side in (-1, 1):
                u, v = ((axis + 1) % 3, (axis + 2) % 3)[::side]

                def corner(a, b):
                    p = list(middle)
                    p[axis] += side * half[axis]
                    p[u] += a * half[u]
                    p[v] += b * half[v]
                    return p
                a, b, c, d = corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)
                points += [a, b, c, a, c, d]
        colour = [random.random() for _ in range(3)] + [1]
        material = self.add('materials', {'pbrMetallicRoughness': {'baseColorFactor': colour}})
        return self.add('meshes', {'primitives': [{'attributes': {'POSITION': self.accessor(points, 'VEC3')},
                                                   'material': material}]})

    def node(self, below=None, **fields):
        number = self.add('nodes', fields)
        above = self.root['scenes'][0]['nodes'] if below is None else self.root['nodes'][below].setdefault('children', [])
        above.append(number)
        return number

    def animate(self, node, path, times_s, values, animation=0, join='LINEAR'):
        while len(self.root['animations']) <= animation:
            self.add('animations', {'channels': [], 'samplers': []})
        of = self.root['animations'][animation]
        kind = {'rotation': 'VEC4', 'weights': 'SCALAR'}.get(path, 'VEC3')
        of['samplers'].append({'input': self.accessor([[t] for t in times_s], 'SCALAR'),
                               'output': self.accessor(values, kind), 'interpolation': join})
        of['channels'].append({'sampler': len(of['samplers']) - 1, 'target': {'node': node, 'path': path}})

    def spin(self, node, animation=0):
        axis = [random.gauss(0, 1) for _ in range(3)]
        length = math.hypot(*axis)
        turns = [[math.sin(a / 2) * x / length for x in axis] + [math.cos(a / 2)] for a in (0, 1.5, 3, 4.5, 6)]
        self.animate(node, 'rotation', [0, 0.5, 1, 1.5, 2], turns, animation)

    def write(self, path):
        text = base64.b64encode(self.bytes).decode()
        root = {k: v for k, v in self.root.items() if v}
        root['buffers'] = [{'byteLength': len(self.bytes), 'uri': 'data:application/octet-stream;base64,' + text}]
        with open(path, 'w') as file:
            json.dump(root, file)


def room():
    scene = Scene()
    scene.node(name='floor', mesh=scene.box((4, 0.1, 4), (0, -2.2, 0)))
    return scene


def moving_box(scene, name, below=None, **fields):
    return scene.node(below, name=name, mesh=scene.box((0.2, 0.5, 0.3)), **fields)


def crowd(count, half, spread):
    scene = room()
    for i in range(count):
        at = [random.uniform(-spread, spread) for _ in range(3)]
        scene.spin(scene.node(name='thing %d' % i, mesh=scene.box(half), translation=at))
    return scene


def skin():
    scene, joints, below = room(), [], None
    scene.spin(moving_box(scene, 'box'))
    for i in range(3):
        below = scene.node(below, name='joint %d' % i)
        joints.append(below)
        scene.spin(below)
    scene.add('skins', {'joints': joints})
    for name in ('lamp', 'camera'):
        scene.spin(scene.node(name=name))
    scene.animate(0, 'weights', [0, 1], [[0], [1]])
    return scene


def one(path, times_s, values, above=None, join='LINEAR', **fields):
    scene = room()
    below = scene.node(name='above', **above) if above else None
    scene.animate(moving_box(scene, 'box', below, **fields), path, times_s, values, join=join)
    return scene


def twice():
    scene = room()
    for i in range(2):
        node = moving_box(scene, 'box %d' % i, translation=[2 * i - 1, 0, 0])
        scene.spin(node, 0)
        scene.spin(node, 1)
    return scene


def main(folder):
    random.seed(4)
    quarter = [[0, 0, 0, 1], [0, 0, math.sqrt(0.5), math.sqrt(0.5)]]
    scenes = {'grows': one('scale', [0, 1], [[1, 1, 1], [2, 1, 1]]),
              'kept': one('scale', [0, 1], [[2, 1, 1], [2, 1, 1]]),
              'jumps': one('translation', [0, 0.5, 1], [[0, 0, 0], [1, 0, 0], [0, 1, 0]], join='STEP'),
              'backwards': one('translation', [0, 1, 0.5], [[0, 0, 0], [1, 0, 0], [0, 1, 0]]),
              'shears': one('rotation', [0, 1], quarter, {'scale': [2, 1, 1]}),
              'slides': one('translation', [0, 1], [[0, 0, 0], [1, 1, 0]], {'scale': [2, 1, 1]}),
              'mirrored': one('rotation', [0, 1], quarter, {'scale': [-1, 1, 1]}, scale=[1, 1, -0.5]),
              'away': one('translation', [0, 1], [[0, 0, 0], [30, 3, 1]]),
              'too_far': one('translation', [0, 1], [[0, 0, 0], [200, 3, 1]]),
              'twice': twice(), 'skin': skin(),
              'crowd_bars': crowd(6, (0.1, 0.1, 1), 0), 'crowd_boxes': crowd(12, (0.4, 0.4, 0.4), 1),
              'few_meet': crowd(3, (0.5, 0.5, 0.5), 0.3), 'many_apart': crowd(24, (0.1, 0.1, 0.1), 1.5)}
    for name, scene in scenes.items():
        scene.write(os.path.join(folder, name + '.gltf'))


main(sys.argv[1])
