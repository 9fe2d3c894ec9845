# SPDX-License-Identifier: MIT
#
# A wide scene on an emulated Cortex-M4: its frames are the host's, whose hashes `limner measure` compares them with. The
# same firmware draws a narrow scene.
. tests/tap.sh

draws() { # ROOMS
    "$BUILD/generate_scale" rooms "$1" "$work" && awk 'n++ % 16 == 0' "$work/rooms$1.cam" >"$work/few.cam" &&
        "$BUILD/limner" measure "$work/rooms$1.obj" --camera "$work/few.cam" --precision fast --core m4 -o "$work/measured" &&
        grep -q ',fast,.*,m4,[1-9][0-9]*' "$work/measured/measure.csv"
}

tap_check "6 x 6 rooms" draws 6
tap_check "18 x 18 rooms, with indices of 32 bits" draws 18
tap_done
