# SPDX-License-Identifier: MIT
#
# A ball of n rings of n quads, with bumps, so that nothing is flat; as OBJ: awk -v n=16 -f tests/ball.awk
BEGIN {
    pi = atan2(0, -1)
    for (i = 0; i <= n; i++) for (j = 0; j < n; j++) {
        a = pi * i / n; b = 2 * pi * j / n; r = 1 + 0.1 * sin(5 * a) * cos(4 * b)
        printf "v %.6f %.6f %.6f\n", r * sin(a) * cos(b), r * cos(a), r * sin(a) * sin(b)
    }
    for (i = 0; i < n; i++) for (j = 0; j < n; j++)
        printf "f %d %d %d %d\n", i * n + j + 1, i * n + (j + 1) % n + 1, (i + 1) * n + (j + 1) % n + 1, (i + 1) * n + j + 1
}
