#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Installs the host program, or takes it away again: sh sim/tools/install.sh install|uninstall. BUILD is the Makefile's; PREFIX,
# an absolute path, is where (/usr/local); DESTDIR comes before it, for whoever makes a package. What was put there, and which
# folders had to be made, is listed in PREFIX/share/limner/installed; uninstalling takes these away, and folders only if they
# are empty. Nothing else is touched. An installation that fails leaves what was there before.
set -eu

fail() {
    echo "install: $*" >&2
    exit 1
}

prefix=${PREFIX-/usr/local}
root=${DESTDIR-}
case $prefix in
/*) ;;
*) fail "PREFIX=$prefix: must be an absolute path" ;;
esac
case $root in
'' | /*) ;;
*) fail "DESTDIR=$root: must be an absolute path" ;;
esac
[ "$prefix" = / ] && prefix=
root=${root%/}
list=$prefix/share/limner/installed
man=$prefix/share/man/man1/limner.1
completion=$prefix/share/bash-completion/completions/limner
documents=$prefix/share/doc/limner

# Folders are listed before what is in them.
make_folder() { # FOLDER, without DESTDIR
    [ -n "$1" ] && [ "$1" != / ] && [ ! -d "$root$1" ] || return 0
    make_folder "${1%/*}"
    mkdir "$root$1"
    echo "d $1" >>"$work/folders"
}

# put MODE TARGET: standard input is to become that file; until all are there it is TARGET.new.
put() {
    [ ! -d "$root$2" ] || fail "$root$2: is a folder"
    make_folder "${2%/*}"
    echo "f $2" >>"$work/files"
    cat >"$root$2.new"
    chmod "$1" "$root$2.new"
}

paths() { sed -n "s/^$1 //p" "$2"; } # d|f LIST

# Those of a list, the last first.
take_away() { # LIST
    sed -n '1!G; h; $p' "$1" >"$work/back"
    paths f "$work/back" | while IFS= read -r file; do rm -f "$root$file"; done
    paths d "$work/back" | while IFS= read -r folder; do
        [ ! -d "$root$folder" ] || rmdir "$root$folder" 2>/dev/null || true
    done
}

# What an installation that failed has left: whatever has its name already is in the list.
undo() {
    sed 's/^f .*/&.new/' "$work/folders" "$work/files" >"$work/undone"
    take_away "$work/undone"
}

# What is there already, of an older version.
read_old() {
    : >"$work/old"
    [ ! -f "$root$list" ] || cat "$root$list" >"$work/old"
    paths d "$work/old" | while IFS= read -r folder; do [ ! -d "$root$folder" ] || echo "d $folder"; done >"$work/old_folders"
}

# All files are there as NAME.new before the first takes its place, and until the last has, the list names the older
# version's, too. It is the last that is taken away.
install() {
    "$BUILD/limner" help --man >"$work/man"
    "$BUILD/limner" help --bash-completion >"$work/completion"
    read_old
    [ -z "$root" ] || mkdir -p "$root"
    trap 'undo || true; rm -rf "$work"' EXIT
    put 644 "$list" </dev/null
    put 755 "$prefix/bin/limner" <"$BUILD/limner"
    put 644 "$man" <"$work/man"
    put 644 "$completion" <"$work/completion"
    for document in README.md CHANGELOG.md LICENSE; do put 644 "$documents/$document" <"$document"; done
    cat "$work/old_folders" "$work/folders" "$work/files" >"$root$list.new"
    grep -vxF -f "$root$list.new" "$work/old" >"$work/gone" || true
    cat "$root$list.new" "$work/gone" >"$work/both"
    put 644 "$list.both" <"$work/both"
    mv -f "$root$list.both.new" "$root$list"
    paths f "$root$list.new" | while IFS= read -r file; do [ "$file" = "$list" ] || mv -f "$root$file.new" "$root$file"; done
    cat "$work/old_folders" "$work/gone" >"$work/unused"
    take_away "$work/unused"
    mv -f "$root$list.new" "$root$list"
    trap 'rm -rf "$work"' EXIT
    echo "install: $root$prefix/bin/limner, limner(1), completion for bash; make uninstall takes them away"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
: >"$work/folders"
: >"$work/files"
case ${1-} in
install) install ;;
uninstall)
    [ -f "$root$list" ] || fail "$root$prefix: Limner is not installed there: no $root$list"
    cat "$root$list" >"$work/old"
    take_away "$work/old"
    echo "install: taken away from $root$prefix"
    ;;
*) fail "install or uninstall, not '${1-}'" ;;
esac
