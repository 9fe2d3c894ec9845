# SPDX-License-Identifier: MIT
#
# The project's own programs draw through a real kernel's spidev, GPIO, hidraw and USB: a User Mode Linux, which runs as
# an ordinary user's process, with the host's files as its root. What went over the wires is played to the emulated
# panels here, and must be the picture that the simulator draws. See tests/kernel/README.md.
. tests/tap.sh

here=tests/kernel

# One reason for the whole suite, as TAP has it in the plan.
skip_all() {
    echo "1..0 # SKIP $*"
    exit 0
}

kernel=$(sh $here/build.sh --path 2>&1) || case $? in
2) skip_all "$kernel" ;;
*)
    echo "$kernel" >"$work/why"
    tap_fail "the tests' kernel builds" "$work/why"
    tap_done
    exit
    ;;
esac
. $here/guests.sh
. $here/pictures.sh
. $here/variants.sh

began_s=$(date +%s)
prepare_stage || exit

for end in well failing crashing early; do
    guest $end usual selftest SELFTEST=$end &
done
wait
if cannot_start well; then skip_all "User Mode Linux does not start here: $(tail -n 1 "$work/well.console")"; fi
tap_check "a guest that ends well is accepted" is_good well
tap_check "a case that fails is noticed" is_bad failing
tap_check "a guest that crashes in the middle is noticed" is_bad crashing
tap_check "a guest that ends before its time is noticed" is_bad early

tap_check "the Linux board's program builds" build_board
guest board usual flight,board FRAMES=8 &
guest libgpiod1 usual display &
guest uhid usual hid BRIDGE=/dev/uhid &
guest hidraw usual hid BRIDGE=/dev/hidg0 &
tap_check "the programs build with hidapi's way by libusb" build_with_libusb
guest libusb libusb hid BRIDGE=/dev/hidg0 &
if libgpiod2=$(sh $here/debian.sh trixie "$(dpkg --print-architecture)" libgpiod3 libgpiod-dev 2>&1); then
    tap_check "the programs build with libgpiod 2" build_with_libgpiod2 "$libgpiod2"
    guest libgpiod2 libgpiod2 display spidev.bufsiz=6000 &
fi
wait

judge_board
judge_display libgpiod1
if [ -e "$work/libgpiod2.status" ]; then
    judge_display libgpiod2
else
    tap_skip "displays through libgpiod 2" "$libgpiod2"
fi
for way in uhid hidraw libusb; do
    judge_bridge $way
done
tap_check "a record with one byte changed is not the picture" falsified libgpiod1
tap_check "a record that is cut short is refused" cut_short libgpiod1

tap_done
echo "# took $(($(date +%s) - began_s)) s, its kernel being built"
