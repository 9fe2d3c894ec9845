#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Does what README tells a newcomer, on a bare Debian 12, and writes megabytes and minutes into README: `make first-hour`, as
# root. The machine is a folder that debootstrap makes anew, without sudo and without /proc; the sources are those of git's
# last commit. Sizes are apt's own figures. HOURS=no: sizes alone, which takes minutes and installs nothing.
# MIRROR: where Debian comes from.
set -eu

mirror=${MIRROR:-http://deb.debian.org/debian}
work=$(mktemp -d)
root=$work/debian
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM

fail() {
    echo "first-hour: $*" >&2
    exit 1
}

[ "$(id -u)" = 0 ] || fail "only root may make a Debian in a folder"
command -v debootstrap >/dev/null || fail "debootstrap is not there; Debian's package debootstrap"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }

# sizes PACKAGE...: megabytes to download and kilobytes installed, of what apt would add.
sizes() {
    inside apt-get install --no-install-recommends --print-uris -qq "$@" >"$work/uris"
    sed "s/^'[^']*' \([^_]*\)_.*/\1/" "$work/uris" | sort -u >"$work/names"
    # shellcheck disable=SC2046 # names are words
    inside apt-cache show --no-all-versions $(cat "$work/names") | awk '/^Installed-Size: / { kb += $2 } END { printf "%d ", kb / 1000 }' >"$work/installed"
    awk '{ bytes += $3 } END { printf "%.0f ", bytes / 1e6 }' "$work/uris"
    cat "$work/installed"
}

# What make would install, by its own lists: of `make run`, and of `make test`.
packages_of() { # 1|2
    printf 'include Makefile\n$(info make $(packages-build))\n$(info make $(packages-build) ccache $(packages-host) $(packages-arm))\n' |
        make -s -n DEPS=skip -f - help | sed -n "$1p"
}

minutes_of() { # GOAL: in the folder, as README has it
    begin_s=$(date +%s)
    inside make -C /limner "$1" >"$work/said" 2>&1 || { tail -n 20 "$work/said" >&2; fail "make $1 failed"; }
    echo $((($(date +%s) - begin_s + 30) / 60))
}

# write NAME VALUE: into README, where it says <!-- NAME -->VALUE<!-- -->.
write() {
    grep -q "<!-- $1 -->[^<]*<!-- -->" README.md || fail "README.md has no place for $1"
    sed "s/\(<!-- $1 -->\)[^<]*\(<!-- -->\)/\1$2\2/" README.md >"$work/README" && cat "$work/README" >README.md
    echo "$1: $2"
}

debootstrap --variant=minbase bookworm "$root" "$mirror" >"$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; fail "debootstrap failed"; }
inside apt-get update -qq

# shellcheck disable=SC2046 # names are words
set -- $(sizes $(packages_of 1))
write run-mb "$1"
write run-installed-mb "$2"
run_mb=$1
# shellcheck disable=SC2046
set -- $(sizes $(packages_of 2))
write test-mb "$(($1 - run_mb))"
write all-installed-mb "$2"
[ "${HOURS-yes}" != no ] || exit 0

mkdir "$root/limner"
git archive HEAD | tar -x -C "$root/limner"
inside apt-get install -y -qq make >"$work/log" 2>&1
write cores "$(nproc)"
# Each by itself: what fails ends the script before anything is written.
run_minutes=$(minutes_of run)
write run-minutes "$run_minutes"
test_minutes=$(minutes_of test)
write test-minutes "$test_minutes"
