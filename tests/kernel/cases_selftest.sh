# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# What the host must not take for success: see tests/kernel.sh.
tap_check "a case that passes" true
case $SELFTEST in
failing) tap_check "a case that fails" false ;;
crashing) exit 1 ;; # of process 1: the kernel panics
early) exec power_off ;;
esac
