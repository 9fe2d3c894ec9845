/* SPDX-License-Identifier: MIT
 *
 * Building the tree with a list of open tasks instead of recursion: trees may be as deep as the
 * scene has planes. Every node takes all polygons of its own group out of the list, whatever
 * rounding says about them, so the work ends. */
#include "compiler/bsp.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "compiler/tree.h"
#include "model/inner.h"

#include <math.h>
#include <stdlib.h>

/* A list of pieces that shall become a subtree. Lists lie on a stack, the next task's on top. */
struct task {
    uint32_t parent;
    bool in_front;
    size_t first, depth;
};

struct stack {
    uint32_t *pieces;
    size_t count, capacity;
    struct task *tasks;
    size_t task_count, task_capacity;
};

struct list {
    uint32_t *items;
    size_t count, capacity;
};

static void list_add(struct list *list, uint32_t item)
{
    list->items = grow(list->items, list->count, &list->capacity, sizeof *list->items);
    list->items[list->count++] = item;
}

/* Pieces ------------------------------------------------------------------------------------- */

static void corner_add(struct bsp *bsp, uint32_t point, uint32_t edge)
{
    bsp->corners = grow(bsp->corners, bsp->corner_count, &bsp->corner_capacity, sizeof *bsp->corners);
    bsp->corners[bsp->corner_count++] = (struct bsp_corner){point, edge};
}

/* A sphere about the middle of the bounds, a little widened against rounding. */
static void piece_enclose(const struct bsp *bsp, struct bsp_piece *piece)
{
    const double(*approx)[3] = (const double(*)[3])bsp->edges.points->approx;
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < piece->count; i++)
        for (int k = 0; k < 3; k++) {
            double at = approx[bsp->corners[piece->first + i].point][k];
            low[k] = fmin(low[k], at);
            high[k] = fmax(high[k], at);
        }
    double square = 0.0;
    for (int k = 0; k < 3; k++) {
        piece->centre[k] = (low[k] + high[k]) / 2.0;
        square += (high[k] - low[k]) * (high[k] - low[k]) / 4.0;
    }
    piece->radius = sqrt(square) + 0x1p-20;
}

/* Makes a piece of the corners from `first` on. */
static uint32_t piece_add(struct bsp *bsp, size_t first, uint32_t polygon)
{
    bsp->pieces = grow(bsp->pieces, bsp->piece_count, &bsp->piece_capacity, sizeof *bsp->pieces);
    struct bsp_piece *piece = &bsp->pieces[bsp->piece_count];
    *piece = (struct bsp_piece){.first = first, .count = (uint32_t)(bsp->corner_count - first), .polygon = polygon};
    piece_enclose(bsp, piece);
    return (uint32_t)bsp->piece_count++;
}

static uint32_t piece_of_polygon(struct bsp *bsp, uint32_t index)
{
    const struct mesh_polygon *polygon = &bsp->mesh->polygons[index];
    const uint32_t *corners = &bsp->mesh->corners[polygon->first];
    size_t first = bsp->corner_count;
    for (uint32_t i = 0; i < polygon->count; i++) {
        const uint32_t next = corners[(i + 1) % polygon->count];
        const uint32_t edge = edges_between(&bsp->edges, corners[i], next);
        bsp->edges.items[edge].hidden = inner_has(bsp->mesh, corners[i], next);
        corner_add(bsp, corners[i], edge);
    }
    return piece_add(bsp, first, index);
}

/* Planes ------------------------------------------------------------------------------------- */

const struct plane *bsp_plane(const struct bsp *bsp, uint32_t group)
{
    return group < bsp->coplanar->count ? &bsp->coplanar->planes[group] : &bsp->cuts[group - bsp->coplanar->count];
}

uint32_t bsp_cut(struct bsp *bsp, enum plane_kind axis, int32_t d)
{
    const uint32_t index = *map_at(&bsp->cut_of, (uint64_t)axis << 32 | (uint32_t)d, (uint32_t)bsp->cut_count);
    if (index == bsp->cut_count) {
        bsp->cuts = grow(bsp->cuts, bsp->cut_count, &bsp->cut_capacity, sizeof *bsp->cuts);
        bsp->cuts[bsp->cut_count++] =
            (struct plane){.n = {axis == PLANE_X, axis == PLANE_Y, axis == PLANE_Z}, .d = d, .kind = axis, .length = 1};
    }
    return (uint32_t)bsp->coplanar->count + index;
}

/* Sides -------------------------------------------------------------------------------------- */

static int corner_side(const struct bsp *bsp, uint32_t point, const struct plane *plane)
{
    if (bsp->tolerance_units == 0.0) return exact_side(bsp->edges.points, point, plane);
    double distance = plane_distance(plane, bsp->edges.points->approx[point]);
    return (distance > bsp->tolerance_units) - (distance < -bsp->tolerance_units);
}

