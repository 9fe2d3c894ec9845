# SPDX-License-Identifier: MIT
#
# Frames of the rooms on emulated Cortex-M0 and Cortex-M4 are those of the host, in every precision profile.
# (Suite `cpus` has the other processors and another scene.)
. tests/tap.sh
. tests/frames_on.sh

frames_on sim/scenes/rooms 96x64 microbit m4
tap_done
