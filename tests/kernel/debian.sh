#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Fetches packages of another Debian release or architecture and prints the folder into which they are unpacked; nothing
# is installed. They come, checked by apt, from the mirror that this system uses already, and stay in the user's cache.
#   sh tests/kernel/debian.sh RELEASE ARCHITECTURE PACKAGE[=PATTERN[,PATTERN]]...
# PATTERN: of all its files only these, for tar. linux-image-ARCHITECTURE stands for the newest kernel.
# Status 2: they cannot be had, and why.
set -eu

cache=${XDG_CACHE_HOME:-$HOME/.cache}/limner
keys=/usr/share/keyrings/debian-archive-keyring.gpg
release=$1 architecture=$2
folder=$cache/debian-$release-$architecture-$(echo "$*" | cat - "$0" | sha256sum | cut -c1-8)
shift 2

cannot() {
    echo "$1"
    exit 2
}

# Of several archives the one that holds this system's release itself.
mirror() {
    codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
    # shellcheck disable=SC2016 # apt's own variables
    apt-get indextargets --format '$(CODENAME) $(REPO_URI)' 'Created-By: Packages' |
        awk -v release="$codename" '$1 == release { print $2; exit }'
}

# An apt of its own: other lists, no packages installed.
write_configuration() { # FOLDER MIRROR
    mkdir -p "$1/state/lists/partial" "$1/cache/archives/partial" "$1/etc/apt.conf.d" "$1/etc/preferences.d"
    : >"$1/state/status"
    echo "deb [signed-by=$keys] $2 $release main" >"$1/etc/sources.list"
    cat >"$1/apt.conf" <<EOF2
Dir::State "$1/state";
Dir::State::status "$1/state/status";
Dir::Cache "$1/cache";
Dir::Etc "$1/etc";
Dir::Etc::sourcelist "$1/etc/sources.list";
Dir::Etc::sourceparts "-";
APT::Architecture "$architecture";
APT::Architectures { "$architecture"; };
APT::Sandbox::User "";
Acquire::Languages "none";
Acquire::Retries "1";
Acquire::http::Timeout "20";
EOF2
}

# What a package's name stands for.
resolve() {
    case $1 in
    linux-image-*) apt-cache depends "$1" | sed -n 's/.*Depends: \(linux-image-[0-9].*\)/\1/p' ;;
    *) echo "$1" ;;
    esac
}

fetch() { # FOLDER PACKAGE[=PATTERNS]...
    export APT_CONFIG="$1/apt.conf"
    cd "$1" && mkdir root && apt-get -qq update || return 1
    shift
    for package; do
        # shellcheck disable=SC2086 # a list
        patterns=$(echo "${package#"${package%%=*}"}" | tr '=,' '  ')
        apt-get -qq download "$(resolve "${package%%=*}")" &&
            (set -f && dpkg-deb --fsys-tarfile "$(find . -name '*.deb')" | tar x -C root --wildcards $patterns) &&
            rm ./*.deb || return 1
    done
}

if [ ! -d "$folder" ]; then
    command -v apt-get >/dev/null || cannot "Debian's packages come through apt, which is not here"
    from=$(mirror)
    [ -n "$from" ] || cannot "apt knows no mirror to fetch Debian's packages from"
    mkdir -p "$cache"
    work=$(mktemp -d "$cache/fetching-XXXXXX")
    trap 'rm -rf "$work"' EXIT
    trap 'exit 1' INT TERM
    write_configuration "$work" "$from"
    (fetch "$work" "$@") >"$work/log" 2>&1 ||
        cannot "Debian $release's packages cannot be fetched: $(grep -m 1 '^E:' "$work/log" || tail -n 1 "$work/log")"
    mv "$work/root" "$folder"
fi
echo "$folder"
