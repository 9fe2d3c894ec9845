# SPDX-License-Identifier: MIT
#
# For tests of exported folders to source: what they draw is compared with `limner render`. Nothing of the project's
# sources is on a compiler's path but the tests' own programs.
# shellcheck shell=sh

# The programs' cameras.h includes the renderer's header by the name that it has in the project.
exported_names() { # FOLDER: names of the project that the tests' programs know
    mkdir -p "$1"
    echo '#include "limner.h"' >"$1/camera.h"
    echo '#include "limner_display.h"' >"$1/board.h"
}

# exported_expected FOLDER MODEL CAMERAS|- RENDER-OPTION...: cameras.h of eight cameras, and the hashes of their frames.
exported_expected() {
    exported_to=$1 exported_model=$2 exported_cameras=$3
    shift 3
    mkdir -p "$exported_to"
    case $exported_cameras in
    -) set -- --frames 8 "$@" ;;
    *)
        awk '!/^#/ && NF && n++ % 5 == 0' "$exported_cameras" | head -n 8 >"$exported_to/few.cam"
        set -- --camera "$exported_to/few.cam" "$@"
        ;;
    esac
    "$BUILD/limner" render "$exported_model" "$@" --write-hashes "$exported_to/expected" --write-cameras "$exported_to/cameras.h"
}
