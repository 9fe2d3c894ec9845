# SPDX-License-Identifier: MIT
#
# Builds the image of one board: `make BOARD=bluepill [SCENE=MODEL] [PANEL=NAME] [PRECISION=NAME]`. The board's folder
# says what it is (board.mk); all of that, and what is below, can be said otherwise on make's command line:
#   SCENE      a model's file, or the name of one in sim/scenes    CAMERA   its path (beside it, or round the model)
#              FILE.wad:MAP: a map of Doom; where FILE is no path and not here, it is Debian's, in /usr/share/games/doom, and Freedoom is
#              installed after asking. Its path is sim/scenes/FILE-MAP.cam, or a walk by `limner walk`
#              test-card: the board's self-test, the card and then a solid that turns; CARD_MS: how long it stays (3000; 100 to emulate)
#   PANEL      the display's chip    MODULE   options of its module: limner help, play: --size 128x128 --rotate 90
#   STREAM     yes: two renderers, of which one finds out what is seen while the other's frame is sent; no; auto: if both
#              have room    LINES  of pixels in RAM, at most
#   PLAYER     yes: who walks with buttons is as large and as fast as Doom's player; no: as suits rooms (maps: yes)
#   WALLS      yes: who walks with buttons is stopped by walls; no: passes through, and none of that is linked
#   PRECISION  draft, fast, fine, exact    COMPILE   other options of `limner compile`: --wireframe --delta
#              --overlay: frames show their number

board_folder := boards/$(BOARD)
$(if $(filter $(boards),$(BOARD)),,$(error there is no board $(BOARD)$(call is_it,$(BOARD),$(boards)); there are: $(boards)))

# Flags that make the processor's code, and what makes an image of objects; a board may say otherwise.
STANDARD := -std=c11 -ffreestanding
FRAMES   := -fcallgraph-info=su
COUNTED_ELF     = $(IMAGE).elf
COUNTED_DRIVERS = $(filter $(common)/hal/mcu/%,$(board_objects))
LINES    := 1
STREAM   := no
WALLS    := no
TITLE     = $(BOARD)$(if $(filter --framebuffer,$(COMPILE)),$(comma) framebuffer)
START    := boards/common/bare_image.c
LINK      = -nostdlib -Lboards/common -T $(board_folder)/memory.ld -Wl,--defsym=image_stack_b=0
LAST     := -lgcc
include $(board_folder)/board.mk

# The module that the board's folder describes is that of its own panel.
ifeq ($(origin PANEL),command line)
ifneq ($(origin MODULE),command line)
MODULE :=
endif
endif

packages-board    = $(PACKAGES) $(if $(freedoom),freedoom)
packages-flash    = $(FLASH_PACKAGES)
packages-emulate  = $(EMULATE_PACKAGES)
packages-cost     = $(EMULATE_PACKAGES)
packages-rules    = $(RULES_PACKAGES)

# -- The scene and its path -------------------------------------------------------------------------------------------

$(if $(word 2,$(SCENE)),$(error SCENE=$(SCENE): make knows no paths with spaces))
CARD    := $(filter test-card,$(SCENE))
CARD_MS := $(if $(filter emulate,$(MAKECMDGOALS)),100,3000)
no_digits = $(subst 0,,$(subst 1,,$(subst 2,,$(subst 3,,$(subst 4,,$(subst 5,,$(subst 6,,$(subst 7,,$(subst 8,,$(subst 9,,$(1)))))))))))
$(if $(or $(call no_digits,$(CARD_MS)),$(if $(CARD_MS),,none)),$(error CARD_MS=$(CARD_MS): must be a whole number of milliseconds))
scene   := $(if $(CARD),icosahedron,$(SCENE))

# FILE.wad:MAP or FILE.wad+FILE.wad:MAP. What make waits for are the files: it knows no colon in a name.
map        := $(if $(findstring .wad:,$(scene))$(findstring .WAD:,$(scene)),$(lastword $(subst :, ,$(scene))))
wad_folder := /usr/share/games/doom
wads       := $(foreach wad,$(if $(map),$(subst +, ,$(scene:%:$(map)=%))),$(if $(findstring /,$(wad))$(wildcard $(wad)),$(wad),$(wad_folder)/$(wad)))
freedoom   := $(filter $(addprefix $(wad_folder)/,freedoom1.wad freedoom2.wad),$(wads))
$(foreach wad,$(filter-out $(freedoom),$(wads)),$(if $(wildcard $(wad)),,$(error SCENE=$(SCENE): there is no $(wad))))
plus       := +
level      := $(subst $() ,$(plus),$(wads)):$(map)
PLAYER     := $(if $(map),yes,no)

model   := $(firstword $(if $(map),$(level)) $(wildcard $(scene)) $(wildcard sim/scenes/$(scene).obj) $(wildcard sim/scenes/$(scene).gltf) \
	$(filter $(BUILD)/scenes/$(scene).obj,$(demo)) $(filter $(BUILD)/scenes/$(scene)/$(scene).obj,$(textured)))
$(if $(model),,$(error there is no scene $(SCENE): neither a file nor a name in sim/scenes, nor demo, textured or test-card))
# What the scene is made from, if that is a file that make knows.
sources_of_model := $(or $(wads),$(model))
stem    := $(or $(CARD),$(if $(map),$(subst $() ,-,$(basename $(notdir $(wads))))-$(map),$(basename $(notdir $(model)))))
walk     = $(folder)/walk.cam
CAMERA  = $(if $(map),$(or $(wildcard sim/scenes/$(stem).cam),$(walk)),$(filter $(basename $(model)).cam,$(demo) $(textured) $(wildcard $(basename $(model)).cam)))
$(foreach path,$(filter-out %/walk.cam,$(CAMERA)),$(if $(or $(wildcard $(path)),$(filter $(path),$(demo) $(textured))),,$(error there is no camera path $(path))))
name    := $(stem)-$(subst :,-,$(PANEL))-$(PRECISION)
BOARDS  := $(BUILD)/boards
folder  := $(BOARDS)/$(BOARD)/$(name)
IMAGE   := $(folder)/image
common  := $(BOARDS)/$(BOARD)/common
options = --precision $(PRECISION) --size $(module_size)

# WxH of the panel, once the module is described.
module_size = $(shell awk '$$2 == "MODULE_W_PX" { w = $$3 } $$2 == "MODULE_H_PX" { h = $$3 } END { print w "x" h }' \
	$(folder)/module.h)

# What the chip cannot turn the camera does, which then sees a picture whose sides may be the panel's, exchanged.
camera_turn  = $(shell sed -n 's/^.define MODULE_CAMERA_TURN PANEL_TURNED_//p' $(folder)/module.h)
camera_lies  = $(filter 90 270,$(camera_turn))
picture_size = $(if $(camera_lies),$(subst $() ,x,$(lastword $(subst x, ,$(module_size))) $(firstword $(subst x, ,$(module_size)))),$(module_size))
scene_flags  = $(if $(camera_lies),-DSCENE_CAMERA_LIES) -DSCENE_MODULE
card_flags   = $(if $(CARD),-DBOARD_CARD=1 -DBOARD_CARD_MS=$(CARD_MS))

# What a file is made from, so that it is made anew when that changes.
$(folder)/choice: force
	@mkdir -p $(@D) $(common)
	@echo '$(PANEL) $(MODULE) $(PRECISION) $(model) $(CAMERA) $(COMPILE) $(STREAM) $(WALLS) $(PLAYER) $(card_flags)' | cmp -s - $@ || \
		echo '$(PANEL) $(MODULE) $(PRECISION) $(model) $(CAMERA) $(COMPILE) $(STREAM) $(WALLS) $(PLAYER) $(card_flags)' > $@

$(folder)/module.c: $(folder)/choice $(BUILD)/limner
	@$(BUILD)/limner module --panel $(PANEL) $(MODULE) -o $(folder)/module

# Made by installing its package.
$(freedoom): | packages ;

$(folder)/model.lim: $(folder)/module.c $(sources_of_model) $(BUILD)/limner
	@echo "SCENE $(model)"
	@rm -f $(folder)/model*.c $(folder)/model*.o
	@$(BUILD)/limner compile $(model) -o $(folder)/model --report $(options) --panel $(PANEL) $(COMPILE) > $(folder)/report

$(walk): $(wads) $(BUILD)/limner
	@mkdir -p $(@D)
	@echo "WALK $(model)"
	@$(BUILD)/limner walk $(model) -o $@

$(folder)/cameras.h: $(folder)/model.lim $(CAMERA)
	@$(BUILD)/limner render $(folder)/model.lim $(addprefix --camera ,$(CAMERA)) --size $(picture_size) --write-cameras $@

# -- Objects: the board's own, which all scenes share, and those that the scene's header fits to it ---------------------

board_flags = $(STANDARD) $(ARCH) $(OPT) $(WARNINGS) -ffunction-sections -fdata-sections $(FRAMES) -MMD -MP \
	-DBOARD_LINES=$(LINES) $(DEFINES) -Ifirmware -Ihal -Iboards/common -I$(board_folder)
image_flags = -I$(folder) -DLIM_CONFIG='"model.h"' $(stream_flags) $(card_flags) $(walls_flags)
walls_flags  = -DBOARD_WALLS=$(if $(filter no,$(WALLS)),0,1) -DBOARD_PLAYER=$(if $(filter no,$(PLAYER)),0,1)
stream_flags = $(if $(filter no,$(STREAM)),,-DSCREEN_STREAMS=1 -DSCENE_RENDERERS=2)

board_sources := $(wildcard hal/*.c) $(SOURCES) $(START)
image_sources := $(wildcard firmware/*.c firmware/*/*.c) $(wildcard $(addprefix boards/common/,main.c app_scene.c card.c screen.c test_card.c walker.c))
board_objects := $(patsubst %,$(common)/%.o,$(basename $(board_sources))) $(if $(BOOT2),$(common)/boot2.o)
image_objects := $(patsubst %.c,$(folder)/%.o,$(image_sources)) $(folder)/module.o

$(common)/flags: force | packages
	@mkdir -p $(@D)
	@echo '$(TOOLS)gcc $(board_flags)' | cmp -s - $@ || echo '$(TOOLS)gcc $(board_flags)' > $@

# Call graphs have a cache of their own; assembly has no graph.
board_cache = $(if $(filter %.c,$<),$(if $(findstring callgraph,$(FRAMES)),CCACHE='$(CCACHE)' sh sim/tools/graph_cache.sh,$(CCACHE)))

define board_object
@mkdir -p $(@D)
@$(board_cache) $(TOOLS)gcc $(board_flags) $(1) -c -o $@ $<
endef

$(common)/%.o: %.c $(common)/flags
	$(call board_object)

$(common)/%.o: %.S $(common)/flags
	$(call board_object)

# A second stage, whose checksum is not the linker's to make.
$(common)/boot2.bin: $(BOOT2) $(common)/flags
	@$(TOOLS)gcc $(ARCH) -c -o $(@:.bin=.code.o) $<
	@$(TOOLS)objcopy -O binary -j .text $(@:.bin=.code.o) $@

$(common)/boot2.c: $(common)/boot2.bin $(BUILD)/limner
	@$(BUILD)/limner boot2 $< -o $@

$(common)/boot2.o: $(common)/boot2.c
	$(call board_object)

$(image_objects): $(folder)/cameras.h $(folder)/model.lim $(common)/flags

$(folder)/%.o: %.c
	$(call board_object,$(image_flags))

$(folder)/boards/common/app_scene.o: image_flags += $(scene_flags)

$(folder)/module.o: $(folder)/module.c
	$(call board_object,$(image_flags))

# -- The image ---------------------------------------------------------------------------------------------------------

$(folder)/limits: force
	@mkdir -p $(@D)
	@echo '$(FLASH_B) $(RAM_B) $(CODE_IN_RAM) $(LINK) $(LAST) $(LINES)' | cmp -s - $@ || \
		echo '$(FLASH_B) $(RAM_B) $(CODE_IN_RAM) $(LINK) $(LAST) $(LINES)' > $@

