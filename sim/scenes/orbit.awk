# SPDX-License-Identifier: MIT
#
# 64 cameras around a model, from above and below, at a distance from which the ball around its bounds touches the picture's
# border (a vertical field of view of 60 degrees): awk -f sim/scenes/orbit.awk MODEL.obj > MODEL.cam

$1 == "v" {
    for (i = 1; i <= 3; i++) {
        if (!count || $(i + 1) < least[i]) least[i] = $(i + 1)
        if (!count || $(i + 1) > most[i]) most[i] = $(i + 1)
    }
    count++
}

END {
    pi = atan2(0, -1)
    for (i = 1; i <= 3; i++) {
        centre[i] = (least[i] + most[i]) / 2
        radius += (most[i] - least[i]) ^ 2 / 4
    }
    away = sqrt(radius) / sin(pi / 6)
    for (frame = 0; frame < 64; frame++) {
        around = 2 * pi * frame / 64
        up = pi / 9 + pi / 6 * sin(4 * around) # -10 to 50 degrees
        printf "%.6f %.6f %.6f %.6f %.6f %.6f\n", centre[1] + away * sin(around) * cos(up), centre[2] + away * sin(up), \
            centre[3] + away * cos(around) * cos(up), centre[1], centre[2], centre[3]
    }
}
