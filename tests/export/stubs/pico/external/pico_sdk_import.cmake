# SPDX-License-Identifier: MIT
#
# Stands in for the Pico SDK, which Debian has not: libraries of its names on the fakes of tests/adapters, for this computer.
set(fakes "${CMAKE_CURRENT_LIST_DIR}/../../../../adapters/fakes")

macro(pico_sdk_init)
    add_library(pico_stdlib INTERFACE)
    target_include_directories(pico_stdlib INTERFACE "${fakes}")
    target_sources(pico_stdlib INTERFACE "${fakes}/fake_pico.c" "${fakes}/fake_wires.c")
    add_library(hardware_spi INTERFACE)
    add_library(hardware_dma INTERFACE)
endmacro()

# The SDK makes the .uf2 here.
function(pico_add_extra_outputs target)
endfunction()
