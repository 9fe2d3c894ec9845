#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Installs the host program, or takes it away again: sh sim/tools/install.sh install|uninstall. BUILD is the Makefile's; PREFIX,
# an absolute path, is where (/usr/local); DESTDIR comes before it, for whoever makes a package. What was put there, and which
# folders had to be made, is listed in PREFIX/share/limner/installed; uninstalling takes these away, and folders only if they
# are empty. Nothing else is touched.
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
    folders="$folders
d $1"
}

# put MODE TARGET: standard input becomes that file, whole or not at all.
put() {
    make_folder "${2%/*}"
    cat >"$root$2.new"
    chmod "$1" "$root$2.new"
    mv -f "$root$2.new" "$root$2"
    files="$files
f $2"
}

# Those of the list, the last first.
take_away() {
    [ -f "$root$list" ] || return 0
    sed -n '1!G; h; $p' "$root$list" >"$work/back"
    sed -n 's/^f //p' "$work/back" | while IFS= read -r file; do rm -f "$root$file"; done
    sed -n 's/^d //p' "$work/back" | while IFS= read -r folder; do
        [ ! -d "$root$folder" ] || rmdir "$root$folder" 2>/dev/null || true
    done
}

install() {
    "$BUILD/limner" help --man >"$work/man"
    "$BUILD/limner" help --bash-completion >"$work/completion"
    take_away
    [ -z "$root" ] || mkdir -p "$root"
    put 755 "$prefix/bin/limner" <"$BUILD/limner"
    put 644 "$man" <"$work/man"
    put 644 "$completion" <"$work/completion"
    for document in README.md CHANGELOG.md LICENSE; do put 644 "$documents/$document" <"$document"; done
    make_folder "${list%/*}"
    printf '%s\n' "${folders#?}" "${files#?}" "f $list" | sed '/^$/d' >"$root$list"
    echo "install: $root$prefix/bin/limner, limner(1), completion for bash; make uninstall takes them away"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
folders='' files=''
case ${1-} in
install) install ;;
uninstall)
    [ -f "$root$list" ] || fail "$root$prefix: Limner is not installed there: no $root$list"
    take_away
    echo "install: taken away from $root$prefix"
    ;;
*) fail "install or uninstall, not '${1-}'" ;;
esac
