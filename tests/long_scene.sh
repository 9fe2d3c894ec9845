# SPDX-License-Identifier: MIT
#
# For test scripts to source: long_scene NAME [ALPHA] writes NAME.obj, NAME.mtl and NAME.cam: a ground of 240 km, boxes of
# 0.6 m on it and others of a kilometre far away, which no 16-bit grid holds; a third of the boxes is of that opacity.
# Twelve cameras go around the small boxes and away from them.
# shellcheck shell=sh

long_scene() { # NAME [ALPHA]
    awk -v name="$1" -v alpha="${2:-1}" '
        function random() { state = (state * 16807) % 2147483647; return state / 2147483647 }
        function box(x, z, side, high, turn, colour,    k, dx, dz) {
            for (k = 0; k < 8; k++) {
                dx = (k % 2 - 0.5) * side
                dz = (int(k / 4) - 0.5) * side
                printf "v %.6f %.6f %.6f\n", x + dx * cos(turn) + dz * sin(turn), int(k / 2) % 2 * high, \
                    z + dz * cos(turn) - dx * sin(turn) >obj
            }
            print "usemtl " colour >obj
            for (k = 1; k <= 6; k++) {
                split(sides[k], corner, " ")
                print "f", points + corner[1], points + corner[2], points + corner[3], points + corner[4] >obj
            }
            points += 8
        }
        BEGIN {
            obj = name ".obj"; mtl = name ".mtl"; cam = name ".cam"
            state = 4711
            split("1 5 7 3;2 4 8 6;1 2 6 5;3 7 8 4;1 3 4 2;5 6 8 7", sides, ";")
            base = name
            sub(".*/", "", base)
            print "mtllib " base ".mtl\nusemtl ground" >obj
            print "v -120000 0 120000\nv 120000 0 120000\nv 120000 0 -120000\nv -120000 0 -120000\nf 1 2 3 4" >obj
            points = 4
            for (i = 0; i < 24; i++)
                box(random() * 16 - 8, random() * 16 - 8, 0.6, 0.6, i % 3 ? 0 : i, i % 3 == 1 ? "glass" : i % 2 ? "red" : "blue")
            for (i = 0; i < 6; i++)
                box(20000 * cos(i) + 9000, 30000 * sin(i), 1000 + 500 * i, 900, i, "rock")
            print "newmtl ground\nKd 0.45 0.4 0.3\nnewmtl red\nKd 1 0.2 0.2\nnewmtl blue\nKd 0.3 0.3 1\nnewmtl rock" >mtl
            print "Kd 0.5 0.5 0.55\nnewmtl glass\nKd 0.2 0.9 0.9\nd " alpha >mtl
            for (i = 0; i < 12; i++) {
                away = i < 9 ? 2 + i * 1.3 : 40 * 9 ^ (i - 9)
                printf "%.5f %.5f %.5f 0 0.3 0\n", away * cos(i * 1.1), i < 9 ? 0.9 + 0.1 * i : away * 0.4, away * sin(i * 1.1) >cam
            }
        }'
}

# The same with pictures: textured_long_scene NAME PICTURE [MASKED] shows one each 2 m on the ground, and one on each side of a
# box; on a third of the boxes, if it is named, the other one, of which parts may be clear.
textured_long_scene() { # NAME PICTURE [MASKED]
    long_scene "$1" && cp "$2" ${3:+"$3"} "$(dirname "$1")" &&
        awk -v picture="$(basename "$2")" -v masked="$(basename "${3:-$2}")" '
            /^newmtl/ { material = $2 }
            /^d / { next }
            /^Kd/ { print "Kd 1 1 1\nmap_Kd " (material == "glass" ? masked : picture); next }
            { print }' "$1.mtl" >"$1.lit" && mv "$1.lit" "$1.mtl" &&
        awk '
            BEGIN { places = "0 0;1 0;1 1;0 1;0 0;120000 0;120000 120000;0 120000"; n = split(places, at, ";")
                    for (i = 1; i <= n; i++) print "vt", at[i] }
            /^f/ { first = faces++ ? 0 : 4; print "f", $2 "/" first + 1, $3 "/" first + 2, $4 "/" first + 3, $5 "/" first + 4; next }
            { print }' "$1.obj" >"$1.lit" && mv "$1.lit" "$1.obj"
}
