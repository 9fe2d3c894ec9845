/* SPDX-License-Identifier: MIT
 *
 * Libraries say themselves which version is loaded; of libgpiod it is known for which it was built. */
#include "base/versions.h"

#include "agree.h"

#include <archive.h>
#include <assimp/version.h>
#include <gd.h>
#include <gmp.h>
#include <hidapi.h>
#include <sys/utsname.h>
#include <zlib.h>

#if LIM_HAVE_SDL2
#include <SDL.h>
#endif

/* What `git describe` said when this was built, or nothing. */
#ifndef LIM_SOURCES
#define LIM_SOURCES ""
#endif

#define TEXT(x) #x
#define VERSION(x) TEXT(x)

const char *versions_program(void)
{
    return VERSION(LIM_VERSION_MAJOR) "." VERSION(LIM_VERSION_MINOR) "." VERSION(LIM_VERSION_PATCH) " " LIM_SOURCES;
}

static void print_window_library(FILE *out)
{
#if LIM_HAVE_SDL2
    SDL_version sdl;
    SDL_GetVersion(&sdl);
    fprintf(out, "SDL: %u.%u.%u\n", sdl.major, sdl.minor, sdl.patch);
#else
    fputs("SDL: built without\n", out);
#endif
}

void versions_print(FILE *out)
{
    struct utsname system;
    fprintf(out, "sources: %s\n", LIM_SOURCES[0] ? LIM_SOURCES : "unknown");
#ifdef __clang__
    fprintf(out, "compiler: %s\n", __VERSION__);
#else
    fprintf(out, "compiler: gcc %s\n", __VERSION__);
#endif
    fprintf(out, "assimp: %u.%u.%u\n", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch());
    fprintf(out, "libgd: %s\n", gdVersionString());
    print_window_library(out);
    fprintf(out, "libgpiod: built for %d\n", LIM_GPIOD);
    fprintf(out, "hidapi: %s\n", hid_version_str());
    fprintf(out, "gmp: %s\n", gmp_version);
    fprintf(out, "zlib: %s\n", zlibVersion());
    fprintf(out, "libarchive: %s\n", archive_version_details());
    if (uname(&system) == 0) fprintf(out, "system: %s %s %s\n", system.sysname, system.release, system.machine);
}
