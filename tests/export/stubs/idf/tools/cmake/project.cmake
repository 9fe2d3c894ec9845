# SPDX-License-Identifier: MIT
#
# Stands in for ESP-IDF, which Debian has not: components as its documentation describes them, each a library of its folder's
# name, and main with the fakes of tests/adapters a program for this computer.
set(fakes "${CMAKE_CURRENT_LIST_DIR}/../../../../../adapters/fakes")

foreach(component driver esp_lcd esp_rom esp_timer)
    add_library(${component} INTERFACE)
    target_include_directories(${component} INTERFACE "${fakes}" "${CMAKE_CURRENT_LIST_DIR}/../../include")
endforeach()

function(idf_component_register)
    cmake_parse_arguments(component "" "" "SRCS;INCLUDE_DIRS;REQUIRES;PRIV_REQUIRES" ${ARGN})
    get_filename_component(name "${CMAKE_CURRENT_LIST_DIR}" NAME)
    add_library(${name} STATIC ${component_SRCS})
    target_include_directories(${name} PUBLIC ${component_INCLUDE_DIRS})
    target_link_libraries(${name} PUBLIC ${component_REQUIRES} ${component_PRIV_REQUIRES})
endfunction()

macro(project name)
    _project(${name} C ${ARGN})
    set(CMAKE_C_STANDARD 11)
    foreach(folder ${EXTRA_COMPONENT_DIRS})
        add_subdirectory("${folder}" component)
    endforeach()
    add_subdirectory(main)
    file(WRITE "${CMAKE_BINARY_DIR}/start.c" "void app_main(void);\nint main(void)\n{\n    app_main();\n    return 0;\n}\n")
    add_executable(${name}.elf "${CMAKE_BINARY_DIR}/start.c" "${fakes}/fake_idf_spi.c" "${fakes}/fake_wires.c")
    target_include_directories(${name}.elf PRIVATE "${fakes}")
    target_link_libraries(${name}.elf main)
endmacro()
