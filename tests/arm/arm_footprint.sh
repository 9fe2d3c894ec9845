# SPDX-License-Identifier: MIT
#
# A scene pays for what it needs, on Cortex-M0+ and Cortex-M4 at -Os: what it does without is not linked, neither
# code nor state; the table in firmware/README.md is what is measured; the bound of the stack holds in fact; memory that is not
# there is missed by the linker.
. tests/tap.sh
. sim/targets/targets.sh
. sim/tools/footprint.sh

# The scenes ------------------------------------------------------------------------------------------------------

# A camera that stands so near that polygons are clipped, and one that sees all of it.
prepare_options= # of compile

prepare() { # NAME MODEL CAMERA...
    mkdir "$work/$1"
    prepare_name=$1 prepare_model=$2
    shift 2
    printf '%s\n' "$@" >"$work/cameras"
    # shellcheck disable=SC2086 # options are words
    "$BUILD/limner" compile "$prepare_model" $prepare_options -o "$work/$prepare_name/model" --report >"$work/$prepare_name/report" &&
        "$BUILD/limner" render "$work/$prepare_name/model.lim" --camera "$work/cameras" --size 240x240 \
            --write-cameras "$work/$prepare_name/cameras.h"
}

# Objects that are there already with the same flags are not compiled again.
built() { # CORE NAME [FLAG...]
    built_core=$1 built_name=$2 built_with=$work/$2/$1.flags
    shift 2
    if ! echo "$*" | cmp -s - "$built_with"; then
        rm -f "$built_with"
        footprint_objects "$built_core" "$work/$built_name" model.h "$@" && echo "$*" >"$built_with" || return 1
    fi
    footprint_link "$built_core" "$work/$built_name"
}

symbols() { # CORE NAME: without the configuration that some hold
    "$(target_tools "$1")nm" "$work/$2/$1/renderer.elf" | awk '{ sub(/\.needs_same_LIM_CONFIG.*/, "", $NF); print $NF }'
}

# What is linked ----------------------------------------------------------------------------------------------

links_no() { # CORE NAME PATTERN
    symbols "$1" "$2" >"$work/symbols"
    grep -q '^lim_frame$' "$work/symbols" && ! grep -E "$3" "$work/symbols"
}

links() { # CORE NAME PATTERN
    symbols "$1" "$2" | grep -qE "$3"
}

state_b() { # CORE NAME MEMBER-OR-TYPE [FLAG...]: of a size that the C compiler knows
    state_core=$1 state_name=$2 state_what=$3
    shift 3
    printf '#include "limner.h"\nchar state[sizeof(%s)];\n' "$state_what" >"$work/state.c"
    # shellcheck disable=SC2046,SC2086 # flags are words
    $(target_compiler "$state_core") $(target_flags "$state_core") $footprint_flags -I"$work/$state_name" \
        -DLIM_CONFIG='"model.h"' "$@" -c -o "$work/state.o" "$work/state.c" && footprint_size "$state_core" "$work/state.o" 3
}

has_no_member() { # NAME MEMBER...
    has_name=$1
    shift
    for member; do
        member_b=$(state_b m4 "$has_name" "((struct lim *)0)->$member") && [ "$member_b" -eq 0 ] && continue
        echo "struct lim has $member"
        return 1
    done
    [ "$(state_b m4 "$has_name" '((struct lim *)0)->pass.view')" -gt 0 ]
}

target_has_no() { # NAME MEMBER...: which users set, and is not declared
    has_name=$1
    shift
    for member; do
        ! state_b m4 "$has_name" "((struct lim_target *)0)->$member" 2>/dev/null || return 1
    done
    [ "$(state_b m4 "$has_name" '((struct lim_target *)0)->done')" -gt 0 ]
}

counters_cost_their_own_size() {
    without=$(state_b m4 rooms 'struct lim') && with=$(state_b m4 rooms 'struct lim' -DLIM_HAS_STATS=1) &&
        stats=$(state_b m4 rooms 'struct lim_stats') && counted=$(state_b m4 rooms 'struct lim_counted') &&
        echo "$without, $stats and $counted make $with" &&
        [ $((without + stats + counted + 4)) -eq "$with" ] && has_no_member rooms pass.stats
}

