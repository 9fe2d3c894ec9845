# SPDX-License-Identifier: MIT
#
# The deltoidal hexecontahedron: of each triangle of an icosahedron three kites, from a corner over the middle of an
# edge to the middle of the triangle. Every kite's plane touches the ball of radius 0.92 m; a corner lies where its
# direction meets the planes. The five kites round a corner have one of six greys, and so have those opposite.
#
#     awk -f sim/scenes/hexecontahedron.awk sim/scenes/icosahedron.obj >sim/scenes/hexecontahedron.obj
#     awk -v materials=1 -f sim/scenes/hexecontahedron.awk >sim/scenes/hexecontahedron.mtl
#     awk -v cameras=1 -f sim/scenes/hexecontahedron.awk >sim/scenes/hexecontahedron.cam

BEGIN {
    RADIUS_M = 0.92
    FROM_CORNER = 0.258819 # of the touching point's direction: sine of its angle with the triangle's middle, 15 degrees,
    FROM_MIDDLE = 0.380623 # and with the corner
    split("1 0.4 0.8 0.5 0.65 0.3", greys)
    if (materials) paint()
    if (cameras) path()
}

function paint(   i) {
    for (i = 1; i in greys; i++) printf "newmtl grey%d\nKd %s %s %s\n", i, greys[i], greys[i], greys[i]
    exit
}

# An orbit that sways up and down, 24 frames.
function path(   i, turn, rise) {
    for (i = 0; i < 24; i++) {
        turn = i * 2 * 3.14159265358979 / 24
        rise = 0.5 * sin(2 * turn)
        printf "%.6f %.6f %.6f 0 0 0\n", 2.3 * cos(rise) * sin(turn), 2.3 * sin(rise), 2.3 * cos(rise) * cos(turn)
    }
    exit
}

$1 == "v" { for (k = 1; k <= 3; k++) corner[corners + 0, k] = $(k + 1); corners++ }
$1 == "f" { for (k = 1; k <= 3; k++) triangle[triangles + 0, k] = $(k + 1) - 1; triangles++ }

# The direction between corners, in u[].
function between(a, b, c,   k, length_m) {
    for (k = 1; k <= 3; k++) u[k] = corner[a, k] + corner[b, k] + (c < 0 ? 0 : corner[c, k])
    length_m = sqrt(u[1] ^ 2 + u[2] ^ 2 + u[3] ^ 2)
    for (k = 1; k <= 3; k++) u[k] /= length_m
}

# The vertex in direction u[], where it meets a kite's plane, whose touching point has direction n[].
function vertex(key,   k, along) {
    if (key in vertices) return vertices[key]
    for (k = 1; k <= 3; k++) along += u[k] * n[k]
    printf "v %.9f %.9f %.9f\n", u[1] * RADIUS_M / along, u[2] * RADIUS_M / along, u[3] * RADIUS_M / along
    return vertices[key] = ++count
}

# Opposite corners are no neighbours.
function grey_of(a,   b) {
    for (b = 0; b < a; b++)
        if (corner[a, 1] == -corner[b, 1] && corner[a, 2] == -corner[b, 2] && corner[a, 3] == -corner[b, 3]) return grey[b]
    return ++pairs
}

function edge_key(a, b) {
    return a < b ? a " " b : b " " a
}

# From corner a round the middle of its triangle, counter-clockwise.
function kite(t, a, b, c,   k, length_m, corners_of) {
    between(a, b, c)
    for (k = 1; k <= 3; k++) n[k] = FROM_CORNER * corner[a, k] + FROM_MIDDLE * u[k]
    length_m = sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
    for (k = 1; k <= 3; k++) n[k] /= length_m
    corners_of = vertex("middle " t)
    between(a, c, -1)
    corners_of = corners_of " " vertex(edge_key(a, c))
    between(a, a, -1)
    corners_of = corners_of " " vertex("corner " a)
    between(a, b, -1)
    return "f " corners_of " " vertex(edge_key(a, b)) "\n"
}

END {
    if (cameras || materials) exit
    print "# A deltoidal hexecontahedron, 1 m in radius: one convex solid of 60 kites."
    print "mtllib hexecontahedron.mtl"
    for (a = 0; a < corners; a++) grey[a] = grey_of(a)
    for (t = 0; t < triangles; t++)
        for (k = 0; k < 3; k++) {
            a = triangle[t, k + 1]
            faces[grey[a]] = faces[grey[a]] kite(t, a, triangle[t, (k + 1) % 3 + 1], triangle[t, (k + 2) % 3 + 1])
        }
    for (i = 1; i in greys; i++) printf "usemtl grey%d\n%s", i, faces[i]
}
