/* SPDX-License-Identifier: MIT
 *
 * Flash and RAM of the smallest boards: ATmega32U4 with its bootloader (Leonardo), RP2040 (Pico), ESP32-C3 with what
 * ESP-IDF leaves of 400 KB and of an application partition of 1 MB. */
#include "export/world.h"

#include "base/choice.h"

#include <string.h>

#define COUNT(files) (sizeof(files) / sizeof *(files))

static const struct world_file ARDUINO[] = {
    {"sim/export/worlds/arduino/library.properties", "library.properties", WORLD_ALWAYS},
    {"sim/export/worlds/arduino/library.json", "library.json", WORLD_ALWAYS},
    {"sim/export/worlds/arduino/README.md", "README.md", WORLD_ALWAYS},
    {"sim/export/worlds/arduino/panel.ino.in", "examples/@name@/@name@.ino", WORLD_WITH_PANEL},
    {"hal/adapters/limner_arduino.h", "src/limner_arduino.h", WORLD_WITH_PANEL},
    {"sim/export/worlds/arduino/tft_espi.ino.in", "examples/@name@_TFT_eSPI/@name@_TFT_eSPI.ino", WORLD_IN_COLOUR},
    {"hal/adapters/limner_tft_espi.h", "src/limner_tft_espi.h", WORLD_IN_COLOUR},
    {"sim/export/worlds/arduino/lovyangfx.ino.in", "examples/@name@_LovyanGFX/@name@_LovyanGFX.ino", WORLD_IN_COLOUR},
    {"hal/adapters/limner_lovyangfx.h", "src/limner_lovyangfx.h", WORLD_IN_COLOUR},
    {"sim/export/worlds/any/lvgl_view.h.in", "examples/@name@_LVGL/@name@_view.h", WORLD_IN_COLOUR},
    {"sim/export/worlds/any/lvgl_view.c.in", "examples/@name@_LVGL/@name@_view.c", WORLD_IN_COLOUR},
    {"hal/adapters/limner_lvgl.h", "src/limner_lvgl.h", WORLD_IN_COLOUR},
};

static const struct world_file IDF[] = {
    {"sim/export/worlds/idf/CMakeLists.txt", "CMakeLists.txt", WORLD_ALWAYS},
    {"sim/export/worlds/idf/idf_component.yml", "idf_component.yml", WORLD_ALWAYS},
    {"sim/export/worlds/idf/README.md", "README.md", WORLD_ALWAYS},
    {"sim/export/worlds/idf/example/CMakeLists.txt", "examples/@name@/CMakeLists.txt", WORLD_WITH_PANEL},
    {"sim/export/worlds/idf/example/main/CMakeLists.txt", "examples/@name@/main/CMakeLists.txt", WORLD_WITH_PANEL},
    {"sim/export/worlds/idf/example/main/main.c.in", "examples/@name@/main/main.c", WORLD_WITH_PANEL},
    {"hal/adapters/limner_idf.h", "include/limner_idf.h", WORLD_WITH_PANEL},
    {"sim/export/worlds/idf/example/CMakeLists.txt", "examples/@name@_esp_lcd/CMakeLists.txt", WORLD_IN_COLOUR},
    {"sim/export/worlds/idf/example/main/CMakeLists.txt", "examples/@name@_esp_lcd/main/CMakeLists.txt",
     WORLD_IN_COLOUR},
    {"sim/export/worlds/idf/esp_lcd/main/main.c.in", "examples/@name@_esp_lcd/main/main.c", WORLD_IN_COLOUR},
    {"hal/adapters/limner_esp_lcd.h", "include/limner_esp_lcd.h", WORLD_IN_COLOUR},
    {"sim/export/worlds/any/lvgl_view.h.in", "examples/@name@_LVGL/@name@_view.h", WORLD_IN_COLOUR},
    {"sim/export/worlds/any/lvgl_view.c.in", "examples/@name@_LVGL/@name@_view.c", WORLD_IN_COLOUR},
    {"hal/adapters/limner_lvgl.h", "include/limner_lvgl.h", WORLD_IN_COLOUR},
};

static const struct world_file PICO[] = {
    {"sim/export/worlds/pico/CMakeLists.txt", "CMakeLists.txt", WORLD_ALWAYS},
    {"sim/export/worlds/pico/README.md", "README.md", WORLD_ALWAYS},
    {"sim/export/worlds/pico/example/CMakeLists.txt", "example/CMakeLists.txt", WORLD_WITH_PANEL},
    {"sim/export/worlds/pico/example/main.c.in", "example/main.c", WORLD_WITH_PANEL},
    {"hal/adapters/limner_pico.h", "src/limner_pico.h", WORLD_WITH_PANEL},
    {"hal/adapters/limner_pico_bus.h", "src/limner_pico_bus.h", WORLD_WITH_PANEL},
};

static const struct world_file CMAKE[] = {
    {"sim/export/worlds/cmake/CMakeLists.txt", "CMakeLists.txt", WORLD_ALWAYS},
    {"sim/export/worlds/cmake/README.md", "README.md", WORLD_ALWAYS},
    {"sim/export/worlds/cmake/example/CMakeLists.txt", "example/CMakeLists.txt", WORLD_ALWAYS},
    {"sim/export/worlds/plain/send.c.in", "example/main.c", WORLD_WITHOUT_PANEL},
    {"sim/export/worlds/plain/panel.c.in", "example/main.c", WORLD_WITH_PANEL},
};

static const struct world_file PLAIN[] = {
    {"sim/export/worlds/plain/README.md", "README.md", WORLD_ALWAYS},
    {"sim/export/worlds/plain/send.c.in", "main.c", WORLD_WITHOUT_PANEL},
    {"sim/export/worlds/plain/panel.c.in", "main.c", WORLD_WITH_PANEL},
};

static const struct world WORLDS[] = {
    {"arduino", "Arduino and PlatformIO", "ili9341", "src/", "src/", ARDUINO, COUNT(ARDUINO), 1, "an Arduino Leonardo",
     28672, 2304, true},
    {"idf", "ESP-IDF", "st7789", "src/", "include/", IDF, COUNT(IDF), 2, "an ESP32-C3", 1048576, 327680, false},
    {"pico", "Pico SDK", "st7789", "src/", "src/", PICO, COUNT(PICO), 2, "a Raspberry Pi Pico", 2097152, 270336, false},
    {"cmake", "CMake", NULL, "src/", "src/", CMAKE, COUNT(CMAKE), 1, NULL, 0, 0, false},
    {"plain", "any compiler", NULL, "", "", PLAIN, COUNT(PLAIN), 1, NULL, 0, 0, false},
};

static const char *name_at(const void *list, size_t index)
{
    const struct world *of = list;
    return index < COUNT(WORLDS) ? of[index].name : NULL;
}

const struct world *world_find(const char *name, struct error *err)
{
    static const struct choice choice = {"--for", "world", name_at, WORLDS};
    size_t index;
    return choice_find(&choice, name, &index, err) ? &WORLDS[index] : NULL;
}
