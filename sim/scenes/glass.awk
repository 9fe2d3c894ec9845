# SPDX-License-Identifier: MIT
#
# The scene glass: a lantern of coloured panes with a candle in it, a bottle, and three panes in a row, on a tiled
# floor in the evening. Glass is drawn on both sides, so each of its faces is written twice, once turned round.
#
#     awk -f sim/scenes/glass.awk >sim/scenes/glass.obj
#     awk -v cameras=1 -f sim/scenes/glass.awk >sim/scenes/glass.cam

function vertex(x, y, z) {
    printf "v %.4f %.4f %.4f\n", x, y, z
    return ++vertices
}

function material(name) {
    print "usemtl " name
}

function quad(a, b, c, d) {
    print "f " a " " b " " c " " d
}

function glass_quad(a, b, c, d) {
    quad(a, b, c, d)
    quad(d, c, b, a)
}

# The i-th of n points of a circle about the y axis through x, z.
function on_circle(x, y, z, r, i, n, turn) {
    return vertex(x + r * cos(turn + i * 2 * PI / n), y, z - r * sin(turn + i * 2 * PI / n))
}

# A ring of quads between two circles; r 0 at either end is a cone. Seen from outside.
function ring(x, z, y0, r0, y1, r1, n, turn, glass,    i, low, high, first_low, first_high) {
    for (i = 0; i < n; i++) {
        low[i] = r0 || !i ? on_circle(x, y0, z, r0, i, n, turn) : low[0]
        high[i] = r1 || !i ? on_circle(x, y1, z, r1, i, n, turn) : high[0]
    }
    low[n] = low[0]
    high[n] = high[0]
    for (i = 0; i < n; i++) {
        if (!r0) print "f " low[i] " " high[i + 1] " " high[i]
        else if (!r1) print "f " low[i] " " low[i + 1] " " high[i]
        else if (glass) glass_quad(low[i], low[i + 1], high[i + 1], high[i])
        else quad(low[i], low[i + 1], high[i + 1], high[i])
    }
}

# A lid or a floor of n corners.
function disc(x, y, z, r, n, turn, up,    i, line, at) {
    for (i = 0; i < n; i++) at[i] = on_circle(x, y, z, r, i, n, turn)
    for (i = 0; i < n; i++) line = up ? line " " at[i] : " " at[i] line
    print "f" line
}

# A box on the floor of directions (c, s) and (-s, c) on the plan, its middle at x, z.
function box(x, z, y0, y1, half_w, half_d, turn,    c, s, i, k, at) {
    c = cos(turn)
    s = -sin(turn)
    for (k = 0; k < 2; k++)
        for (i = 0; i < 4; i++) {
            u = (i == 0 || i == 3 ? -1 : 1) * half_w
            w = (i < 2 ? 1 : -1) * half_d
            at[k * 4 + i] = vertex(x + u * c - w * s, k ? y1 : y0, z + u * s + w * c)
        }
    for (i = 0; i < 4; i++) quad(at[i], at[(i + 1) % 4], at[4 + (i + 1) % 4], at[4 + i])
    quad(at[4], at[5], at[6], at[7])
    quad(at[3], at[2], at[1], at[0])
}

function tiles(    i, k, n, x, z, at) {
    n = 8
    for (i = 0; i < n; i++)
        for (k = 0; k < n; k++) {
            x = -2.8 + i * 0.7
            z = -2.8 + k * 0.7
            material((i + k) % 2 ? "tile_dark" : "tile_light")
            at = vertex(x, 0, z)
            vertex(x, 0, z + 0.7)
            vertex(x + 0.7, 0, z + 0.7)
            vertex(x + 0.7, 0, z)
            quad(at, at + 1, at + 2, at + 3)
        }
}