int bsp_piece_sides(const struct bsp *bsp, const struct bsp_piece *piece, const struct plane *plane)
{
    double distance = plane_distance(plane, piece->centre), reach = piece->radius + bsp->tolerance_units;
    if (fabs(distance) > reach) return distance > 0.0 ? BSP_FRONT : BSP_BACK;
    int sides = BSP_ON;
    for (size_t i = 0; i < piece->count && sides != BSP_BOTH; i++) {
        int side = corner_side(bsp, bsp->corners[piece->first + i].point, plane);
        if (side) sides |= side > 0 ? BSP_FRONT : BSP_BACK;
    }
    return sides;
}

int bsp_piece_filed(const struct bsp *bsp, const struct bsp_piece *piece, const struct plane *plane)
{
    const int sides = bsp_piece_sides(bsp, piece, plane);
    if (sides != BSP_ON) return sides;
    return plane_distance(plane, piece->centre) >= 0.0 ? BSP_FRONT : BSP_BACK;
}

/* Splitting ---------------------------------------------------------------------------------- */

/* Where the outline of a piece leaves one side of a plane: at corner `at`, or just before it. */
struct crossing {
    uint32_t point; /* on the plane */
    uint32_t edge;  /* that leads on from it */
    uint32_t at;    /* the first corner that is not on the side left */
    uint32_t next;  /* the first corner after `point` */
};

/* Follows the outline from corner `from`, which lies on the given side (1 or -1). The outline of a
 * convex polygon leaves a side once; corners that noise brings back to it are not looked at. */
static struct crossing find_crossing(struct bsp *bsp, const struct bsp_piece *piece, uint32_t from, int side,
                                     uint32_t group)
{
    const struct plane *plane = bsp_plane(bsp, group);
    const struct bsp_corner *corners = &bsp->corners[piece->first];
    uint32_t before = from, at;
    int at_side;
    for (;; before = at) {
        at = (before + 1) % piece->count;
        at_side = corner_side(bsp, corners[at].point, plane) * side;
        if (at_side <= 0) break;
    }
    if (at_side == 0) return (struct crossing){corners[at].point, corners[at].edge, at, (at + 1) % piece->count};
    uint32_t edge = corners[before].edge;
    return (struct crossing){edges_cut(&bsp->edges, edge, plane, group), edge, at, at};
}

/* The part of a piece between two crossings, closed by the edge `cut`. */
static uint32_t piece_between(struct bsp *bsp, const struct bsp_piece *piece, struct crossing from, struct crossing to,
                              uint32_t cut)
{
    size_t first = bsp->corner_count;
    corner_add(bsp, from.point, from.edge);
    for (uint32_t i = from.next; i != to.at; i = (i + 1) % piece->count)
        corner_add(bsp, bsp->corners[piece->first + i].point, bsp->corners[piece->first + i].edge);
    corner_add(bsp, to.point, cut);
    return piece_add(bsp, first, piece->polygon);
}

/* The corners farthest in front of and behind the plane. */
static void find_extremes(const struct bsp *bsp, const struct bsp_piece *piece, const struct plane *plane,
                          uint32_t *top, uint32_t *bottom)
{
    double highest = -INFINITY, lowest = INFINITY;
    for (uint32_t i = 0; i < piece->count; i++) {
        const double *at = bsp->edges.points->approx[bsp->corners[piece->first + i].point];
        double distance = plane_distance(plane, at);
        if (distance > highest) *top = i;
        if (distance < lowest) *bottom = i;
        highest = fmax(highest, distance);
        lowest = fmin(lowest, distance);
    }
}

static void piece_split(struct bsp *bsp, uint32_t index, uint32_t group, struct list *front, struct list *back)
{
    const struct bsp_piece piece = bsp->pieces[index];
    uint32_t top = 0, bottom = 0;
    find_extremes(bsp, &piece, bsp_plane(bsp, group), &top, &bottom);
    struct crossing down = find_crossing(bsp, &piece, top, 1, group);
    struct crossing up = find_crossing(bsp, &piece, bottom, -1, group);
    uint32_t cut = edges_add_cut(&bsp->edges, down.point, up.point);
    list_add(front, piece_between(bsp, &piece, up, down, cut));
    list_add(back, piece_between(bsp, &piece, down, up, cut));
    bsp->splits++;
}

/* Building ----------------------------------------------------------------------------------- */

static void place(struct bsp *bsp, struct bsp_node *node, uint32_t piece)
{
    bsp->placed = grow(bsp->placed, bsp->placed_count, &bsp->placed_capacity, sizeof *bsp->placed);
    bsp->placed[bsp->placed_count++] = piece;
    node->count++;
}

static void file_piece(struct bsp *bsp, struct bsp_node *node, uint32_t index, struct list *front, struct list *back)
{
    const struct bsp_piece *piece = &bsp->pieces[index];
    const struct plane *plane = bsp_plane(bsp, node->group);
    if (bsp->coplanar->group[piece->polygon] == node->group) {
        place(bsp, node, index);
        return;
    }
    int sides = bsp_piece_filed(bsp, piece, plane);
    if (sides == BSP_BOTH)
        piece_split(bsp, index, node->group, front, back);
    else
        list_add(sides == BSP_FRONT ? front : back, index);
}

