/* SPDX-License-Identifier: MIT
 *
 * Declarations between these two are those of functions in C, for C++ as well. */
#ifndef HAL_C_LINKAGE_H
#define HAL_C_LINKAGE_H

#ifdef __cplusplus
#define HAL_C_BEGIN extern "C" {
#define HAL_C_END }
#else
#define HAL_C_BEGIN
#define HAL_C_END
#endif

#endif
