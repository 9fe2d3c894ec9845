# SPDX-License-Identifier: MIT
#
# Builds sim/tools/doom_view.c with Doom's own renderer: sh sim/tools/doom.sh PROGRAM. Its sources are those of Debian's package
# chocolate-doom. apt fetches and checks them from where the system's packages come from, by a list of sources and a state of its own: the
# system's stay as they are. They lie outside of the project, for the next clone as well; nothing of them enters it. SDL's place is taken by a
# few lines, as nothing is shown.
# -O2, as for all that is counted here.
set -eu

program=$1
version='3.0.1+really3.0.0+git1471-1'
folder=${XDG_CACHE_HOME:-$HOME/.cache}/limner/chocolate-doom-$version
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    printf 'doom: %s\n' "$*" >&2
    exit 1
}

apt() {
    apt-get -qq -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::State::lists="$work/lists" \
        -o Dir::Cache="$work/cache" -o APT::Sandbox::User= "$@" >&2
}

fetch() {
    command -v apt-get >/dev/null || fail "chocolate-doom's sources come from Debian, by apt-get, which is not here"
    mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/source" "$(dirname "$folder")"
    place=$(apt-get indextargets --format '$(REPO_URI)' 'Codename: bookworm' 'Component: main' | head -n 1)
    [ -n "$place" ] || fail "apt knows no place that has Debian 12's packages"
    echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $place bookworm main" >"$work/sources.list"
    apt update || fail "the list of Debian's sources cannot be fetched"
    (cd "$work" && apt source --download-only "chocolate-doom=$version") || fail "chocolate-doom $version cannot be fetched"
    tar xzf "$work/chocolate-doom_${version%-*}.orig.tar.gz" -C "$work/source" --strip-components=1
    mv -T "$work/source" "$folder" 2>/dev/null || [ -e "$folder/src/doom/r_main.c" ] || fail "$folder: cannot be put in place"
}

# What cmake would find out, and of SDL what the headers of the game ask for. All processors here are little-endian.
write_headers() {
    cat >"$work/config.h" <<'END'
#define PACKAGE_NAME "Chocolate Doom"
#define PACKAGE_TARNAME "chocolate-doom"
#define PACKAGE_VERSION "3.0.1"
#define PACKAGE_STRING "Chocolate Doom 3.0.1"
#define PROGRAM_PREFIX "chocolate-"
#define HAVE_DIRENT_H 1
#define HAVE_DECL_STRCASECMP 1
#define HAVE_DECL_STRNCASECMP 1
END
    cat >"$work/SDL_endian.h" <<'END'
enum { SDL_LIL_ENDIAN = 1234, SDL_BIG_ENDIAN = 4321, SDL_BYTEORDER = SDL_LIL_ENDIAN };
#define SDL_SwapLE16(x) (x)
#define SDL_SwapLE32(x) (x)
END
    echo 'typedef union { int type; } SDL_Event;' >"$work/SDL.h"
}

# The game but for its sounds, and of what lies below it what maps and pictures need. What else these name is never called.
build() {
    set -- "$here/doom_view.c"
    for file in "$folder"/src/doom/*.c; do
        [ "${file##*/}" = s_sound.c ] || set -- "$@" "$file"
    done
    for name in d_mode deh_str m_bbox m_fixed m_misc tables w_file w_file_stdc w_wad z_zone; do
        set -- "$@" "$folder/src/$name.c"
    done
    mkdir -p "$(dirname "$program")"
    "${CC:-gcc}" -O2 -g -w -no-pie -ffunction-sections -fdata-sections -Wl,--gc-sections -Wl,--unresolved-symbols=ignore-all -I"$work" \
        -I"$folder/src" -I"$folder/src/doom" -o "$program" "$@" -lm || fail "chocolate-doom's renderer cannot be built"
}

[ -e "$folder/src/doom/r_main.c" ] || fetch
write_headers
build
