/* SPDX-License-Identifier: MIT
 *
 * Other trees are better where the BSP tree splits much, or where its frames reach many polygons of which nothing is
 * seen. By default that is where they are tried. One whole compilation for each of them, pools included, because these
 * draw the cameras.
 *
 * The BSP tree is the smallest of several. Of a large building it may be a lopsided one, of which a frame walks ten
 * times what it shows; so where much is reached, the tree of the heuristic that balances is tried, too. */
#include "compiler/tree_choice.h"

#include "base/deadline.h"
#include "compiler/compile_mesh.h"
#include "compiler/order_choice.h"
#include "trees/splitter.h"

#include <math.h>
#include <string.h>

static const enum tree_kind OTHERS[] = {TREE_CLUSTERS, TREE_AXIS};
static const double ENOUGH = 0.9, ALIKE = 0.01; /* of the BSP tree's instructions */
static const double OTHERS_SHARE = 0.5;         /* of the time: what follows needs some */
static const double FEW_REACHED = 6.0;          /* polygons for each that is seen */
static const size_t MANY = 40000;               /* polygons: what splits much then is a mesh, and takes no tree */

static bool is_better(const struct compile_report *a, const struct compile_report *b, const struct compile_report *bsp)
{
    if (isnan(a->instructions) || a->instructions > ENOUGH * bsp->instructions) return false;
    if (b == bsp) return true;
    const double less = b->instructions - a->instructions;
    return fabs(less) > ALIKE * bsp->instructions ? less > 0.0 : a->flash_b < b->flash_b;
}

/* The trees under way: *out is the best of them. */
struct trial {
    struct compilation *work;
    struct compiled *out;
    struct compile_report bsp; /* the smallest BSP tree's */
};

/* Replaces *out where the tree is better. One that fails, being too large, is none. */
static void try_tree(struct trial *trial, enum tree_kind kind)
{
    const struct compile_report *best = trial->out->report.choice.replaced ? &trial->out->report : &trial->bsp;
    struct compiled candidate;
    struct error ignored;
    if (deadline_passed() || !compilation_tree(trial->work, kind, &candidate, &ignored)) return;
    if (!deadline_passed() && is_better(&candidate.report, best, &trial->bsp)) {
        const struct compiled worse = *trial->out;
        *trial->out = candidate;
        candidate = worse;
        trial->out->report.choice.replaced = true;
    }
    compiled_free(&candidate);
}

static bool reaches_much(const struct compile_report *report)
{
    return report->reached_a_seen > FEW_REACHED;
}

static void try_balanced(struct trial *trial)
{
    const struct compile_options *options = trial->work->options;
    struct compile_options balanced = *options;
    if (strcmp(options->splitter, "auto") != 0 || strcmp(trial->bsp.splitter, splitter_scout->name) == 0) return;
    balanced.splitter = splitter_scout->name;
    trial->work->options = &balanced;
    try_tree(trial, TREE_BSP);
    trial->work->options = options;
}

static void try_others(struct compilation *work, struct compiled *out)
{
    struct trial trial = {work, out, out->report};
    const struct deadline_end whole = deadline_share(OTHERS_SHARE);
    if (reaches_much(&trial.bsp)) try_balanced(&trial);
    for (size_t i = 0; i < sizeof OTHERS / sizeof *OTHERS; i++)
        try_tree(&trial, OTHERS[i]);
    deadline_say("the BSP tree, and of the others those tried in time");
    deadline_restore(whole);
    out->report.choice =
        (struct tree_choice){CHOICE_MADE, out->report.choice.replaced, trial.bsp.instructions, trial.bsp.flash_b};
}

static void choose_tree(struct compilation *work, struct compiled *out)
{
    const struct compile_options *options = work->options;
    const bool is_open = options->trial != TRIAL_NEVER && options->tree == TREE_AUTO && options->portals != PORTALS_ON;
    if (!is_open || (out->report.draws != LIM_NEAREST_FIRST && out->report.draws != LIM_SCANLINE)) return;
    const struct compile_report *bsp = &out->report;
    const bool unasked = options->trial == TRIAL_IF_SPLIT, splits_much = compilation_splits_much(bsp);
    if (isnan(bsp->instructions))
        out->report.choice.kind = CHOICE_UNKNOWN;
    else if (unasked && !splits_much && !reaches_much(bsp))
        out->report.choice.kind = CHOICE_NEEDLESS;
    else if (unasked && splits_much && bsp->polygons_in > MANY)
        out->report.choice.kind = CHOICE_LONG;
    else
        try_others(work, out);
}

bool tree_choice_compile(const struct mesh *mesh, const struct compile_options *options, struct compiled *out,
                         struct error *err)
{
    struct compilation work;
    *out = (struct compiled){0};
    bool ok = compilation_begin(&work, mesh, options, err) && compilation_tree(&work, options->tree, out, err);
    if (ok) choose_tree(&work, out);
    ok = ok && compilation_portals(&work, out, err);
    compilation_end(&work);
    if (ok && options->framebuffer) order_settle_framebuffer(&out->report);
    return ok;
}
