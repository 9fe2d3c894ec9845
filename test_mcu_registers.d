test_mcu_registers.o: tests/test_mcu_registers.c tests/cmocka_ready.h \
  hal/mcu/avr_spi.h hal/bus.h hal/mcu/mcu.h hal/mcu/pl022.h \
  hal/mcu/rp2040_dma.h hal/mcu/sio_gpio.h hal/mcu/stm32_clock.h \
  hal/mcu/stm32f1_rcc.h hal/mcu/stm32f4_rcc.h

tests/cmocka_ready.h:

hal/mcu/avr_spi.h:

hal/bus.h:

hal/mcu/mcu.h:

hal/mcu/pl022.h:

hal/mcu/rp2040_dma.h:

hal/mcu/sio_gpio.h:

hal/mcu/stm32_clock.h:

hal/mcu/stm32f1_rcc.h:

hal/mcu/stm32f4_rcc.h:
