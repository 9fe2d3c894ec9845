# SPDX-License-Identifier: MIT
#
# README says what the program measures: `make tables` would change nothing.
. tests/tap.sh

tap_check "the table in README is what is measured now" sh sim/tools/tables.sh --check
tap_done
