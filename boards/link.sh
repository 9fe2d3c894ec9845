# SPDX-License-Identifier: MIT
#
# Links an image and sees that it fits: sh boards/link.sh FOLDER TITLE OBJECT... In: the objects beside what gcc left
# of their call graphs, FOLDER/model*.c, FOLDER/report of `limner compile`, and of the environment what boards/image.mk
# exports. Out: FOLDER/image.elf, image.map, and what it takes, as text (`fits`) and numbers (`takes`). Where RAM is
# short there are fewer lines, then one renderer instead of two (STREAM=auto), then less for it than the scene asks for:
# the same frames, for more time. What does not fit even so is refused.
set -eu
. sim/tools/footprint.sh

folder=$1 title=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { # LINE...
    rm -f "$folder"/image.* "$folder/fits" "$folder/takes"
    printf 'link: %s\n' "$@" >&2
    exit 1
}

compile() { # OBJECT SOURCE [FLAG...]
    compile_object=$1 compile_source=$2
    shift 2
    # shellcheck disable=SC2086 # flags are words
    $COMPILER -I"$folder" -DLIM_CONFIG='"model.h"' "$@" -c -o "$compile_object" "$compile_source"
}

compile_model() {
    for source in "$folder"/model*.c; do # what moves has files of its own
        compile "${source%.c}.o" "$source"
    done
}

too_large='overflowed\|will not fit\|is not within region'

# What does not fit is linked all the same, to see by how much.
link() {
    # shellcheck disable=SC2086 # flags are words
    "${TOOLS}gcc" $ARCH $OPT -Wl,--gc-sections -Wl,--noinhibit-exec -Wl,-Map,"$folder/image.map" $LINK \
        -o "$work/image.elf" "$@" "$folder"/model*.o $LAST 2>"$work/said" ||
        grep -q "$too_large" "$work/said" || { cat "$work/said" >&2; fail "$title: cannot be linked"; }
    # What a linker script asserts does not inhibit it, either.
    if grep -v "$too_large" "$work/said" >&2; then fail "$title: is not linked as it should be"; fi
    "${TOOLS}nm" -S "$work/image.elf" >"$work/symbols"
    "${TOOLS}size" -A "$work/image.elf" | awk -v code_in_ram="${CODE_IN_RAM:-}" '
        $1 ~ /^\.(boot2|vectors|text|rodata|init|fini)/ { code += $2 }
        $1 ~ /^\.(data|sdata)/ { data += $2 }
        $1 ~ /^\.(bss|sbss|noinit)/ { bss += $2 }
        END { print code + data, (code_in_ram ? code : 0) + data + bss }' >"$work/size"
    read -r flash_b static_b <"$work/size"
}

symbol_b() { # NAME: bytes of the largest symbol of that name
    awk -v name="$1" 'NF == 4 && $4 == name { print $2 }' "$work/symbols" | sort | tail -n 1 |
        { read -r hex && echo $((0x$hex)) || echo 0; }
}

# -- The stack: the deepest chain of calls from main(), or of what an exception calls -----------------------------------

# Of all code: as gcc left it, or, of AVR's, as the image has it.
graph() {
    if [ "$TOOLS" = avr- ]; then
        "${TOOLS}objdump" -dl "$work/image.elf" | awk -f sim/tools/avr_graph.awk
    else
        for object in $objects; do cat "${object%.o}.ci"; done
    fi
}

stack_of() { # ROOT...
    awk '{ sub(/\..*/, "", $NF); print $NF }' "$work/symbols" | sort -u >"$work/linked"
    graph >"$work/graph"
    awk -f sim/tools/stack.awk -v roots="$*" -v only="$(tr '\n' ' ' <"$work/linked")" "$work/pointers" "$work/graph"
}

# -- What fits -----------------------------------------------------------------------------------------------------------

fits() {
    [ -z "${RAM_B:-}" ] || [ $((static_b + stack_b)) -le "$RAM_B" ]
}

