/* SPDX-License-Identifier: MIT
 *
 * What right shifts and masks by constants are, in terms of division (WP leaves shifts of negative numbers
 * open; fixed.h asserts that the compiler's are these), and what a quotient is, in terms of its dividend. */
#ifndef TESTS_PROVE_SHIFTS_H
#define TESTS_PROVE_SHIFTS_H

#include <stdint.h>

/*@ axiomatic shifts {
      axiom right_1: \forall integer x; (x >> 1) * 2 <= x < (x >> 1) * 2 + 2;
      axiom right_2: \forall integer x; (x >> 2) * 4 <= x < (x >> 2) * 4 + 4;
      axiom right_3: \forall integer x; (x >> 3) * 8 <= x < (x >> 3) * 8 + 8;
      axiom right_4: \forall integer x; (x >> 4) * 16 <= x < (x >> 4) * 16 + 16;
      axiom right_5: \forall integer x; (x >> 5) * 32 <= x < (x >> 5) * 32 + 32;
      axiom right_6: \forall integer x; (x >> 6) * 64 <= x < (x >> 6) * 64 + 64;
      axiom right_7: \forall integer x; (x >> 7) * 128 <= x < (x >> 7) * 128 + 128;
      axiom right_8: \forall integer x; (x >> 8) * 256 <= x < (x >> 8) * 256 + 256;
      axiom right_9: \forall integer x; (x >> 9) * 512 <= x < (x >> 9) * 512 + 512;
      axiom right_10: \forall integer x; (x >> 10) * 1024 <= x < (x >> 10) * 1024 + 1024;
      axiom right_11: \forall integer x; (x >> 11) * 2048 <= x < (x >> 11) * 2048 + 2048;
      axiom right_12: \forall integer x; (x >> 12) * 4096 <= x < (x >> 12) * 4096 + 4096;
      axiom right_13: \forall integer x; (x >> 13) * 8192 <= x < (x >> 13) * 8192 + 8192;
      axiom right_14: \forall integer x; (x >> 14) * 16384 <= x < (x >> 14) * 16384 + 16384;
      axiom right_15: \forall integer x; (x >> 15) * 32768 <= x < (x >> 15) * 32768 + 32768;
      axiom right_16: \forall integer x; (x >> 16) * 65536 <= x < (x >> 16) * 65536 + 65536;
      axiom right_20: \forall integer x; (x >> 20) * 1048576 <= x < (x >> 20) * 1048576 + 1048576;
      axiom right_24: \forall integer x; (x >> 24) * 16777216 <= x < (x >> 24) * 16777216 + 16777216;
      axiom right_28: \forall integer x; (x >> 28) * 268435456 <= x < (x >> 28) * 268435456 + 268435456;
      axiom right_30: \forall integer x; (x >> 30) * 1073741824 <= x < (x >> 30) * 1073741824 + 1073741824;
      axiom right_31: \forall integer x; (x >> 31) * 2147483648 <= x < (x >> 31) * 2147483648 + 2147483648;
      axiom right_32: \forall integer x; (x >> 32) * 4294967296 <= x < (x >> 32) * 4294967296 + 4294967296;
      axiom low_7: \forall integer x; x == (x >> 7) * 128 + (x & 127);
      axiom low_8: \forall integer x; x == (x >> 8) * 256 + (x & 255);
      axiom low_9: \forall integer x; x == (x >> 9) * 512 + (x & 511);
      axiom low_10: \forall integer x; x == (x >> 10) * 1024 + (x & 1023);
      axiom low_11: \forall integer x; x == (x >> 11) * 2048 + (x & 2047);
      axiom low_12: \forall integer x; x == (x >> 12) * 4096 + (x & 4095);
      axiom low_16: \forall integer x; x == (x >> 16) * 65536 + (x & 65535);
      axiom low_30: \forall integer x; x == (x >> 30) * 1073741824 + (x & 1073741823);
      axiom quotient_up: \forall integer a, b; b >= 1 && a >= 0 ==> 0 <= a / b <= a;
      axiom quotient_down: \forall integer a, b; b >= 1 && a <= 0 ==> a <= a / b <= 0;
    } */

#endif
