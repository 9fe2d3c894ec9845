# SPDX-License-Identifier: MIT
#
# What frames cost, on every processor, and what they take of memory: profile fast.
#   sh sim/tools/bench.sh                                  everything: build/bench.csv, the tables, what changed since
#                                                    the baseline, and what is lost to other renderers (exit status 1:
#                                                    something grew, or is lost for no reason that the baseline has)
#   sh sim/tools/bench.sh --baseline                       the same; writes the baseline, and the tables, anew
#   sh sim/tools/bench.sh --rows CORES SCENE SIZE PATH     rows of these to standard output
# SCENES, a list in the environment, has it count these scenes alone; --baseline keeps the rows of all others.
# SIZE is 240x240, or 128x64-framebuffer: painted into all of the picture's pixels, instead of line by line.
# PATH is `own`, the camera file that the scene comes with and is compiled for, or `random`, cameras on which nothing was
# tuned and which the compiler does not know; both of 64 frames. Needs $BUILD/limner, $BUILD/scenes and $WARNINGS;
# progress goes to standard error.
set -eu
. sim/targets/targets.sh
. sim/tools/footprint.sh
. sim/tools/bench_host.sh

: "${BUILD:=build}" "${WARNINGS:?is set by the Makefile: make bench}"
export BUILD
out=$BUILD/bench
baseline=sim/tools/bench.baseline.csv

header=core,scene,size,path,stage,mean,worst
frames=64
scenes='mesh5000 demo teapot rooms' # what takes longest first
all_cores=m0plus,m3,m4,m33,rv32
sizes='240x240 128x64'
small=128x64-framebuffer small_scenes='teapot rooms' # where there is RAM for that on any board
more_scenes='solid3648tex wuson solid3648 spider map01tex map01 teapot-smooth rooms-smooth teapottex roomstex movers furnished'
more_cores=m0plus,m4 # on which others were counted, at 240x240
paths='own random'
seed=1

# -- Scenes: model, cameras, and what `limner` takes beside them --------------------------------------------------------

# NAME MODEL CAMERAS [OPTION...]: of scenes that are not sim/scenes/NAME.obj alone.
elsewhere() {
    made=$BUILD/scenes/bench
    cat <<END
demo $BUILD/scenes/demo.obj $BUILD/scenes/demo.cam
mesh5000 $BUILD/scenes/mesh5000.obj $BUILD/scenes/mesh5000.cam
spider $made/spider.obj $made/spider.cam
wuson $made/wuson.obj $made/wuson.cam
solid3648 $made/solid3648.obj $made/solid3648.cam
solid3648tex $made/solid3648tex.obj $made/solid3648.cam
map01 $made/map01.obj $made/map01.cam
map01tex $made/map01tex.obj $made/map01.cam
teapottex sim/scenes/mapped/teapottex.obj sim/scenes/teapot.cam
roomstex sim/scenes/mapped/roomstex.obj sim/scenes/rooms.cam
teapot-smooth sim/scenes/teapot.obj sim/scenes/teapot.cam --antialias
rooms-smooth sim/scenes/rooms.obj sim/scenes/rooms.cam --antialias
movers sim/scenes/movers.gltf sim/scenes/movers.cam
furnished $made/furnished.obj sim/scenes/rooms.cam
END
}

word_of() { # SCENE FIRST-FIELD LAST-FIELD
    {
        elsewhere
        echo "$1 sim/scenes/$1.obj sim/scenes/$1.cam"
    } | awk -v name="$1" -v from="$2" -v to="$3" '$1 == name {
            for (i = from; i <= to && i <= NF; i++) printf "%s%s", (i > from ? " " : ""), $i
            exit
        }'
}

model_of() { # SCENE
    word_of "$1" 2 2
}

options_of() { # SCENE
    word_of "$1" 4 9
}

# -- Sizes: in pixels, what `limner` takes beside them, and the bytes of pixels that the target keeps -----------------

pixels_of() { # SIZE
    echo "${1%-framebuffer}"
}

framebuffer_of() { # SIZE
    case $1 in
    *-framebuffer) echo --framebuffer ;;
    esac
}

