/* SPDX-License-Identifier: MIT
 *
 * Radiosity by ray casting. Direct light comes from the sun, from points sampled on the openings
 * that show sky, and from lamps; a fixed fan of rays over the hemisphere finds what each polygon
 * sees, and a few rounds over that table spread the light. All samples are the same for every
 * polygon, so that neighbours differ by their place alone and flat walls stay free of noise. */
#include "demo_light.h"
#include "demo_house.h"
#include "demo_rays.h"

#include <stdlib.h>

enum { SPOTS = 6, FAN = 48, SEEN = SPOTS * FAN, SKY_SAMPLES = 16, BALL_SAMPLES = 4, BOUNCES = 5 };

static const double far_m = 100;
static const double off_surface_m = 0.005;
static const struct vec3 sun_power = {6.2, 5.0, 3.4};
static const struct vec3 sky_power = {7.6, 8.3, 9.0};
static const struct vec3 ambient = {0.010, 0.011, 0.013};

struct baker {
    struct rays rays;
    struct opening *openings;
    size_t opening_count;
    struct vec3 *direct, *light; /* of each polygon: irradiance over pi */
    int *seen;                   /* SEEN polygon numbers each */
};

/* The additive recurrence of the plastic number: even coverage of the square by any prefix. */
static void even_point(int i, double *u, double *v)
{
    *u = fmod(0.5 + 0.7548776662466927 * i, 1);
    *v = fmod(0.5 + 0.5698402909980532 * i, 1);
}

static struct vec3 spot_on(const struct polygon *polygon, int i)
{
    double u, v;
    even_point(i, &u, &v);
    return vec_add(polygon_point(polygon, u, v), vec_scale(polygon->normal, off_surface_m));
}

static struct vec3 fan_direction(struct vec3 normal, int i)
{
    double u, v;
    even_point(i, &u, &v);
    struct vec3 side = fabs(normal.y) < 0.9 ? (struct vec3){0, 1, 0} : (struct vec3){1, 0, 0};
    struct vec3 a = vec_unit(vec_cross(side, normal)), b = vec_cross(normal, a);
    double sine = sqrt(u), angle = 2 * DEMO_PI * v;
    struct vec3 flat = vec_add(vec_scale(a, sine * cos(angle)), vec_scale(b, sine * sin(angle)));
    return vec_add(flat, vec_scale(normal, sqrt(1 - u)));
}

static struct vec3 linear_colour(uint32_t colour)
{
    double channel[3];
    for (int i = 0; i < 3; i++) {
        double c = (colour >> (16 - 8 * i) & 0xff) / 255.0;
        channel[i] = c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
    }
    return (struct vec3){channel[0], channel[1], channel[2]};
}

static double window_glow(const struct baker *baker, struct vec3 spot, struct vec3 normal,
                          const struct opening *opening)
{
    struct vec3 cross = vec_cross(opening->edge_u, opening->edge_v);
    double glow = 0;
    for (int i = 0; i < SKY_SAMPLES; i++) {
        struct vec3 at = vec_add(opening->corner, vec_scale(opening->edge_u, (i % 4 + 0.5) / 4));
        at = vec_add(at, vec_scale(opening->edge_v, (i / 4 + 0.5) / 4));
        struct vec3 way = vec_sub(at, spot);
        double distance = vec_length(way);
        struct vec3 direction = vec_scale(way, 1 / distance);
        double here = vec_dot(normal, direction), there = -vec_dot(cross, direction) / SKY_SAMPLES;
        if (here <= 0 || there <= 0) continue;
        if (!rays_blocked(&baker->rays, spot, direction, far_m)) glow += here * there / fmax(distance * distance, 0.04);
    }
    return glow * opening->brightness / DEMO_PI;
}

static double lamp_glow(const struct baker *baker, struct vec3 spot, struct vec3 normal, const struct lamp *lamp)
{
    double glow = 0;
    for (int i = 0; i < BALL_SAMPLES; i++) {
        /* the corners of a tetrahedron */
        struct vec3 corner = {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i == 0 || i == 3 ? 1 : -1};
        struct vec3 way = vec_sub(vec_add(lamp->at, vec_scale(corner, lamp->radius_m)), spot);
        double distance = vec_length(way);
        struct vec3 direction = vec_scale(way, 1 / distance);
        double here = vec_dot(normal, direction);
        if (here > 0 && !rays_blocked(&baker->rays, spot, direction, distance))
            glow += here / (distance * distance + 0.1);
    }
    return glow / BALL_SAMPLES / DEMO_PI;
}

static double sun_glow(const struct baker *baker, struct vec3 spot, struct vec3 normal)
{
    struct vec3 to_sun = vec_unit(vec_scale(house_sun, -1));
    double here = vec_dot(normal, to_sun);
    if (here <= 0 || rays_blocked(&baker->rays, spot, to_sun, far_m)) return 0;
    return here / DEMO_PI;
}

static struct vec3 direct_light(const struct baker *baker, struct vec3 spot, struct vec3 normal)
{
    struct vec3 sum = vec_scale(sun_power, sun_glow(baker, spot, normal));
    for (size_t i = 0; i < baker->opening_count; i++)
        sum = vec_add(sum, vec_scale(sky_power, window_glow(baker, spot, normal, &baker->openings[i])));
    for (size_t i = 0; i < house_lamp_count; i++)
        sum = vec_add(sum, vec_scale(house_lamps[i].power, lamp_glow(baker, spot, normal, &house_lamps[i])));
    return sum;
}

