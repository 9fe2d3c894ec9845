# SPDX-License-Identifier: MIT
#
# Builds, demonstrates and tests Limner. `make help` lists the goals; `make --trace` shows every command in full.
# Products go to $(BUILD) and out/. Nothing but make is needed to start: see sim/setup.sh.

# -- What can be chosen: make CC=clang OPT=-O0 BUILD=build/other SUITES="host cross" DEPS=no ---------------------------

BUILD := build
OPT   := -O2
ifeq ($(origin CC),default)
CC    := gcc
endif
export BUILD CC

ALL_SUITES := host arm cross compilers sanitize models format soak
SUITES     := host arm
suites     := $(if $(filter all,$(SUITES)),$(ALL_SUITES),$(SUITES))

# -- How make runs: on all cores, each recipe's output in one piece ----------------------------------------------------

ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell nproc) --output-sync --no-print-directory
endif
# Begins a recipe line whose output must appear as it comes: with +, but not under `make -n`, where + would run it.
LIVE = $(if $(findstring n,$(firstword -$(MAKEFLAGS))),,+)@

.PHONY: all run view check test test-fixed test-programs models-table tables format clean help packages force
.SECONDARY:
.DELETE_ON_ERROR:

all: $(BUILD)/limner ## build the host program, build/limner (the default)

help: ## list the goals
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' Makefile
	@echo "Suites of make test: $(ALL_SUITES)"

# -- Debian packages: what every build needs, and what a goal or a suite needs beside ----------------------------------

packages-build         := gcc libc6-dev pkg-config libassimp-dev libgd-dev libgmp-dev zlib1g-dev
packages-host          := libcmocka-dev
packages-arm           := gcc-arm-none-eabi qemu-system-arm
packages-fixed         := $(packages-host) $(packages-arm)
packages-cross         := gcc-arm-none-eabi gcc-riscv64-unknown-elf gcc-avr
packages-compilers     := clang
packages-sanitize      := $(packages-host)
packages-models        := assimp-testmodels
packages-format        := clang-format
packages-soak          := $(packages-host)
packages-view          := libsdl2-dev
packages-models-table  := $(packages-models)
packages-test-programs := $(packages-host)
packages-test          := $(foreach suite,$(suites),$(packages-$(suite)))

packages:
	$(LIVE)sh sim/setup.sh $(sort $(packages-build) $(foreach goal,$(MAKECMDGOALS),$(packages-$(goal))))

# -- The host program: firmware and simulator, all but main() in a library that the tests link too ---------------------

WARNINGS := -Wall -Wextra -Wconversion -Wshadow -Wundef -Wmissing-prototypes -Wstrict-prototypes -Werror
export WARNINGS

LIBRARIES = assimp gdlib $(if $(filter 1,$(HAVE_SDL2)),sdl2)
HAVE_SDL2 = $(shell pkg-config --exists sdl2 && echo 1 || echo 0)
FLAGS = -std=c11 $(OPT) $(WARNINGS) -ffp-contract=off -D_POSIX_C_SOURCE=200809L -DLIM_HAVE_SDL2=$(HAVE_SDL2) \
	-Ifirmware -Ihal -Isim -Iboards/common $(shell pkg-config --cflags $(LIBRARIES)) -MMD -MP
LINKS = $(shell pkg-config --libs $(LIBRARIES)) -lgmp -lz -lm

object  = $(patsubst %.c,$(BUILD)/host/%.o,$(1))
sources := $(filter-out sim/core.c,$(wildcard firmware/*.c hal/*.c boards/common/*.c sim/*.c))
library := $(BUILD)/host/liblimner.a

# The compiler reads its flags from this file, so that whatever is compiled is compiled anew when they change.
$(BUILD)/host/flags: force | packages
	@mkdir -p $(@D)
	@echo '$(FLAGS)' | cmp -s - $@ || echo '$(FLAGS)' > $@

$(BUILD)/host/%.o: %.c $(BUILD)/host/flags
	@mkdir -p $(@D)
	@echo "CC $<"
	@$(CC) @$(BUILD)/host/flags -c -o $@ $<

%.a:
	@rm -f $@
	@ar rcs $@ $^

# The renderer once for each precision profile, all names but that of its table made local.
profiles     := fast fine
core_sources := $(wildcard firmware/*.c) sim/core.c
core_object   = $(patsubst %.c,$(BUILD)/core-$(1)/%.o,$(core_sources))

define core
$(BUILD)/core-$(1)/%.o: %.c $(BUILD)/host/flags
	@mkdir -p $$(@D)
	@echo "CC $$< ($(1))"
	@$$(CC) @$(BUILD)/host/flags -DLIM_PROFILE=LIM_PROFILE_$(shell echo $(1) | tr a-z A-Z) -DCORE=core_$(1) -c -o $$@ $$<

$(BUILD)/core-$(1).o: $(call core_object,$(1))
	@ld -r -o $$@ $$^
	@objcopy --keep-global-symbol=core_$(1) $$@

-include $(patsubst %.o,%.d,$(call core_object,$(1)))
endef
$(foreach profile,$(profiles),$(eval $(call core,$(profile))))

$(library): $(call object,$(filter-out sim/main.c,$(sources))) $(patsubst %,$(BUILD)/core-%.o,$(profiles))

$(BUILD)/limner: $(call object,sim/main.c) $(library)
	@echo "LD $@"
	@$(CC) $(OPT) -o $@ $^ $(LINKS)

# -- The demo ----------------------------------------------------------------------------------------------------------

demo      := $(BUILD)/scenes/demo.obj $(BUILD)/scenes/demo.cam
generator := $(wildcard sim/scenes/*.c)

$(BUILD)/generate_demo: $(call object,$(generator))
	@$(CC) $(OPT) -o $@ $^ -lm

$(demo) &: $(BUILD)/generate_demo
	@mkdir -p $(@D)
	@$< $(@D)

run: $(BUILD)/limner $(demo) ## compile and render the demo scene into out/
	$(LIVE)mkdir -p out
	$(LIVE)$(BUILD)/limner compile $(BUILD)/scenes/demo.obj -o out/demo
	$(LIVE)$(BUILD)/limner render $(BUILD)/scenes/demo.obj --camera $(BUILD)/scenes/demo.cam --size 240x240 \
		-o 'out/%03d.png' --gif out/demo.gif --sheet out/sheet.png --stats --compare
	$(LIVE)echo "The pictures: out/sheet.png (all at once) and out/demo.gif (moving)"

view: $(BUILD)/limner $(demo) ## fly through the demo scene in a window
	$(LIVE)$(BUILD)/limner view $(BUILD)/scenes/demo.obj

# -- The tests: each suite is a list of programs that print TAP --------------------------------------------------------

test_library  := $(BUILD)/host/libtests.a
test_sources  := $(wildcard tests/*.c)
test_programs := $(patsubst %.c,$(BUILD)/%,$(filter tests/test_%.c tests/soak_%.c,$(test_sources)))

$(test_library): $(call object,$(filter-out tests/test_%.c tests/soak_%.c,$(test_sources)))

$(test_programs): $(BUILD)/tests/%: $(BUILD)/host/tests/%.o $(test_library) $(library)
	@mkdir -p $(@D)
	@echo "LD $@"
	@$(CC) $(OPT) -o $@ $^ -lcmocka $(LINKS)

suite-host      := $(filter $(BUILD)/tests/test_%,$(test_programs)) $(wildcard tests/cli_*.sh)
suite-arm       := $(wildcard tests/arm_*.sh)
suite-fixed     := $(BUILD)/tests/test_fixed tests/arm_fixed.sh
suite-cross     := tests/cross.sh
suite-compilers := tests/compilers.sh
suite-sanitize  := tests/sanitize.sh
suite-models    := tests/models.sh
suite-format    := tests/format.sh
suite-soak      := $(filter $(BUILD)/tests/soak_%,$(test_programs))

unknown := $(filter-out $(ALL_SUITES) fixed,$(suites))
$(if $(unknown),$(error there is no suite $(unknown); there are: all $(ALL_SUITES)))

programs := $(sort $(foreach suite,$(suites),$(suite-$(suite))))

test: $(BUILD)/limner $(demo) $(programs) ## run the host and Arm suites; SUITES=all: every suite
	$(LIVE)sh tests/run.sh $(programs)

check: ## run the host suite only
	@$(MAKE) test SUITES=host

test-fixed: ## run the fixed-point tests on the host and on emulated Arm
	@$(MAKE) test SUITES=fixed

test-programs: $(test_programs) ## build the unit tests without running them

models-table: $(BUILD)/limner ## write the outcomes of Debian's test models anew
	$(LIVE)sh tests/models.sh --table > tests/models.expected

tables: $(BUILD)/limner $(demo) ## measure README's table and draw its picture anew
	$(LIVE)sh sim/tables.sh --write

# -- Housekeeping ------------------------------------------------------------------------------------------------------

format: packages ## lay out every C file by .clang-format
	@find firmware hal boards sim tests -name '*.[ch]' -exec clang-format -i {} +

clean: ## remove build/ and out/
	@rm -rf $(BUILD) out

-include $(patsubst %.o,%.d,$(call object,$(sources) $(generator) $(test_sources)))
