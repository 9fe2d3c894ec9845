# SPDX-License-Identifier: MIT
#
# Builds, demonstrates and tests Limner. `make help` lists the goals; `make --trace` shows every command in full.
# Products go to $(BUILD) and out/. Nothing but make is needed to start: see sim/tools/setup.sh.

# -- What can be chosen: make CC=clang OPT=-O0 BUILD=build/other SUITES="host cross" DEPS=no ---------------------------

BUILD := build
OPT   := -O2
# A board's OPT is that of its image: the host program stays as it is.
HOST_OPT := $(if $(BOARD),-O2,$(OPT))
HIDAPI := hidraw
ifeq ($(origin CC),default)
CC    := gcc
endif
export BUILD CC
# What is made does not hang on how busy the machine is.
export LIMNER_TIME_LIMIT := 0
# CCACHE= does without.
ifeq ($(origin CCACHE),undefined)
CCACHE := $(shell sh sim/tools/compiler_cache.sh)
endif

# All of them, but for programs that are slow and seldom find anything: those are the suite `slow`.
ALL_SUITES := host arm cpus boards export cross compilers sanitize models brought format kernel foreign
SUITES     := host arm
suites     := $(if $(filter all,$(SUITES)),$(ALL_SUITES),$(SUITES))

# -- How make runs: on all cores, each recipe's output in one piece ----------------------------------------------------

ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell nproc) --output-sync --no-print-directory
endif
# Begins a recipe line whose output must appear as it comes: with +, but not under `make -n`, where + would run it.
LIVE = $(if $(findstring n,$(firstword -$(MAKEFLAGS))),,+)@

# What is like a word, of a list: `= WORD` but for capitals, or `~ WORD`, or nothing; and that as a question.
nearest = $(shell awk -f sim/tools/nearest.awk -- '$(1)' $(2))
is_it   = $(foreach meant,$(word 2,$(call nearest,$(1),$(2))),$(comma) is it $(meant)?)
comma  := ,

# A goal that is no file is one of those below.
wrong_goal := $(firstword $(foreach goal,$(MAKECMDGOALS),$(if $(findstring /,$(goal))$(findstring .,$(goal)),,$(goal))))
ifneq ($(wrong_goal),)
known_goals := $(shell awk -f sim/tools/goals.awk Makefile boards/image.mk)
wrong_goal  := $(firstword $(foreach goal,$(filter-out $(known_goals),$(MAKECMDGOALS)),$(if $(findstring /,$(goal))$(findstring .,$(goal)),,$(goal))))
$(if $(wrong_goal),$(error there is no goal $(wrong_goal)$(call is_it,$(wrong_goal),$(known_goals)); make help lists them))
endif

.PHONY: first-hour all install uninstall extremes soak run view check test test-arm64 test-fixed test-programs models-table tables footprint tradeoff scale predictions compare bench bench-baseline prove exhaustive fuzz fuzz-coverage mutate format clean help packages force
.SECONDARY:
.DELETE_ON_ERROR:

all: $(BUILD)/limner ## [start] build the host program, build/limner (the default); BOARD=NAME: a board's image

help: ## [care] list the goals
	@awk -f sim/tools/help.awk Makefile boards/image.mk
	@printf '\nSuites of make test: %s.\nOn demand: slow (what is slow and seldom finds anything; proofs are among it), arm64 (a stock kernel), features (all pairs of LIM_HAS_ flags; SUITES=all has an eighth, SEED=0 to 7 say which), models, boards, compilers and cross with SEED=all (else a part), sanitize with it (else a sixteenth), long unit tests with it (else half of their work), sub-bits (profiles with other ones), levels (all maps of Freedoom; LEVELS="E1M1 MAP01": these), and cpus with EVERY_PROFILE=yes.\n' "$(ALL_SUITES)"

# -- Debian packages: what every build needs, and what a goal or a suite needs beside ----------------------------------

packages-build         := gcc libc6-dev pkg-config libassimp-dev libgd-dev libgmp-dev libjansson-dev libmeshoptimizer-dev zlib1g-dev \
	libgpiod-dev libhidapi-dev libarchive-dev lib3mf-dev
packages-host          := libcmocka-dev libosmesa6-dev sigrok-cli groff-base tidy freedoom python3
packages-arm           := gcc-arm-none-eabi qemu-system-arm gnuplot-nox
packages-fixed         := $(packages-host) $(packages-arm)
packages-cpus          := g++ $(packages-arm) gcc-riscv64-unknown-elf gcc-avr avr-libc gcc-powerpc-linux-gnu \
	libc6-dev-powerpc-cross gcc-xtensa-lx106 qemu-system-misc qemu-user simavr
packages-export        := g++ cmake arduino-builder arduino-core-avr gcc-avr avr-libc libsimavr-dev libelf-dev gcc-riscv64-unknown-elf \
	qemu-system-misc $(packages-arm)
