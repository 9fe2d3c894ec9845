test_panel_starts.o: tests/test_panel_starts.c tests/cmocka_ready.h \
  tests/panel_rig.h sim/emulated_display.h sim/display.h sim/error.h \
  hal/panels.h hal/dcs.h hal/panel.h hal/pixels.h hal/bus.h hal/wire.h \
  hal/pages.h hal/sharp.h hal/solomon.h hal/port.h sim/emulated_dcs.h \
  sim/emulated_port.h sim/emulated_pages.h sim/emulated_sharp.h \
  sim/emulated_solomon.h tests/fault_port.h boards/common/screen.h \
  firmware/camera.h firmware/config.h firmware/errors.h hal/greys.h \
  firmware/target.h firmware/rect.h

tests/cmocka_ready.h:

tests/panel_rig.h:

sim/emulated_display.h:

sim/display.h:

sim/error.h:

hal/panels.h:

hal/dcs.h:

hal/panel.h:

hal/pixels.h:

hal/bus.h:

hal/wire.h:

hal/pages.h:

hal/sharp.h:

hal/solomon.h:

hal/port.h:

sim/emulated_dcs.h:

sim/emulated_port.h:

sim/emulated_pages.h:

sim/emulated_sharp.h:

sim/emulated_solomon.h:

tests/fault_port.h:

boards/common/screen.h:

firmware/camera.h:

firmware/config.h:

firmware/errors.h:

hal/greys.h:

firmware/target.h:

firmware/rect.h:
