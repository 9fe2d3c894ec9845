// @name@ on @panel@ by Arduino's SPI: SCK and MOSI are the board's own, the other pins are named here.
#include <@name@_display.h>
#include <limner_arduino.h>

// cs, dc, reset, backlight, select (a memory LCD's, which its driver sets)
static struct limner_arduino wires = {@cs_10@, 9, 8, LIMNER_NO_PIN, @select_10@, SPISettings()};
static struct board board;
static struct lim_camera camera = {
    {0, 0, 0}, 0, 0, 0, @NAME@_DISPLAY_TAN_X_Q28, @NAME@_DISPLAY_TAN_Y_Q28, @SCENE@_M_Q8(@NEAR_M@)};
static int err;

void setup() {
  limner_arduino_board(&wires, &board, @NAME@_DISPLAY_HZ, @NAME@_DISPLAY_SPI_MODES);
  err = @name@_display_begin(&board);
  pinMode(LED_BUILTIN, OUTPUT);
}

void loop() {
  static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);
  static uint32_t yaw;
  lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), yaw += LIM_DEGREES(3), LIM_DEGREES(-25));
  if (!err) err = @name@_display_frame(&camera, millis());
  digitalWrite(LED_BUILTIN, err ? HIGH : LOW); // lit: it failed; err says how (limner_display.h, limner.h)
}
