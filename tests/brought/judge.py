# SPDX-License-Identifier: MIT
#
# One input of the suite: files, how `limner render` is called with them, and what is to come of it: pictures that rays
# have, or words on standard error.
import os
import re
import subprocess

import numpy as np
from PIL import Image

import rays

SIZE_PX = (96, 72)
OFF_MOST = 9  # of 255: RGB565 has steps of 8
LEAST_SURE = 0.25  # of a picture's pixels: else it proves nothing


class Input:
    """files: bytes by name; the model is the first. triangles: a list, or a function of the time in seconds that makes
    one; None: it must be refused. says: a pattern that standard error must have; None: nothing is to be said."""

    def __init__(self, name, files, triangles, options=(), says=None, frames=0, fps=10, front=False):
        self.name, self.files, self.triangles, self.says = name, files, triangles, says
        self.options, self.frames, self.fps = list(options), frames, fps
        self.front = front  # seen from +z: what has one side


def cameras_of(triangles, count, random, front):
    points = np.concatenate([t.points for t in triangles])
    low, high = points.min(0), points.max(0)
    middle, reach = (low + high) / 2, np.linalg.norm(high - low) / 2 + 1e-9
    out = []
    for _ in range(count):
        way = random.normal(size=3)
        way[1] = np.clip(way[1], -0.8, 0.8)
        way[2] = abs(way[2]) + 0.5 if front else way[2]
        out.append(rays.Camera(middle + way / np.linalg.norm(way) * reach * random.uniform(1.9, 2.6), middle))
    return out


def _wrong(path, camera, triangles):
    """None, or what is wrong."""
    if not os.path.exists(path):
        return 'there is no picture'
    got = np.asarray(Image.open(path).convert('RGB'), dtype=np.int64)
    want, is_sure = rays.picture(camera, triangles, *SIZE_PX)
    if is_sure.mean() < LEAST_SURE:
        return 'only %.0f %% of the pixels are sure' % (100 * is_sure.mean())
    is_off = (np.abs(got - want) > OFF_MOST).any(axis=2) & is_sure
    if not is_off.any():
        return None
    y, x = np.argwhere(is_off)[0]
    return '%d of %d pixels are wrong; at %d, %d: %s, not %s' % (is_off.sum(), is_sure.sum(), x, y, tuple(got[y, x]),
                                                               tuple(want[y, x]))


def judge(each, folder, random):
    """None, or a line on what is wrong."""
    os.makedirs(folder)
    for name, data in each.files.items():
        os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
        with open(os.path.join(folder, name), 'wb') as out:
            out.write(data)
    at = each.triangles if callable(each.triangles) else lambda time_s: each.triangles
    refused = each.triangles is None
    cameras = [] if refused else cameras_of(at(0.0), each.frames or 2, random, each.front)
    with open(os.path.join(folder, 'it.cam'), 'w') as out:
        out.writelines(camera.line() + '\n' for camera in cameras or [rays.Camera((0, 0, 9), (0, 0, 0))])
    model = next(iter(each.files))
    command = [os.path.abspath(os.environ['BUILD']) + '/limner', 'render', model, '--camera', 'it.cam', '--unlit', '--precision', 'exact', '--size',
               '%dx%d' % SIZE_PX, '--near', str(rays.NEAR_M), '-o', '%03d.png', *each.options]
    command += ['--fps', str(each.fps)] if each.frames else []
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=300)
    said = done.stderr.decode('utf-8', 'replace').strip()
    if (done.returncode != 0) != refused:
        return 'exit status %d: %s' % (done.returncode, said or 'nothing is said')
    if each.says is None and said:
        return 'it says: ' + said
    if each.says is not None and not re.search(each.says, said):
        return "it says '%s', not '%s'" % (said, each.says)
    for i, camera in enumerate(cameras):
        wrong = _wrong(os.path.join(folder, '%03d.png' % i), camera, at(i / each.fps))
        if wrong:
            return 'frame %d: %s' % (i, wrong)
    return None
