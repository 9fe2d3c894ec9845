# SPDX-License-Identifier: MIT
#
# sim/MEASURED.md says what the program measures: `make tables` would change nothing.
. tests/tap.sh

tap_check "the table in sim/MEASURED.md is what is measured now" sh sim/tools/tables.sh --check
tap_done