packages-cross         := gcc-arm-none-eabi gcc-riscv64-unknown-elf gcc-avr avr-libc g++ clang
packages-compilers     := g++ clang gcc-arm-none-eabi gcc-riscv64-unknown-elf
packages-sanitize      := $(packages-host)
packages-models        := assimp-testmodels
# parallel is for tests/choices/cli_sweep.sh, which skips what wants it where it is not there.
packages-brought       := python3 python3-numpy python3-pil parallel $(packages-models)
packages-features      := clang
packages-arm64         := libcmocka-dev gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-system-arm device-tree-compiler cpio
packages-test-arm64    := $(packages-arm64)
packages-kernel        := libcmocka-dev linux-source-6.1 flex bison bc xz-utils gpiod
packages-foreign       := python3-luma.lcd python3-luma.oled $(packages-kernel)
packages-format        := clang-format
packages-soak          := $(packages-host)
packages-sub-bits      := $(packages-host) $(packages-arm) gcc-riscv64-unknown-elf qemu-system-misc
packages-extremes      := $(packages-host)
packages-prove         := frama-c-base why3 z3
packages-slow          = $(foreach suite,arm cpus boards export cross sanitize prove,$(packages-$(suite)))
packages-levels        := freedoom $(packages-arm)
packages-level-walks   := $(packages-levels)
packages-fuzz          := clang libclang-rt-dev
packages-mutate        := $(packages-host)
packages-fuzz-coverage := $(packages-fuzz)
packages-view          := libsdl2-dev
packages-stm32         := $(shell sed -n 's/^RULES_PACKAGES *:= *//p' boards/stm32f405/board.mk)
packages-simavr        := $(shell sed -n 's/^EMULATE_PACKAGES *:= *//p' boards/arduboy/board.mk)
packages-models-table  := $(packages-models)
packages-test-programs := $(packages-host)
packages-footprint     := gcc-arm-none-eabi
packages-flags         := gcc-arm-none-eabi
packages-tradeoff      := $(packages-arm) gcc-riscv64-unknown-elf qemu-system-misc
packages-scale         := gcc-arm-none-eabi qemu-system-arm gnuplot-nox
packages-contact-sheet := $(packages-models)
packages-predictions    := $(packages-models)
packages-compare       := gcc-arm-none-eabi qemu-system-arm
packages-bench         := $(packages-tradeoff) $(packages-models) freedoom valgrind
packages-bench-baseline := $(packages-bench)
packages-boards        := freedoom sigrok-cli $(shell sed -n 's/^\(EMULATE_\|RULES_\)\{0,1\}PACKAGES *:= *//p' boards/*/board.mk)
packages-methods        := gcc-arm-none-eabi qemu-system-arm freedoom $(packages-models)
packages-delta-cost    := gcc-arm-none-eabi qemu-system-arm
packages-overlay-cost  := gcc-arm-none-eabi qemu-system-arm
packages-doom           := freedoom valgrind
packages-texels          := gcc-arm-none-eabi qemu-system-arm freedoom
packages-walk-cost       := gcc-arm-none-eabi qemu-system-arm freedoom
packages-tables        := $(foreach table,$(TABLES),$(packages-$(table)))
packages-test          := ccache $(foreach suite,$(suites),$(packages-$(suite)))

# A goal that is a file needs what makes it; with BOARD= every goal may need the board's compiler.
packages-for-file = $(strip $(if $(filter $(BUILD)/tests/% $(BUILD)/host/tests/% tests/%,$(1)),$(packages-host)) \
	$(if $(filter $(BUILD)/tests/fuzz,$(1)),$(packages-fuzz)) $(if $(filter $(BUILD)/simavr_oled,$(1)),$(packages-simavr)) \
	$(if $(filter $(BUILD)/stm32 $(BUILD)/esp32c3,$(1)),$(packages-stm32)))
goals           := $(or $(MAKECMDGOALS),all)
packages-wanted  = $(packages-build) $(if $(findstring clang,$(CC)),clang) $(packages-board) \
	$(foreach goal,$(goals),$(packages-$(goal)) $(call packages-for-file,$(goal)))

# Whatever calls a tool waits for this, most of it through a file of flags; tests/cli/cli_packages.sh looks.
packages:
	$(LIVE)sh sim/tools/setup.sh $(sort $(packages-wanted))

# -- The host program: firmware and simulator, all but main() in a library that the tests link too ---------------------

WARNINGS := -Wall -Wextra -Wconversion -Wshadow -Wundef -Wmissing-prototypes -Wstrict-prototypes -Werror
export WARNINGS

# hidapi reaches bridges by the kernel's hidraw or, with HIDAPI=libusb, past it.
LIBRARIES = assimp gdlib jansson libarchive libgpiod hidapi-$(HIDAPI)
HAVE_SDL2 = $(shell pkg-config --exists sdl2 && echo 1 || echo 0)
SDL2      = $(if $(filter 1,$(HAVE_SDL2)),sdl2)
GPIOD     = $(firstword $(subst ., ,$(shell pkg-config --modversion libgpiod)))
FLAGS = -std=c11 $(HOST_OPT) $(WARNINGS) -ffp-contract=off -D_POSIX_C_SOURCE=200809L \
	-DLIM_GPIOD=$(GPIOD) -DSCREEN_STREAMS=1 \
	-Ifirmware -Ihal -Isim -Iboards/common $(shell pkg-config --cflags $(LIBRARIES)) -MMD -MP
LINKS = $(shell pkg-config --libs $(LIBRARIES) $(SDL2)) -l3MF -lmeshoptimizer -lgmp -lz -lm

progress    = sh sim/tools/progress.sh
progress_of = $(BUILD)/progress $(progress_count)
object  = $(patsubst %.c,$(BUILD)/host/%.o,$(1))
# The rooms of sim/ and of firmware/, the lowest first: each includes itself and lower ones (tests/rooms.sh).
rooms   := base outputs core pictures model levels files gltf formats readers scene trees portals cameras displays glass render accuracy compiler export measure page cli
firmware_rooms := math view screen pixels movers lines touch pieces orders
sources := $(filter-out sim/core/core.c,$(wildcard firmware/*.c $(firmware_rooms:%=firmware/%/*.c) hal/*.c hal/linux/*.c hal/hid/*.c hal/mcu/*.c $(rooms:%=sim/%/*.c))) \
	$(addprefix boards/common/,card.c screen.c test_card.c walker.c)
library := $(BUILD)/host/liblimner.a

# The compiler reads its flags from this file, so that whatever is compiled is compiled anew when they change.
$(BUILD)/host/flags: force | packages
	@mkdir -p $(@D)
	@echo '$(FLAGS)' | cmp -s - $@ || echo '$(FLAGS)' > $@
	@$(progress) begin $(progress_of)

$(BUILD)/host/%.o: %.c $(BUILD)/host/flags
	@mkdir -p $(@D)
	@$(progress) step $(progress_of) "CC $<"
	@$(CCACHE) $(CC) @$(BUILD)/host/flags $(PLACES) -c -o $@ $<

%.a:
	@rm -f $@
	@ar rcs $@ $^

# The renderer once for each precision profile, all names but that of its table made local. Those with other sub-pixel
# bits are compiled by whoever measures them: see sim/targets/core.sh.
profiles     := draft fast fine exact
export PROFILES = $(profiles)
core_sources := $(wildcard firmware/*.c $(firmware_rooms:%=firmware/%/*.c)) sim/core/core.c
core_object   = $(patsubst %.c,$(BUILD)/core-$(1)/%.o,$(core_sources))
core_flags    = -DCORE=core_$(1) -DLIM_PROFILE=LIM_PROFILE_$(shell echo $(1) | tr a-z A-Z)

define core
$(BUILD)/core-$(1)/%.o: %.c $(BUILD)/host/flags
	@mkdir -p $$(@D)
	@$$(progress) step $$(progress_of) "CC $$< ($(1))"
	@$$(CCACHE) $$(CC) @$(BUILD)/host/flags $(core_flags) -c -o $$@ $$<

$(BUILD)/core-$(1).o: $(call core_object,$(1))
	@ld -r -o $$@ $$^
	@objcopy --keep-global-symbol=core_$(1) $$@

-include $(patsubst %.o,%.d,$(call core_object,$(1)))
endef
$(foreach name,$(profiles),$(eval $(call core,$(name))))

# What `limner export` writes folders from: sim/export/embedded.h.
embedded := $(sort $(wildcard firmware/*.[ch] $(firmware_rooms:%=firmware/%/*.[ch]) hal/*.[ch] hal/adapters/*.h) \
	$(addprefix boards/common/,board.h screen.c screen.h screen_work.h) $(shell find sim/export/worlds -type f) LICENSE)

$(BUILD)/host/embedded.c: $(embedded) sim/tools/embed.sh $(BUILD)/host/embedded
	@sh sim/tools/embed.sh $(embedded) > $@

# Their names, so that what is new or gone counts.
$(BUILD)/host/embedded: force
	@mkdir -p $(@D)
	@echo '$(embedded)' | cmp -s - $@ || echo '$(embedded)' > $@

$(BUILD)/host/embedded.o: $(BUILD)/host/embedded.c $(BUILD)/host/flags
	@echo "CC $< ($(words $(embedded)) files)"
	@$(CCACHE) $(CC) @$(BUILD)/host/flags -c -o $@ $<

$(library): $(BUILD)/host/embedded.o
$(library): $(call object,$(filter-out sim/cli/main.c,$(sources))) $(patsubst %,$(BUILD)/core-%.o,$(profiles))

$(BUILD)/limner: $(call object,sim/cli/main.c) $(library) | $(BUILD)/count_plugin.so
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $(filter %.o %.a,$^) $(LINKS)

# `limner measure` builds firmware for emulated processors and with other sub-pixel bits; QEMU loads a plugin that counts.
$(call object,sim/measure/measure_cost.c sim/measure/sub_bits.c sim/cli/cmd_measure.c sim/measure/sweep_results.c): PLACES = -DLIM_SOURCE_FOLDER='"$(CURDIR)"' \
	-DLIM_COUNT_PLUGIN='"$(abspath $(BUILD))/count_plugin.so"'

# What reports say of the sources: written anew, and compiled anew, when it changes. A copy that git does not know, built
# into the same folder, keeps it.
$(BUILD)/host/sources: force
	@mkdir -p $(@D)
	@sources="$$(git describe --always --dirty 2>/dev/null || cat $@ 2>/dev/null)"; echo "$$sources" | cmp -s - $@ || echo "$$sources" > $@

$(call object,sim/base/versions.c): PLACES = -DLIM_SOURCES='"$(shell cat $(BUILD)/host/sources)"'
$(call object,sim/base/versions.c): $(BUILD)/host/sources

# SDL2, which may come later, is a matter of these files alone.
SDL2_FLAGS = -DLIM_HAVE_SDL2=$(HAVE_SDL2) $(if $(SDL2),$(shell pkg-config --cflags $(SDL2)))
$(BUILD)/host/sdl2: force | packages
	@mkdir -p $(@D)
	@echo '$(SDL2_FLAGS)' | cmp -s - $@ || echo '$(SDL2_FLAGS)' > $@

$(call object,sim/cli/window.c sim/base/versions.c): PLACES += $(SDL2_FLAGS)
$(call object,sim/cli/window.c sim/base/versions.c): $(BUILD)/host/sdl2

$(BUILD)/count_plugin.so: sim/targets/count_plugin.c $(BUILD)/host/flags
	@echo "CC $< (plugin)"
	@$(CC) -std=c11 -O2 $(WARNINGS) -fPIC -fvisibility=hidden -shared -o $@ $<

# A host of simavr, for the Arduboy: see boards/arduboy.
$(BUILD)/simavr_oled: sim/emulators/simavr_oled.c $(BUILD)/host/flags
	@echo "CC $< (simavr)"
	@$(CC) -std=c11 -O2 $(WARNINGS) -D_POSIX_C_SOURCE=200809L -isystem /usr/include/simavr -isystem /usr/include/simavr/parts \
		-o $@ $< -lsimavrparts -lsimavr -lelf -lgd

# An STM32 without its processor, which the tests break the rules of; and with Unicorn's: see boards/DESIGN.md.
stm32_chip := $(call object,$(wildcard sim/emulators/stm32_chip*.c) sim/emulators/stm32_rules.c)
$(BUILD)/tests/test_stm32_rules: $(stm32_chip)
$(BUILD)/stm32: $(call object,sim/emulators/stm32.c) $(stm32_chip)
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $^ -lunicorn

# An ESP32-C3, in the same way.
esp32c3_chip := $(call object,sim/emulators/esp32c3_chip.c sim/emulators/esp32c3_rules.c)
$(BUILD)/tests/test_esp32c3_rules: $(esp32c3_chip)
$(BUILD)/esp32c3: $(call object,sim/emulators/esp32c3.c sim/base/sha256.c) $(esp32c3_chip)
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $^ -lunicorn

# -- The demo ----------------------------------------------------------------------------------------------------------

demo      := $(BUILD)/scenes/demo.obj $(BUILD)/scenes/demo.cam
textured  := $(addprefix $(BUILD)/scenes/textured/textured,.obj .cam)
generator := $(filter-out %textured.c sim/scenes/textured_% %scale.c sim/scenes/scale_% %bench.c sim/scenes/bench_%,$(wildcard sim/scenes/*.c))
scale_generator := $(wildcard sim/scenes/scale_*.c) sim/scenes/generate_scale.c
dense     := $(BUILD)/scenes/mesh5000.obj $(BUILD)/scenes/mesh5000.cam
bench_generator := $(wildcard sim/scenes/bench_*.c) sim/scenes/generate_bench.c
bench_scenes := $(addprefix $(BUILD)/scenes/bench/,spider.cam wuson.cam solid3648.cam map01.cam furnished.obj)
textured_generator := $(wildcard sim/scenes/textured_*.c) sim/scenes/generate_textured.c

$(BUILD)/generate_demo: $(call object,$(generator))
	@$(CC) $(HOST_OPT) -o $@ $^ -lm

$(demo) &: $(BUILD)/generate_demo
	@mkdir -p $(@D)
	@$< $(@D)

$(BUILD)/generate_textured: $(call object,$(textured_generator))
	@$(CC) $(HOST_OPT) -o $@ $^ $(LINKS)

$(textured) &: $(BUILD)/generate_textured
	@mkdir -p $(@D)
	@$< $(@D)

$(BUILD)/generate_scale: $(call object,$(scale_generator))
	@$(CC) $(HOST_OPT) -o $@ $^ -lm

# Scenes of any size: rooms12.obj is a building of 12 x 12 rooms, mesh5000.obj a mesh of 5000 triangles.
$(BUILD)/scenes/rooms%.obj $(BUILD)/scenes/rooms%.cam &: $(BUILD)/generate_scale
	@mkdir -p $(BUILD)/scenes
	@$< rooms $* $(BUILD)/scenes

$(BUILD)/scenes/mesh%.obj $(BUILD)/scenes/mesh%.mtl $(BUILD)/scenes/mesh%.cam &: $(BUILD)/generate_scale
	@mkdir -p $(BUILD)/scenes
	@$< mesh $* $(BUILD)/scenes

$(BUILD)/generate_bench: $(call object,$(bench_generator))
	@$(CC) $(HOST_OPT) -o $@ $^ -lm

# What other renderers were counted on, too: see sim/scenes/README.md. Models of Debian's packages are taken without materials.
bench_folder = mkdir -p $(@D) && cp sim/scenes/mapped/t*.png $(@D)
bench_orbit   = awk -f sim/scenes/orbit.awk $(basename $@).obj >$@

$(BUILD)/scenes/bench/spider.cam: /usr/share/assimp/models/OBJ/spider.obj sim/scenes/orbit.awk | packages
$(BUILD)/scenes/bench/wuson.cam: /usr/share/assimp/models/OBJ/WusonOBJ.obj sim/scenes/orbit.awk | packages
$(BUILD)/scenes/bench/spider.cam $(BUILD)/scenes/bench/wuson.cam:
	@$(bench_folder) && sed '/^mtllib/d' $< >$(basename $@).obj && $(bench_orbit)

$(BUILD)/scenes/bench/solid3648.cam: $(BUILD)/generate_bench sim/scenes/orbit.awk
	@$(bench_folder) && $< solid $(basename $@) && $(bench_orbit)

$(BUILD)/scenes/bench/map01.cam: $(BUILD)/generate_bench | packages
	@$(bench_folder) && $< level $(basename $@) /usr/share/games/doom/freedoom2.wad MAP01

# Rooms with things in them, along the way of rooms.cam.
$(BUILD)/scenes/bench/furnished.obj: $(addprefix $(BUILD)/scenes/bench/,spider.cam wuson.cam solid3648.cam) sim/scenes/furnish.awk
	@awk -v things="$(@D)/spider.obj 1.4 4.9 0 1 30; sim/scenes/teapot.obj 0.8 3 0 4.9 70; $(@D)/wuson.obj 1.7 8.6 0 3.1 10; \
		$(@D)/solid3648.obj 1.3 8.9 0 8.9 200; $(@D)/spider.obj 1.6 12.9 0 8.9 0; sim/scenes/teapot.obj 1 12.9 0 12.9 0" \
		-f sim/scenes/furnish.awk sim/scenes/rooms.obj >$@.part && mv $@.part $@

# Made by installing their packages.
/usr/share/assimp/models/%.obj: | packages ;

run: $(BUILD)/limner $(demo) ## [start] compile and render the demo scene into out/
	$(LIVE)mkdir -p out
	$(LIVE)$(BUILD)/limner compile $(BUILD)/scenes/demo.obj -o out/demo
	$(LIVE)$(BUILD)/limner render $(BUILD)/scenes/demo.obj --camera $(BUILD)/scenes/demo.cam --size 240x240 \
		-o 'out/%03d.png' --gif out/demo.gif --sheet out/sheet.png --stats --compare --brief
	$(LIVE)echo "The pictures: out/sheet.png (all at once) and out/demo.gif (moving)"

view: $(BUILD)/limner $(demo) ## [start] fly through the demo scene in a window
	$(LIVE)$(BUILD)/limner view $(BUILD)/scenes/demo.obj

$(BUILD)/contact_sheet: sim/tools/contact_sheet.c $(BUILD)/host/flags
	@echo "CC $<"
	@$(CC) -std=c11 -O2 $(WARNINGS) -o $@ $< -lgd

.PHONY: contact-sheet
contact-sheet: $(BUILD)/limner $(BUILD)/contact_sheet packages ## [measure] draw others' models by default options, to be looked at: out/contact-sheet.png; MODELS="A B": these
	$(LIVE)sh sim/tools/contact_sheet.sh out/contact-sheet.png $(MODELS)

# -- The tests: each suite is a list of programs that print TAP --------------------------------------------------------

test_library  := $(BUILD)/host/libtests.a
test_sources  := $(wildcard $(addprefix tests/,unit/*/*.c golden/*.c extremes/*.c fuzz/*.c exhaustive/exhaustive.c fakes/*.c rigs/*.c rigs/*/*.c))
test_mains    := $(foreach source,$(test_sources),$(if $(filter test_% soak_%,$(notdir $(source))),$(source)))
test_programs := $(patsubst %.c,$(BUILD)/tests/%,$(notdir $(test_mains)))