bound() {
    [ -f "$work/pointers" ] || footprint_pointers >"$work/pointers" || fail "$title: its stack cannot be bounded"
    # shellcheck disable=SC2046 # not all processors have exceptions
    stack=$(stack_of main $(awk '$NF == "image_fault" { print $NF }' "$work/symbols")) || fail "$title: its stack cannot be bounded"
    stack_b=${stack%%:*}
}

# With so many renderers and lines, and less memory for the scene, perhaps.
again() { # [FLAG...]
    for source in main app_scene; do
        compile "$work/$source.o" boards/common/$source.c -USCENE_RENDERERS -DSCENE_RENDERERS="$renderers" \
            -UBOARD_LINES -DBOARD_LINES="$lines" "$@"
    done
    objects=$(echo "$objects" | tr ' ' '\n' | sed "s#^.*/\(main\|app_scene\)\.o\$#$work/\1.o#")
    # shellcheck disable=SC2086 # objects are words
    link $objects
    bound
}

with_fewer_lines() { # LEAST: half as many, again and again
    while [ "$lines" -gt "$1" ]; do
        lines=$((lines / 2))
        again
        ! fits || return 0
    done
    return 1
}

with_one_renderer() {
    [ "$STREAM" = auto ] && [ "$renderers" -gt 1 ] || return 1
    renderers=1
    again && fits
}

with_less() { # for the scene: what is left
    asked_b=$(($(symbol_b mem) / renderers))
    least_b=$(awk '/^ *least, bytes/ { print $NF }' "$folder/report")
    mem_b=$(((asked_b + (RAM_B - static_b - stack_b - 8 * renderers + 8) / renderers) / 8 * 8))
    if [ "$mem_b" -lt "$least_b" ]; then
        over_b=$((static_b + stack_b - RAM_B))
        fail "$title: RAM is short by $((over_b - renderers * (asked_b - least_b))) of $RAM_B bytes, even with the least memory for the scene" \
            "  it takes $((static_b - renderers * asked_b)) beside the scene, $least_b for it at least, and $stack_b for the stack" \
            "  what helps: a smaller panel, PRECISION=draft or fast, a scene with fewer polygons in view"
    fi
    note="the scene asks for $asked_b bytes and gets $mem_b: views that need more are drawn in bands"
    again -DSCENE_MEM_B="$mem_b"
}

# How frames come about. What is painted or filled at once has one renderer, whatever was asked for.
mode() {
    if grep -q ' lim_frame_work$' "$work/symbols"; then
        echo "two renderers: one walks while the other's lines are sent"
    elif [ -n "$note" ]; then
        echo "one renderer, in bands where memory is short"
    else
        echo "one renderer"
    fi
}

objects=$*
note=
lines=$LINES
renderers=1
compile_model
link "$@"
stack= stack_b=0
if [ -n "${RAM_B:-}" ]; then
    bound
    [ "$STREAM" = no ] || renderers=2
    fits || with_fewer_lines 2 || with_one_renderer || with_fewer_lines 1 || with_less
fi
if [ -n "${FLASH_B:-}" ] && [ "$flash_b" -gt "$FLASH_B" ]; then
    scene_b=$("${TOOLS}size" "$folder"/model*.o | awk 'NR > 1 { sum += $1 } END { print sum }')
    fail "$title: flash is short by $((flash_b - FLASH_B)) of $FLASH_B bytes" \
        "  it takes $((flash_b - scene_b)) for code and cameras, and $scene_b for the scene" \
        "  what helps: a scene with fewer polygons, a path with fewer cameras, OPT=-Os, PRECISION=draft"
fi
fits || fail "$title: RAM is short by $((static_b + stack_b - RAM_B)) bytes"
mv "$work/image.elf" "$folder/image.elf"
echo "$flash_b $static_b $stack_b" >"$folder/takes"
{
    echo "$title"
    echo "  flash   $flash_b${FLASH_B:+ of $FLASH_B bytes, $((FLASH_B - flash_b)) left}"
    echo "  RAM     $static_b${RAM_B:+, stack $stack_b at most, of $RAM_B bytes: $((RAM_B - static_b - stack_b)) left}"
    echo "  frames  $(mode); $(symbol_b lines) bytes of lines"
    [ -z "$note" ] || echo "  $note"
} >"$folder/fits"
