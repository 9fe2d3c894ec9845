/* SPDX-License-Identifier: MIT
 *
 * What tests of the compiler's choices begin with. A failure ends the test. */
#ifndef TESTS_CHOICE_RIG_H
#define TESTS_CHOICE_RIG_H

#include "accuracy/reference.h"
#include "compiler/compile.h"
#include "rigs/mesh_rig.h"

/* They leave the order to the compiler. */
struct compile_options choice_rig_options(void);

/* compiled_free() and reference_free() them. */
struct compiled choice_rig_compile(const struct mesh *mesh, const struct compile_options *options);
struct reference choice_rig_reference(const struct mesh *mesh);

/* Whether the compiler tries what a test is about. */
typedef bool choice_rig_is_tried(const struct mesh *mesh, const struct compile_options *options);

/* It does with these options alone, not where the profile is exact, the method or the tree named, edges drawn, or
 * another order unwanted. */
void choice_rig_assert_open(const struct mesh *mesh, choice_rig_is_tried *is_tried);

#endif
