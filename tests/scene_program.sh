# SPDX-License-Identifier: MIT
#
# For test scripts to source: scene_program OUTPUT ARGUMENT... links a program for this machine of all of firmware/, of each
# SOURCE.c among the arguments, and with the other arguments as flags, without a warning. Each is compiled by itself and
# firmware/ as one file, so that a compiler's cache knows again what has not changed.
# shellcheck shell=sh
. tests/one_file.sh

scene_program() { # OUTPUT ARGUMENT...
    program_output=$1 program_flags='' program_objects=''
    shift
    for program_argument; do
        case $program_argument in
        *.c) ;;
        *) program_flags="$program_flags $program_argument" ;;
        esac
    done
    program_firmware=$(one_file) || return 1
    for program_argument in "$@" "$program_firmware"; do
        case $program_argument in
        *.c)
            program_object=$program_output.$(basename "$program_argument" .c).o
            # shellcheck disable=SC2086 # flags are words
            ${CCACHE:-} "${CC:-gcc}" -std=c11 -O1 $WARNINGS $program_flags -Ifirmware "-I$work" -c -o "$program_object" "$program_argument" || return 1
            program_objects="$program_objects $program_object"
            ;;
        esac
    done
    # shellcheck disable=SC2086 # names are words
    "${CC:-gcc}" -o "$program_output" $program_objects
}
