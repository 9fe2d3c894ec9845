# SPDX-License-Identifier: MIT
#
# Models of others, of Debian's assimp-testmodels: what reading.py makes of a file, and what the host program draws.
import os

import reading
from judge import Input

FOLDER = '/usr/share/assimp/models'
# No others: they are broken on purpose, have pictures or what else reading.py does not know, or too many triangles.
MODELS = ['PLY/cube.ply', 'PLY/cube_binary.ply', 'PLY/float-color.ply', 'STL/Spider_binary.stl', 'STL/sphereWithHole.stl',
          'STL/triangle.stl', 'STL/triangle_with_two_solids.stl',
          'glTF2/BoxBadNormals-glTF-Binary/BoxBadNormals.glb', 'glTF2/cameras/Cameras.gltf',
          *('glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_%02d.gltf' % i for i in (4, 5, 6, 11, 12, 13, 14, 15))]


def _folder_of(path):
    """The files beside it that it may name."""
    out = {os.path.basename(path): b''}
    for root, _, names in os.walk(os.path.dirname(path)):
        for name in names:
            with open(os.path.join(root, name), 'rb') as file:
                out[os.path.relpath(os.path.join(root, name), os.path.dirname(path))] = file.read()
    return out


def _few(path):
    """A folder with many models: the one alone."""
    with open(path, 'rb') as file:
        return {os.path.basename(path): file.read()}


def inputs(random):
    for model in MODELS:
        path = os.path.join(FOLDER, model)
        files = _folder_of(path) if 'glTF' in model else _few(path)
        try:
            triangles = reading.triangles_of(path)
        except reading.Unknown as what:
            raise AssertionError('%s: %s' % (model, what))
        yield Input(model, files, triangles, ('--up', 'y'), says='')
