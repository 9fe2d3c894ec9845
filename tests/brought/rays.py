# SPDX-License-Identifier: MIT
#
# What a camera sees of triangles, by rays in double precision: the truth of this suite. Nothing here knows of any file
# format, nor of any code of the renderer, the compiler or the reference.
import numpy as np

NOTHING = np.array([0, 0, 0])
NEAR_M = 0.1
EDGE_PX = 0.05     # so near to an edge, both sides are right
TEXTURE_PX = 2.0   # so near to where a texture's colour changes, a smaller level of it may show a mixture


class Texture:
    """An array of rows of (r, g, b), from the top; how it goes on beyond 0..1, across and down."""

    def __init__(self, rows, wraps=('repeat', 'repeat')):
        self.rows, self.wraps = np.asarray(rows, dtype=np.int64), wraps

    def at(self, uv):
        """Of glTF's coordinates: v runs down from the top."""
        h_px, w_px = self.rows.shape[:2]
        x = self._wrapped(uv[:, 0], w_px, self.wraps[0])
        y = self._wrapped(uv[:, 1], h_px, self.wraps[1])
        return self.rows[y, x]

    @staticmethod
    def _wrapped(u, side_px, wrap):
        texel = np.floor(u * side_px).astype(np.int64)
        if wrap == 'clamp':
            return np.clip(texel, 0, side_px - 1)
        if wrap == 'mirror':
            texel = np.mod(texel, 2 * side_px)
            return np.where(texel < side_px, texel, 2 * side_px - 1 - texel)
        return np.mod(texel, side_px)


class Triangle:
    """Counter-clockwise seen from its front. Its colour is sRGB, 0..255; a texture's colours are times it."""

    def __init__(self, points, colour=(200, 200, 200), two_sided=False, texture=None, uvs=None, emitted=(0, 0, 0)):
        self.points = np.asarray(points, dtype=np.float64)
        self.colour, self.two_sided, self.emitted = np.asarray(colour, dtype=np.float64), two_sided, np.asarray(emitted)
        self.texture, self.uvs = texture, None if uvs is None else np.asarray(uvs, dtype=np.float64)

    def moved(self, matrix):
        """By a 4x4 matrix; one that mirrors turns the corners' order, as file formats say."""
        points = self.points @ matrix[:3, :3].T + matrix[:3, 3]
        uvs = self.uvs
        if np.linalg.det(matrix[:3, :3]) < 0:
            points, uvs = points[::-1], None if uvs is None else uvs[::-1]
        return Triangle(points, self.colour, self.two_sided, self.texture, uvs, self.emitted)

    def colours(self, weights):
        if self.texture is None:
            shown = np.tile(self.colour, (len(weights), 1))
        else:
            shown = self.texture.at(weights @ self.uvs) * self.colour / 255
        return np.clip(np.rint(shown + self.emitted), 0, 255).astype(np.int64)


class Camera:
    """As a line of a camera file; the field of view is vertical."""

    def __init__(self, eye, target, fov_deg=60.0):
        self.eye, self.target, self.fov_deg = np.asarray(eye, float), np.asarray(target, float), fov_deg

    def rays(self, w_px, h_px, dx_px=0.0, dy_px=0.0):
        """Through the pixels' middles, or beside them; not of length 1: of depth 1."""
        forward = self.target - self.eye
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, (0.0, 1.0, 0.0))
        right /= np.linalg.norm(right)
        up = np.cross(right, forward)
        half = np.tan(np.radians(self.fov_deg) / 2)
        x = ((np.arange(w_px) + 0.5 + dx_px) * 2 / w_px - 1) * half * w_px / h_px
        y = (1 - (np.arange(h_px) + 0.5 + dy_px) * 2 / h_px) * half
        return (forward + x[None, :, None] * right + y[:, None, None] * up).reshape(-1, 3)

    def line(self):
        return ' '.join('%.17g' % v for v in (*self.eye, *self.target))


def _hits(eye, rays, points):
    """Of each ray with each triangle: the depth (infinite: none) and two barycentric weights; arrays [ray, triangle]."""
    a, ab, ac = points[:, 0], points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    across = np.cross(rays[:, None, :], ac[None, :, :])
    volume = np.einsum('rtk,tk->rt', across, ab)
    beside = eye - a
    with np.errstate(divide='ignore', invalid='ignore'):
        u = np.einsum('rtk,tk->rt', across, beside) / volume
        along = np.cross(beside, ab)
        v = np.einsum('rk,tk->rt', rays, along) / volume
        depth = np.einsum('tk,tk->t', ac, along)[None, :] / volume
    is_hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (depth > NEAR_M) & (volume != 0)
    return np.where(is_hit, depth, np.inf), u, v, volume > 0


def _seen(camera, triangles, rays):
    """The number of the triangle that each ray meets first (-1: none), and its colour. Of equal depths, the later."""
    colours = np.tile(NOTHING, (len(rays), 1))
    nearest, number = np.full(len(rays), np.inf), np.full(len(rays), -1)
    weights = np.zeros((len(rays), 2))
    two_sided = np.array([t.two_sided for t in triangles])
    points = np.array([t.points for t in triangles])
    for first in range(0, len(triangles), 64):
        part = slice(first, first + 64)
        depth, u, v, is_front = _hits(camera.eye, rays, points[part])
        depth = np.where(is_front | two_sided[part], depth, np.inf)
        best = depth.shape[1] - 1 - np.argmin(depth[:, ::-1], axis=1)
        every = np.arange(len(rays))
        is_nearer = (depth[every, best] <= nearest) & np.isfinite(depth[every, best])
        nearest = np.where(is_nearer, depth[every, best], nearest)
        number = np.where(is_nearer, first + best, number)
        weights = np.where(is_nearer[:, None], np.stack([u[every, best], v[every, best]], 1), weights)
    for i in np.unique(number[number >= 0]):
        here = number == i
        u, v = weights[here].T
        colours[here] = triangles[i].colours(np.stack([1 - u - v, u, v], 1))
    return number, colours


def picture(camera, triangles, w_px, h_px):
    """Colours a pixel, and whether they are sure: the same a little beside."""
    number, colours = _seen(camera, triangles, camera.rays(w_px, h_px))
    is_textured = np.array([t.texture is not None for t in triangles] + [False])[number]
    is_sure = np.ones(len(number), dtype=bool)
    steps = ((EDGE_PX, True), (TEXTURE_PX, False), (TEXTURE_PX / 2, False))
    for step_px, asks_all in steps if is_textured.any() else steps[:1]:
        for dx, dy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            _, beside = _seen(camera, triangles, camera.rays(w_px, h_px, dx * step_px, dy * step_px))
            is_sure &= (beside == colours).all(axis=1) | (not asks_all and ~is_textured)
    return colours.reshape(h_px, w_px, 3), is_sure.reshape(h_px, w_px)