# The planes of the model decide: with a feature that it does not need the code grows, without it does not.
grows_with() { # NAME FLAG...
    grows_name=$1
    shift
    built m4 "$grows_name" && before=$(footprint_size m4 "$work/$grows_name/m4/renderer.elf" 1) &&
        built m4 "$grows_name" "$@" && after=$(footprint_size m4 "$work/$grows_name/m4/renderer.elf" 1) || return 1
    echo "$before bytes, with $* $after"
    [ "$after" -gt "$before" ]
}

# Whether it is by scan lines is known when it is compiled; the other's code is in neither.
draws_by_scan_lines() { # NAME
    grep -q 'LIM_HAS_SCANLINE 1' "$work/$1/model.h" && grep -q 'LIM_HAS_NEAREST 0' "$work/$1/model.h" &&
        grows_with "$1" -DLIM_HAS_NEAREST=1
}

# The 64-bit values of exact planes are in the code of a scene that has such planes, and not of others.
no_exact_planes() { # NAME
    built m4 "$1" && grep -q 'LIM_HAS_LARGE 0' "$work/$1/model.h" && grows_with "$1" -DLIM_HAS_SLANTED=1 -DLIM_HAS_LARGE=1
}

within() { # CORE NAME MOST
    built "$1" "$2" && code_b=$(footprint_size "$1" "$work/$2/$1/renderer.elf" 1) && echo "$code_b bytes" && [ "$code_b" -le "$3" ]
}

# The stack ---------------------------------------------------------------------------------------------------

stack_holds() { # CORE NAME
    built "$1" "$2" && bound=$(footprint_stack "$1" "$work/$2") &&
        target_link "$1" "$work/stack.elf" -Os -ffreestanding -I"$work/$2" -DLIM_CONFIG='"model.h"' \
            tests/footprint/stack.c "$work/$2/model.c" firmware/*.c firmware/*/*.c &&
        used_b=$(target_run "$1" "$work/stack.elf") || return 1
    echo "used $used_b, bound $bound"
    [ "$used_b" -le "${bound%%:*}" ] && [ $((used_b * 3)) -ge $((${bound%%:*} * 2)) ]
}

has_a_bound() { # CORE NAME
    built "$1" "$2" && bound=$(footprint_stack "$1" "$work/$2") && echo "$bound" && [ "${bound%%:*}" -gt 0 ]
}

recursion_is_found() {
    printf 'int a(int n);\nint b(int n);\nint lim_frame(int n);\nint a(int n) { return n ? b(n - 1) + 1 : 0; }\n%s\n%s\n' \
        'int b(int n) { return a(n) * 3 + a(n + 1); }' 'int lim_frame(int n) { return a(n) + 1; }' >"$work/recursion.c"
    (cd "$work" && arm-none-eabi-gcc -Os -fno-inline -fcallgraph-info=su -c recursion.c) || return 1
    ! awk -f sim/tools/stack.awk -v roots=lim_frame "$work/recursion.ci" 2>"$work/said" && grep -q 'calls itself' "$work/said"
}

unknown_pointers_are_found() {
    printf 'int lim_frame(int (*f)(void)) { return f() + 1; }\n' >"$work/pointer.c"
    (cd "$work" && arm-none-eabi-gcc -Os -fcallgraph-info=su -c pointer.c) || return 1
    ! awk -f sim/tools/stack.awk -v roots=lim_frame "$work/pointer.ci" 2>"$work/said" &&
        grep -q 'pointer.c:1:[0-9]*: calls through a pointer, and nobody says where to' "$work/said"
}

# Two files, each with a static function of the same name, of which one takes 400 bytes; and a stage that is set between the
# renderer and a target, which it calls in the same words.
write_led() { # FOLDER
    mkdir -p "$1"
    printf '%s\n' 'struct the_target {' '    int (*lend)(int y);' '};' 'typedef int sink(int x);' 'int use(int *room);' \
        'int give(sink *to, int x);' 'extern struct the_target target;' 'int set(void);' >"$1/led.h"
    printf '%s\n' '#include "led.h"' 'static sink push;' 'static int push(int x) { return x * 3; }' \
        'static int lend(int y) { int room[100]; room[0] = y; return use(room); }' \
        'int set(void) { target.lend = lend; return give(push, 3); }' >"$1/deep.c"
    printf '%s\n' '#include "led.h"' 'int stage(void);' \
        'static int lend(int y) { int room[50]; room[0] = y; return use(room) + target.lend(y); }' \
        'int stage(void) {' '    target.lend = lend; /* never called from this file */' '    return 0; }' >"$1/stage.c"
    printf '%s\n' '#include "led.h"' 'struct the_target target;' 'int give(sink *to, int x) { return to(x) + 1; }' \
        'int lim_frame(int y);' 'int lim_frame(int y) {' '    return target.lend(y) + give(0, y); }' >"$1/frame.c"
}

led_bound() { # FOLDER: bytes and path of lim_frame()
    for name in deep stage frame; do
        (cd "$1" && arm-none-eabi-gcc -Os -fno-inline -fno-ipa-cp -fcallgraph-info=su -c $name.c) || return 1
    done
    awk -f sim/tools/pointers.awk "$1"/*.[ch] >"$1/pointers" &&
        awk -f sim/tools/stack.awk -v roots=lim_frame "$1/pointers" "$1"/*.ci 2>&1
}

pointers_lead_there() {
    write_led "$work/led" && led_bound "$work/led" >"$work/said" && cat "$work/said" &&
        grep -qE '^[0-9]+: lim_frame [0-9]+, lend 2[0-9]{2}, lend 4[0-9]{2}, use' "$work/said"
}

# Without the word that the stage calls another it calls itself; renamed, its function is found as before.
words_in_the_sources_count() {
    write_led "$work/led2" && sed -i 's/never called/called never/' "$work/led2/stage.c" || return 1
    led_bound "$work/led2" >"$work/again" && { cat "$work/again"; return 1; }
    grep -q 'lend: calls itself' "$work/again" || return 1
    write_led "$work/led3" && sed -i 's/\([ *]\)lend\([(;]\)/\1lent\2/; s/target\.lent/target.lend/; s/= lend/= lent/' "$work/led3/deep.c" &&
        led_bound "$work/led3" >"$work/again" && cat "$work/again" && grep -q 'lent 4' "$work/again" &&
        [ "$(sed 's/:.*//' "$work/again")" = "$(sed 's/:.*//' "$work/said")" ]
}

# A cache of objects and call graphs, sim/tools/graph_cache.sh: in a folder of any name what is the same comes from it, what is not
# is compiled.
graph_of() { # FOLDER FLAG...
    graph_dir=$work/$1
    shift
    (cd "$graph_dir" && XDG_CACHE_HOME=$work/cache CCACHE=yes sh "$OLDPWD/sim/tools/graph_cache.sh" arm-none-eabi-gcc -Os \
        -fcallgraph-info=su -I"$graph_dir" "$@" -MMD -c -o made.o code.c) && cat "$graph_dir/made.o" "$graph_dir/made.ci"
}

cached_graphs_are_right() {
    for folder in here there; do
        mkdir "$work/$folder"
        echo 'enum { ROOM = 40 };' >"$work/$folder/room.h"
        printf '#include "room.h"\nint use(int *);\nint lim_frame(void) { int room[ROOM]; return use(room) + MORE; }\n' \
            >"$work/$folder/code.c"
    done
    graph_of here -DMORE=1 >"$work/first" && graph_of there -DMORE=1 | cmp "$work/first" - || return 1
    [ "$(find "$work/cache" -name '*.ci' | wc -l)" -eq 1 ] && grep -q '^made.o: code.c .*room.h' "$work/there/made.d" || return 1
    ! graph_of here -DMORE=2 | cmp -s "$work/first" - && ! graph_of here -DMORE=1 -O2 | cmp -s "$work/first" - || return 1
    echo 'enum { ROOM = 50 };' >"$work/there/room.h"
    ! graph_of there -DMORE=1 | cmp -s "$work/first" - && [ "$(find "$work/cache" -name '*.ci' | wc -l)" -eq 4 ] &&
        grep -q '20[0-9] bytes' "$work/there/made.ci"
}

