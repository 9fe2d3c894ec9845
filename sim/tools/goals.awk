# SPDX-License-Identifier: MIT
#
# The goals that Makefiles have, files and patterns left out: awk -f sim/tools/goals.awk MAKEFILE...
/^[a-z0-9][a-z0-9 -]*:([^=]|$)/ {
    sub(/:.*/, "")
    print
}
