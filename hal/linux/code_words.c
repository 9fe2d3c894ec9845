/* SPDX-License-Identifier: MIT */
#include "code_words.h"

#include "mcu/mcu.h"
#include "panel.h"
#include "target.h"

#include <stddef.h>
#include <string.h>

/* Linux has no errno beyond it. */
enum { ERRNO_END = 1000 };

static const struct {
    int code;
    const char *words;
} table[] = {
    {LIM_ERR_MEMORY, "too little memory"},
    {LIM_ERR_SCENE, "the scene needs more than the renderer was built for"},
    {LIM_ERR_TARGET, "the target's size or format is not supported, or it lent no line"},
    {LIM_ERR_CAMERA, "the camera's position or lens is out of range"},
    {LIM_ERR_BEGIN, "no frame was begun"},
    {LIM_ERR_ANSWER, "the target answered with a positive number, where it should with 0 or a negative one"},
    {PANEL_ERR_CONFIG, "the configuration does not fit the panel's chip"},
    {PANEL_ERR_WINDOW, "a window lies outside of the panel, or got more pixels than it has"},
    {PANEL_ERR_UNSUPPORTED, "the panel cannot do it, or the pin for it is not wired"},
    {MCU_ERR_TIMEOUT, "a peripheral did not get ready in time"},
    {MCU_ERR_CONFIG, "a rate, a pin or a mode that the peripheral does not have"},
    {MCU_ERR_BUS, "a DMA controller could not read or write memory"},
};

const char *code_words(int code)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (table[i].code == code) return table[i].words;
    return code < 0 && code > -ERRNO_END ? strerror(-code) : "a code that only the port knows";
}
