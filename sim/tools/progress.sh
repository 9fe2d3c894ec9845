#!/bin/sh
# SPDX-License-Identifier: MIT
#
# How far a first build has come. FILE has a byte for each file that was compiled; N is how many there are to compile, 0:
# whoever compiles a few files again wants no numbers.
#   sh sim/tools/progress.sh begin FILE N          says how many, and about how long
#   sh sim/tools/progress.sh step FILE N WORDS     on a terminal [n/N] and the words; elsewhere a line each half minute
# On a terminal: MAKE_TERMOUT, which make sets, is not empty. PROGRESS_TELL_S: another time than half a minute.
set -u
action=$1 file=$2 all=$3
shift 3
# Of a processor, for an average file: 2 minutes on two processors for `make run` (README.md).
FILE_MS=300

duration() { # SECONDS
    if [ "$1" -lt 90 ]; then echo "$1 seconds"; else echo "$((($1 + 30) / 60)) minutes"; fi
}

begin() {
    [ "$all" -gt 0 ] || return 0
    mkdir -p "$(dirname "$file")"
    : >"$file"
    date +%s >"$file.told"
    processors=$(nproc)
    echo "$all files to compile: about $(duration $((all * FILE_MS / 1000 / processors + 1))) on $processors processors"
}

# The file of times is one line long, and whoever reads it while another writes tells a line more or less.
tell() {
    now_s=$(date +%s) told_s=$(cat "$file.told" 2>/dev/null)
    [ $((now_s - ${told_s:-0})) -ge "${PROGRESS_TELL_S:-30}" ] || [ "$n" -eq "$all" ] || return 0
    echo "$now_s" >"$file.told"
    echo "[$n/$all] files compiled"
}

step() {
    if [ ! -f "$file" ] || [ "$all" -eq 0 ]; then
        echo "$*"
        return
    fi
    printf . >>"$file"
    n=$(wc -c <"$file")
    if [ "$n" -gt "$all" ]; then
        echo "$*" # changed files beside the missing ones
    elif [ -n "${MAKE_TERMOUT:-}" ]; then
        echo "[$n/$all] $*"
    else
        tell
    fi
}

case $action in
begin) begin ;;
step) step "$@" ;;
*) echo "progress.sh: begin or step, not $action" >&2 && exit 1 ;;
esac
