/* SPDX-License-Identifier: MIT
 *
 * Any text as a map of registers; what follows a % says which module listens, and is a trace of QEMU's. */
#include "fuzz_listener.h"
#include "glass/qemu_trace.h"

static bool take(struct listener *listener, const char *line, void *ctx, struct error *err)
{
    return !qemu_trace_is(line) || qemu_trace_take(ctx, listener, line, err);
}

static const char *check_map(const struct qemu_map *map)
{
    if (map->count > QEMU_TRACE_REGISTERS) return "more registers than there is room for";
    for (size_t i = 0; i < map->count; i++)
        if (map->registers[i].idiom > QEMU_OUTPUT || map->registers[i].pin >= LISTENER_PINS ||
            map->registers[i].bit > 31)
            return "a register of no idiom, pin or bit";
    return NULL;
}

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    const struct fuzz_bytes text = fuzz_part(&bytes, '%');
    const char *path = fuzz_as_file(text.at, text.left_b);
    struct qemu_map map;
    struct error err;

    if (!qemu_map_read(&map, path, &err)) return fuzz_check_refusal(err.text, path);
    const char *broken = check_map(&map);
    return broken ? broken : fuzz_listen(&bytes, take, &map);
}

const struct fuzz_target fuzz_qemu = {"qemu", run, NULL};
