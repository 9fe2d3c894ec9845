# SPDX-License-Identifier: MIT
#
# For test scripts to source: part_of N NAME... prints every Nth name, a line each; which of them $SEED says, others with
# each commit. SEED=0 to SEED=N-1 name them, SEED=all has all.
# shellcheck shell=sh

: "${SEED:=$(printf '%d' "0x$(git rev-parse --short=6 HEAD 2>/dev/null || echo 0)")}"

part_of() { # N NAME...
    part_count=$1
    shift
    printf '%s\n' "$@" | awk -v seed="$SEED" -v of="$part_count" 'seed == "all" || (NR + seed) % of == 0'
}
