/* SPDX-License-Identifier: MIT
 *
 * hidapi's functions over emulated cables: what links this in gets them instead of the library's. Bridges are plugged
 * into a few places, each with a path and a serial number. */
#ifndef TESTS_FAKE_HIDAPI_H
#define TESTS_FAKE_HIDAPI_H

#include "glass/emulated_cable.h"

#include <wchar.h>

enum { FAKE_PLACES = 20 };

struct fake_place {
    struct emulated_cable *cable; /* NULL, or unplugged: nothing is listed */
    const char *path;
    const wchar_t *serial; /* may be NULL */
    int open_errno;        /* opening it fails with that; 0: it does not */
    bool open_untold;      /* opening it fails, and errno stays as it is */
};

struct fake_hidapi {
    struct fake_place places[FAKE_PLACES];
    unsigned opened, closed, listed, freed;
    unsigned interrupted_every; /* each so many-th read is ended by a signal; 0: none */
    unsigned reads;
    bool writes_short; /* fewer bytes are written than were given */
    int longest_ms;    /* that a read was to wait at most, since this was 0 */
    int shortest_ms;   /* and at least, of those that wait for an answer */
    bool ended_open;   /* the library was left while something was open */
};

extern struct fake_hidapi fake_hidapi; /* hidapi has no contexts */

#endif
