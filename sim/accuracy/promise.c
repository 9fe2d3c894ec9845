/* SPDX-License-Identifier: MIT
 *
 * One table. */
#include "accuracy/promise.h"

#include "base/grow.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double WRONG_PERCENT[] = {
    [LIM_PROFILE_DRAFT] = 0.0, [LIM_PROFILE_FAST] = 0.05, [LIM_PROFILE_FINE] = 0.03, [LIM_PROFILE_EXACT] = 0.005};

double promise_wrong_percent(const struct core *core)
{
    return WRONG_PERCENT[core ? core->profile : LIM_PROFILE_FAST];
}

/* What may be tried; whether it does, `limner measure` says. */
static const char *help_for(const struct compiled *scene)
{
    if (!method_is_exact(scene->report.draws)) return "--method nearest has an exact order";
    if (scene->report.mesh_leaves) return "--mesh-leaves none has an exact order";
    return scene->report.core->profile == LIM_PROFILE_EXACT
               ? "limner worst shows such a view"
               : "--precision exact rounds less, limner worst shows a view";
}

static struct note *new_note(struct compile_report *report)
{
    size_t capacity = report->note_count;
    report->notes = grow(report->notes, report->note_count, &capacity, sizeof *report->notes);
    struct note *note = &report->notes[report->note_count++];
    *note = (struct note){.is_detail = false};
    return note;
}

/* What is wrong along faces need not be wrong elsewhere, nor be of the same face. */
static void note_along(struct compiled *scene, double promised)
{
    struct note *note = new_note(&scene->report);
    snprintf(note->text, sizeof note->text,
             "%.4f %% of pixels are predicted to be wrong in views along faces, %s promises %g %%; %s",
             scene->report.wrong.grazing_percent, scene->report.core->name, promised, help_for(scene));
}

void promise_note(struct compiled *scene)
{
    const struct predicted *wrong = &scene->report.wrong;
    const double promised = promise_wrong_percent(scene->report.core);
    char face[64] = "";
    if (promised <= 0.0 || isnan(wrong->percent)) return;
    if (wrong->percent <= promised) {
        if (wrong->grazing_cameras && wrong->grazing_percent > promised) note_along(scene, promised);
        return;
    }
    if (wrong->worst_face)
        snprintf(face, sizeof face, "; face %lu is in %.0f %% of these", (unsigned long)wrong->worst_face,
                 wrong->worst_face_percent);
    struct note *note = new_note(&scene->report);
    snprintf(note->text, sizeof note->text, "%.4f %% of pixels are predicted to be wrong, %s promises %g %%%s; %s",
             wrong->percent, scene->report.core->name, promised, face, help_for(scene));
}
