# SPDX-License-Identifier: MIT
#
# The ESP8266's core, which neither divides nor has products of 64 bits, nor reads words that are not aligned: the
# fixed-point vectors in every profile, and frames of every kind of scene, each in one of the profiles (EVERY_PROFILE=yes: in
# all). A caller's bug takes an exception there, too.
. tests/tap.sh
. tests/fixed_on.sh
. tests/cpus/kinds.sh

for tool in xtensa-lx106-elf-gcc qemu-system-xtensa; do
    command -v $tool >/dev/null && continue
    tap_skip "lx106" "needs gcc-xtensa-lx106 and qemu-system-misc: there is no $tool"
    tap_done
    exit
done

# What sim/targets/integers_lx106.c has in place of the compiler's library.
integers_agree() {
    for core in host lx106; do
        target_link $core "$work/integers" tests/targets/integers.c && target_run $core "$work/integers" >"$work/$core.txt" || return 1
    done
    [ "$(sort -u "$work/host.txt" | wc -l)" -eq 400 ] && diff "$work/host.txt" "$work/lx106.txt"
}

takes_an_exception() { # STATEMENT, where words are at at_address
    printf 'static int words[2];\nstatic char *volatile at_address = (char *)words;\nint main(void);\nint main(void) { %s; return 0; }\n' \
        "$1" >"$work/fault.c" &&
        target_link lx106 "$work/fault" "$work/fault.c" || return 1
    target_run lx106 "$work/fault" >"$work/said"
    [ $? -eq 2 ] && grep -q '^fault: ' "$work/said"
}

not_an_exception() {
    ! takes_an_exception "$@" && [ ! -s "$work/said" ]
}

tap_check "products and quotients of 64 and 32 bits are the host's" integers_agree
tap_check "a trap takes an exception" takes_an_exception '__builtin_trap()'
tap_check "so does a word that is not aligned" takes_an_exception '*(volatile int *)(at_address + 1) = 1'
tap_check "and memory that is not there" takes_an_exception '*(volatile int *)(at_address - (unsigned)at_address) = 1'
tap_check "a word that is there does not" not_an_exception '*(volatile int *)(at_address + 4) = 1'
fixed_on lx106
kinds_on lx106 lx106:-Os
tap_done
