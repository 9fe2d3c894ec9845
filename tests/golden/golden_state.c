/* SPDX-License-Identifier: MIT */
#include "golden_state.h"

#include "core/core.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

void golden_state_clear(struct simulator *simulator, const struct golden_stage *stage)
{
    const struct core *core = simulator->core;

    memset(simulator->mem, 0, simulator->mem_b);
    if (simulator->mover_mem)
        memset(simulator->mover_mem, 0, core->movers_mem_b(simulator->scene, &stage->moving.limits));
}

uint32_t golden_state(const struct simulator *simulator)
{
    switch (simulator->core->profile) {
    case LIM_PROFILE_DRAFT:
        return golden_state_draft(simulator->lim, simulator->instance_count);
    case LIM_PROFILE_FAST:
        return golden_state_fast(simulator->lim, simulator->instance_count);
    case LIM_PROFILE_FINE:
        return golden_state_fine(simulator->lim, simulator->instance_count);
    default:
        return golden_state_exact(simulator->lim, simulator->instance_count);
    }
}
