/* SPDX-License-Identifier: MIT
 *
 * A tree first; then, if that is cheaper and as right, a mesh without one, or dense parts as leaves. The reference has
 * a say in both. */
#include "compiler/decision.h"

#include "accuracy/predict.h"
#include "base/deadline.h"
#include "compiler/decision_cache.h"
#include "compiler/decision_key.h"
#include "compiler/faithful.h"
#include "compiler/mesh_choice.h"
#include "compiler/mesh_leaf_choice.h"
#include "core/core.h"

/* The reference is made once it is asked. */
static bool reference_want(struct reference *reference, bool *is_made, const struct mesh *fine, struct error *err)
{
    if (*is_made) return true;
    *is_made = true;
    return reference_init(reference, fine, PREDICT_SIDE_PX, PREDICT_SIDE_PX, err);
}

static bool hold_against(const struct mesh *mesh, const struct mesh *fine, const struct compile_options *options,
                         struct compiled *out, struct error *err)
{
    struct reference reference = {0};
    struct mesh_trials trials;
    struct leaf_trial leaves = {0};
    bool is_made = false, ok = true;
    if (mesh_choice_try(mesh, options, out, &trials))
        ok = reference_want(&reference, &is_made, fine, err) &&
             mesh_choice_settle(&trials, mesh, options, &reference, mesh->merged_into, out, err);
    if (ok && leaf_trial_begin(&leaves, mesh, options, out))
        ok = reference_want(&reference, &is_made, fine, err) &&
             leaf_trial_settle(&leaves, &reference, mesh->merged_into, out, err);
    reference_free(&reference);
    mesh_trials_free(&trials);
    leaf_trial_free(&leaves);
    if (!ok) compiled_free(out);
    return ok;
}

bool decision_asks_reference(const struct compile_options *options)
{
    const bool is_exact = options->core && options->core->profile == LIM_PROFILE_EXACT;
    const bool is_open = (!options->method && options->tree == TREE_AUTO) || options->leaves_open;
    return options->choose_order && is_open && !is_exact;
}

/* What was cut short by the time is not remembered: it hangs on the machine. */
static bool decide(const struct mesh *mesh, const struct mesh *fine, const struct compile_options *options,
                   struct compiled *out, struct error *err)
{
    uint8_t key[CACHE_KEY_B];
    const bool remembers = cache_is_open();
    if (remembers) decision_key(key, mesh, decision_asks_reference(options) ? fine : NULL, options);
    if (remembers && decision_cache_find(key, mesh, options, out)) return true;
    const size_t cuts = deadline_cuts();
    if (!faithful_compile(mesh, options, out, err)) return false;
    out->report.near_m = options->near_m;
    if (!hold_against(mesh, fine, options, out, err)) return false;
    if (remembers && deadline_cuts() == cuts) decision_cache_keep(key, out);
    return true;
}

bool decision_make(const struct mesh *mesh, const struct mesh *fine, const struct compile_options *options,
                   struct compiled *out, struct error *err)
{
    if (!decide(mesh, fine, options, out, err)) return false;
    out->report.core = options->core ? options->core : &core_fast;
    return true;
}
