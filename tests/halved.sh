# SPDX-License-Identifier: MIT
#
# For test scripts to source: halved NAME... and quartered NAME...: every second or fourth one, a line each; which of them
# $SEED says, others with each commit. SEED=0 to SEED=3 name them, SEED=all has all.
# shellcheck shell=sh

: "${SEED:=$(printf '%d' "0x$(git rev-parse --short=6 HEAD 2>/dev/null || echo 0)")}"

part_of() { # OF NAME...
    part_count=$1
    shift
    printf '%s\n' "$@" | awk -v seed="$SEED" -v of="$part_count" 'seed == "all" || (NR + seed) % of == 0'
}
halved() { part_of 2 "$@"; }
quartered() { part_of 4 "$@"; }
