#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Sees to it that Debian packages are installed: sh sim/tools/setup.sh PACKAGE...
# Says nothing if all are there. Otherwise names the missing ones and the size of the download, and
# installs them with apt: at once as root; for anyone else through sudo, after a yes on a terminal.
# DEPS=no only says what is missing, and fails; DEPS=skip does not look, for systems where the same
# tools come from elsewhere.
# shellcheck disable=SC2086 # $missing is a list of words
set -eu

say() { printf 'setup: %s\n' "$*" >&2; }

fail() {
    say "$*"
    exit 1
}

# The packages among the arguments that are neither installed nor provided by one that is.
missing_of() {
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' 2>/dev/null |
        sed -n 's/^installed //p' | tr ',' '\n' | sed 's/^ *//; s/ .*//')
    for package; do
        printf '%s\n' "$installed" | grep -qxF -- "$package" || echo "$package"
    done
}

# How much apt would download for the arguments; fails if its lists do not know one of them.
download_size() {
    uris=$(apt-get install --print-uris -qq --no-install-recommends "$@" 2>/dev/null) || return 1
    printf '%s\n' "$uris" | awk '{ bytes += $3 } END { printf "%.1f MB", bytes / 1e6 }'
}

apt() { $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 "$@" </dev/null >/dev/null; }

install() { apt install -y --no-remove --no-install-recommends "$@"; }

[ "${DEPS:-}" != skip ] || exit 0
if ! command -v dpkg-query >/dev/null; then
    say "this is not Debian, so nothing is checked; Debian's names of what is needed: $*"
    exit 0
fi
missing=$(missing_of "$@" | paste -sd ' ')
[ -n "$missing" ] || exit 0

as_root=
[ "$(id -u)" = 0 ] || as_root=sudo
by_hand="to install them${as_root:+, as root}: apt-get install --no-install-recommends $missing"
if ! size=$(download_size $missing); then
    size='size not known before apt-get update'
    if [ -z "$as_root" ] && [ "${DEPS:-}" != no ]; then
        say "fetching apt's package lists"
        apt update || fail "apt-get update failed"
        size=$(download_size $missing) || fail "apt does not offer all of: $missing"
    fi
fi
say "missing packages: $missing (to download: $size)"

[ "${DEPS:-}" != no ] || fail "DEPS=no, so nothing is installed; $by_hand"
if [ -n "$as_root" ]; then
    command -v sudo >/dev/null || fail "only root may install packages, and there is no sudo here; $by_hand"
    { [ -t 0 ] && [ -t 2 ]; } || fail "no terminal to ask for a yes; $by_hand"
    printf 'setup: install them now, through sudo? [y/N] ' >&2
    read -r answer || answer=
    case $answer in
    [yY] | [yY][eE][sS]) ;;
    *) fail "nothing is installed; $by_hand" ;;
    esac
fi

say "installing; this takes a minute or two"
if ! install $missing; then
    say "trying again with fresh package lists"
    { apt update && install $missing; } || fail "apt could not install them; $by_hand"
fi
say "done"
