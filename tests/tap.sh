# SPDX-License-Identifier: MIT
#
# For test scripts to source: prints test results in the Test Anything Protocol, and lends a temporary folder, $work.
# $kept, which a script makes if it wants it, stays: the next run's make finds there what is made already, and a compiler's
# cache knows headers by their place. Every script ends with tap_done: a plan that is missing is a failure.
# shellcheck shell=sh

: "${BUILD:?is set by the Makefile: run this script through make test}" "${WARNINGS:?}"
: "${CCACHE=$(sh sim/tools/compiler_cache.sh)}"
export CCACHE # limner measure compiles, too

# What is said does not hang on how busy the machine is.
export LIMNER_PROGRESS=0

# A make that a test starts shares nothing with the make that started the test.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

tap_count=0
# Of the same name in each run, unless another run has it: a compiler's cache knows headers by their place.
work=${TMPDIR:-/tmp}/limner-test-$(basename "$0" .sh)
mkdir -m 700 "$work" 2>/dev/null || work=$(mktemp -d)
# What was decided once is not decided again: a decision counts for the build that made it alone.
LIMNER_CACHE=$(cd "$BUILD" && pwd)/decisions
export LIMNER_CACHE
kept=$(cd "$BUILD" && pwd)/kept/$(basename "$0" .sh)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM

tap_ok() {
    tap_count=$((tap_count + 1))
    echo "ok $tap_count - $1"
}

# tap_fail NAME [FILE]: the file's lines say why.
tap_fail() {
    tap_count=$((tap_count + 1))
    echo "not ok $tap_count - $1"
    [ -z "${2:-}" ] || sed 's/^/# /' "$2"
}

# tap_check NAME COMMAND...: passes if the command succeeds; if not, shows how what it printed begins and ends.
tap_check() {
    tap_name=$1
    shift
    if ("$@") >"$work/.said" 2>&1; then
        tap_ok "$tap_name"
    else
        awk '{ line[NR] = $0 }
            END { for (i = 1; i <= NR; i++) if (i <= 20 || i > NR - 20) print line[i] }' "$work/.said" >"$work/.why"
        tap_fail "$tap_name" "$work/.why"
    fi
}

tap_skip() { # NAME REASON
    tap_count=$((tap_count + 1))
    echo "ok $tap_count - $1 # SKIP $2"
}

tap_on_terminal() { # as tap_check, where the command can have a terminal
    if script -qec true /dev/null >/dev/null 2>&1; then
        tap_check "$@"
    else
        tap_skip "$1" "this system has no pseudo-terminals"
    fi
}

tap_done() {
    echo "1..$tap_count"
}