/* A spot inside a closed piece of furniture sees its inner sides: it says nothing about light. */
static bool look_round(const struct baker *baker, struct vec3 spot, struct vec3 normal, int *seen)
{
    int inner = 0;
    for (int i = 0; i < FAN; i++) {
        struct vec3 direction = fan_direction(normal, i);
        int hit = rays_first(&baker->rays, spot, direction);
        bool behind = hit != NOTHING && vec_dot(baker->rays.soup->polygons[hit].normal, direction) > 0;
        seen[i] = behind ? NOTHING : hit;
        inner += behind;
    }
    return inner < FAN / 2;
}

static void gather_direct(struct baker *baker, size_t number)
{
    const struct polygon *polygon = &baker->rays.soup->polygons[number];
    struct vec3 sum = {0, 0, 0};
    int open = 0;
    for (int i = 0; i < SPOTS; i++) {
        struct vec3 spot = spot_on(polygon, i);
        if (!look_round(baker, spot, polygon->normal, &baker->seen[number * SEEN + (size_t)(open * FAN)])) continue;
        sum = vec_add(sum, direct_light(baker, spot, polygon->normal));
        open++;
    }
    for (int i = open * FAN; i < SEEN; i++)
        baker->seen[number * SEEN + (size_t)i] =
            open ? baker->seen[number * SEEN + (size_t)(i % (open * FAN))] : NOTHING;
    baker->direct[number] = vec_add(ambient, vec_scale(sum, 1.0 / (open ? open : 1)));
}

static struct vec3 reflectance(const struct polygon *polygon)
{
    const struct material *material = &materials[polygon->material];
    return vec_scale(linear_colour(material->colour), 1 + polygon->grain * material->grain);
}

/* Less colour is handed on than is shown: true interreflection turns a brick court all red. */
static struct vec3 bounced_colour(const struct polygon *polygon)
{
    struct vec3 colour = reflectance(polygon);
    double grey = vec_dot(colour, (struct vec3){0.2126, 0.7152, 0.0722});
    return vec_lerp(colour, (struct vec3){grey, grey, grey}, 0.4);
}

static void bounce(struct baker *baker, struct vec3 *next)
{
    const struct soup *soup = baker->rays.soup;
    for (size_t i = 0; i < soup->count; i++) {
        struct vec3 sum = {0, 0, 0};
        for (size_t j = 0; j < SEEN; j++) {
            int hit = baker->seen[i * SEEN + j];
            if (hit == NOTHING || materials[soup->polygons[hit].material].emission > 0) continue;
            sum = vec_add(sum, vec_mul(bounced_colour(&soup->polygons[hit]), baker->light[hit]));
        }
        next[i] = vec_add(baker->direct[i], vec_scale(sum, 1.0 / SEEN));
    }
}

static void collect_openings(struct baker *baker)
{
    baker->openings = demo_realloc(NULL, (house_window_count + house_sky_count) * sizeof *baker->openings);
    for (size_t i = 0; i < house_window_count; i++) {
        struct frame frame = window_frame(&house_windows[i]);
        double width_m = window_width_mm(&house_windows[i]) / 1000.0;
        double height_m = window_height_mm(&house_windows[i]) / 1000.0;
        struct opening opening = {vec_sub(frame.origin, vec_scale(frame.right, width_m / 2)),
                                  vec_scale(frame.right, width_m), vec_scale(frame.up, height_m),
                                  house_windows[i].brightness};
        baker->openings[baker->opening_count++] = opening;
    }
    for (size_t i = 0; i < house_sky_count; i++)
        baker->openings[baker->opening_count++] = house_skies[i];
}

/* Film: a soft shoulder towards white, then the sRGB curve. */
static uint32_t expose(struct vec3 light)
{
    double in[3] = {light.x, light.y, light.z};
    uint32_t colour = 0;
    for (int i = 0; i < 3; i++) {
        double x = in[i] * 1.6;
        double film = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
        double c = fmin(1, film <= 0.0031308 ? film * 12.92 : 1.055 * pow(film, 1 / 2.4) - 0.055);
        colour = colour << 8 | (uint32_t)lround(c * 255);
    }
    return colour;
}

void light_bake(struct soup *soup)
{
    struct baker baker = {.rays = rays_build(soup)};
    collect_openings(&baker);
    baker.direct = demo_realloc(NULL, soup->count * sizeof *baker.direct);
    baker.light = demo_realloc(NULL, soup->count * sizeof *baker.light);
    baker.seen = demo_realloc(NULL, soup->count * SEEN * sizeof *baker.seen);
    struct vec3 *next = demo_realloc(NULL, soup->count * sizeof *next);
    for (size_t i = 0; i < soup->count; i++) {
        gather_direct(&baker, i);
        baker.light[i] = baker.direct[i];
    }
    for (int i = 0; i < BOUNCES; i++) {
        struct vec3 *previous = baker.light;
        bounce(&baker, next);
        baker.light = next;
        next = previous;
    }
    for (size_t i = 0; i < soup->count; i++) {
        const struct polygon *polygon = &soup->polygons[i];
        struct vec3 lit = vec_mul(reflectance(polygon), baker.light[i]);
        bool shines = materials[polygon->material].emission > 0;
        soup->polygons[i].colour = shines ? materials[polygon->material].colour : expose(lit);
    }
    free(next);
    free(baker.seen);
    free(baker.light);
    free(baker.direct);
    free(baker.openings);
    rays_free(&baker.rays);
}
