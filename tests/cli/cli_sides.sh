# SPDX-License-Identifier: MIT
#
# A display with a longer side than the scene was compiled for is refused when the firmware is compiled, in C and in C++, with
# a framebuffer and without, in words that say what to do.
. tests/tap.sh

wanted='a side of this display is 0, or longer than what the scene was compiled for: limner compile --size WxH'

compiles() { # HEADER LANGUAGE W H
    printf '#include "%s.h"\nSOLID_MEMORY(%s, %s);\nint main(void) { return solid_memory.w_px == 0; }\n' solid "$3" "$4" >"$work/main.$2"
    case $2 in c) compiler="$CC -std=c11" ;; *) compiler="g++ -std=c++11" ;; esac
    # shellcheck disable=SC2086 # flags are words
    $compiler -fsyntax-only -Wall -Wextra -Werror -Ifirmware -I"$work/$1" "$work/main.$2" >"$work/said" 2>&1
}
takes() { compiles "$@" || { cat "$work/said" && return 1; }; }
refuses() { ! compiles "$@" && cat "$work/said" && grep -qF "$wanted" "$work/said"; }

mkdir "$work/lines" "$work/whole" "$work/wide"
for way in 'lines --size 240x240' 'whole --size 240x240 --framebuffer' 'wide --size 320x240'; do
    # shellcheck disable=SC2086 # arguments are words
    set -- $way
    folder=$1
    shift
    tap_check "$folder: compiled" "$BUILD/limner" compile sim/scenes/icosahedron.obj "$@" -o "$work/$folder/solid"
done
for language in c cc; do
    if [ $language = cc ] && ! command -v g++ >/dev/null; then
        tap_skip "the same in C++" "g++ is not installed"
        continue
    fi
    for folder in lines whole; do
        tap_check "$folder, $language: 240x240" takes $folder $language 240 240
        tap_check "$folder, $language: less" takes $folder $language 200 100
        for size in '320 240' '240 320' '241 8' '0 240' '240 0'; do
            # shellcheck disable=SC2086 # a width and a height
            tap_check "$folder, $language: not $size" refuses $folder $language $size
        done
    done
    tap_check "$language: 320x240 where it was compiled for that, either way round" takes wide $language 320 240
    tap_check "$language: 240x320" takes wide $language 240 320
    tap_check "$language: no longer side" refuses wide $language 321 240
done
tap_done
