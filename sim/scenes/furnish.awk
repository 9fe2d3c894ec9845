# SPDX-License-Identifier: MIT
#
# Sets models into another one:
#   awk -v things="spider.obj 1.4 4.9 0 1 30; teapot.obj ..." -f sim/scenes/furnish.awk ROOMS.obj > FURNISHED.obj
# A thing is a model, how long its longest side shall be, where the middle of its ground stands, and a turn about its
# upright in degrees. Of things positions and faces are taken alone; each is a material, thing1 and on, without a file.

$1 == "v" { vertices++ }
$1 != "mtllib" { print }

function number_of(corner, first) {
    sub(/\/.*/, "", corner)
    return corner < 0 ? vertices + corner + 1 : first + corner
}

function read(model, line, word, count, k) {
    points = faces = 0
    while ((getline line < model) > 0) {
        count = split(line, word)
        if (word[1] == "v") {
            points++
            for (k = 1; k <= 3; k++) {
                at[points, k] = word[k + 1]
                if (points == 1 || at[points, k] < low[k]) low[k] = at[points, k]
                if (points == 1 || at[points, k] > high[k]) high[k] = at[points, k]
            }
        } else if (word[1] == "f") {
            face[++faces] = line
        }
    }
    close(model)
    if (points) return
    printf "furnish.awk: %s: no vertices\n", model >"/dev/stderr"
    exit failed = 1
}

function place(size, x, y, z, turn, k, i, longest, scale, across, along) {
    for (k = 1; k <= 3; k++)
        if (high[k] - low[k] > longest) longest = high[k] - low[k]
    scale = size / longest
    turn *= atan2(0, -1) / 180
    for (i = 1; i <= points; i++) {
        across = (at[i, 1] - (low[1] + high[1]) / 2) * scale
        along = (at[i, 3] - (low[3] + high[3]) / 2) * scale
        printf "v %.6f %.6f %.6f\n", x + cos(turn) * across + sin(turn) * along, y + (at[i, 2] - low[2]) * scale, \
            z - sin(turn) * across + cos(turn) * along
    }
}

function add(thing, name, word, first, i, k, count, line) {
    split(thing, word)
    read(word[1])
    first = vertices
    place(word[2], word[3], word[4], word[5], word[6])
    vertices += points
    print "usemtl " name
    for (i = 1; i <= faces; i++) {
        count = split(face[i], word)
        line = "f"
        for (k = 2; k <= count; k++)
            line = line " " number_of(word[k], first)
        print line
    }
}

END {
    if (failed) exit 1
    count_of_things = split(things, thing, / *; */)
    for (t = 1; t <= count_of_things; t++)
        add(thing[t], "thing" t)
}