function lantern(    i, n, r, turn, low, high, names) {
    n = 6
    r = 0.8
    turn = 0.2
    split("ruby amber leaf sea cobalt violet", names, " ")
    material("brass")
    disc(0, 0.18, 0, r + 0.08, n, turn, 1)
    ring(0, 0, 0, r + 0.16, 0.18, r + 0.08, n, turn)
    ring(0, 0, 1.62, r + 0.16, 2.3, 0.12, n, turn)
    disc(0, 1.62, 0, r + 0.16, n, turn, 0)
    ring(0, 0, 2.3, 0.12, 2.46, 0.12, n, turn)
    disc(0, 2.46, 0, 0.12, n, turn, 1)
    for (i = 0; i < n; i++)
        box(r * cos(turn + i * PI / 3), -r * sin(turn + i * PI / 3), 0.18, 1.62, 0.035, 0.035, turn + i * PI / 3)
    for (i = 0; i < n; i++) {
        material(names[i + 1])
        low = on_circle(0, 0.18, 0, r - 0.03, i, n, turn)
        on_circle(0, 0.18, 0, r - 0.03, i + 1, n, turn)
        on_circle(0, 1.62, 0, r - 0.03, i + 1, n, turn)
        on_circle(0, 1.62, 0, r - 0.03, i, n, turn)
        glass_quad(low, low + 1, low + 2, low + 3)
    }
    material("wax")
    ring(0, 0, 0.18, 0.2, 0.8, 0.2, 8, 0)
    disc(0, 0.8, 0, 0.2, 8, 0, 1)
    material("flame")
    ring(0, 0, 0.83, 0, 0.98, 0.09, 6, 0)
    ring(0, 0, 0.98, 0.09, 1.3, 0, 6, 0)
}

function bottle(x, z,    n) {
    n = 10
    material("wine")
    ring(x, z, 0.03, 0.27, 0.6, 0.27, n, 0.1)
    disc(x, 0.6, z, 0.27, n, 0.1, 1)
    material("bottle")
    ring(x, z, 0, 0.32, 0.85, 0.32, n, 0.1, 1)
    ring(x, z, 0.85, 0.32, 1.1, 0.11, n, 0.1, 1)
    ring(x, z, 1.1, 0.11, 1.45, 0.11, n, 0.1, 1)
    material("cork")
    ring(x, z, 1.38, 0.09, 1.53, 0.1, n, 0.1)
    disc(x, 1.53, z, 0.1, n, 0.1, 1)
}

# Panes that stand one behind the other: what they mix to shows where they overlap.
function panes(    i, at, names) {
    split("red green blue", names, " ")
    for (i = 0; i < 3; i++) {
        material(names[i + 1])
        at = vertex(-2.1 + 0.25 * i, 0.02 + 0.16 * i, 1.5 - 0.45 * i)
        vertex(-1.1 + 0.25 * i, 0.02 + 0.16 * i, 1.7 - 0.45 * i)
        vertex(-1.1 + 0.25 * i, 1.02 + 0.16 * i, 1.7 - 0.45 * i)
        vertex(-2.1 + 0.25 * i, 1.02 + 0.16 * i, 1.5 - 0.45 * i)
        glass_quad(at, at + 1, at + 2, at + 3)
    }
}

# Evening all round: a ring of bands seen from inside, and the ground.
function evening(    i, k, n, heights, names, at) {
    n = 12
    split("0 1.2 2.6 4.6 9", heights, " ")
    split("dusk_1 dusk_2 dusk_3 dusk_4", names, " ")
    for (k = 1; k <= 4; k++) {
        material(names[k])
        for (i = 0; i < n; i++) {
            at = on_circle(0, heights[k] - 0.05, 0, 9, i, n, 0)
            on_circle(0, heights[k] - 0.05, 0, 9, i + 1, n, 0)
            on_circle(0, heights[k + 1] - 0.05, 0, 9, i + 1, n, 0)
            on_circle(0, heights[k + 1] - 0.05, 0, 9, i, n, 0)
            quad(at + 3, at + 2, at + 1, at)
        }
    }
    material("ground")
    disc(0, -0.05, 0, 9, n, 0, 1)
}

# Once round, rising and sinking.
function orbit(    i, n, a) {
    n = 64
    for (i = 0; i < n; i++) {
        a = 0.35 + i * 2 * PI / n
        printf "%.4f %.4f %.4f 0 0.9 0\n", 4.3 * sin(a), 2.1 + 1.1 * sin(2 * a), 4.3 * cos(a)
    }
}

BEGIN {
    PI = atan2(0, -1)
    if (cameras) {
        orbit()
        exit
    }
    print "# Glass, by sim/scenes/glass.awk\nmtllib glass.mtl"
    evening()
    tiles()
    lantern()
    bottle(1.5, 0.7)
    panes()
}