# Sets of objects are taken while they are used, and made anew where a file is missing.
kept_sets_are_whole() {
    XDG_CACHE_HOME=$work/sets
    mkdir "$work/kept" && : >"$work/kept/model.h"
    footprint_compile() {
        echo compiled >>"$work/compiled"
        mkdir "$work/kept/m4" && for source in firmware/*.c firmware/*/*.c; do
            source=$(basename "$source" .c) && : >"$work/kept/m4/$source.o" >"$work/kept/m4/$source.ci"
        done
    }
    takes() { # HOW-OFTEN-COMPILED-BY-THEN
        footprint_objects m4 "$work/kept" model.h && [ "$(wc -l <"$work/compiled")" -eq "$1" ] &&
            [ -f "$work/kept/m4/frame.o" ] && [ -f "$work/kept/m4/frame.ci" ]
    }
    takes 1 && set=$(echo "$work/sets/limner/objects"/*) && touch -d '6 days ago' "$set" && takes 1 &&
        [ -z "$(find "$set" -maxdepth 0 -mtime +1)" ] && rm "$set/frame.ci" && takes 2 && takes 2 &&
        touch -d '9 days ago' "$set" && takes 3
}

# Memory ------------------------------------------------------------------------------------------------------

# The scene's memory is a constant: on 16 KB of RAM the teapot does not link, and the icosahedron does.
link_on_microbit() { # NAME
    target_link microbit "$work/small.elf" -Os -I"$work/$1" -DLIM_CONFIG='"model.h"' tests/footprint/stack.c \
        "$work/$1/model.c" firmware/*.c firmware/*/*.c 2>"$work/said"
}

too_large_is_the_linkers_affair() {
    ! link_on_microbit teapot && cat "$work/said" && grep -qE 'overflowed by [0-9]+ bytes|too little RAM' "$work/said"
}

tap_check "the rooms compile to C" prepare rooms sim/scenes/rooms.obj '2 1.6 2 6 1.4 7' '3 1.6 3 3.1 0.2 3.1'
prepare_options=--antialias
tap_check "the rooms compile to C for smooth edges" prepare smooth sim/scenes/rooms.obj '2 1.6 2 6 1.4 7' '3 1.6 3 3.1 0.2 3.1'
prepare_options='--delta --round'
tap_check "the rooms compile to C for what changes, and round glass" prepare changing sim/scenes/rooms.obj '2 1.6 2 6 1.4 7' '3 1.6 3 3.1 0.2 3.1'
prepare_options=
tap_check "the rooms compile to C for frames in parts" prepare parts sim/scenes/rooms.obj '2 1.6 2 6 1.4 7' '3 1.6 3 3.1 0.2 3.1'
tap_check "the teapot compiles to C" prepare teapot sim/scenes/teapot.obj '0 1 3 0 0.4 0' '0.2 0.3 0.1 1 0.3 0.2'
prepare_options='--method convex'
tap_check "the icosahedron compiles to C" prepare icosahedron sim/scenes/icosahedron.obj '0 1 3 0 0 0' '0.8 0.6 0.4 0.3 0.3 0'
prepare_options=
tap_check "the glass compiles to C" prepare glass sim/scenes/glass.obj '1 1.5 4 0 0.9 0' '0.1 0.9 0.3 1 0.6 0.5'
tap_check "the report calls it one convex solid" grep -qE 'one convex solid +yes' "$work/icosahedron/report"
tap_check "the rooms with movers compile to C" prepare moving sim/scenes/movers.gltf '-3.7 1.5 1.6 0 1.1 -0.4' '0.6 1.5 0.2 2.6 1.3 0'
tap_check "the textured rooms compile to C" prepare textured "$BUILD/scenes/textured/textured.obj" \
    '2 1.6 1 0 1.4 0' '3.2 1.6 1 3.3 0.2 1'
for core in m0plus m4; do
    tap_check "$core: the renderer of the rooms builds" built $core rooms
    tap_check "$core: it has a walk, spans and retained polygons" links $core rooms '^lim_(walk_next|span_close|retain)$'
    tap_check "$core: and neither painter nor convex code, nor portals" links_no $core rooms 'painter|convex|portal'
    tap_check "$core: nor anything for transparent polygons" links_no $core rooms 'blend|layer|alpha'
    tap_check "$core: nor for cameras that look at a target" links_no $core rooms 'look_at|orbit|atan2'
    tap_check "$core: nor for wireframe" links_no $core rooms 'wire|hidden|edge_column'
    tap_check "$core: nor for antialiased edges" links_no $core rooms 'smooth|sample|strip|mask|antialias'
    tap_check "$core: the renderer of the smooth rooms builds" built $core smooth
    tap_check "$core: it has all of that" links $core smooth '^lim_(mask_close|smooth_mix|strip_next)$'
    tap_check "$core: nor anything to compare frames, or of round glass" links_no $core rooms 'delta|runs|rects|changes|visible'
    footprint_entries='lim_frame lim_init lim_set_delta'
    tap_check "$core: the renderer of the changing rooms builds" built $core changing
    footprint_entries='lim_frame lim_init'
    tap_check "$core: it has all of that" links $core changing '^lim_(set_delta|runs_keep|rects_add)$'
    tap_check "$core: nor anything of frames in parts" links_no $core rooms 'ahead|collect_(begin|some)|frame_(begin|work|paint)'
    footprint_entries='lim_frame lim_init lim_frame_begin lim_frame_work lim_frame_paint'
    tap_check "$core: the renderer of the rooms in parts builds" built $core parts
    footprint_entries='lim_frame lim_init'
    tap_check "$core: it has all of that" links $core parts '^lim_(begin_ahead|collect_begin|collect_some|frame_work)$'
    tap_check "$core: the renderer of the glass builds" built $core glass
    tap_check "$core: it blends, and paints backwards what its stack cannot hold" links $core glass '^lim_(blend|painter_line)$'
    tap_check "$core: nor anything of textures" links_no $core rooms 'texture|texel|palette|mapping'
    tap_check "$core: nor anything of movers" links_no $core rooms \
        'mover|meet|crowd|near_plane|route|motion|instance|lim_(light|lamp|root)|lim_piece|newell|corner|entry|sorted'
    tap_check "$core: the renderer of the rooms with movers builds" built $core moving
    tap_check "$core: it meets them on its way" links $core moving '^lim_meet_next$'
    tap_check "$core: it compares them line by line" links $core moving '^lim_crowd_cut_line$'
    tap_check "$core: and splits nothing" links_no $core moving 'lim_piece|newell|entry|sorted'
    tap_check "$core: but does not light them" links_no $core moving 'lim_light|lim_isqrt'
    tap_check "$core: the renderer of the textured rooms builds" built $core textured
    tap_check "$core: it has all of that" links $core textured '^lim_texture_(begin|set|fill)$'
    tap_check "$core: the renderer of the icosahedron builds" built $core icosahedron
    tap_check "$core: it has no walk, no culling, no spans, nothing retained" links_no $core icosahedron \
        'walk|cull|span|retain|nearest|painter|lim_paint|wire'
done
tap_check "nor has it state for them" has_no_member icosahedron pass.walk pass.cull nearest sorter pass.stats
tap_check "the rooms have no state for a convex solid" has_no_member rooms convex painter pass.stats pass.wireframe pass.view.antialiased delta nearest-\>paint.layers nearest-\>paint.smooth
tap_check "nor for movers" has_no_member rooms movers sorter
tap_check "what moves has none for sorting" has_no_member moving sorter
tap_check "nor for windows and round glass" target_has_no rooms window visible fill
tap_check "nor for textures" has_no_member rooms pass.texturing
tap_check "counters cost what they count in, and without them nothing is counted" counters_cost_their_own_size
tap_check "a scene without large planes has no code for them" no_exact_planes rooms
tap_check "subtree bounds are only tested where there are some" grows_with icosahedron -DLIM_HAS_NEAREST=1 -DLIM_HAS_CULL=1
tap_check "scan lines cost the rooms something, and are not there" grows_with rooms -DLIM_HAS_SCANLINE=1
tap_check "so does nearest first the teapot, which is drawn by scan lines" draws_by_scan_lines teapot
tap_check "m4: the renderer of the rooms takes 8 KB at most" within m4 rooms 8192
tap_check "m4: that of a convex solid takes 4.75 KB at most" within m4 icosahedron 4864
for core in m0plus m4; do
    for name in rooms teapot icosahedron glass textured; do
        tap_check "$core: $name uses no more stack than the bound, and two thirds of it" stack_holds $core $name
    done
done
for core in m0plus m4; do
    tap_check "$core: the stack has a bound with movers too" has_a_bound $core moving
    tap_check "$core: and with antialiased edges" has_a_bound $core smooth
    tap_check "$core: and where only changes are sent" has_a_bound $core changing
done
tap_check "recursion has no bound" recursion_is_found
tap_check "nor has a pointer that nobody accounts for" unknown_pointers_are_found
tap_check "calls through pointers lead where the sources say, of two functions of one name to the right one" pointers_lead_there
tap_check "what the sources do not say of them is missed, and a new name is not" words_in_the_sources_count
tap_check "objects and call graphs from the cache are those of the compiler" cached_graphs_are_right
tap_check "sets of objects are kept while they are used, and whole" kept_sets_are_whole
tap_check "16 KB of RAM hold the icosahedron" link_on_microbit icosahedron
tap_check "what they do not hold the linker refuses" too_large_is_the_linkers_affair
tap_check "the table in firmware/README.md is what is measured now" sh sim/tools/tables.sh --check footprint
tap_done
