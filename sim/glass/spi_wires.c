/* SPDX-License-Identifier: MIT
 *
 * A sampled capture shows what changed shortly before or behind an edge of the clock together with the edge. D/C and
 * select change between bytes only: so the edge that ends a byte came before them, and any other after them. The
 * board's LED, which ends frames, comes behind the clock. */
#include "glass/spi_wires.h"

#include <stdio.h>

enum { LEVEL_B = 96 };
static const uint64_t NO_LEVEL_NS = UINT64_MAX; /* no level of the clock has been seen from its begin to its end */

static uint8_t bit_of(enum capture_wire wire)
{
    return (uint8_t)(1u << wire);
}

static bool is_selected(const struct spi_wires *wires)
{
    if (wires->wired & bit_of(CAPTURE_SELECT)) return wires->at.high & bit_of(CAPTURE_SELECT);
    return !(wires->wired & bit_of(CAPTURE_CS)) || !(wires->at.high & bit_of(CAPTURE_CS));
}

static bool is_left_out(const struct spi_wires *wires)
{
    return (wires->is_running || wires->waits_for_reset) && !wires->is_heard;
}

/* A byte that is not whole where one must be. */
static bool refuse_bits(const struct spi_wires *wires, enum capture_wire wire, struct error *err)
{
    char level[LEVEL_B];
    const unsigned long long shortest_ns = wires->shortest_ns;
    if (wires->shortest_ns == NO_LEVEL_NS)
        snprintf(level, sizeof level, "it has had one edge so far");
    else
        snprintf(level, sizeof level, "its shortest level since the last such change was %llu ns", shortest_ns);
    return error_set(err, "%s changes after %u bit%s of a byte: edges of sck were missed, or added by noise; %s",
                     capture_wire_names[wire], wires->n_bits, wires->n_bits == 1 ? "" : "s", level);
}

/* Where a wire changes that changes between bytes only. What comes before the first such change may have begun before
 * the capture, or be the clock's way to its idle level. */
static bool end_byte(struct spi_wires *wires, enum capture_wire wire, struct error *err)
{
    const bool is_first = !wires->is_aligned && wires->bytes == 0;
    if (wires->n_bits && !is_first && !is_left_out(wires)) return refuse_bits(wires, wire, err);
    wires->n_bits = 0;
    wires->is_aligned = true;
    wires->shortest_ns = NO_LEVEL_NS;
    return true;
}

/* A command begins: by D/C, or by the select of what has none. */
static bool begins_command(const struct spi_wires *wires, enum capture_wire wire, bool high)
{
    return wires->wired & bit_of(CAPTURE_DC) ? wire == CAPTURE_DC && !high : wire == CAPTURE_SELECT && high;
}

static bool change(struct spi_wires *wires, uint64_t now_ns, enum capture_wire wire, bool high, struct error *err)
{
    const bool parts_bytes = wire == CAPTURE_DC || wire == CAPTURE_CS || wire == CAPTURE_SELECT;
    if (wires->has_begun && parts_bytes && !end_byte(wires, wire, err)) return false;
    if (wire == CAPTURE_RESET && !high) wires->n_bits = 0;
    if (wires->is_running ? wires->has_begun && begins_command(wires, wire, high) : wire == CAPTURE_RESET && !high)
        wires->is_heard = true;
    wires->at.high = (uint8_t)(high ? wires->at.high | bit_of(wire) : wires->at.high & ~bit_of(wire));
    return wires->events.level(wires->events.ctx, now_ns, wire, high, err);
}

static bool take_bit(struct spi_wires *wires, uint64_t now_ns, struct error *err)
{
    if (wires->at.unknown & bit_of(CAPTURE_MOSI) && !is_left_out(wires))
        return error_set(err, "mosi is unknown (x or z) at an edge of sck");
    wires->byte = (uint8_t)(wires->byte << 1 | ((wires->at.high & bit_of(CAPTURE_MOSI)) != 0));
    if (++wires->n_bits < 8) return true;
    wires->n_bits = 0;
    wires->pause_ns = now_ns - wires->byte_ns;
    wires->byte_ns = now_ns;
    if (is_left_out(wires)) return true;
    if (wires->at.unknown & wires->wired & bit_of(CAPTURE_DC))
        return error_set(err, "dc is unknown (x or z) at the end of a byte");
    wires->bytes++;
    return wires->events.byte(wires->events.ctx, now_ns, wires->byte, err);
}