target_b() { # SIZE
    pixels=$(pixels_of "$1")
    case $1 in
    *-framebuffer) echo $((2 * ${pixels%x*} * ${pixels#*x})) ;;
    *) echo $((2 * ${pixels%x*})) ;;
    esac
}

# The cameras of a path, as a word for --camera. A file's are thinned out evenly.
cameras_of() { # SCENE PATH FOLDER
    [ "$2" = own ] || { echo "random:$seed:$frames"; return; }
    awk -v frames=$frames '!/^ *(#|$)/ { line[count++] = $0 }
        END {
            if (frames > count) frames = count
            for (i = 0; i < frames; i++) print line[int(i * count / frames)]
        }' "$(word_of "$1" 3 3)" >"$3/own.cam"
    echo "$3/own.cam"
}

# A scene is compiled for its own path, if that is what is counted.
path_of() { # PATH CAMERAS
    case $1 in
    own) echo "--path $2" ;;
    esac
}

# -- Rows: STAGE MEAN WORST becomes CORE,SCENE,SIZE,PATH,STAGE,MEAN,WORST --------------------------------------------

rows_of() { # CORE SCENE SIZE PATH
    sed "s/ /,/g; s/^/$1,$2,$3,$4,/"
}

# From the CSV files of `limner measure`. The file frame.c is told from the whole frame.
measured_rows() { # FOLDER SCENE SIZE PATH
    awk -F , -v place="$2,$3,$4" '
        FNR == 1 { file++; for (i = 1; i <= NF; i++) column[$i] = i; next }
        function field(name) { return $column[name] }
        file == 1 && FNR == 2 { printf "all,%s,wrong_percent,%s,%s\n", place, field("wrong_percent"), field("worst_frame_percent") }
        file == 1 && FNR == 2 { printf "all,%s,holes_px,%d,%d\n", place, field("holes"), field("holes") }
        file == 1 { printf "%s,%s,frame,%s,%s\n", field("core"), place, field("instructions"), field("worst_instructions") }
        file == 2 {
            stage = field("stage") == "frame" ? "frame.c" : field("stage")
            printf "%s,%s,%s,%s,%s\n", field("core"), place, stage, field("instructions"), field("worst")
        }' "$1/measure.csv" "$1/stages.csv"
}

# shellcheck disable=SC2046 # options are words
emulated() { # CORES SCENE SIZE PATH FOLDER
    cameras=$(cameras_of "$2" "$4" "$5")
    "$BUILD/limner" measure "$(model_of "$2")" --camera "$cameras" $(path_of "$4" "$cameras") --size "$(pixels_of "$3")" \
        $(framebuffer_of "$3") $(options_of "$2") --precision fast --core "$1" -o "$5" >/dev/null
    measured_rows "$5" "$2" "$3" "$4"
}

# shellcheck disable=SC2046
on_host() { # SCENE SIZE FOLDER
    for path in $paths; do
        cameras=$(cameras_of "$1" "$path" "$3")
        "$BUILD/limner" compile "$(model_of "$1")" $(path_of "$path" "$cameras") --size "$(pixels_of "$2")" \
            $(framebuffer_of "$2") -o "$3/model" >/dev/null
        bench_host_count "$3" "$cameras" "$(pixels_of "$2")" >"$3/counted"
        rows_of host "$1" "$2" "$path" <"$3/counted"
    done
}

# Bytes at -Os, compiled for its own path; a line of the panel, or all of them, is the target's. Flash a face of the
# model, merged or not.
# shellcheck disable=SC2046
memory() { # SCENE SIZE FOLDER
    "$BUILD/limner" compile "$(model_of "$1")" $(path_of own "$(cameras_of "$1" own "$3")") --size "$(pixels_of "$2")" \
        $(framebuffer_of "$2") $(options_of "$1") -o "$3/model" --report >"$3/report"
    pixels=$(pixels_of "$2")
    faces=$(sed -n 's/^ *faces in the model *//p' "$3/report")
    data_b=$(footprint_data "$3")
    awk -v data_b="$data_b" -v faces="$faces" 'BEGIN {
        printf "faces %d %d\nscene_b %d %d\nscene_b_a_face %.1f %.1f\n", faces, faces, data_b, data_b, data_b / faces, data_b / faces
    }' | rows_of all "$1" "$2" -
    for core in m0plus m4; do
        footprint_costs $core "$3" "${pixels#*x}" >"$3/costs"
        awk -v target_b="$(target_b "$2")" '{
            print "code_b", $1, $1
            print "ram_b", $2, $2
            print "stack_b", $3, $3
            print "all_ram_b", $2 + $3 + target_b, $2 + $3 + target_b
        }' "$3/costs" | rows_of $core "$1" "$2" -
    done
}

