# SPDX-License-Identifier: MIT
#
# other_cameras.awk -v seed=N -v count=N: cameras in an OBJ file's metres, a line each, as `--camera` takes them.
# They are drawn from the file's text by nothing of the simulator: predictions are held against them as well. An eye
# stands before a random point of a random face, at 2 % to 100 % of the model's diagonal from it (small and large
# distances as often), and looks at that point or at a random vertex. Nothing keeps it out of walls.

function number(word,    part) { # of the vertex that an `f` names
    split(word, part, "/")
    return part[1] < 0 ? vertices + 1 + part[1] : part[1] + 0
}

function reach(axis, value) {
    if (vertices == 1 || value < low[axis])
        low[axis] = value
    if (vertices == 1 || value > high[axis])
        high[axis] = value
}

function drop(axis) { return at[a, axis] + u * (at[b, axis] - at[a, axis]) + v * (at[c, axis] - at[a, axis]) }

function cross_of(p, q) {
    return (at[b, p] - at[a, p]) * (at[c, q] - at[a, q]) - (at[b, q] - at[a, q]) * (at[c, p] - at[a, p])
}

function draw_target(    face, t) {
    face = int(rand() * faces) + 1
    a = corner[face, 1]
    b = corner[face, 2]
    c = corner[face, 3]
    u = rand()
    v = rand()
    if (u + v > 1) {
        u = 1 - u
        v = 1 - v
    }
    for (t = 1; t <= 3; t++)
        target[t] = drop(t)
}

function draw_eye(    t, square, towards, distance) {
    do {
        square = 0
        for (t = 1; t <= 3; t++) {
            way[t] = 2 * rand() - 1
            square += way[t] ^ 2
        }
    } while (square > 1 || square < 0.01)
    towards = way[1] * cross_of(2, 3) + way[2] * cross_of(3, 1) + way[3] * cross_of(1, 2)
    distance = (towards < 0 ? -1 : 1) * diagonal * exp(log(0.02) * rand()) / sqrt(square)
    for (t = 1; t <= 3; t++)
        eye[t] = target[t] + distance * way[t]
}

# Neither at the eye nor straight above or below it.
function can_be_seen(    x, y, z) {
    x = target[1] - eye[1]
    y = target[2] - eye[2]
    z = target[3] - eye[3]
    return x * x + y * y + z * z > 1e-6 * diagonal ^ 2 && x * x + z * z > 1e-4 * (x * x + y * y + z * z)
}

$1 == "v" {
    vertices++
    for (axis = 1; axis <= 3; axis++) {
        at[vertices, axis] = $(axis + 1) + 0
        reach(axis, $(axis + 1) + 0)
    }
}

$1 == "f" && NF >= 4 {
    faces++
    for (i = 1; i <= 3; i++)
        corner[faces, i] = number($(i + 1))
}

END {
    srand(seed)
    diagonal = sqrt((high[1] - low[1]) ^ 2 + (high[2] - low[2]) ^ 2 + (high[3] - low[3]) ^ 2)
    while (drawn < count && faces > 0 && diagonal > 0) {
        draw_target()
        draw_eye()
        if (rand() < 0.5) {
            chosen = int(rand() * vertices) + 1
            for (axis = 1; axis <= 3; axis++)
                target[axis] = at[chosen, axis]
        }
        if (can_be_seen()) {
            printf "%.9g %.9g %.9g %.9g %.9g %.9g\n", eye[1], eye[2], eye[3], target[1], target[2], target[3]
            drawn++
        }
    }
}
