# SPDX-License-Identifier: MIT
#
# OBJ and MTL: what modellers write, and what people mend by hand.
import re

import numpy as np

import rays
import things
from judge import Input


class Text:
    def __init__(self):
        self.obj, self.mtl, self.triangles, self.count = [], [], [], 0
        self.files = {}

    def add(self, part, name, corner='%d', flipped=False):
        """v runs up in OBJ, down in the rays' textures."""
        self.obj.append('usemtl ' + name)
        self.obj += ['v %.9g %.9g %.9g' % tuple(p) for p in part.points]
        if part.uvs is not None:
            self.obj += ['vt %.9g %.9g' % (u, 1 - v) for u, v in part.uvs]
        for corners in part.triangles:
            self.obj.append('f ' + ' '.join(corner.replace('%d', str(self.count + i + 1)) for i in corners))
        self.count += len(part.points)
        self.triangles += part.seen()

    def bytes(self, name='it', library='it.mtl', end='\n'):
        head = ['mtllib ' + library] if library else []
        out = {name + '.obj': end.join(head + self.obj + ['']).encode()}
        out['it.mtl'] = end.join(self.mtl + ['']).encode()
        out.update(self.files)
        return out


def _kd(colour):
    return 'Kd %.6g %.6g %.6g' % tuple(np.asarray(colour) / 255)


def _box(text, statement=_kd, before=(), behind=()):
    for number, part in enumerate(things.box((-1, -0.5, -0.5), (2, 1, 1.5))):
        text.mtl += ['newmtl m%d' % number, *before, statement(part.colour), *behind]
        text.add(part, 'm%d' % number)


def _statements():
    """Words that change nothing of what is drawn."""
    for words in ('aniso 0.5', 'anisor 0.1', 'Pr 0.5', 'Pm 0', 'Ps 0', 'Pc 0', 'Pcr 0.03', 'Ks 0 0 0', 'Ns 90', 'Ni 1.45', 'illum 2',
                  'Tf 1 1 1', 'sharpness 60', 'Ka 1 1 1', 'd 1', 'Tr 0'):
        text = Text()
        _box(text, before=[words])
        yield Input('known words: ' + words, text.bytes(), text.triangles)
    for words in ('frobnicate 3', 'xyzzy', 'Kx 1 2 3'):
        text = Text()
        _box(text, behind=[words])
        yield Input('unknown words: ' + words, text.bytes(), text.triangles, says=words.split()[0])
    for words in (['Tr 1'], ['d 1', 'Tr 1'], ['Tr 1', 'd 1']):
        text = Text()
        _box(text, behind=words)
        yield Input("MeshLab's " + ' '.join(words), text.bytes(), text.triangles, says='Tr')
    text = Text()
    _box(text)
    text.mtl = ['Kd 1 1 1', 'd 0.5'] + text.mtl
    yield Input('statements before newmtl', text.bytes(), text.triangles, says='newmtl')


def _layouts():
    for name, change in (('a BOM', lambda b: b'\xEF\xBB\xBF' + b), ('CRLF', lambda b: b.replace(b'\n', b'\r\n')),
                         ('no last newline', lambda b: b.rstrip(b'\n')), ('tabs', lambda b: b.replace(b' ', b'\t')),
                         ('blanks at ends', lambda b: b.replace(b'\n', b'  \n')),
                         ('comments at ends of numbers', lambda b: re.sub(rb'\n([vf] [^\n]*)', rb'\n\1 # v 1 2 3', b)),
                         ('names with #', lambda b: b.replace(b'usemtl m', b'usemtl m #')),
                         ('continued lines', lambda b: b.replace(b'f 1 2', b'f 1 \\\n2'))):
        text = Text()
        _box(text)
        files = text.bytes()
        files['it.obj'] = change(files['it.obj'])
        if '#' in name:
            files['it.mtl'] = files['it.mtl'].replace(b'newmtl m', b'newmtl m #')
        yield Input(name, files, text.triangles)
    for corner in ('%d/', '%d//', '%d/%d', '%d//%d', '%d/%d/%d'):
        text = Text()
        text.obj += ['vt 0 0'] * 24 + ['vn 0 0 1'] * 24
        for number, part in enumerate(things.box((-1, -0.5, -0.5), (2, 1, 1.5))):
            text.mtl += ['newmtl m%d' % number, _kd(part.colour)]
            text.add(part, 'm%d' % number, corner)
        files = text.bytes()
        files['it.obj'] = files['it.obj'].rstrip(b'\n')
        yield Input('corners as ' + corner, files, text.triangles)
    text = Text()
    _box(text)
    text.obj = [line + ' 2' if line[:2] == 'v ' else line for line in text.obj]
    yield Input('a weight of 2', text.bytes(), text.triangles, says='weight|fourth|w ')


