fake_hidapi.o: tests/fake_hidapi.c tests/fake_hidapi.h \
  sim/emulated_cable.h hal/hid/reports.h hal/bus.h tests/cmocka_ready.h \
  /usr/include/hidapi/hidapi.h

tests/fake_hidapi.h:

sim/emulated_cable.h:

hal/hid/reports.h:

hal/bus.h:

tests/cmocka_ready.h:

/usr/include/hidapi/hidapi.h:
