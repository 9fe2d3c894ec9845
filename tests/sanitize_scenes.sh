# SPDX-License-Identifier: MIT
#
# Every scene of sim/scenes and both generated ones, drawn by the sanitizers' build with every method, option, format of
# panel, tree and profile that there is: no report. Scenes are found by their folder and names by `limner help`'s own
# lists below; each run takes the next of every list, so that in a few runs a scene meets each name, and in all runs
# together names meet in pairs. What cannot go together is refused in a line, which is no failure; what neither draws
# nor says why is. Pictures are small and frames few: it is arithmetic that is looked at. A run has every second scene, as
# sanitize.sh has programs.
. tests/tap.sh
. tests/with_sanitizers.sh

limner=$build/limner

# Words, and how many of them go before those of the run before come again: no two lists have the same length in common.
methods='nearest scanline painter bsp clusters axis octree depth newell portals convex'
profiles='draft fast fine exact'
panels='memory framebuffer st7789 st7789:rgb444 ili9488:rgb666 ssd1327 ssd0323 pcd8544 ssd1306 ls013b7dh03 gc9a01'
options='-- --wireframe --antialias --delta --delta=3 --unlit --wireframe=00FF00,000000 --ids --antialias'
movers='on/baked on/turning off/baked'
lenses='60/ 150/ 2/ 120/0.05 30/0.2'
sizes='48x36 1x1 64x64 7x84 84x7 33x17 84x48'
orders='-- --newell=planes --newell=one --newell=planes,one'

# The word of a list whose turn it is.
word() { # TURN WORD...
    turn=$1
    shift
    shift $((turn % $#))
    echo "$1"
}

size_for() { # PANEL TURN: black and white ones and greys are small, and all have an even width
    case $1 in
    memory | framebuffer) word "$2" $sizes ;;
    pcd8544) echo 84x48 ;;
    ls013b7dh03) echo 128x128 ;;
    *) word "$2" 48x36 64x64 32x84 84x32 64x48 ;;
    esac
}

# What a run is given besides the scene, as words.
arguments() { # TURN
    method=$(word "$1" $methods)
    panel=$(word $(($1 / 2)) $panels)
    option=$(word $(($1 / 3)) $options)
    lens=$(word $(($1 / 5)) $lenses)
    mover=$(word $(($1 / 3)) $movers)
    order=$(word "$1" $orders)
    set -- "--method=$method" "--precision=$(word "$1" $profiles)" "--panel=$panel" "--size=$(size_for "$panel" "$1")" \
        "--fov=${lens%/*}" "--movers=${mover%/*}" "--mover-light=${mover#*/}"
    [ -z "${lens#*/}" ] || set -- "$@" "--near=${lens#*/}"
    [ "$option" = -- ] || set -- "$@" "$option"
    [ "$option" != --ids ] || set -- "$@" "$work/ids"
    [ "$method" != newell ] || [ "$order" = -- ] || set -- "$@" "$order"
    echo "$@"
}

cameras_of() { # SCENE: its own or, if there are none, an orbit
    if [ -f "${1%.*}.cam" ]; then
        awk '!/^#/ && NF { line[n++] = $0 }
            END { for (i = 0; i < 2 && i < n; i++) print line[int(i * n / 2)] }' "${1%.*}.cam" >"$work/$2.cam"
        echo "--camera=$work/$2.cam"
    else
        echo --camera=random:1:2
    fi
}

# One run; a refusal is an answer, too.
render() { # SCENE NAME ARGUMENT...
    scene=$1 name=$2
    shift 2
    status=0
    timeout 120 "$limner" render "$scene" "$@" --stats >"$work/$name.out" 2>"$work/$name.err" || status=$?
    if [ $status -gt 1 ] || grep -q 'runtime error\|Sanitizer' "$work/$name.err" ||
        { [ $status -eq 1 ] && ! tail -n 1 "$work/$name.err" | grep -q '^limner: '; }; then
        echo "limner render $scene $*: status $status"
        cat "$work/$name.err"
        return 1
    fi
}

# What cannot go together is refused; then the method and the profile have a run to themselves.
draw() { # SCENE NAME CAMERA METHOD PROFILE ARGUMENT...
    render "$@" || return 1
    [ $status -eq 1 ] || return 0
    render "$1" "$2" "$3" "$4" "$5" --size=48x36 --panel=memory || return 1
    [ $status -eq 0 ] || echo refused >>"$work/$2.refused"
}

# The runs of a scene, each with the turn after the one before; fewer of one that takes long.
runs_of() { # SCENE
    if [ "$(wc -c <"$1")" -lt 30000 ]; then echo 13; else echo 7; fi
}

draw_scene() { # SCENE FIRST-TURN RUNS
    name=$(basename "$1" | tr -c 'a-zA-Z0-9\n' _)
    cameras=$(cameras_of "$1" "$name")
    : >"$work/$name.refused"
    turn=$2
    while [ "$turn" -lt $(($2 + $3)) ]; do
        # shellcheck disable=SC2046 # words
        draw "$1" "$name" "$cameras" $(arguments "$turn") || return 1
        turn=$((turn + 1))
    done
    # One that is mostly refused, whatever it is given, has not been looked at.
    echo "$(wc -l <"$work/$name.refused") of $3 are refused"
    [ "$(wc -l <"$work/$name.refused")" -lt $(($3 * 3 / 4)) ] || { cat "$work/$name.err"; return 1; }
}

becomes_c() { # SCENE
    "$limner" compile "$1" -o "$work/compiled/$(basename "$1")" --size 64x64
}

tap_check "the program builds with the sanitizers" sanitized "$limner"
echo "# SEED=$SEED"
turn=0
for scene in sim/scenes/*.obj sim/scenes/*.gltf sim/scenes/*.glb sim/scenes/*.ply sim/scenes/*.stl \
    "$BUILD/scenes/demo.obj" "$BUILD/scenes/textured/textured.obj"; do
    case $scene in *'*'*) continue ;; esac
    echo "$(runs_of "$scene") $turn $scene"
    turn=$((turn + $(runs_of "$scene")))
done >"$work/scenes"
part_of 2 "$(cat "$work/scenes")" >"$work/half"
while read -r runs turn scene; do
    tap_check "$(basename "$scene"), $runs ways" draw_scene "$scene" "$turn" "$runs"
    [ "$runs" -lt 13 ] || tap_check "$(basename "$scene") becomes C" becomes_c "$scene"
done <"$work/half"
for report in tests/reports/*.tar; do
    tap_check "$report" "$limner" replay "$report"
done
tap_done
