/* SPDX-License-Identifier: MIT
 *
 * The emulated MCP2210 notices what its datasheet does not allow: each mistake once, with the answer that it gets. */
#include "glass/emulated_mcp2210.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

static void mistakes_are_complained_about(void **state)
{
    static const struct {
        uint8_t before[8], report[24], status;
        enum emulated_mcp2210_complaint kind;
    } cases[] = {
        {{0}, {0x99}, 0xF9, BRIDGE_UNKNOWN_COMMAND},
        {{0}, {0x10, 1}, 0, BRIDGE_RESERVED},
        {{0}, {0x60, 0x20}, 0xFB, BRIDGE_NVRAM},
        {{0}, {0x51}, 0xFB, BRIDGE_NVRAM},
        {{0}, {0x21, 0, 0, 0, 3, 2, 2, 2, 2, 2, 2, 2, 2}, 0, BRIDGE_VALUE},
        {{0}, {0x40, [4] = 0xDB, 5, [18] = 1}, 0, BRIDGE_VALUE},                /* 1499 Hz */
        {{0}, {0x40, [4] = 0x01, 0x1B, 0xB7, [18] = 1}, 0, BRIDGE_VALUE},       /* 12000001 Hz */
        {{0}, {0x40, [4] = 0, 0x1B, 0xB7}, 0, BRIDGE_VALUE},                    /* no bytes a transaction */
        {{0}, {0x40, [4] = 0, 0x1B, 0xB7, [18] = 1, 0, 4}, 0, BRIDGE_VALUE},    /* mode 4 */
        {{0}, {0x40, [4] = 0, 0x1B, 0xB7, [9] = 2, [18] = 1}, 0, BRIDGE_VALUE}, /* select 9 */
        {{0}, {0x42, 61}, 0xF9, BRIDGE_TOO_LONG},
        {{0}, {0x42, 5}, 0xF8, BRIDGE_TRANSACTION},
        {{0}, {0x42, 0}, 0xF8, BRIDGE_TRANSACTION},
        {{0x42, 2}, {0x42, 3}, 0xF8, BRIDGE_TRANSACTION},
        {{0x42, 2}, {0x40, [4] = 0, 0x1B, 0xB7, [18] = 1}, 0xF8, BRIDGE_BUSY},
        {{0x42, 2}, {0x21, 0, 0, 0, 2, 2, 2, 2, 2, 2, 2, 2, 2}, 0xF8, BRIDGE_BUSY},
        {{0x42, 2}, {0x30, 0, 0, 0, 0xFF, 1}, 0, BRIDGE_BUSY},
        {{0x42, 2}, {0x32, 0, 0, 0, 0xFF, 1}, 0, BRIDGE_BUSY},
        {{0}, {0x30, 0, 0, 0, 0xFE, 1}, 0, BRIDGE_NOT_GPIO},
        {{0x21}, {0x30, 0, 0, 0, 1, 0}, 0, BRIDGE_NOT_OUTPUT},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct emulated_mcp2210 bridge, *chip = &bridge;
        uint8_t report[EMULATED_MCP2210_REPORT_B] = {0}, answer[EMULATED_MCP2210_REPORT_B];
        emulated_mcp2210_init(chip);
        memcpy(report, cases[i].before, sizeof cases[i].before);
        if (report[0] == 0x21) report[15] = 1; /* GP0 is an input */
        if (report[0]) emulated_mcp2210_answer(chip, report, answer);
        assert_int_equal(chip->complaints, 0);
        memset(report, 0, sizeof report);
        memcpy(report, cases[i].report, sizeof cases[i].report);
        emulated_mcp2210_answer(chip, report, answer);
        if (chip->complaints != 1 || chip->complaints_of[cases[i].kind] != 1)
            fail_msg("mistake %zu: %u complaints, the last: %s", i, chip->complaints, chip->complaint);
        assert_int_equal(answer[1], cases[i].status);
    }
}

static int count_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    (void)data;
    *(size_t *)ctx += n_b;
    return 0;
}

/* GP3 is the display's chip select, low in transactions once it has that function. */
static void bytes_without_chip_select_are_lost(void **state)
{
    static const uint8_t settings[EMULATED_MCP2210_REPORT_B] = {0x40, [4] = 0, 0x1B, 0xB7,    [8] = 0xFF,
                                                                1,    0xF7,    1,    [18] = 2};
    static const uint8_t functions[EMULATED_MCP2210_REPORT_B] = {0x21, [4] = 2, 2, 2,           1, 2,    2,
                                                                 2,    2,       2, [13] = 0xFF, 1, 0xFF, 1};
    static const uint8_t transfer[EMULATED_MCP2210_REPORT_B] = {0x42, 2}, end[EMULATED_MCP2210_REPORT_B] = {0x42};
    (void)state;
    for (unsigned selected = 0; selected < 2; selected++) {
        uint8_t answer[EMULATED_MCP2210_REPORT_B];
        struct emulated_mcp2210 bridge;
        size_t arrived_b = 0;
        emulated_mcp2210_init(&bridge);
        bridge.select = 3;
        bridge.spi = (struct bus){.ctx = &arrived_b, .write = count_bytes};
        emulated_mcp2210_answer(&bridge, settings, answer);
        if (selected) emulated_mcp2210_answer(&bridge, functions, answer);
        emulated_mcp2210_answer(&bridge, transfer, answer);
        emulated_mcp2210_answer(&bridge, end, answer);
        assert_int_equal(answer[3], 0x10);
        assert_int_equal(arrived_b, selected ? 2 : 0);
        assert_int_equal(bridge.complaints_of[BRIDGE_NOT_SELECTED], !selected);
        assert_int_equal(bridge.complaints, !selected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_are_complained_about),
        cmocka_unit_test(bytes_without_chip_select_are_lost),
    };
    return cmocka_run_group_tests_name("emulated_mcp2210", tests, NULL, NULL);
}