/* The clock may be unknown until somebody drives it: then it is where it rests. */
static bool take_clock(struct spi_wires *wires, uint64_t now_ns, struct wire_levels levels, struct error *err)
{
    const uint8_t clock = bit_of(CAPTURE_SCK);
    const bool was_known = !(wires->at.unknown & clock), high = levels.high & clock;
    if (levels.unknown & clock) {
        if (wires->has_begun && was_known && wires->n_bits && !is_left_out(wires))
            return error_set(err, "sck is unknown (x or z) within a byte");
        wires->at.unknown |= clock;
        wires->at.high = (uint8_t)((wires->at.high & ~clock) | (wires->rests_high ? clock : 0));
        return true;
    }
    const bool is_edge = wires->has_begun && high != ((wires->at.high & clock) != 0);
    wires->at.unknown &= (uint8_t)~clock;
    wires->at.high = (uint8_t)((wires->at.high & ~clock) | (levels.high & clock));
    if (!is_edge) return true;
    if (wires->clock_edges++ && now_ns - wires->edge_ns < wires->shortest_ns)
        wires->shortest_ns = now_ns - wires->edge_ns;
    wires->edge_ns = now_ns;
    if (high == wires->takes_falling) return true;
    if (is_selected(wires)) return take_bit(wires, now_ns, err);
    wires->other_edges++;
    return true;
}

static bool take_others(struct spi_wires *wires, uint64_t now_ns, struct wire_levels levels, uint8_t which,
                        struct error *err)
{
    for (int i = 0; i < CAPTURE_WIRES; i++) {
        const uint8_t bit = bit_of((enum capture_wire)i);
        if (!(which & wires->wired & bit) || levels.unknown & bit) continue;
        const bool high = levels.high & bit, is_new = !wires->has_begun || wires->at.unknown & bit;
        if (!is_new && high == ((wires->at.high & bit) != 0)) continue;
        if (!change(wires, now_ns, (enum capture_wire)i, high, err)) return false;
    }
    return true;
}

/* MOSI with it: what changes together with an edge changed shortly before. */
static bool take_data_and_clock(struct spi_wires *wires, uint64_t now_ns, struct wire_levels levels, struct error *err)
{
    const uint8_t data = bit_of(CAPTURE_MOSI);
    wires->at.high = (uint8_t)((wires->at.high & ~data) | (levels.high & data));
    wires->at.unknown = (uint8_t)((wires->at.unknown & ~data) | (levels.unknown & data));
    return take_clock(wires, now_ns, levels, err);
}

/* Whether an edge comes that ends a byte. */
static bool ends_byte(const struct spi_wires *wires, struct wire_levels levels)
{
    const uint8_t clock = bit_of(CAPTURE_SCK);
    const bool high = levels.high & clock, is_edge = high != ((wires->at.high & clock) != 0);
    return wires->has_begun && wires->n_bits == 7 && is_edge && !(levels.unknown & clock) &&
           high != wires->takes_falling && is_selected(wires);
}

bool spi_wires_take(struct spi_wires *wires, uint64_t now_ns, struct wire_levels levels, struct error *err)
{
    const uint8_t clock = bit_of(CAPTURE_SCK), last = bit_of(CAPTURE_LED);
    const uint8_t others = (uint8_t) ~(bit_of(CAPTURE_MOSI) | clock | last);
    const bool is_first = ends_byte(wires, levels);
    if (!wires->has_begun) wires->shortest_ns = NO_LEVEL_NS;
    if (!wires->has_begun) wires->byte_ns = now_ns;
    if (is_first && !take_data_and_clock(wires, now_ns, levels, err)) return false;
    if (!take_others(wires, now_ns, levels, others, err)) return false;
    wires->at.unknown = (uint8_t)((wires->at.unknown & clock) | (levels.unknown & ~clock));
    if (!is_first && !take_data_and_clock(wires, now_ns, levels, err)) return false;
    if (!take_others(wires, now_ns, levels, last, err)) return false;
    wires->has_begun = true;
    return true;
}
