/* SPDX-License-Identifier: MIT
 *
 * By the glTF 2.0 specification's appendix C; rotations go the shorter way round. */
#include "readers/motion_track.h"

#include "base/grow.h"
#include "model/pose.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t values_a_key(const struct track *track)
{
    return track->width * (track->join == TRACK_CUBIC ? 3 : 1);
}

struct track track_make(size_t count, unsigned width, enum track_join join)
{
    struct track track = {.count = count, .width = width, .join = join};
    track.times_s = grow_zeroed(count, sizeof *track.times_s);
    track.values = grow_zeroed(count * values_a_key(&track), sizeof *track.values);
    return track;
}

void track_free(struct track *track)
{
    free(track->times_s);
    free(track->values);
    *track = (struct track){0};
}

double *track_key(const struct track *track, size_t key)
{
    return track->values + key * values_a_key(track) + (track->join == TRACK_CUBIC ? track->width : 0);
}

static void to_unit(double turn[4])
{
    double length = 0;
    for (int i = 0; i < 4; i++)
        length = hypot(length, turn[i]);
    for (int i = 0; i < 4; i++)
        turn[i] = length > 0 ? turn[i] / length : i == 3;
}

/* The last key that is not behind the time; the first one, if all are. */
static size_t key_before(const struct track *track, double time_s)
{
    size_t low = 0, high = track->count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (track->times_s[middle] <= time_s)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void linear_between(const struct track *track, size_t key, double t, double *out)
{
    const double *from = track_key(track, key), *to = track_key(track, key + 1);
    if (track->width == 4) {
        double a[4], b[4];
        memcpy(a, from, sizeof a);
        memcpy(b, to, sizeof b);
        to_unit(a);
        to_unit(b);
        pose_turn_between(a, b, t, out);
        return;
    }
    for (unsigned i = 0; i < track->width; i++)
        out[i] = from[i] + t * (to[i] - from[i]);
}

/* Hermite's spline. */
static void cubic_between(const struct track *track, size_t key, double t, double *out)
{
    const double *from = track_key(track, key), *to = track_key(track, key + 1);
    const double span_s = track->times_s[key + 1] - track->times_s[key], t2 = t * t, t3 = t2 * t;
    for (unsigned i = 0; i < track->width; i++)
        out[i] = (2 * t3 - 3 * t2 + 1) * from[i] + span_s * (t3 - 2 * t2 + t) * from[track->width + i] +
                 (3 * t2 - 2 * t3) * to[i] + span_s * (t3 - t2) * (to - track->width)[i];
}

void track_at(const struct track *track, double time_s, double within_s, double *out)
{
    const size_t key = key_before(track, within_s);
    const bool is_between = key + 1 < track->count && within_s > track->times_s[key];
    const double span_s = is_between ? track->times_s[key + 1] - track->times_s[key] : 0;
    const double t = span_s > 0 ? fmin(fmax((time_s - track->times_s[key]) / span_s, 0), 1) : 0;
    if (!is_between || track->join == TRACK_STEP)
        memcpy(out, track_key(track, key), track->width * sizeof *out);
    else if (track->join == TRACK_LINEAR)
        linear_between(track, key, t, out);
    else
        cubic_between(track, key, t, out);
    if (track->width == 4) to_unit(out);
}

bool track_changes(const struct track *track, double most)
{
    bool changes = false;
    const double *first = track->count ? track_key(track, 0) : NULL;
    for (size_t key = 0; key < track->count; key++) {
        const double *value = track_key(track, key);
        for (unsigned i = 0; i < track->width; i++) {
            changes |= !(fabs(value[i] - first[i]) <= most);
            if (track->join != TRACK_CUBIC || track->count < 2) continue;
            changes |= key > 0 && !(fabs((value - track->width)[i]) <= most);
            changes |= key + 1 < track->count && !(fabs(value[track->width + i]) <= most);
        }
    }
    return changes;
}

bool track_is_sound(const struct track *track)
{
    bool is_sound = true;
    for (size_t key = 0; key < track->count; key++)
        is_sound &= isfinite(track->times_s[key]) && track->times_s[key] >= (key ? track->times_s[key - 1] : 0);
    for (size_t i = 0; i < track->count * values_a_key(track); i++)
        is_sound &= isfinite(track->values[i]) != 0;
    return is_sound;
}