$(BUILD)/host/tests/%.o: PLACES = -Itests

$(test_library): $(call object,$(filter-out $(test_mains),$(test_sources)))

# build/tests/test_span is made of tests/unit/firmware/test_span.c: names are unique over all rooms.
$(foreach source,$(test_mains),$(eval $(BUILD)/tests/$(basename $(notdir $(source))): $(call object,$(source))))

$(test_programs): $(test_library) $(library)
	@mkdir -p $(@D)
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $(filter %.o,$^) $(filter %.a,$^) -lcmocka $(test_links) $(LINKS)

$(BUILD)/tests/test_osmesa: test_links := -lOSMesa

# A machine without a kernel takes the place of these calls, see tests/fakes/fake_linux.h, and of libgpiod's.
faked      := test_linux_port test_linux_spi test_linux_panels test_play
fake_calls := open close read readlink access ioctl glob globfree calloc clock_gettime clock_nanosleep
$(addprefix $(BUILD)/tests/,$(faked)): $(call object,tests/fakes/fake_gpiod_v1.c tests/fakes/fake_gpiod_v2.c)
$(addprefix $(BUILD)/tests/,$(faked)): test_links := $(foreach name,$(fake_calls),-Xlinker --wrap=$(name))
tests/cli/cli_gpiod.sh: $(BUILD)/tests/test_linux_port
$(BUILD)/tests/test_hid_port: test_links := -Xlinker --wrap=calloc
$(BUILD)/tests/test_output_sets: test_links := $(foreach name,link rename unlink,-Xlinker --wrap=$(name))

