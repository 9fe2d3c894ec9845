test_hid_port.o: tests/test_hid_port.c tests/bridge_rig.h sim/display.h \
  sim/error.h hal/panels.h hal/dcs.h hal/panel.h hal/pixels.h hal/bus.h \
  hal/wire.h hal/pages.h hal/sharp.h hal/solomon.h hal/port.h \
  sim/emulated_bridge.h sim/emulated_cable.h hal/hid/reports.h \
  sim/emulated_ch347.h sim/emulated_mcp2210.h sim/emulated_port.h \
  hal/hid/bridge_port.h hal/hid/bridge.h sim/emulated_display.h \
  sim/emulated_dcs.h sim/emulated_pages.h sim/emulated_sharp.h \
  sim/emulated_solomon.h boards/common/screen.h firmware/camera.h \
  firmware/config.h firmware/errors.h hal/greys.h firmware/target.h \
  firmware/rect.h tests/cmocka_ready.h tests/fake_hidapi.h \
  hal/hid/hid_bridges.h /usr/include/hidapi/hidapi.h hal/hid/hid_port.h

tests/bridge_rig.h:

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

sim/emulated_bridge.h:

sim/emulated_cable.h:

hal/hid/reports.h:

sim/emulated_ch347.h:

sim/emulated_mcp2210.h:

sim/emulated_port.h:

hal/hid/bridge_port.h:

hal/hid/bridge.h:

sim/emulated_display.h:

sim/emulated_dcs.h:

sim/emulated_pages.h:

sim/emulated_sharp.h:

sim/emulated_solomon.h:

boards/common/screen.h:

firmware/camera.h:

firmware/config.h:

firmware/errors.h:

hal/greys.h:

firmware/target.h:

firmware/rect.h:

tests/cmocka_ready.h:

tests/fake_hidapi.h:

hal/hid/hid_bridges.h:

/usr/include/hidapi/hidapi.h:

hal/hid/hid_port.h:
