# SPDX-License-Identifier: MIT
#
# field_scenes.awk -v kind=KIND -v seed=N -v count=N -v cameras=FILE: an OBJ scene of which paths look along faces, and
# `count` such cameras as `--camera` takes them; by nothing of the simulator. KIND: floor, bars, sheets, fins, corridor.
# Eyes stand where whoever made the scene would stand: a man's height above a floor, beside a fin, between two walls.

function between(low, high) { return low + (high - low) * rand() }
function between_log(low, high) { return low * exp(log(high / low) * rand()) }

function vertex(x, y, z) {
    printf "v %.9g %.9g %.9g\n", x, y, z
    return ++vertices
}

# A parallelogram from a corner along two ways, seen from where these run counterclockwise.
function quad(x, y, z, ax, ay, az, bx, by, bz) {
    vertex(x, y, z)
    vertex(x + ax, y + ay, z + az)
    vertex(x + ax + bx, y + ay + by, z + az + bz)
    vertex(x + bx, y + by, z + bz)
    printf "usemtl m%d\nf -4 -3 -2 -1\n", ++faces % 7
}

# A box of these sides, turned about y, from its lowest middle point; `inwards`: seen from within.
function box(x, y, z, w, h, d, turn, inwards,    c, s, ax, az, bx, bz) {
    c = cos(turn)
    s = sin(turn)
    ax = w * c; az = -w * s
    bx = d * s; bz = d * c
    x -= (ax + bx) / 2
    z -= (az + bz) / 2
    side(inwards, x, y, z, bx, 0, bz, ax, 0, az, h)      # top, below
    wall(inwards, x, y, z, ax, az, h, -1)
    wall(inwards, x + bx, y, z + bz, ax, az, h, 1)
    wall(inwards, x, y, z, bx, bz, h, 1)
    wall(inwards, x + ax, y, z + az, bx, bz, h, -1)
}

function side(inwards, x, y, z, ax, ay, az, bx, by, bz, h) {
    if (inwards) {
        quad(x, y, z, ax, ay, az, bx, by, bz)
        quad(x, y + h, z, bx, by, bz, ax, ay, az)
    } else {
        quad(x, y, z, bx, by, bz, ax, ay, az)
        quad(x, y + h, z, ax, ay, az, bx, by, bz)
    }
}

function wall(inwards, x, y, z, ax, az, h, outward) {
    if ((outward > 0) != (inwards > 0))
        quad(x, y, z, ax, 0, az, 0, h, 0)
    else
        quad(x, y, z, 0, h, 0, ax, 0, az)
}

# From an eye along a way in the plane of x and z, with turns of some degrees.
function camera(x, y, z, yaw, pitch, reach) {
    yaw += between(-8, 8) * DEGREE
    pitch += between(-4, 4) * DEGREE
    printf "%.9g %.9g %.9g %.9g %.9g %.9g\n", x, y, z, x + reach * sin(yaw) * cos(pitch), y + reach * sin(pitch),
           z + reach * cos(yaw) * cos(pitch) >cameras
}

function floor_scene(    size, i, n, s) {
    size = between_log(10, 10000)
    quad(-size / 2, 0, -size / 2, 0, 0, size, size, 0, 0)
    n = int(between(4, 30))
    for (i = 0; i < n; i++) {
        s = size * between_log(0.01, 0.06)
        box(between(-0.45, 0.45) * size, 0, between(-0.45, 0.45) * size, s, s * between(0.3, 2), s * between(0.3, 2),
            between(0, TURN))
    }
    for (i = 0; i < count; i++)
        camera(between(-0.5, 0.5) * size, rand() < 0.5 ? between(1, 2) : size * between_log(0.005, 0.1),
               between(-0.5, 0.5) * size, between(0, TURN), -3 * DEGREE, size / 4)
}

function bars_scene(    i, n, length_m, thick, gap, span) {
    n = int(between(4, 13))
    length_m = between(1, 20)
    thick = length_m * between_log(0.003, 0.03)
    gap = thick * between(2, 8)
    span = n * gap
    for (i = 0; i < n; i++)
        box((i - (n - 1) / 2) * gap, 0, 0, thick, thick * between(0.5, 2), length_m, between(-0.5, 0.5) * DEGREE)
    for (i = 0; i < count; i++)
        if (rand() < 0.5) # along them, from an end
            camera(between(-0.5, 0.5) * span, thick * between(-3, 6), -length_m * between(0.5, 0.9), 0, 0, length_m)
        else
            camera(-span / 2 - length_m * between(0.1, 0.5), thick * between(-3, 6), between(-0.4, 0.4) * length_m,
                   TURN / 4, 0, length_m)
}

function sheets_scene(    i, n, size, gap, y, yaw, away) {
    n = rand() < 0.5 ? 2 : int(between(3, 9))
    size = between_log(0.5, 60)
    gap = between_log(0.001, 0.02)
    for (i = 0; i < n; i++) {
        y = i * gap
        quad(-size / 2, y, -size / 2, 0, 0, size, size, 0, 0)
        quad(-size / 2, y, -size / 2, size, 0, 0, 0, 0, size)
    }
    for (i = 0; i < count; i++) {
        yaw = between(0, TURN)
        away = size * between(0.3, 1.2)
        camera(-away * sin(yaw), (n - 1) * gap + size * between_log(0.005, 0.1), -away * cos(yaw), yaw, -2 * DEGREE,
               away)
    }
}

# Louvres: panes turned about their own middles; or a fan of them about one axis.
function fins_scene(    i, n, size, turn, is_fan, gap, x, c, s, yaw) {
    n = int(between(5, 20))
    size = between_log(0.3, 10)
    is_fan = rand() < 0.5
    gap = size * between(0.1, 0.4)
    for (i = 0; i < n; i++) {
        turn = is_fan ? TURN * i / n : 0.3
        c = cos(turn) * size
        s = sin(turn) * size
        x = is_fan ? 0 : (i - n / 2) * gap
        quad(x, 0, 0, s, 0, c, 0, size, 0)
        quad(x, 0, 0, 0, size, 0, s, 0, c)
    }
    for (i = 0; i < count; i++) {
        turn = is_fan ? TURN * int(rand() * n) / n : 0.3
        x = is_fan ? 0 : (int(rand() * n) - n / 2) * gap
        c = -size * between(0.1, 1.5)
        s = size * between(-0.03, 0.03)
        camera(x + c * sin(turn) + s * cos(turn), size * between(0.2, 0.8), c * cos(turn) - s * sin(turn), turn, 0,
               size)
    }
}

function corridor_scene(    length_m, w, h, i, n, x) {
    length_m = between_log(10, 100000)
    w = length_m > 5000 ? length_m * between_log(0.001, 0.01) : between(2, 5)
    h = w * between(0.7, 1.3)
    box(0, 0, length_m / 2, w, h, length_m, 0, 1)
    n = int(between(2, 8))
    for (i = 0; i < n; i++) {
        x = (i % 2 ? 1 : -1) * w * 0.35
        box(x, 0, length_m * between(0.05, 0.95), w * 0.1, h * between(0.2, 0.8), w * 0.1, 0)
    }
    for (i = 0; i < count; i++)
        camera(w * between(-0.2, 0.2), h * between(0.3, 0.7), length_m * between(0.02, 0.7), rand() < 0.7 ? 0 : TURN / 2, 0,
               length_m / 10)
}

BEGIN {
    DEGREE = atan2(0, -1) / 180
    TURN = 360 * DEGREE
    srand(seed)
    rand()
    if (kind == "floor") floor_scene()
    if (kind == "bars") bars_scene()
    if (kind == "sheets") sheets_scene()
    if (kind == "fins") fins_scene()
    if (kind == "corridor") corridor_scene()
}
