// @name@ in an endless orbit, on the display of a board that LovyanGFX knows (LGFX_AUTODETECT).
#include "@name@.h"
#define LGFX_AUTODETECT
#include "limner_lovyangfx.h"

@SCENE@_MEMORY(@W@, @H@);
static LGFX lcd;
static struct limner_lovyangfx display = {&lcd, &@scene@_memory, 0, 0, false};
static struct lim_camera camera;
static int err;

void setup() {
  lcd.init();
  lcd.fillScreen(TFT_BLACK);
  err = @scene@_begin(&@scene@_memory, limner_lovyangfx_send, &display);
  if (!err) err = lim_camera_set_fov(&camera, LIM_DEGREES(@LENS@), @W@, @H@);
  camera.near_q8 = @SCENE@_M_Q8(@ORBIT_M@ / 20.0);
}

void loop() {
  static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);
  lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), millis() * (LIM_DEGREES(45) / 1000), LIM_DEGREES(-20));
  if (!err) err = lim_frame(@scene@_memory.lim, &camera);
  if (err) lcd.drawString("limner: error " + String(err), 0, 0);
}
