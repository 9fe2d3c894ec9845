# SPDX-License-Identifier: MIT
#
# The renderer of a profile with other sub-pixel bits than its own, as a shared object that `limner measure` loads. From
# the project's folder:
#   sh sim/targets/core.sh NAME FOLDER        fast_4: FOLDER/core_fast_4.so, profile fast with 4 bits
# Flags are the Makefile's for its cores, and what a shared object needs.
set -eu

name=$1 folder=$2
objects=$folder/$name.objects
profile=$(echo "${name%_*}" | tr '[:lower:]' '[:upper:]')
flags="-std=c11 -O2 -Wall -ffp-contract=off -fPIC -Ifirmware -Isim -DCORE=core_$name -DLIM_PROFILE=LIM_PROFILE_$profile
    -DLIM_SUB_BITS=${name##*_}"

mkdir -p "$objects"
: "${CC:=gcc}" "${CCACHE=}"
export CC CCACHE flags objects
# The first error is what whoever called shows.
failed() {
    grep -m 1 'error' "$folder/said" >&2 || tail -n 1 "$folder/said" >&2
    exit 1
}

# shellcheck disable=SC2016 # the inner shell's
printf '%s\n' firmware/*.c firmware/*/*.c sim/core/core.c | xargs -n 1 -P "$(nproc)" sh -c '
    $CCACHE $CC $flags -c -o "$objects/$(basename "$1" .c).o" "$1" || exit 255' sh 2>"$folder/said" || failed
$CC -shared -Wl,-Bsymbolic -o "$folder/core_$name.so" "$objects"/*.o 2>"$folder/said" || failed
rm -r "$objects"
