# SPDX-License-Identifier: MIT
#
# star.awk -v seed=N -v count=N: triangles through one point, seen from both sides, as an OBJ file.

BEGIN {
    srand(seed)
    for (i = 0; i < count; i++) {
        for (k = 0; k < 6; k++) c[k] = 2 * rand() - 1
        printf "v %.4f %.4f %.4f\nv %.4f %.4f %.4f\nv %.4f %.4f %.4f\n", c[0], c[1], c[2], c[3], c[4], c[5], -c[0] - c[3], -c[1] - c[4], -c[2] - c[5]
        printf "f %d %d %d\nf %d %d %d\n", 3 * i + 1, 3 * i + 2, 3 * i + 3, 3 * i + 3, 3 * i + 2, 3 * i + 1
    }
}
