/* SPDX-License-Identifier: MIT */
#include "measure/measure_tools.h"

#include "base/child.h"
#include "base/notice.h"

#include <stdio.h>
#include <string.h>

enum { TOOLS_MAX = 8, LIST_B = 256 };

/* Each once. */
struct missing {
    const char *programs[TOOLS_MAX], *packages[TOOLS_MAX];
    size_t count;
};

static bool is_missing(struct missing *missing, const char *program, const char *package)
{
    if (child_exists(program)) return false;
    for (size_t i = 0; i < missing->count; i++)
        if (strcmp(missing->programs[i], program) == 0) return true;
    if (missing->count == TOOLS_MAX) return true;
    missing->programs[missing->count] = program;
    missing->packages[missing->count++] = package;
    return true;
}

static bool lacks(const struct measure_cpu *cpu, struct missing *missing)
{
    const bool no_compiler = is_missing(missing, cpu->compiler, cpu->compiler_package);
    return is_missing(missing, cpu->emulator, cpu->emulator_package) || no_compiler;
}

static void list(const char *const *words, size_t count, const char *between, char text[LIST_B])
{
    *text = '\0';
    for (size_t i = 0, at = 0; i < count && at < LIST_B; i++)
        at += (size_t)snprintf(text + at, LIST_B - at, "%s%s", i ? between : "", words[i]);
}

static void tell(const struct missing *missing, const char *const *titles, size_t count, bool is_all)
{
    char cpus[LIST_B], programs[LIST_B], packages[LIST_B];
    const bool is_one = missing->count == 1;
    list(titles, count, ", ", cpus);
    list(missing->programs, missing->count, ", ", programs);
    list(missing->packages, missing->count, " ", packages);
    notice("instructions are not counted%s%s: %s %s not there; Debian's package%s %s", is_all ? "" : " on ",
           is_all ? "" : cpus, programs, is_one ? "is" : "are", is_one ? "" : "s", packages);
}

static void fit_cpus(struct measure_request *request)
{
    struct missing missing = {.count = 0};
    const char *titles[MEASURE_REQUEST_CPUS_MAX];
    size_t kept = 0, left_out = 0;
    for (size_t i = 0; i < request->cpu_count; i++) {
        const struct measure_cpu *cpu = request->cpus[i];
        if (lacks(cpu, &missing))
            titles[left_out++] = cpu->title;
        else
            request->cpus[kept++] = cpu;
    }
    request->cpu_count = kept;
    if (left_out) tell(&missing, titles, left_out, !kept);
}

/* Of a program that was copied somewhere else without its sources. */
static bool has_sources(const struct measure_request *request)
{
    struct error reason;
    if (measure_sources_check(&reason)) return true;
    if (request->cpu_count) notice("instructions are not counted: %s", reason.text);
    return false;
}

void measure_tools_fit(struct measure_request *request)
{
    if (request->is_cost_asked) return;
    if (has_sources(request))
        fit_cpus(request);
    else
        request->cpu_count = 0;
    if (!request->folder || !request->cpu_count || child_exists("gnuplot")) return;
    request->no_plot = true;
    notice("measure.png is not drawn: gnuplot is not there; Debian's package gnuplot-nox");
}