# -- All of it, as many jobs at once as there are processors ----------------------------------------------------------

frames_of() { # SCENE SIZE
    for path in $paths; do echo "emulated $1 $2 $path"; done
    echo "on_host $1 $2 -"
}

jobs() {
    all_jobs | awk -v wanted=" ${SCENES:-} " 'wanted ~ /^ +$/ || index(wanted, " " $2 " ")'
}

all_jobs() {
    for scene in $more_scenes; do
        for path in $paths; do echo "some $scene 240x240 $path"; done
        echo "memory $scene 240x240 -"
    done
    for scene in $scenes; do
        for size in $sizes; do frames_of "$scene" "$size"; done
        echo "memory $scene 240x240 -"
    done
    for scene in $small_scenes; do
        frames_of "$scene" $small
        echo "memory $scene $small -"
    done
}

job() { # KIND SCENE SIZE PATH FOLDER: its rows
    case $1 in
    emulated) emulated $all_cores "$2" "$3" "$4" "$5" ;;
    some) emulated $more_cores "$2" "$3" "$4" "$5" ;;
    on_host) on_host "$2" "$3" "$5" ;;
    memory) memory "$2" "$3" "$5" ;;
    esac
}

# A process of its own, so that the first command that fails ends it; xargs begins no more after status 255.
one() { # KIND SCENE SIZE PATH
    folder=$out/$1-$2-$3-$4
    mkdir -p "$folder"
    if ! sh sim/tools/bench.sh --job "$@" "$folder" >"$folder/rows" 2>"$folder/log"; then
        echo "bench: $* failed:" >&2
        cat "$folder/log" >&2
        exit 255
    fi
    mv "$folder/rows" "$folder.csv"
    echo "bench: $(find "$out" -maxdepth 1 -name "*.csv" | wc -l) of $(jobs | wc -l): $*" >&2
}

everything() {
    rm -rf "$out"
    mkdir -p "$out"
    jobs >"$out/jobs"
    [ -s "$out/jobs" ] || { echo "bench: SCENES: there is none of these: $SCENES" >&2; return 1; }
    xargs -L 1 -P "$(nproc)" sh sim/tools/bench.sh --one <"$out/jobs"
    echo "$header" >"$BUILD/bench.csv"
    while read -r kind scene size path; do cat "$out/$kind-$scene-$size-$path.csv"; done <"$out/jobs" |
        sort -t , -k 2,4 -k 1,1 -s >>"$BUILD/bench.csv"
    [ "${SCENES:-}" ] || BENCH_CSV=$BUILD/bench.csv sh sim/tools/tables.sh peers
}

# Changes first, then lost rows: both are said, whatever the other's outcome.
judge() {
    status=0
    sh sim/tools/bench_compare.sh "$baseline" "$BUILD/bench.csv" "$(wanted_rows)" || status=$?
    sh sim/tools/bench_compare.sh --peers "$baseline" "$BUILD/bench.csv" || status=1
    return $status
}

# What CORE,SCENE,SIZE,PATH of the rows that are counted matches.
wanted_rows() {
    [ "${SCENES:-}" ] && echo "^[^,]*,($(echo $SCENES | tr ' ' '|'))," || echo .
}

case ${1:-} in
--one | --job)
    name=${1#--}
    shift
    "$name" "$@"
    ;;
--rows)
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    echo "$header"
    emulated "$2" "$3" "$4" "$5" "$work"
    ;;
--baseline)
    everything
    judge || true
    sh sim/tools/bench_compare.sh --baseline "$baseline" "$BUILD/bench.csv" "$(wanted_rows)" >"$out/baseline"
    cp "$out/baseline" "$baseline"
    sh sim/tools/tables.sh --write figures peers bench bench-stages bench-memory
    ;;
'')
    everything
    judge
    ;;
esac
