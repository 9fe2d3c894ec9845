/* @name@ on a display of @W@x@H@ pixels: all of a program but display_send(), which is yours. */
#include "@name@.h"

/* Sends n_px pixels, RGB565 with the red byte first, from (x_px, y_px) to the right. 0, or a negative error. */
int display_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px);

@SCENE@_MEMORY(@W@, @H@); /* @scene@_memory: the renderer, what it works in, and a line of pixels */
static struct lim_camera camera;

int main(void)
{
    static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);

    int err = @scene@_begin(&@scene@_memory, display_send, NULL);
    if (!err) err = lim_camera_set_fov(&camera, LIM_DEGREES(@LENS@), @W@, @H@);
    camera.near_q8 = @SCENE@_M_Q8(@NEAR_M@);
    for (uint32_t yaw = 0; !err; yaw += LIM_DEGREES(3)) {
        lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), yaw, LIM_DEGREES(-25));
        err = lim_frame(@scene@_memory.lim, &camera);
    }
    return err; /* limner.h says what it is */
}
