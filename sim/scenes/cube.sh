# SPDX-License-Identifier: MIT
#
# For scripts to source: cube_make FOLDER makes cube.dae and cube.cam there, the rooms with a cube that turns (cube.awk).
# shellcheck shell=sh

cube_make() {
    awk -f sim/scenes/cube.awk sim/scenes/rooms.obj >"$1/cube.dae" &&
        awk -v cameras=1 -f sim/scenes/cube.awk sim/scenes/rooms.obj >"$1/cube.cam"
}