extremes := $(filter $(BUILD)/tests/test_extreme_%,$(test_programs))
tests/cli/cli_extremes.sh: $(extremes) $(BUILD)/limner
tests/cli/cli_bench.sh: $(BUILD)/generate_bench
tests/cli/cli_scale.sh tests/cli/cli_small.sh tests/choices/cli_summary.sh tests/arm/arm_scale.sh: $(BUILD)/generate_scale
tests/sub_bits.sh: $(BUILD)/limner $(addprefix $(BUILD)/tests/,test_convex test_scanline test_target_errors)

suite-host      := $(filter-out $(extremes),$(filter $(BUILD)/tests/test_%,$(test_programs))) $(wildcard tests/cli/cli_*.sh tests/files/cli_*.sh tests/formats/*.sh tests/choices/cli_*.sh)
suite-arm       := $(wildcard tests/arm/arm_*.sh)
suite-fixed     := $(BUILD)/tests/test_fixed tests/arm/arm_fixed.sh
suite-cpus      := $(wildcard tests/cpus/cpus_*.sh)
suite-boards    := $(wildcard tests/boards/boards_*.sh)
suite-export    := $(wildcard tests/export/export_*.sh tests/adapters/adapters_*.sh)
suite-cross     := tests/cross.sh tests/cross_cplusplus.sh
suite-compilers := tests/compilers.sh tests/users_warnings.sh
suite-sanitize  := $(wildcard tests/sanitize*.sh)
suite-models    := tests/models.sh
suite-brought   := $(wildcard tests/brought/brought_*.sh)
suite-features  := tests/features_gcc.sh tests/features_clang.sh
suite-sub-bits  := tests/sub_bits.sh
suite-levels    := tests/levels.sh
suite-prove     := tests/prove.sh
suite-format    := tests/format.sh tests/rooms.sh tests/pointers.sh
suite-kernel    := tests/kernel.sh
suite-foreign   := tests/foreign.sh
suite-arm64     := tests/arm64.sh
suite-slow      := $(suite-prove) $(patsubst %,tests/%.sh,sanitize_scenes cross_cplusplus \
	$(addprefix arm/arm_,footprint balance compare splitters framebuffer) \
	$(addprefix cpus/cpus_,rooms sorted wireframe begin m33 lx106 assert movers antialias glass cplusplus config \
		mesh_leaves mesh_textured solid) \
	$(addprefix boards/boards_,frames card level pico esp32c3 stm32) $(addprefix export/export_,plain size) \
	$(addprefix cli/cli_,compare scale packages trees))
suite-extremes  := tests/cli/cli_extremes.sh
suite-soak      := $(filter $(BUILD)/tests/soak_%,$(test_programs))

# What buttons do to a board's frames.
$(BUILD)/tests/boards/walked: $(BUILD)/host/tests/boards/walked.o $(library)
	@mkdir -p $(@D)
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $^ $(LINKS)

# And what they do in maps of Doom: another walker comes before the library's.
$(BUILD)/host/tests/boards/player.o: boards/common/walker.c $(BUILD)/host/flags
	@mkdir -p $(@D)
	@$(CCACHE) $(CC) @$(BUILD)/host/flags -DBOARD_PLAYER=1 -c -o $@ $<

$(BUILD)/tests/boards/walked_level: $(BUILD)/host/tests/boards/walked.o $(BUILD)/host/tests/boards/player.o $(library)
	@mkdir -p $(@D)
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $^ $(LINKS)

tests/boards/boards_lm3s6965evb.sh: $(BUILD)/tests/boards/walked
tests/boards/boards_level.sh: $(BUILD)/tests/boards/walked_level

tests/export/export_arduino.sh: $(BUILD)/simavr_oled

# Programs for the tests with a kernel of their own, which is built beforehand because that takes minutes, once.
kernel_programs := $(patsubst %,$(BUILD)/tests/kernel/%,replay port_calls bridge power_off pins wires paint)

$(kernel_programs): $(BUILD)/tests/kernel/%: $(BUILD)/host/tests/kernel/%.o $(library)
	@mkdir -p $(@D)
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $^ -lcmocka $(LINKS)

# The test card for drivers of others.
$(BUILD)/tests/foreign/card: $(BUILD)/host/tests/foreign/card.o $(library)
	@mkdir -p $(@D)
	@echo "LD $@"
	@$(CC) $(HOST_OPT) -o $@ $^ $(LINKS)

.PHONY: tests-kernel
tests-kernel: packages
	$(LIVE)sh tests/kernel/build.sh || true

tests/kernel.sh: tests-kernel $(kernel_programs)
tests/arm64.sh: $(kernel_programs)
tests/foreign.sh: tests-kernel $(kernel_programs) $(BUILD)/tests/foreign/card

known_suites := $(ALL_SUITES) slow prove arm64 fixed features sub-bits levels extremes soak all
unknown := $(filter-out $(known_suites),$(suites))
$(if $(unknown),$(error there is no suite $(unknown)$(call is_it,$(firstword $(unknown)),$(known_suites)); there are: all $(ALL_SUITES) slow prove arm64 features sub-bits levels extremes))

# By itself it draws all frames, in all suites a part of them.
ifeq ($(suites),extremes)
export EXTREMES := whole
endif

# The longest first, so that none of them is left alone at the end.
longest  := tests/sanitize.sh tests/arm/arm_footprint.sh tests/boards/boards_frames.sh tests/models.sh tests/sanitize_scenes.sh \
	tests/cross.sh tests/compilers.sh tests/users_warnings.sh tests/prove.sh tests/boards/boards_build.sh \
	$(addprefix tests/cli/cli_,coordinates features extremes)
asked    := $(sort $(foreach suite,$(suites),$(suite-$(suite))))
ifneq ($(filter all,$(SUITES))$(filter file,$(origin SUITES)),)
asked    := $(filter-out $(suite-slow),$(asked))
endif
programs := $(filter $(longest),$(asked)) $(filter-out $(longest),$(asked))

test: $(BUILD)/limner $(demo) $(textured) $(programs) ## [start] run the host and Arm suites; SUITES=all: every suite
	$(LIVE)sh tests/run.sh $(programs)

check: ## [test] run the host suite only
	@$(MAKE) test SUITES=host

# A make of their own, which waits until this one has made what else it was asked for.
check test-fixed test-arm64 prove: | $(filter-out check test-fixed test-arm64 prove,$(MAKECMDGOALS))

test-fixed: ## [test] run the fixed-point tests on the host and on emulated Arm
	@$(MAKE) test SUITES=fixed

test-arm64: ## [test] draw through a stock arm64 kernel in QEMU, whose pins are watched
	@$(MAKE) test SUITES=arm64

extremes: $(extremes) $(BUILD)/limner packages ## [measure] run the tests of extremes and write their page anew, with its pictures
	$(LIVE)EXTREMES=write sh tests/cli/cli_extremes.sh

soak: $(suite-soak) packages ## [test] 10^9 pixels of random closed scenes in every profile
	$(LIVE)for program in $(suite-soak); do $$program || exit 1; done

test-programs: $(test_programs) ## [test] build the unit tests without running them

# -- Proofs, exhaustion, fuzzing: see tests/prove.sh, tests/exhaustive/exhaustive.h, tests/fuzz/fuzz.h -----------------

FUZZ_TARGETS := camera camera_file lim_file render long features mesh movers long_movers touch obj gltf ply stl off picture wire_log qemu vcd text written report wad
FUZZ_FLAGS   := -max_total_time=60
FUZZ_S       := 0
export FUZZ_FLAGS FUZZ_S

prove: ## [test] prove that the arithmetic of the kernels cannot overflow
	@$(MAKE) test SUITES=prove

exhaustive: $(BUILD)/tests/exhaustive ## [test] try all 2^32 arguments of every unary kernel
	$(LIVE)$<

fuzz: packages ## [test] fuzz each target for a minute; FUZZ_TARGETS=render FUZZ_FLAGS=-runs=1000000: other ones, longer
	$(LIVE)sh tests/fuzz/fuzz.sh $(FUZZ_TARGETS)

fuzz-coverage: packages ## [test] count which lines the fuzz corpora reach; FUZZ_S=30: fuzz each target that long first
	$(LIVE)sh tests/fuzz/fuzz_coverage.sh $(FUZZ_TARGETS)

$(BUILD)/tests/exhaustive: $(call object,tests/exhaustive/main.c tests/exhaustive/exhaustive.c) $(library)
	@mkdir -p $(@D)
	@$(CC) $(HOST_OPT) -o $@ $^ $(LINKS)

fuzz_objects := $(call object,$(filter-out tests/fuzz/test_%,$(wildcard tests/fuzz/*.c)) tests/rigs/closed_scene.c tests/unit/levels/wad_writer.c)

$(BUILD)/tests/fuzz: $(call object,tests/fuzz/libfuzzer/main.c) $(fuzz_objects) $(library)
	@mkdir -p $(@D)
	@$(CC) $(HOST_OPT) -fsanitize=fuzzer -o $@ $^ $(LINKS)

$(BUILD)/tests/fuzz_replay: $(call object,tests/fuzz/libfuzzer/replay.c) $(fuzz_objects) $(library)
	@mkdir -p $(@D)
	@$(CC) $(HOST_OPT) -o $@ $^ $(LINKS)

$(BUILD)/tests/fuzz_seeds: $(call object,tests/fuzz/libfuzzer/seeds.c) $(fuzz_objects) $(library)
	@mkdir -p $(@D)
	@$(CC) $(HOST_OPT) -o $@ $^ $(LINKS)

# -- Mutants: see tests/mutants/README.md -------------------------------------------------------------------------------

mutate: $(if $(TESTS),$(TESTS:%=$(BUILD)/tests/%),test-programs) $(demo) packages ## [test] break the code on purpose, 300 times; SEED=7 MUTANTS=50 FILES=firmware/view/clip.c TESTS=test_clip, or MUTANT=NUMBER: one
	$(LIVE)SEED='$(SEED)' MUTANTS='$(MUTANTS)' FILES='$(FILES)' MUTANT='$(MUTANT)' TESTS='$(TESTS)' sh tests/mutants.sh

models-table: $(BUILD)/limner ## [measure] write the outcomes of Debian's test models anew
	$(LIVE)sh tests/models.sh --table > tests/models/models.expected

# All tables of pages are written by one script, which has their list.
tables: ## [measure] write the quick tables of pages anew; TABLES="delta-cost boards foreign": these
footprint: ## [measure] compile the table of flash, RAM and stack anew
tradeoff: ## [measure] measure accuracy against cost; everything into out/tradeoff/
scale: ## [measure] measure how costs grow with a scene
predictions: ## [measure] hold predicted wrong pixels against measured ones, of 47 models and of paths along faces
compare: ## [measure] measure every visibility method; everything into out/compare/

tables: $(if $(filter foreign,$(TABLES)),tests/foreign.sh) $(if $(filter methods,$(TABLES)),$(BUILD)/generate_bench)
tables footprint tradeoff scale predictions compare: $(BUILD)/limner $(BUILD)/generate_scale $(demo) packages
	$(LIVE)sh sim/tools/tables.sh --write $(if $(filter tables,$@),$(TABLES),$@)
	$(if $(filter predictions,$@),$(LIVE)sh sim/tools/tables.sh --write along)

first-hour: ## [measure] do what README tells a newcomer on a bare Debian, as root, and write its megabytes and minutes; HOURS=no: megabytes alone
	$(LIVE)sh sim/tools/first_hour.sh

bench: $(BUILD)/limner $(demo) $(dense) $(bench_scenes) packages ## [measure] count instructions and bytes; what changed, and what is lost to others; SCENES="rooms spider": of these
	$(LIVE)SCENES='$(SCENES)' sh sim/tools/bench.sh

bench-baseline: $(BUILD)/limner $(demo) $(dense) $(bench_scenes) packages ## [measure] as bench; write the baseline and the tables anew
	$(LIVE)SCENES='$(SCENES)' sh sim/tools/bench.sh --baseline

# -- Boards: see boards/image.mk ----------------------------------------------------------------------------------------

boards := $(patsubst boards/%/board.mk,%,$(sort $(wildcard boards/*/board.mk)))

