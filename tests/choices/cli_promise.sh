# SPDX-License-Identifier: MIT
#
# What a profile promises of wrong pixels, and what `limner compile` says of a scene that has more: how much, which face
# it is, and what helps. A ball that any order draws well stands beside two boxes through each other, which no order of
# whole triangles gets right: a mesh by distance errs there.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
cd "$work" || exit 1

# Faces 1 to 12 are the boxes', the others the ball's.
awk -v n=16 'function box(x, y, z, dx, dy, dz,    i, o) {
    o = vertices + 1
    for (i = 0; i < 8; i++) { printf "v %g %g %g\n", x + (i % 2 ? dx : -dx), y + (int(i / 2) % 2 ? dy : -dy), z + (i > 3 ? dz : -dz); vertices++ }
    faces[++count] = o " " o + 2 " " o + 3 " " o + 1; faces[++count] = o + 4 " " o + 5 " " o + 7 " " o + 6
    faces[++count] = o " " o + 1 " " o + 5 " " o + 4; faces[++count] = o + 2 " " o + 6 " " o + 7 " " o + 3
    faces[++count] = o " " o + 4 " " o + 6 " " o + 2; faces[++count] = o + 1 " " o + 3 " " o + 7 " " o + 5
}
BEGIN {
    box(0, 0, 0, 1, 0.2, 0.3); box(0.1, 0, 0.05, 0.25, 1, 0.2)
    pi = atan2(0, -1)
    for (i = 0; i <= n; i++) for (j = 0; j < n; j++) {
        a = pi * i / n; b = 2 * pi * j / n
        printf "v %.6f %.6f %.6f\n", 4 + sin(a) * cos(b), cos(a), sin(a) * sin(b)
    }
    for (k = 1; k <= count; k++) print "f " faces[k]
    for (i = 0; i < n; i++) for (j = 0; j < n; j++)
        printf "f %d %d %d %d\n", vertices + i * n + j + 1, vertices + i * n + (j + 1) % n + 1, vertices + (i + 1) * n + (j + 1) % n + 1, vertices + (i + 1) * n + j + 1
}' >both.obj

predicted() { awk '/wrong pixels, predicted/ { print $4 }' said; }
compile() { "$limner" compile both.obj --report "$@" >said 2>&1; }

outside() { # PROFILE PROMISE HELP
    compile --method mesh --precision "$1" && cat said && grep -F "note: $(predicted) % of pixels are predicted to be wrong, $1 promises $2 %; face " said >note &&
        grep -qF -- "$3" note && awk '{ sub(/.*face /, ""); exit !($1 >= 1 && $1 <= 12) }' note
}
tap_check "fast promises 0.05 %: more is told, with the face that errs and what helps" outside fast 0.05 '--method nearest has an exact order'
tap_check "fine promises 0.03 %" outside fine 0.03 '--method nearest has an exact order'
tap_check "exact promises 0.005 %" outside exact 0.005 '--method nearest has an exact order'

silent() { compile "$@" && cat said && ! grep -q 'promises' said; }
tap_check "draft promises nothing" silent --method mesh --precision draft
within() { silent --method nearest && awk -v percent="$(predicted)" 'BEGIN { exit !(percent <= 0.05) }'; }
tap_check "of what is within nothing is said" within

tap_done
