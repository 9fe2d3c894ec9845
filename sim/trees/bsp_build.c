/* SPDX-License-Identifier: MIT
 *
 * Building the tree with a list of open tasks instead of recursion: trees may be as deep as the
 * scene has planes. Every node takes all polygons of its own group out of the list, whatever
 * rounding says about them, so the work ends. */
#include "trees/bsp_build.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "trees/dense_cut.h"

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

/* A tree under way. */
struct build {
    struct bsp *bsp;
    const struct tree_plan *plan;
    struct rings rings;  /* of clusters: of the list that a subtree began with; empty: not found */
    size_t tasks_beside; /* on the stack, of no part of that list */
    struct stack stack;
    struct list front, back; /* of the node at hand */
};

static void build_free(struct build *build)
{
    rings_free(&build->rings);
    free(build->front.items);
    free(build->back.items);
    free(build->stack.pieces);
    free(build->stack.tasks);
}

static void list_add(struct list *list, uint32_t item)
{
    list->items = grow(list->items, list->count, &list->capacity, sizeof *list->items);
    list->items[list->count++] = item;
}

static void place(struct bsp *bsp, struct bsp_node *node, uint32_t piece)
{
    bsp->placed = grow(bsp->placed, bsp->placed_count, &bsp->placed_capacity, sizeof *bsp->placed);
    bsp->placed[bsp->placed_count++] = piece;
    node->count++;
}

static void file_piece(struct bsp *bsp, struct bsp_node *node, uint32_t index, struct list *front, struct list *back)
{
    const struct bsp_piece *piece = &bsp->pieces[index];
    if (bsp->coplanar->group[piece->polygon] == node->group) {
        place(bsp, node, index);
        return;
    }
    int sides = bsp_piece_filed(bsp, piece, node->group);
    if (sides != BSP_BOTH) {
        list_add(sides == BSP_FRONT ? front : back, index);
        return;
    }
    uint32_t in_front, behind;
    bsp_piece_split(bsp, index, node->group, &in_front, &behind);
    list_add(front, in_front);
    list_add(back, behind);
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

/* Who hides whom, where a list gets short enough for that: it serves the list's whole subtree. */
static void settle_rings(struct build *build, const uint32_t *list, size_t count)
{
    struct rings *rings = &build->rings;
    if (rings->hiding.count && build->stack.task_count < build->tasks_beside) rings_free(rings);
    if (dense_count(build->bsp, build->plan->parts, list, count)) return;
    if (rings->hiding.count || !tree_wants_rings(build->plan, count)) return;
    rings_find(rings, build->bsp, list, count);
    build->tasks_beside = build->stack.task_count;
}

static void leaf_add(struct bsp *bsp, const struct task *task, const uint32_t *pieces, size_t count, bool is_mesh)
{
    struct bsp_node *node = node_add(bsp, task, BSP_NONE);
    node->is_mesh = is_mesh;
    for (size_t i = 0; i < count; i++)
        place(bsp, node, pieces[i]);
}

/* Makes a leaf of the list, if the kind of tree has one here. */
static bool end_in_leaf(struct build *build, const struct task *task, const uint32_t *list, size_t count)
{
    struct bsp *bsp = build->bsp;
    const bool is_dense = dense_count(bsp, build->plan->parts, list, count) > 0;
    if (is_dense) {
        if (!tree_ends_dense(bsp, build->plan, list, count)) return false;
        leaf_add(bsp, task, list, count, true);
        return true;
    }
    uint32_t *order = grow_zeroed(count, sizeof *order);
    const bool ends = tree_ends(bsp, build->plan->kind, &build->rings, list, count, order);
    if (ends) leaf_add(bsp, task, order, count, false);
    free(order);
    return ends;
}

/* Turns the task on top of the stack into a leaf, or into a node and up to two tasks. */
static void divide(struct build *build)
{
    struct bsp *bsp = build->bsp;
    struct stack *stack = &build->stack;
    struct list *front = &build->front, *back = &build->back;
    const struct task task = stack->tasks[--stack->task_count];
    const uint32_t *list = stack->pieces + task.first;
    size_t count = stack->count - task.first;
    settle_rings(build, list, count);
    if (end_in_leaf(build, &task, list, count)) {
        stack->count = task.first;
        return;
    }
    uint32_t group =
        tree_divider(bsp, build->plan, &build->rings, (struct bsp_place){task.parent, task.in_front}, list, count);
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
static void show_progress(const struct bsp *bsp, const struct tree_plan *plan)
{
    const size_t all = bsp->mesh->polygon_count + bsp->splits;
    progress_bar(bsp->placed_count < all ? bsp->placed_count : all, all, "compiling: %zu polygons, %s, %s",
                 bsp->mesh->polygon_count, tree_names[plan->kind], plan->splitter->name);
}

bool bsp_build(struct bsp *bsp, const struct mesh *mesh, const struct coplanar *coplanar, const struct tree_plan *plan,
               struct exact_points *points)
{
    struct build build = {.bsp = bsp, .plan = plan};
    *bsp = (struct bsp){
        .mesh = mesh, .coplanar = coplanar, .parts = plan->parts, .tolerance_units = plan->tolerance_units};
    bsp->edges.points = points;
    for (size_t i = 0; i < mesh->polygon_count; i++)
        list_add(&build.front, bsp_piece_of(bsp, (uint32_t)i));
    stack_push(&build.stack, (struct task){.parent = BSP_NONE, .depth = 1}, &build.front);
    while (build.stack.task_count && bsp->piece_count <= BSP_PIECES_MAX && !deadline_passed()) {
        show_progress(bsp, plan);
        divide(&build);
    }
    bool complete = build.stack.task_count == 0 && !deadline_passed(); /* what ended early is no tree */
    edges_sort(&bsp->edges);
    build_free(&build);
    return complete;
}