ifdef BOARD
# In whichever capitals.
board_is := $(call nearest,$(BOARD),$(boards))
override BOARD := $(if $(filter =,$(board_is)),$(word 2,$(board_is)),$(BOARD))
include boards/image.mk
else
flash emulate cost rules:
	@echo "$@: say BOARD=NAME; there are: $(boards)" >&2; exit 1
endif

.PHONY: boards
boards: $(BUILD)/limner $(demo) packages ## [board] build an image for every board
	$(LIVE)for board in $(boards); do $(MAKE) BOARD=$$board DEPS=skip || exit 1; done

# -- What a first build has to compile: the objects of its goals that are not there ------------------------------------

progress_program := $(filter all install run view test check $(BUILD)/limner,$(or $(MAKECMDGOALS),all))
progress_objects := $(if $(progress_program),$(call object,$(sources)) $(foreach name,$(profiles),$(call core_object,$(name)))) \
	$(if $(filter run view test,$(MAKECMDGOALS)),$(call object,$(generator))) \
	$(if $(filter test,$(MAKECMDGOALS)),$(call object,$(test_sources) $(textured_generator)))
progress_missing := $(words $(filter-out $(wildcard $(progress_objects)),$(progress_objects)))
# A few files are compiled before anybody asks.
progress_count   := $(if $(filter $(shell test $(progress_missing) -ge 100 && echo yes),yes),$(progress_missing),0)

