/* SPDX-License-Identifier: MIT
 *
 * What a scene's moving objects cost, as a table. */
#include "base/printable.h"
#include "compiler/leaf_report.h"
#include "compiler/moving_compile.h"
#include "scene/mcu_mem.h"
#include "scene/mcu_sizes.h"

#include <stdio.h>

/* Its scene, its keys, and its entry in the table of objects. */
static size_t object_flash_b(const struct moving_object *object)
{
    const size_t key_b = sizeof *object->keys + (object->origins ? sizeof *object->origins : 0);
    return object->scene.report.flash_b + object->motion.count * key_b + MCU_MOVED_B +
           (object->origins ? (size_t)MCU_MOVED_LONG_B : 0);
}

static void print_object(const struct moving_object *object)
{
    const struct lim_scene *scene = &object->scene.scene;
    printable_print(stdout, "  %-28s %8u %8u %8u %8zu\n", object->name, (unsigned)scene->polygon_count,
                    (unsigned)scene->node_count, (unsigned)object->motion.count, object_flash_b(object));
}

size_t moving_flash_b(const struct moving *moving)
{
    size_t flash_b = 0;
    for (size_t i = 0; i < moving->count; i++)
        flash_b += object_flash_b(&moving->objects[i]);
    return flash_b;
}

static void print_sum(const struct moving *moving)
{
    size_t polygons = 0, nodes = 0, keys = 0;
    for (size_t i = 0; i < moving->count; i++) {
        const struct moving_object *object = &moving->objects[i];
        polygons += object->scene.scene.polygon_count;
        nodes += object->scene.scene.node_count;
        keys += object->motion.count;
    }
    printf("  %-28s %8zu %8zu %8zu %8zu\n", "in all", polygons, nodes, keys, moving_flash_b(moving));
}

void moving_report_print(const struct moving *moving, const struct compiled *scene, const char *name)
{
    printf("%-30s %8s %8s %8s %8s\n", "objects that move", "polygons", "nodes", "keys", "bytes");
    for (size_t i = 0; i < moving->count; i++)
        print_object(&moving->objects[i]);
    print_sum(moving);
    printf("  %-28s %8zu beside the scene's\n", "working memory, bytes", mcu_movers_mem_b(scene, moving));
    for (size_t i = 0; i < moving->count; i++)
        leaf_report_print(&moving->objects[i].scene.report.leaf_parts, moving->objects[i].name);
    if (name)
        printable_print(stdout,
                        "  note: %s.lim holds what stands still alone: `limner render` shows no objects of it\n", name);
}
