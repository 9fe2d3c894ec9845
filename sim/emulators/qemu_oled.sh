# SPDX-License-Identifier: MIT
#
# Runs the image of the LM3S6965 board in QEMU, whose own OLED shows the frames, frame by frame under gdb:
#   sh sim/emulators/qemu_oled.sh IMAGE FRAMES FOLDER [CHECK LIMNER decode ...]
# Leaves in FOLDER the display after each frame (000.png ...; a pixel is 4x4 of it), `trace`, every write to a device's
# register, and `log` of gdb. With CHECK, a file of hashes, both must have them: the trace as the decoding command
# makes pictures of it, and the display. A line `FRAME COMMAND` of the file $OLED_COMMANDS is a command of gdb's before
# that frame is drawn; of frame 0, before anything runs. Ends with an error when there are fewer frames in $EMULATE_S
# seconds (60), or QEMU's display has complained.
set -eu

image=$1 frames=$2 folder=$3
shift 3

fail() {
    echo "qemu_oled: $*" >&2
    exit 1
}

for tool in qemu-system-arm gdb-multiarch; do
    command -v $tool >/dev/null || fail "$tool is missing; Debian's package of that name has it"
done

# An instruction takes 256 ns of the machine's time: every run is the same, and waits take few of them. QEMU ends by
# itself, even if gdb does not.
qemu="qemu-system-arm -M lm3s6965evb -kernel $image -nodefaults -nic user,restrict=on -display none -serial none
    -monitor none -icount shift=8 -S -gdb stdio -D $folder/trace -trace memory_region_ops_write"

# When the next frame begins, the last one is on the display, and the LED has changed. In the end QEMU may be gone before
# it has answered a kill, which is no error then.
script() { # COMMANDS
    echo "set pagination off"
    echo "set confirm off"
    # shellcheck disable=SC2086 # words, on one line
    echo "target remote | exec timeout -k 5 ${EMULATE_S:-60}" $qemu "2>$folder/said"
    echo "break frame_begin"
    awk -v frames="$frames" -v folder="$folder" '
        { frame = $1; sub(/^[^ ]* /, ""); before[frame] = before[frame] $0 "\n" }
        END {
            printf "%scontinue\n", before[0]
            for (frame = 0; frame < frames; frame++) {
                if (frame) printf "%s", before[frame]
                printf "continue\nmonitor screendump %s/%03d.png -f png\n", folder, frame
            }
            print "echo all frames\\n\nkill"
        }' "$1"
}

mkdir -p "$folder"
rm -f "$folder"/*.png "$folder/trace"
script "${OLED_COMMANDS:-/dev/null}" >"$folder/script"
gdb-multiarch -nx -batch -x "$folder/script" "$image" >"$folder/log" 2>&1 </dev/null || grep -qx 'all frames' "$folder/log" || {
    tail -n 5 "$folder/log" "$folder/said" >&2
    fail "$image did not draw $frames frames"
}
if grep -i 'ssd0323\|error' "$folder/said" >&2; then fail "QEMU's display complains"; fi
[ $# -gt 0 ] || exit 0
check=$1 limner=$2
shift
"$@" <"$folder/trace"
"$limner" hashes "$folder"/*.png --shrink 4 --check "$check" >"$folder/shown" || { cat "$folder/shown"; exit 1; }
echo "QEMU's display shows the same $frames frames"
