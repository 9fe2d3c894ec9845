#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Process 1 of the tests' kernel: mounts what the cases want, runs those named in $CASES as the kernel's command line
# has it, and ends the kernel. The root is the host's own, read-only; in $RESULTS, the one place that can be written,
# it leaves guest.tap and the records of the wires. $STAGE is the folder that tests/kernel.sh made, and
# $STAGE/$PROGRAMS what it built for this guest.
set -u
export PATH="$STAGE/$PROGRAMS:$STAGE:/usr/sbin:/usr/bin:/sbin:/bin" HOME=/ TMPDIR="$RESULTS"

mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs devtmpfs /dev
mount -t configfs configfs /sys/kernel/config
mount -t tmpfs tmpfs /run
mount -t hostfs -o "$TMPDIR" hostfs "$TMPDIR"
cd "$TMPDIR" || exit
exec >guest.tap 2>guest.err

export BUILD=- WARNINGS=- # which the script below insists on
. "$STAGE/tap.sh"
. "$STAGE/in_guest.sh"
for cases in $(echo "$CASES" | tr , ' '); do
    . "$STAGE/cases_$cases.sh"
done
tap_done
exec power_off