# -- Housekeeping ------------------------------------------------------------------------------------------------------

format: packages ## [care] lay out every C file by .clang-format
	@find firmware hal boards sim tests -name '*.[ch]' -exec clang-format -i {} +

PREFIX  := $(if $(filter command,$(firstword $(origin prefix))),$(prefix),/usr/local)
DESTDIR :=
install: $(BUILD)/limner ## [care] install limner, its manual page and completion for bash; PREFIX=/usr/local, or prefix=, and DESTDIR=
	$(LIVE)PREFIX='$(PREFIX)' DESTDIR='$(DESTDIR)' sh sim/tools/install.sh install

uninstall: ## [care] take away what make install has put there, with the same PREFIX and DESTDIR
	$(LIVE)PREFIX='$(PREFIX)' DESTDIR='$(DESTDIR)' sh sim/tools/install.sh uninstall

clean: ## [care] remove build/ and out/
	@rm -rf $(BUILD) out

-include $(patsubst %.o,%.d,$(call object,$(sources) $(generator) $(textured_generator) $(scale_generator) $(test_sources) tests/exhaustive/main.c tests/fuzz/libfuzzer/main.c tests/fuzz/libfuzzer/replay.c tests/fuzz/libfuzzer/seeds.c \
	tests/boards/walked.c tests/foreign/card.c $(wildcard sim/emulators/stm32*.c sim/emulators/esp32c3*.c) \
	$(filter-out %/wire_tap.c %/wire_display.c,$(wildcard tests/kernel/*.c))))
