/* SPDX-License-Identifier: MIT
 *
 * Looks through all of /dev/gpiochip*, also when the line was found, so that a name that two lines have is noticed. */
#include "gpio_names.h"

#include "fail.h"

#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char CONSUMER[] = "limner";

struct search {
    const char *name;
    char chip[64];         /* of CHIP:NUMBER; "": by the line's own name, as of ":NUMBER" */
    unsigned long number;  /* of CHIP:NUMBER */
    struct gpio_line line; /* the first that was found */
    unsigned found;
    char second[2 * GPIO_NAME_B];    /* where the second was found */
    char searched[PORT_ERROR_B / 2]; /* the chips, for an error */
    char denied[64];                 /* a chip that could not be opened, and */
    int denied_err_no;               /* why; 0: there is none */
};

/* A line's name may have a colon too: what follows that of CHIP:NUMBER is a number. */
static void search_parse(struct search *search, const char *name)
{
    const char *colon = strrchr(name, ':');
    char *end = NULL;
    *search = (struct search){.name = name};
    if (!colon || colon[1] < '0' || colon[1] > '9') return;
    search->number = strtoul(colon + 1, &end, 10);
    if (*end != '\0') return;
    if (strncmp(name, "/dev/", 5) == 0) name += 5;
    snprintf(search->chip, sizeof search->chip, "%.*s", (int)(colon - name), name);
}

static void search_list(struct search *search, const struct gpio_chip *chip)
{
    const size_t used = strlen(search->searched);
    snprintf(search->searched + used, sizeof search->searched - used, "%s%s (%s)", used ? ", " : "", chip->name,
             chip->label);
}

static void search_found(struct search *search, const struct gpio_chip *chip, unsigned offset)
{
    search->found++;
    if (search->found == 1)
        search->line = (struct gpio_line){.chip = *chip, .offset = offset};
    else
        snprintf(search->second, sizeof search->second, "%s:%u", chip->name, offset);
}

static int search_lines(struct search *search, const struct gpio_chip *chip)
{
    struct gpio_line_info info;
    for (unsigned offset = 0; offset < chip->n_lines; offset++) {
        const int err = gpio_chip_line(chip, offset, &info);
        if (err) return err;
        if (strcmp(info.name, search->name) == 0) search_found(search, chip, offset);
    }
    return 0;
}

/* The chip of the first find stays open, with that. A link to a chip has another name than the chip has: it is met
 * there. */
static int search_chip(struct search *search, const char *path)
{
    const bool found_before = search->found > 0;
    struct gpio_chip chip;
    int err = gpio_chip_open(&chip, path);
    if (err) {
        search->denied_err_no = -err;
        snprintf(search->denied, sizeof search->denied, "%s", path);
        return 0;
    }
    if (strcmp(strrchr(path, '/') + 1, chip.name) == 0) {
        search_list(search, &chip);
        if (search->chip[0] == '\0')
            err = search_lines(search, &chip);
        else if (strcmp(search->chip, chip.name) == 0 || strcmp(search->chip, chip.label) == 0)
            search_found(search, &chip, (unsigned)search->number);
    }
    if (found_before || !search->found) gpio_chip_close(&chip);
    return err;
}

static int search_all(struct search *search)
{
    glob_t paths;
    int err = 0;
    if (glob("/dev/gpiochip*", 0, NULL, &paths) != 0) return 0;
    for (size_t i = 0; i < paths.gl_pathc && !err; i++)
        err = search_chip(search, paths.gl_pathv[i]);
    globfree(&paths);
    return err;
}

static int nothing_found(const struct search *search, struct port *port)
{
    const int err_no = search->denied_err_no;
    if (err_no == EACCES || err_no == EPERM) return linux_fail_denied(port, err_no, search->denied, "gpio");
    if (err_no) return linux_fail(port, err_no, "%s: %s", search->denied, strerror(err_no));
    if (search->searched[0] == '\0')
        return linux_fail(port, ENOENT, "%s: there is no GPIO chip, no /dev/gpiochip*; load its driver", search->name);
    return linux_fail(port, ENOENT, "%s: no %s of that name on %s; `limner devices` lists them", search->name,
                      search->chip[0] ? "chip" : "line", search->searched);
}

static int search_check(const struct search *search, struct port *port)
{
    const struct gpio_line *line = &search->line;
    if (search->found == 0) return nothing_found(search, port);
    if (search->found > 1)
        return linux_fail(port, ENOTUNIQ, "%s: more than one is called so; give %s:%u or %s", search->name,
                          line->chip.name, line->offset, search->second);
    if (search->chip[0] && search->number >= line->chip.n_lines)
        return linux_fail(port, EINVAL, "%s: %s (%s) has lines 0 to %u", search->name, line->chip.name,
                          line->chip.label, line->chip.n_lines - 1);
    return 0;
}

static int in_use(const struct gpio_line *line, const char *name, int err_no, struct port *port)
{
    struct gpio_line_info info;
    const bool known = err_no == EBUSY && gpio_chip_line(&line->chip, line->offset, &info) == 0 && info.consumer[0];
    if (known)
        return linux_fail(
            port, err_no,
            "%s: %s:%u is in use by \"%s\"; end that program, take the overlay away that says so, or take another line",
            name, line->chip.name, line->offset, info.consumer);
    return linux_fail(port, err_no, "%s: %s:%u cannot be had: %s", name, line->chip.name, line->offset,
                      strerror(err_no));
}

int gpio_take(struct gpio_line *line, const char *name, enum gpio_use use, struct port *port)
{
    struct search search;
    search_parse(&search, name);
    int err = search_all(&search);
    err = err ? linux_fail(port, -err, "%s: lines cannot be listed: %s", name, strerror(-err))
              : search_check(&search, port);
    *line = search.line;
    if (!err) {
        err = gpio_line_request(line, use, CONSUMER);
        if (err) (void)in_use(line, name, -err, port);
    }
    if (err) gpio_line_release(line);
    return err;
}
