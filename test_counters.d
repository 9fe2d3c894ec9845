test_counters.o: tests/test_counters.c tests/cmocka_ready.h \
  hal/mcu/avr_timer.h hal/bus.h hal/mcu/mcu.h hal/mcu/mtime.h \
  hal/mcu/systick.h

tests/cmocka_ready.h:

hal/mcu/avr_timer.h:

hal/bus.h:

hal/mcu/mcu.h:

hal/mcu/mtime.h:

hal/mcu/systick.h:
