# SPDX-License-Identifier: MIT
#
# Draws inputs of a kind, made up from a seed, and holds each frame against rays: python3 main.py KIND FOLDER [NAME].
# Prints TAP, a line an input. What fails stays in the folder, with its camera: limner render can be called there again.
import concurrent.futures
import importlib
import os
import shutil
import sys

import numpy as np

import judge

SEED = 20


def _judged(each, number, folder):
    random = np.random.default_rng([SEED, number])
    try:
        return judge.judge(each, folder, random)
    except Exception as error:  # an input that cannot be judged has failed, and says why
        return '%s: %s' % (type(error).__name__, error)


def main(kind, folder, only=''):
    inputs = [i for i in importlib.import_module('kind_' + kind).inputs(np.random.default_rng(SEED)) if only in i.name]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        places = [os.path.join(folder, '%s%03d' % (kind, i)) for i in range(len(inputs))]
        answers = list(pool.map(_judged, inputs, range(len(inputs)), places))
    for number, (each, place, wrong) in enumerate(zip(inputs, places, answers), 1):
        print('%sok %d - %s: %s' % ('not ' if wrong else '', number, kind, each.name))
        if wrong:
            print('# ' + wrong.replace('\n', '\n# '))
        else:
            shutil.rmtree(place)
    print('1..%d' % len(inputs))
    return any(answers)


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
