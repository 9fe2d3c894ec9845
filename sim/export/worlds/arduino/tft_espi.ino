// @name@ in an endless orbit, on whatever display TFT_eSPI is set up for.
#include "@name@.h"
#include "limner_tft_espi.h"

@SCENE@_MEMORY(@W@, @H@);
static TFT_eSPI tft;
static struct limner_tft_espi display = {&tft, &@scene@_memory, 0, 0, false};
static struct lim_camera camera;
static int err;

void setup() {
  tft.init();
  tft.fillScreen(TFT_BLACK);
  err = @scene@_begin(&@scene@_memory, limner_tft_espi_send, &display);
  if (!err) err = lim_camera_set_fov(&camera, LIM_DEGREES(@LENS@), @W@, @H@);
  camera.near_q8 = @SCENE@_M_Q8(@ORBIT_M@ / 20.0);
}

void loop() {
  static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);
  lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), millis() * (LIM_DEGREES(45) / 1000), LIM_DEGREES(-20));
  if (!err) err = lim_frame(@scene@_memory.lim, &camera);
  if (err) tft.drawString("limner: error " + String(err), 0, 0, 2);
}