export BOARD TOOLS ARCH OPT LINK LAST FLASH_B RAM_B CODE_IN_RAM STREAM LINES
$(IMAGE).elf: $(board_objects) $(image_objects) boards/link.sh sim/tools/footprint.sh sim/tools/pointers.awk sim/tools/stack.awk sim/tools/avr_graph.awk \
		$(folder)/limits $(wildcard $(board_folder)/*.ld boards/common/*.ld)
	$(LIVE)rm -f $(IMAGE).*
	$(LIVE)COMPILER='$(TOOLS)gcc $(board_flags) $(stream_flags) $(scene_flags) $(card_flags) $(walls_flags)' sh boards/link.sh $(folder) \
		'$(BOARD): $(model) on $(PANEL), $(module_size), precision $(PRECISION)' $(board_objects) $(image_objects)

$(IMAGE).bin: $(IMAGE).elf
	@$(TOOLS)objcopy -O binary $< $@

$(IMAGE).hex: $(IMAGE).elf
	@$(TOOLS)objcopy -O ihex $< $@

$(IMAGE).uf2: $(IMAGE).bin $(BUILD)/limner
	@$(BUILD)/limner uf2 $< -o $@ $(UF2)

# What the ROM of an Espressif chip loads.
$(IMAGE).esp: $(IMAGE).elf $(BUILD)/limner
	@$(BUILD)/limner espimage $< -o $@ $(ESPIMAGE)

# A frame more, the first one.
define with_card
@$(BUILD)/limner card --panel $(PANEL) $(MODULE) --write-hashes $@.card > $@.said && mv $@ $@.path && \
	cat $@.card $@.path | awk '{ print NR - 1, $$2 }' > $@
endef

# An image for which something may lie over the frames shows their numbers.
number_sign := \#
caption      = $(if $(filter --overlay,$(COMPILE)),--overlay 'frame $(number_sign)')

# What the simulator makes of the same scene on the same panel: the emulated board's frames are checked against it.
$(folder)/golden: $(folder)/model.lim $(CAMERA) $(BUILD)/limner
	@$(BUILD)/limner render $(model) $(addprefix --camera ,$(CAMERA)) $(options) --panel $(PANEL) $(filter-out --fill --framebuffer --overlay,$(COMPILE)) $(caption) --write-hashes $@
	$(if $(CARD),$(with_card))

# For EMULATE: N frames of the path, and what makes pictures of the bytes that an emulator tells.
N      := 8
CHECK   = $(folder)/golden.$(N)
PICTURES = out/boards/$(BOARD)
DECODE  = $(BUILD)/limner decode - --panel $(PANEL) $(MODULE) --frames $(N) -o '$(PICTURES)/%03d.png' \
	$(if $(camera_turn),,--check $(CHECK))

# The path is flown for ever.
$(folder)/golden.$(N): $(folder)/golden
	@awk -v n=$(N) '{ hash[NR] = $$2 } END { for (i = 0; i < n + 0; i++) print i, hash[i % NR + 1] }' $< > $@

# What QEMU has no clock for is counted.
COUNTED = sh sim/emulators/count.sh $(N) $(BUILD)/count_plugin.so $(COUNTED_ELF) $(QEMU) $(COUNTED_DRIVERS)
SPI_HZ  = $(shell awk -v clock_hz=$(SPI_CLOCK_HZ) -v most_hz=$(or $(SPI_MAX_HZ),$(SPI_CLOCK_HZ)) -v dividers=$(SPI_DIVIDERS) ' \
	$$2 == "MODULE_SPEED_HZ" { \
		wanted_hz = $$3 + 0 < most_hz + 0 ? $$3 + 0 : most_hz + 0; \
		for (by = 2; clock_hz / by > wanted_hz; by = dividers == "powers" ? 2 * by : by + 2); \
		print clock_hz / by }' $(folder)/module.h)

# The rate that the panel was asked for: what the SPI's may not exceed.
PANEL_HZ = $(shell awk '$$2 == "MODULE_SPEED_HZ" { print $$3 + 0 }' $(folder)/module.h)

.PHONY: image flash emulate rules cost
all: image
image: $(addprefix $(IMAGE).,elf $(IMAGES)) $(if $(CARD),$(folder)/golden) | packages
	@cat $(folder)/fits
	@printf '  %s\n' $(addprefix $(IMAGE).,elf $(IMAGES)) $(if $(CARD),$(folder)/golden)

flash: image ## [start] BOARD=NAME: put the image on the board
	$(LIVE)command -v $(FLASH_TOOL) > /dev/null || { echo "flash: $(FLASH_TOOL) is missing; $(or $(FLASH_FROM),Debian's package: $(FLASH_PACKAGES))" >&2; exit 1; }
	$(LIVE)$(FLASH)

emulate: image $(CHECK) $(EMULATOR) ## [start] BOARD=NAME [N=FRAMES]: run the image in its emulator; frames, checked, into out/boards/NAME
	$(LIVE)mkdir -p $(PICTURES)
	$(LIVE)$(EMULATE)
	$(LIVE)echo "emulate: $(if $(camera_turn),$(N) frames were not checked: the simulator does not turn its camera as this panel needs,$(N) frames equal the simulator's); PNGs in $(PICTURES)"

rules: image $(CHECK) $(RULES_CHECKER) ## [board] BOARD=NAME [N=FRAMES]: hold what the image does to registers to its maker's manuals; frames, checked
	$(LIVE)$(if $(RULES),,echo "rules: none are written down for $(BOARD)" >&2; exit 1)
	$(LIVE)mkdir -p $(PICTURES)
	$(LIVE)$(RULES)

cost: image $(CHECK) $(EMULATOR) $(BUILD)/count_plugin.so ## [board] BOARD=NAME: run N frames, and print what one costs
	$(LIVE)mkdir -p $(PICTURES)
	$(LIVE)$(EMULATE) > $(folder)/emulated
	$(LIVE)$(if $(QEMU),$(COUNTED) > $(folder)/counted)
	$(LIVE)sh boards/cost.sh $(folder) '$(TITLE) | $(stem), $(PRECISION) | $(PANEL), $(module_size)' \
		$(CPU_HZ) $(SPI_HZ)

-include $(patsubst %.o,%.d,$(board_objects) $(image_objects))
