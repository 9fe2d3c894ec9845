#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Which lines of the renderer and of the readers the fuzz corpora reach: sh tests/fuzz/fuzz_coverage.sh TARGET... (make
# fuzz-coverage). Replays tests/fuzz/corpus, and what fuzzing found in $BUILD/fuzz/corpus, under gcc's coverage, and nothing
# else: no unit test counts. FUZZ_S=30 fuzzes each target for so long first. FUZZ_FOUND=no: tests/fuzz/corpus alone.
#
# A line counts once, whatever number of profiles it is compiled for, and is reached if it is in any. Prints each file's
# share, the lines that are not reached with FUZZ_LINES=yes, and both totals; fails if one is below its bound.
set -eu

: "${BUILD:?is set by the Makefile}" "${FUZZ_S:=0}" "${FUZZ_FOUND:=yes}" "${FUZZ_LINES:=no}"
build=$BUILD/coverage
least_firmware=95 least_readers=90

# What takes bytes of others' making, by name, so that a new file of these kinds is one without being named here.
readers='import.*|model_io|model_build|model_colour|model_unit|model_whole|number.*|own_formats|ply_.*|text|vertex_.*|node_transforms|gltf.*|decimal|float_step|.*_file'
readers="$readers|source.*|companion|inputs|picture.*|wad|level.*|camera_path|wire_log|listener|qemu_trace|vcd|channels|spi_wires|capture|picture_ends|link_map|hashes|lim_.*"
readers="$readers|binary|uf2|boot2|elf_segments|esp_image|report_text|bug_report|parse|arguments|options|measure_request|(camera|module|port)_choice"
# Not these: they write.
writers='frame_file'
# Nor these, which open files that are not handed in: of the system and of tools (child, counts, model, streams), that
# the program has written itself (cmd_measure, measure_cost, report_run, model_import; export and export_folder: what an
# earlier export wrote), ports and devices (cmd_devices); and cmd_report_bug, which copies files without looking into them.
others='child|counts|model|streams|cmd_measure|measure_cost|report_run|cmd_devices|cmd_report_bug|outputs|export|export_folder|model_import'

# A file that opens something to read it is one of those above, whatever its name.
opens='\<(f?open|freopen|fread|fgets|getline|getc_unlocked|input_open|whole_file_read|companion_open)\('
for source in sim/*/*.c; do
    case $source in sim/emulators/* | sim/scenes/* | sim/targets/* | sim/tools/*) continue ;; esac # programs of their own
    name=$(basename "$source" .c)
    grep -qE "$opens" "$source" || continue
    printf '%s\n' "$name" | grep -qxE "$readers|$writers|$others" && continue
    echo "fuzz-coverage: $source opens files, and is in no list of tests/fuzz/fuzz_coverage.sh"
    exit 1
done

if [ "$FUZZ_S" != 0 ]; then
    FUZZ_FLAGS="-max_total_time=$FUZZ_S" sh tests/fuzz/fuzz.sh "$@"
fi
make -s BUILD="$build" CC=gcc CCACHE= OPT='-O0 --coverage' DEPS=skip "$build/tests/fuzz_replay"
find "$build" -name '*.gcda' -exec rm -f {} +
for target; do
    set -- "tests/fuzz/corpus/$target"
    if [ "$FUZZ_FOUND" = yes ] && [ -d "$BUILD/fuzz/corpus/$target" ]; then
        set -- "$@" "$BUILD/fuzz/corpus/$target"
    fi
    "$build/tests/fuzz_replay" "$target" "$@" 2>/dev/null
done

# Of each compilation of a file: how often each line ran.
notes() {
    for notes in "$build"/core-*/firmware/*.gcno "$build"/core-*/firmware/*/*.gcno "$build"/host/firmware/*.gcno "$build"/host/firmware/*/*.gcno "$build"/host/sim/*/*.gcno; do
        name=$(basename "$notes" .gcno)
        case $notes in
        */host/sim/*) printf '%s\n' "$name" | grep -qxE "$readers" || continue ;;
        esac
        printf '%s\n' "$name" | grep -qxE "$writers" || printf '%s\n' "$notes"
    done
}

notes | xargs gcov --stdout --relative-only 2>/dev/null | awk -v firmware_least="$least_firmware" \
    -v readers_least="$least_readers" -v show="$FUZZ_LINES" '
    function percent(a, b) { return b ? 100 * a / b : 100 }
    {
        count = $0; sub(/:.*/, "", count); gsub(/ /, "", count)
        rest = $0; sub(/^[^:]*:/, "", rest)
        line = rest; sub(/:.*/, "", line); line += 0
    }
    line == 0 {
        if (rest ~ /Source:/) {
            source = rest; sub(/.*Source:/, "", source)
            wanted = source ~ /^(firmware\/([a-z0-9_]*\/)?[a-z0-9_]*\.[ch]|sim\/[a-z0-9_]*\/[a-z0-9_]*\.c)$/
        }
        next
    }
    !wanted || count == "-" { next }
    {
        place = source ":" line
        if (!(place in seen)) { seen[place] = 1; lines[source]++; text[place] = rest }
        if (count !~ /^[#=]/ && count + 0 > 0 && !(place in hit)) { hit[place] = 1; reached[source]++ }
    }
    END {
        for (source in lines) {
            group = source ~ /^firmware/ ? "firmware" : "readers"
            of[group] += lines[source]; in_all[group] += reached[source]
            printf "%-30s %5d of %5d lines  %6.2f %%\n", source, reached[source], lines[source],
                percent(reached[source], lines[source]) | "sort"
        }
        close("sort")
        if (show == "yes")
            for (place in seen)
                if (!(place in hit)) print "not reached: " place " " text[place] | "sort -t: -k1,2 -k3n"
        close("sort -t: -k1,2 -k3n")
        f = percent(in_all["firmware"], of["firmware"]); r = percent(in_all["readers"], of["readers"])
        printf "firmware: %d of %d lines, %.2f %%, at least %d %%\n", in_all["firmware"], of["firmware"], f, firmware_least
        printf "readers in sim: %d of %d lines, %.2f %%, at least %d %%\n", in_all["readers"], of["readers"], r, readers_least
        exit f < firmware_least || r < readers_least || !of["firmware"] || !of["readers"]
    }'
