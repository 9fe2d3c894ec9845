/* SPDX-License-Identifier: MIT
 *
 * All that the page of `limner report` tells: collected first (page_collect.c), then written, a file a section. */
#ifndef SIM_PAGE_H
#define SIM_PAGE_H

#include "measure/measure_request.h"
#include "measure/worst_views.h"
#include "scene/method.h"

#include <gd.h>
#include <stdio.h>

enum { PAGE_VIEWS = 24, PAGE_SHOWN = 12, PAGE_ROWS_MAX = 16, PAGE_LABEL_B = 64 };

/* A view from somewhere. */
struct page_view {
    gdImagePtr picture, difference; /* NULL: not shown */
    struct lim_stats stats;
    struct compare_counts wrong;
};

/* A choice that there is: a precision, or a method with its tree. */
struct page_row {
    char label[PAGE_LABEL_B], option[PAGE_LABEL_B]; /* what asks for it */
    const struct core *core;
    struct compiled scene; /* its arrays are page.scenes', or `own`'s */
    struct compiled own;
    struct accuracy accuracy;
    struct cost costs[MEASURE_REQUEST_CPUS_MAX];
    bool is_this;     /* what the page is about */
    bool has_worst;   /* compiled with --worst */
    bool is_on_front; /* nothing is better both ways: wrong pixels, and instructions where these are known, else RAM */
    double instructions; /* a frame: counted on the first processor, else predicted; NaN: neither */
};

struct page {
    struct measure_request request;
    struct measure_source source;
    struct measure_scenes scenes;
    struct compiled scene; /* the one that the page is about: shares a row's arrays */
    struct lens lens;
    struct camera_path path;
    const char *path_words; /* which cameras these are */
    struct page_view views[PAGE_VIEWS];
    size_t view_count, shown_count;
    struct page_row rows[PAGE_ROWS_MAX];
    size_t row_count, this_row;
    struct measure_refusals refused;
    struct worst_views worst;
    struct page_view worst_cost, worst_error;
    char too_long[128]; /* why other methods are no rows; empty: they are, or do not go with the scene */
};

/* Compiles, draws, compares, searches, and counts where processors are named. */
bool page_collect(struct page *page, struct error *err);

/* One file of HTML. */
bool page_write(const struct page *page, FILE *file, struct error *err);

void page_free(struct page *page);

/* Sections, each with its heading. */
bool page_views_write(const struct page *page, FILE *file, struct error *err);
bool page_worst_write(const struct page *page, FILE *file, struct error *err);
void page_cost_write(const struct page *page, FILE *file);
void page_memory_write(const struct page *page, FILE *file);
void page_tree_write(const struct page *page, FILE *file);
void page_front_write(const struct page *page, FILE *file);
void page_advice_write(const struct page *page, FILE *file);

/* Bytes of RAM on a 32-bit MCU: working memory, what moves, pixels. */
size_t page_ram_b(const struct page *page, const struct compiled *scene);
size_t page_pixels_b(const struct page *page, const struct compiled *scene);

/* Whether frame_cost.h's figures are instructions of these frames. */
bool page_is_predicted(const struct page *page);

#endif
