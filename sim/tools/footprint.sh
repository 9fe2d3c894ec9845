# SPDX-License-Identifier: MIT
#
# What a scene costs in a firmware, for scripts to source: compiled for a Cortex-M at -Os, the renderer linked by
# what lim_init() and lim_frame() reach. Runs in the project's folder. After footprint_of: the renderer's code and
# tables, the scene's data, the RAM of struct lim and the scene's memory, the worst-case stack; all bytes.
# Needs sim/targets/targets.sh to be sourced as well, and $WARNINGS.
# shellcheck shell=sh

footprint_flags='-Os -ffreestanding -ffunction-sections -fdata-sections -Ifirmware'

# Where objects are kept that the same compiler makes of the same sources and header with the same flags; nothing: nowhere.
footprint_kept() { # FLAG...
    footprint_cache=${XDG_CACHE_HOME:-${HOME:-/nowhere}/.cache}/limner/objects
    if [ -z "${CCACHE:-}" ] || ! mkdir -p "$footprint_cache" 2>/dev/null || ! [ -w "$footprint_cache" ]; then return; fi
    # What was not used for a week goes. Another job may be about to use it: footprint_take looks whether all of it came.
    find "$footprint_cache" -mindepth 1 -maxdepth 1 -mtime +7 -exec rm -rf {} + 2>/dev/null || true
    # shellcheck disable=SC2086
    {
        echo "$footprint_core $(target_flags "$footprint_core") $footprint_flags $WARNINGS $*" && "$(target_compiler "$footprint_core")" --version &&
            cat "$footprint_dir"/*.h firmware/*.[ch] firmware/*/*.[ch]
    } | sha256sum | sed "s#^\([0-9a-f]*\).*#$footprint_cache/\1#"
}

# footprint_objects CORE FOLDER HEADER [FLAG...]: the renderer's objects and call graphs in FOLDER, which has the
# scene's HEADER.
footprint_objects() {
    footprint_core=$1 footprint_dir=$2 footprint_header=$3
    shift 3
    rm -rf "$footprint_dir/$footprint_core"
    footprint_set=$(footprint_kept "$@")
    if [ -n "$footprint_set" ] && footprint_take "$footprint_set" "$footprint_dir/$footprint_core"; then return; fi
    rm -rf "$footprint_dir/$footprint_core"
    footprint_compile "$@" || return 1
    [ -z "$footprint_set" ] || { cp -r "$footprint_dir/$footprint_core" "$footprint_set.$$" && rm -rf "$footprint_set" && mv -T "$footprint_set.$$" "$footprint_set" 2>/dev/null; } ||
        rm -rf "$footprint_set.$$"
}

# A set that is kept, whole or not at all.
footprint_take() { # SET FOLDER
    touch -c "$1" 2>/dev/null || true
    [ -d "$1" ] && cp -r "$1" "$2" 2>/dev/null || return 1
    for footprint_source in firmware/*.c firmware/*/*.c; do
        footprint_object=${footprint_source##*/}
        [ -f "$2/${footprint_object%.c}.o" ] && [ -f "$2/${footprint_object%.c}.ci" ] || return 1
    done
}

footprint_compile() { # FLAG...
    mkdir "$footprint_dir/$footprint_core"
    for footprint_source in firmware/*.c firmware/*/*.c; do
        footprint_object=${footprint_source##*/}
        # shellcheck disable=SC2046,SC2086 # flags are words
        sh sim/tools/graph_cache.sh $(target_compiler "$footprint_core") $(target_flags "$footprint_core") $footprint_flags \
            $WARNINGS -fcallgraph-info=su -I"$footprint_dir" -DLIM_CONFIG="\"$footprint_header\"" "$@" \
            -c -o "$footprint_dir/$footprint_core/${footprint_object%.c}.o" "$footprint_source" || return 1
    done
}

footprint_entries='lim_frame lim_init'

# footprint_symbols CORE FOLDER: those of the entries, some of which hold the configuration (firmware/agree.h).
footprint_symbols() {
    "$(target_tools "$1")nm" --defined-only -P "$2/$1"/*.o | awk -v entries=" $footprint_entries " '
        { name = $1; sub(/\.needs_same_LIM_CONFIG.*/, "", name) }
        index(entries, " " name " ") { print $1 }'
}

# footprint_link CORE FOLDER: what of the objects the entries need, in FOLDER/CORE/renderer.elf. Of a C
# library it needs memcpy and memset at most.
footprint_link() {
    # shellcheck disable=SC2046,SC2086 # flags are words
    $(target_compiler "$1") $(target_flags "$1") -Os -ffreestanding -ffunction-sections -c \
        -o "$2/$1/library.image" boards/common/bare_image.c &&
        $(target_compiler "$1") $(target_flags "$1") -nostdlib -Wl,--gc-sections -Wl,-e,lim_frame \
            $(printf -- '-Wl,-u,%s ' $(footprint_symbols "$1" "$2")) -o "$2/$1/renderer.elf" "$2/$1"/*.o "$2/$1/library.image" -lgcc
}

footprint_size() { # CORE FILE COLUMN: 1 text, 2 data, 3 bss
    "$(target_tools "$1")size" "$2" | awk -v column="$3" 'NR > 1 { sum += $column } END { print sum }'
}

# footprint_ram CORE FOLDER HEADER SCENE H_PX [FLAG...]: struct lim, and what SCENE asks for; SCENE in capitals.
footprint_ram() {
    footprint_core=$1 footprint_dir=$2 footprint_header=$3 footprint_scene=$4 footprint_h_px=$5
    shift 5
    printf '#include "limner.h"\nstruct lim lim;\nuint32_t mem[%s_SCENE_MEM_B(%s) / 4];\n' "$footprint_scene" \
        "$footprint_h_px" >"$footprint_dir/ram.c"
    # shellcheck disable=SC2046,SC2086 # flags are words; avr-gcc would make both common, which counts as no section
    $(target_compiler "$footprint_core") $(target_flags "$footprint_core") $footprint_flags -fno-common \
        -I"$footprint_dir" -DLIM_CONFIG="\"$footprint_header\"" "$@" -c -o "$footprint_dir/ram.image" \
        "$footprint_dir/ram.c" && footprint_size "$footprint_core" "$footprint_dir/ram.image" 3
}

# Where calls through pointers lead, in the project's folder.
footprint_pointers() {
    find -L firmware hal boards -name '*.[ch]' ! -path 'hal/adapters/*' -exec awk -f sim/tools/pointers.awk {} +
}

# footprint_stack CORE FOLDER: the bytes and the path, without what the target's functions take.
footprint_stack() {
    footprint_pointers >"$2/pointers" &&
        awk -f sim/tools/stack.awk -v roots='lim_init lim_frame' "$2/pointers" "$2/$1"/*.ci
}

# footprint_costs CORE FOLDER H_PX: of the scene model.h in FOLDER: code, RAM, stack.
footprint_costs() {
    footprint_objects "$1" "$2" model.h && footprint_link "$1" "$2" && footprint_stack "$1" "$2" >"$2/stack" || return 1
    echo "$(footprint_size "$1" "$2/$1/renderer.elf" 1) $(footprint_ram "$1" "$2" model.h MODEL "$3")" \
        "$(sed 's/:.*//' "$2/stack")"
}

footprint_data() { # FOLDER: the constant arrays of the scene model.c
    # shellcheck disable=SC2046,SC2086 # flags are words
    $(target_compiler m4) $(target_flags m4) $footprint_flags -I"$1" -DLIM_CONFIG='"model.h"' \
        -c -o "$1/model.image" "$1/model.c" && footprint_size m4 "$1/model.image" 1
}