def _textured(map_line, uvs, wraps=('repeat', 'repeat'), name='it.png', library='it.mtl', scale=(1, 1), offset=(0, 0)):
    text = Text()
    rows = things.quarters()
    part = things.panel((-1, -1, 0), 2, rows, uvs)
    text.mtl += ['newmtl t', 'Kd 1 1 1', map_line]
    text.add(part, 't', '%d/%d')
    uvs_up = np.stack([part.uvs[:, 0], 1 - part.uvs[:, 1]], 1) * scale + offset
    part.uvs = np.stack([uvs_up[:, 0], 1 - uvs_up[:, 1]], 1)
    part.texture = rays.Texture(rows, wraps)
    part.two_sided = False
    text.files[name] = things.png(rows)
    return text.bytes(library=library), part.seen()


def _maps():
    square = ((0, 1), (1, 1), (1, 0), (0, 0))
    twice = ((-0.5, 1.5), (1.5, 1.5), (1.5, -0.5), (-0.5, -0.5))
    for options in ('', '-blendu on', '-blendv off', '-bm 1', '-boost 2', '-cc off', '-imfchan m', '-texres 64',
                    '-colorspace sRGB', '-mm 0 1', '-clamp off', '-whatever 3'):
        says = 'whatever' if 'whatever' in options else None
        files, triangles = _textured('map_Kd %s it.png' % options, square)
        yield Input('map_Kd ' + options, files, triangles, says=says, front=True)
    for options, scale, offset in (('-s 2 2 1', (2, 2), (0, 0)), ('-s 2', (2, 1), (0, 0)), ('-o 0.25 0.5 0', (1, 1), (0.25, 0.5)),
                                   ('-s 2 3 1 -o 0.5 0.25 0', (2, 3), (0.5, 0.25))):
        files, triangles = _textured('map_Kd %s it.png' % options, square, scale=scale, offset=offset)
        yield Input('map_Kd ' + options, files, triangles, front=True)
    files, triangles = _textured('map_Kd -clamp on it.png', twice, ('clamp', 'clamp'))
    yield Input('map_Kd -clamp on', files, triangles, front=True)
    for said, name in (('"it.png"', 'it.png'), ('it.png  ', 'it.png'), ('a b.png', 'a b.png'), ('"a b.png"', 'a b.png'),
                       ('a%20b.png', 'a b.png'), ('.\\it.png', 'it.png'), ('./it.png', 'it.png'), ('d/it.png', 'd/it.png'),
                       ('d\\it.png', 'd/it.png')):
        files, triangles = _textured('map_Kd ' + said, square, name=name)
        yield Input('a picture called ' + said, files, triangles, front=True)
    for said in ('/home/somebody/tex/it.png', 'C:\\tex\\it.png', 'IT.PNG', '../nowhere/it.png'):
        files, triangles = _textured('map_Kd ' + said, square)
        yield Input('a picture elsewhere: ' + said, files, triangles, says='it.png', front=True)
    for library in ('"it.mtl"', 'it.mtl  ', './it.mtl', 'other.mtl it.mtl', 'it.mtl other.mtl'):
        files, triangles = _textured('map_Kd it.png', square, library=library)
        files['other.mtl'] = b'newmtl other\nKd 1 0 0\n'
        yield Input('mtllib ' + library, files, triangles, front=True)
    for library in ('IT.mtl', '/nowhere/it.mtl', 'C:\\x\\it.mtl'):
        files, triangles = _textured('map_Kd it.png', square, library=library)
        yield Input('mtllib ' + library, files, triangles, says='it.mtl', front=True)


def inputs(random):
    yield from _statements()
    yield from _layouts()
    yield from _maps()
