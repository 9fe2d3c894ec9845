# SPDX-License-Identifier: MIT
#
# For the scripts of this folder to source, behind tap.sh: compiling for the fakes of the libraries, in C and in C++. The
# renderer is the tests' own, with all features, whatever a scene's header says. Without a cache, which would not see that
# a broken header takes the place of another one.
# shellcheck shell=sh disable=SC2154 # $work is tap.sh's

limner=$BUILD/limner
case ${CC:-gcc} in
*clang*) CXX=clang++ ;;
*) CXX=g++ ;;
esac
places="-I$work/broken -I$work -Ifirmware -Ihal -Ihal/adapters -Iboards/common -Itests/adapters/fakes -Itests/adapters -DSCREEN_STREAMS=1"
mkdir -p "$work/broken"

in_c() { # SOURCE OBJECT FLAG...
    source=$1 object=$2
    shift 2
    # shellcheck disable=SC2086 # flags are words
    "${CC:-gcc}" -std=c11 -O1 $WARNINGS $places "$@" -c -o "$object" "$source"
}

in_cplusplus() { # SOURCE OBJECT FLAG...
    source=$1 object=$2
    shift 2
    # shellcheck disable=SC2086
    $CXX -x c++ -std=c++11 -O1 -Wall -Wextra -Wconversion -Wundef -Werror $places "$@" -c -o "$object" "$source"
}

fakes_compile() { # NAME...
    for fake; do
        in_c "tests/adapters/fakes/$fake.c" "$work/$fake.o" || return 1
    done
}

link_frames() { # PROGRAM OBJECT...
    $CXX -o "$@" "$BUILD/host/liblimner.a"
}

compile_scene() { # MODEL SIZE
    rm -f "$work"/model*
    "$limner" compile "$1" --size "$2" -o "$work/model" >"$work/compiled" || return 1
    for part in "$work"/model*.c; do
        in_c "$part" "${part%.c}.o" -include limner.h || return 1
    done
}

# A header with something wrong in it, by sed; the others beside it, as they may include it.
break_header() { # HEADER EXPRESSION
    cp hal/adapters/*.h "$work/broken/"
    sed -e "$2" "hal/adapters/$1" >"$work/broken/$1"
    ! cmp -s "hal/adapters/$1" "$work/broken/$1"
}

mend_headers() { rm -f "$work"/broken/*; }

has_cplusplus() { command -v $CXX >/dev/null; }