static struct bsp_node *node_add(struct bsp *bsp, const struct task *task, uint32_t group)
{
    bsp->nodes = grow(bsp->nodes, bsp->node_count, &bsp->node_capacity, sizeof *bsp->nodes);
    uint32_t index = (uint32_t)bsp->node_count++;
    struct bsp_node *node = &bsp->nodes[index];
    *node = (struct bsp_node){.group = group,
                              .front = BSP_NONE,
                              .back = BSP_NONE,
                              .parent = task->parent,
                              .in_front = task->in_front,
                              .first = bsp->placed_count};
    if (task->parent != BSP_NONE) {
        struct bsp_node *parent = &bsp->nodes[task->parent];
        *(task->in_front ? &parent->front : &parent->back) = index;
    }
    bsp->depth = task->depth > bsp->depth ? task->depth : bsp->depth;
    return node;
}

static void stack_push(struct stack *stack, struct task task, const struct list *list)
{
    if (list->count == 0) return;
    task.first = stack->count;
    for (size_t i = 0; i < list->count; i++) {
        stack->pieces = grow(stack->pieces, stack->count, &stack->capacity, sizeof *stack->pieces);
        stack->pieces[stack->count++] = list->items[i];
    }
    stack->tasks = grow(stack->tasks, stack->task_count, &stack->task_capacity, sizeof *stack->tasks);
    stack->tasks[stack->task_count++] = task;
}

/* Makes a leaf of the list, if the kind of tree has one here. */
static bool end_in_leaf(struct bsp *bsp, enum tree_kind kind, const struct task *task, const uint32_t *list,
                        size_t count)
{
    uint32_t *order = grow_zeroed(count, sizeof *order);
    const bool ends = tree_ends(bsp, kind, list, count, order);
    if (ends) {
        struct bsp_node *node = node_add(bsp, task, BSP_NONE);
        for (size_t i = 0; i < count; i++)
            place(bsp, node, order[i]);
    }
    free(order);
    return ends;
}

/* Turns the task on top of the stack into a leaf, or into a node and up to two tasks. */
static void divide(struct bsp *bsp, const struct bsp_plan *plan, struct stack *stack, struct list *front,
                   struct list *back)
{
    const struct task task = stack->tasks[--stack->task_count];
    const uint32_t *list = stack->pieces + task.first;
    size_t count = stack->count - task.first;
    if (end_in_leaf(bsp, plan->kind, &task, list, count)) {
        stack->count = task.first;
        return;
    }
    uint32_t group = tree_divider(bsp, plan, (struct tree_place){task.parent, task.in_front}, list, count);
    struct bsp_node *node = node_add(bsp, &task, group);
    front->count = back->count = 0;
    for (size_t i = 0; i < count; i++)
        file_piece(bsp, node, list[i], front, back);
    stack->count = task.first;
    struct task child = {.parent = (uint32_t)(bsp->node_count - 1), .depth = task.depth + 1};
    stack_push(stack, child, back);
    child.in_front = true;
    stack_push(stack, child, front);
}

/* Each node takes one polygon in at least, and those still to come may be split. */
static void show_progress(const struct bsp *bsp, const struct bsp_plan *plan)
{
    const size_t all = bsp->mesh->polygon_count + bsp->splits;
    progress_bar(bsp->placed_count < all ? bsp->placed_count : all, all, "compiling: %zu polygons, %s, %s",
                 bsp->mesh->polygon_count, tree_names[plan->kind], plan->splitter->name);
}

bool bsp_build(struct bsp *bsp, const struct mesh *mesh, const struct coplanar *coplanar, const struct bsp_plan *plan,
               struct exact_points *points)
{
    *bsp = (struct bsp){.mesh = mesh, .coplanar = coplanar, .tolerance_units = plan->tolerance_units};
    bsp->edges.points = points;
    struct stack stack = {0};
    struct list front = {0}, back = {0};
    for (size_t i = 0; i < mesh->polygon_count; i++)
        list_add(&front, piece_of_polygon(bsp, (uint32_t)i));
    stack_push(&stack, (struct task){.parent = BSP_NONE, .depth = 1}, &front);
    if (tree_wants_rings(plan, bsp->piece_count)) rings_find(&bsp->rings, bsp);
    while (stack.task_count && bsp->piece_count <= BSP_PIECES_MAX && !deadline_passed()) {
        show_progress(bsp, plan);
        divide(bsp, plan, &stack, &front, &back);
    }
    bool complete = stack.task_count == 0 && !deadline_passed(); /* what ended early is no tree */
    edges_sort(&bsp->edges);
    free(front.items);
    free(back.items);
    free(stack.pieces);
    free(stack.tasks);
    return complete;
}

void bsp_free(struct bsp *bsp)
{
    edges_free(&bsp->edges);
    map_free(&bsp->cut_of);
    rings_free(&bsp->rings);
    free(bsp->cuts);
    free(bsp->corners);
    free(bsp->pieces);
    free(bsp->nodes);
    free(bsp->placed);
    *bsp = (struct bsp){0};
}
