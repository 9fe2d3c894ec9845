#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Builds the kernel that tests/kernel.sh runs: User Mode Linux from Debian's sources, with the display's wires tapped.
#   sh tests/kernel/build.sh          builds it unless it is there
#   sh tests/kernel/build.sh --path   only says where it is; fails, with the reason, if it is not
# It lies in the user's cache, named by what it was made of: the package's version, the configuration, the tap and how
# all that is compiled. A build that fails leaves its log there, and is not tried again until one of these changes or the
# log is removed.
# Status 2: this machine cannot build it.
set -eu

package=linux-source-6.1
archive=/usr/src/$package.tar.xz
here=$(cd "$(dirname "$0")" && pwd)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/limner

cannot() {
    echo "$1"
    exit 2
}

key() {
    {
        dpkg-query -W -f '${Version}\n' "$package"
        sed -n '/^compile()/,/^}/p' "$here/build.sh"
        cat "$here/uml.config" "$here"/wire_*.[ch]
    } | sha256sum | cut -c1-16
}

# One line that grows, if descriptor 3 is a terminal.
show_progress() {
    awk -v live="$([ -t 3 ] && echo 1)" '
        live && /^ +(CC|AR|LD|AS) / { printf "\rkernel: %d files", ++files > "/dev/fd/3" }
        END { if (files) printf "\r\033[K" > "/dev/fd/3" }'
}

# As in any kernel tree; the tap becomes one of its drivers. User Mode Linux has room for 2696 bytes of a program's
# vector registers: processors with AMX have 11 kB, and want all of them set or none.
compile() { # FOLDER
    tar xf "$archive" -C "$1" --strip-components=1 &&
        sed -i '/HOST_FP_SIZE/s/2696/12288/' "$1/arch/x86/um/user-offsets.c" &&
        cp "$here"/wire_*.[ch] "$1/drivers/spi/" &&
        echo 'obj-y += wire_tap.o wire_display.o' >>"$1/drivers/spi/Makefile" &&
        make -C "$1" ARCH=um KCONFIG_ALLCONFIG="$here/uml.config" allnoconfig &&
        { make -C "$1" ARCH=um -j"$(nproc)" linux 2>&1 | tee -a "$1/log" | show_progress; } &&
        strip -o "$1/stripped" "$1/linux"
}

build() {
    mkdir -p "$cache"
    tree=$(mktemp -d "$cache/building-XXXXXX")
    trap 'rm -rf "$tree"' EXIT
    trap 'exit 1' INT TERM
    began_s=$(date +%s)
    echo "kernel: building User Mode Linux into $cache; takes 2 to 4 minutes, once" >&2
    if ! compile "$tree" 3>&2 >>"$tree/log" 2>&1; then
        mv "$tree/log" "$kernel.failed"
        echo "kernel: it does not build, see $kernel.failed" >&2
        exit 1
    fi
    mv "$tree/stripped" "$kernel"
    echo "kernel: built in $(($(date +%s) - began_s)) s" >&2
}

[ "$(uname -sm)" = "Linux x86_64" ] || cannot "User Mode Linux runs on Linux on x86-64 alone"
[ -r "$archive" ] || cannot "Debian's package $package is not installed"
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES CC BUILD WARNINGS
kernel=$cache/uml-$(key)
if [ -x "$kernel" ]; then
    [ "${1:-}" != --path ] || echo "$kernel"
elif [ -e "$kernel.failed" ]; then
    tail -n 20 "$kernel.failed"
    exit 1
else
    for tool in gcc make flex bison bc xz; do
        command -v $tool >/dev/null || cannot "$tool is not installed, which a kernel's build takes"
    done
    [ "${1:-}" != --path ] || cannot "the tests' kernel is not built: sh tests/kernel/build.sh"
    build
fi
