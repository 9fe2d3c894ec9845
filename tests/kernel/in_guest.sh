# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# What several cases want in a guest: the record of the wires, and programs that refuse.

# keep NAME: what was recorded since the last time, as NAME.wires.
keep() { dd if=/dev/wire_tap of="$1.wires" bs=1M iflag=nonblock 2>"$1.dd"; }
forget() { dd if=/dev/wire_tap of=/dev/null bs=1M iflag=nonblock 2>/dev/null; }

# refuse PATTERN COMMAND...: it fails with one line on stderr that matches.
refuse() {
    pattern=$1
    shift
    "$@" 2>said
    status=$?
    cat said
    [ $status = 1 ] && [ "$(wc -l <said)" = 1 ] && grep -qE -- "$pattern" said
}
