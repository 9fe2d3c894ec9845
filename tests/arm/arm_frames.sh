# SPDX-License-Identifier: MIT
#
# Frames of the rooms, and of a convex solid by its own method, on emulated Cortex-M0 and Cortex-M4 are those of the
# host, in every precision profile; at -Os Cortex-M4 divides where the others have a table (LIM_RECIP_TABLE).
# (Suite `cpus` has the other processors and another scene.)
. tests/tap.sh
. tests/frames_on.sh
. tests/part_of.sh

scene=sim/scenes/rooms size=96x64
# shellcheck disable=SC2086 # a list
by_file=" $(part_of 4 $PROFILES | tr '\n' ' ')" # one profile, file by file, as users build; the others: tests/part_of.sh
for profile in $PROFILES; do
    case $by_file in
    *" $profile "*) frames_firmware='firmware/*.c firmware/*/*.c' ;;
    *) frames_firmware=$(one_file) ;;
    esac
    frames_of "$profile" microbit m4 m4:-Os
done
frames_firmware=$(one_file)
cp sim/scenes/icosahedron.obj "$work/solid.obj"
cp sim/scenes/teapot.cam "$work/solid.cam"
frames_options='--method convex'
frames_on "$work/solid" 96x64 microbit m4 m4:-Os
tap_done
