#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Fuzzes one target after another under libFuzzer and clang's sanitizers: sh tests/fuzz.sh TARGET... (make fuzz).
# Starts from tests/corpus and keeps what it finds in $BUILD/fuzz/corpus; an input that breaks a promise is
# left as $BUILD/fuzz/TARGET-crash-... FUZZ_FLAGS are libFuzzer's: -max_total_time=60, -runs=10000000.
set -eu

: "${BUILD:?is set by the Makefile}" "${FUZZ_FLAGS:=-max_total_time=60}"
build=$BUILD/fuzz

# Coverage by counters alone: recorded comparisons would be those of the sanitizers, and cost three quarters of the time.
opt='-O2 -g -fsanitize=address,undefined -fno-sanitize-recover=all'
opt="$opt -fsanitize-coverage=inline-8bit-counters,pc-table"
make -s BUILD="$build" CC=clang OPT="$opt" DEPS=skip "$build/tests/fuzz"
for target; do
    mkdir -p "$build/corpus/$target"
    echo "fuzz: $target"
    # shellcheck disable=SC2086 # FUZZ_FLAGS is a list
    "$build/tests/fuzz" --target="$target" -entropic=0 -max_len=2048 -print_final_stats=1 \
        -artifact_prefix="$build/$target-" $FUZZ_FLAGS "$build/corpus/$target" "tests/corpus/$target"
done
