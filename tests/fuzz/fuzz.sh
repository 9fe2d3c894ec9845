#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Fuzzes one target after another under libFuzzer and clang's sanitizers: sh tests/fuzz/fuzz.sh TARGET... (make fuzz).
# Starts from tests/fuzz/corpus and from seeds (libfuzzer/seeds.c), and keeps what it finds in $BUILD/fuzz/corpus; an input that breaks a promise is
# left as $BUILD/fuzz/TARGET-crash-... FUZZ_FLAGS are libFuzzer's: -max_total_time=60, -runs=10000000.
# FUZZ_MERGE=yes does not fuzz: it makes tests/fuzz/corpus the least of itself and what was found that reaches as much.
#
# Models and pictures are read by libraries that are not ours, are not instrumented, and crash or hang on some files,
# which is why the program runs them in a child process. Their targets go on after a crash; afterwards each such input is
# run again, and is a finding if a frame of ours is in its stack before one of these libraries'.
set -eu

: "${BUILD:?is set by the Makefile}" "${FUZZ_FLAGS:=-max_total_time=60}" "${FUZZ_MERGE:=no}"
build=$BUILD/fuzz
foreign='libassimp|libarchive|libgd|libpng|libjpeg|libz\.|libtiff|libwebp|libavif|libheif'
export ASAN_OPTIONS="allocator_may_return_null=1:${ASAN_OPTIONS:-}"

# Coverage by counters alone: recorded comparisons would be those of the sanitizers, and cost three quarters of the time.
opt='-O2 -g -fsanitize=address,undefined -fno-sanitize-recover=all'
opt="$opt -fsanitize-coverage=inline-8bit-counters,pc-table"
make -s BUILD="$build" CC=clang OPT="$opt" DEPS=skip "$build/tests/fuzz" "$build/tests/fuzz_seeds"

run() { # TARGET FLAG...
    name=$1
    shift
    # shellcheck disable=SC2086 # FUZZ_FLAGS is a list
    "$build/tests/fuzz" --target="$name" -entropic=0 -max_len=2048 -print_final_stats=1 -timeout=10 \
        -artifact_prefix="$build/$name-" "$@" $FUZZ_FLAGS "$build/corpus/$name" "tests/fuzz/corpus/$name"
}

# Whether a crash's stack, from the top down, comes to a library of others before it comes to a source of ours.
is_foreign() { # LOG
    awk -v foreign="$foreign" '
        / #[0-9]+ 0x/ && $0 ~ foreign { exit }
        / #[0-9]+ 0x.*\/(sim|firmware|tests)\/[a-z0-9_\/]*\.[ch]:/ { ours = 1; exit }
        END { exit ours }' "$1"
}

# The crashes of a target that went on after them.
judge() { # TARGET
    judged=0
    for input in "$build/$1"-crash-* "$build/$1"-timeout-* "$build/$1"-oom-* "$build/$1"-leak-*; do
        [ -f "$input" ] || continue
        if "$build/tests/fuzz" --target="$1" -timeout=10 "$input" >"$build/judge.log" 2>&1 || is_foreign "$build/judge.log"; then
            mkdir -p "$build/foreign"
            mv "$input" "$build/foreign/"
            continue
        fi
        cat "$build/judge.log"
        echo "fuzz: $1: $input"
        judged=1
    done
    return $judged
}

# The fewest inputs that reach all edges together, whatever the number of times; and those that broke a promise once,
# which are called broke-...
merge() { # TARGET
    rm -rf "$build/merged"
    mkdir -p "$build/merged"
    "$build/tests/fuzz" --target="$1" -set_cover_merge=1 -use_counters=0 -max_len=2048 -timeout=10 "$build/merged" \
        "tests/fuzz/corpus/$1" "$build/corpus/$1"
    find "tests/fuzz/corpus/$1" -type f ! -name 'broke-*' -exec rm -f {} +
    for input in "$build/merged"/*; do
        cp "$input" "tests/fuzz/corpus/$1/$(basename "$input" | cut -c 1-12)"
    done
}

TMPDIR=$(mktemp -d) # of inputs that are files, also where the program does not come to its end
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
mkdir -p "$build/corpus"
ASAN_OPTIONS="$ASAN_OPTIONS:detect_leaks=0" "$build/tests/fuzz_seeds" "$build/corpus" 40
for target; do
    mkdir -p "$build/corpus/$target" "tests/fuzz/corpus/$target"
    if [ "$FUZZ_MERGE" = yes ]; then
        merge "$target"
        continue
    fi
    echo "fuzz: $target"
    case $target in
    obj | gltf | ply | stl | off | picture)
        status=0
        run "$target" -timeout=3 -fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 || status=$?
        case $status in 0 | 1 | 70 | 71 | 77) ;; *) exit "$status" ;; esac # of crashes, hangs, too much memory
        judge "$target"
        ;;
    *) run "$target" ;;
    esac
done
