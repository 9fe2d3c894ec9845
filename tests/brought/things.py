# SPDX-License-Identifier: MIT
#
# What the inputs show: a few parts, each a list of triangles of one look, which the generators of kinds write into files
# in all ways that a format has. Coordinates are small multiples of 1/8, so that any type of number holds them.
import io

import numpy as np
from PIL import Image

import rays

# Channels far apart, so that one face is never taken for another.
COLOURS = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0), (255, 0, 255), (0, 255, 255), (255, 128, 0), (128, 0, 255),
           (0, 128, 0), (128, 128, 128), (255, 255, 255), (128, 64, 0)]
BOX = [((0, 1, 3, 2), 0), ((4, 6, 7, 5), 1), ((0, 4, 5, 1), 2), ((2, 3, 7, 6), 3), ((0, 2, 6, 4), 4), ((1, 5, 7, 3), 5)]


class Part:
    """points: Nx3; triangles: Mx3 indices into them; one look."""

    def __init__(self, points, triangles, colour, texture=None, uvs=None, two_sided=False):
        self.points = np.asarray(points, dtype=np.float64)
        self.triangles = np.asarray(triangles, dtype=np.int64)
        self.colour, self.texture, self.two_sided = colour, texture, two_sided
        self.uvs = None if uvs is None else np.asarray(uvs, dtype=np.float64)

    def seen(self, matrix=None):
        """As the rays' triangles, moved by a matrix."""
        out = []
        for corners in self.triangles:
            uvs = None if self.uvs is None else self.uvs[corners]
            triangle = rays.Triangle(self.points[corners], self.colour, self.two_sided, self.texture, uvs)
            out.append(triangle if matrix is None else triangle.moved(matrix))
        return out


def box(at, size, first_colour=0):
    """Six parts: each side has a colour of its own."""
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * np.asarray(size) + np.asarray(at)
    parts = []
    for (a, b, c, d), number in BOX:
        points = corners[[a, b, c, d]]
        parts.append(Part(points, [(0, 1, 2), (0, 2, 3)], COLOURS[(first_colour + number) % len(COLOURS)]))
    return parts


def quarters(side_px=64):
    """A picture whose four quarters tell which way it lies."""
    rows = np.zeros((side_px, side_px, 3), dtype=np.int64)
    half = side_px // 2
    rows[:half, :half], rows[:half, half:] = (255, 0, 0), (0, 255, 0)
    rows[half:, :half], rows[half:, half:] = (0, 0, 255), (255, 255, 0)
    return rows


def png(rows):
    out = io.BytesIO()
    Image.fromarray(np.asarray(rows, dtype=np.uint8)).save(out, 'PNG')
    return out.getvalue()


def panel(at, side, rows, uvs=((0, 1), (1, 1), (1, 0), (0, 0)), wraps=('repeat', 'repeat'), colour=(255, 255, 255)):
    """A square that faces +z and is seen from both sides; UVs as glTF counts them, from the lower left corner on."""
    x, y, z = at
    points = [(x, y, z), (x + side, y, z), (x + side, y + side, z), (x, y + side, z)]
    return Part(points, [(0, 1, 2), (0, 2, 3)], colour, rays.Texture(rows, wraps), uvs, two_sided=True)


def turn(axis, angle):
    """A quaternion x, y, z, w."""
    axis = np.asarray(axis, dtype=np.float64) / np.linalg.norm(axis)
    return np.append(axis * np.sin(angle / 2), np.cos(angle / 2))


def matrix_of(at=(0, 0, 0), q=(0, 0, 0, 1), scale=(1, 1, 1)):
    x, y, z, w = np.asarray(q, dtype=np.float64) / np.linalg.norm(q)
    out = np.eye(4)
    out[:3, :3] = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]) * np.asarray(scale)
    out[:3, 3] = at
    return out


def linear_of(colour):
    """0..1 of light, of bytes of sRGB."""
    c = np.asarray(colour, dtype=np.float64) / 255
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
