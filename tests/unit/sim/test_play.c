/* SPDX-License-Identifier: MIT
 *
 * `limner play` on a fake machine with an emulated display: the picture on the glass is the simulator's, whichever way
 * it is turned; a call that fails costs a frame and no more; the panel is dark at the end, and all is released. */
#include "cli/commands.h"
#include "cli/options.h"
#include "displays/player.h"
#include "fakes/fake_linux.h"
#include "linux/interrupt.h"
#include "rigs/cmocka_ready.h"
#include "scene/moving.h"
#include "test_card.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

ssize_t __real_read(int fd, void *to, size_t most_b);
int __real_close(int fd);

enum { W_PX = 96, H_PX = 72, ARGS_MAX = 32 };

static struct emulated_display glass; /* large */
static uint32_t raw[W_PX * H_PX];
static uint8_t rgb[3 * W_PX * H_PX];

static const struct display_module glass_module = {
    .w_px = W_PX, .h_px = H_PX, .ox_px = 11, .oy_px = 12, .invert = true};

static void plug_in(const char *panel, const struct display_module *module)
{
    struct panel_choice choice;
    fake_linux_init();
    assert_true(panel_choice_parse(panel, NULL, &choice, &(struct error){0}));
    emulated_display_choose(&glass, &choice, module);
    fake.display = glass.port;
    fake.chips[0].lines[5].wire = emulated_port_dc(fake.display);
    fake.chips[0].lines[4].wire = emulated_port_reset(fake.display);
    fake.chips[0].lines[3].wire = emulated_port_backlight(fake.display);
}

/* `play`, the panel, the pins and what follows, divided by spaces. */
static int play(const char *panel, const char *more)
{
    char line[512], *argv[ARGS_MAX] = {NULL};
    int argc = 0;
    snprintf(line, sizeof line, "play --panel %s --spi /dev/spidev0.0 --dc GPIO5 --reset GPIO4 --backlight GPIO3 %s",
             panel, more);
    for (char *word = strtok(line, " "); word; word = strtok(NULL, " "))
        argv[argc++] = word;
    return cmd_play(argc, argv);
}

static void assert_ended(void)
{
    struct error err;
    if (!emulated_display_is_quiet(&glass, &err)) fail_msg("%s", err.text);
    assert_true(fake_is_clean());
    assert_false(fake.chips[0].lines[3].level); /* the light is out */
    emulated_display_show(&glass, rgb);
    for (size_t i = 0; i < sizeof rgb; i++)
        assert_int_equal(rgb[i], 0);
}

/* What the simulator makes of a frame of the orbit. */
static void draw_expected(char *panel, unsigned w_px, unsigned h_px, size_t frame, enum panel_rotation camera_turn,
                          uint16_t *pixels)
{
    char size[16];
    char *argv[] = {"view", "--panel", panel, "--size", size, "sim/scenes/icosahedron.obj", NULL};
    struct options options;
    struct compiled scene = {0};
    struct moving moving = {0};
    struct camera_path path = {0};
    struct simulator simulator;
    struct lens lens;
    struct lim_camera camera;
    struct error err;
    snprintf(size, sizeof size, "%ux%u", w_px, h_px);
    assert_true(options_parse(6, argv, OPTIONS_VIEW, &options, &err));
    options.orbit_frames = 240;
    assert_true(options_load(&options, &scene, &moving, &lens, &path, &err));
    assert_true(camera_path_to_camera(&path, frame, &lens, &scene.grid, &camera, &err));
    screen_turn_camera(&camera, camera_turn);
    assert_true(simulator_init_on(&simulator, &scene.scene, &options.setup, &options.panel, &err));
    assert_true(simulator_frame(&simulator, &camera, &err));
    memcpy(pixels, simulator.pixels, (size_t)w_px * h_px * sizeof pixels[0]);
    simulator_free(&simulator);
    camera_path_free(&path);
    compiled_free(&scene);
    moving_free(&moving);
}

static void the_display_shows_what_the_simulator_does(void **state)
{
    (void)state;
    static uint16_t expected[W_PX * H_PX];
    draw_expected("st7789", W_PX, H_PX, 2, PANEL_UPRIGHT, expected);
    plug_in("st7789", &glass_module);
    assert_int_equal(play("st7789", "--size 96x72 --offset 11,12 --frames 3 sim/scenes/icosahedron.obj"), 0);
    emulated_dcs_show(&glass.chip.dcs, 0, NULL, raw);
    for (size_t i = 0; i < W_PX * H_PX; i++)
        assert_int_equal(raw[i], expected[i]);
    assert_int_equal(fake.speed_hz, 40000000);
    assert_ended();
}

/* The mode in which a card goes out. */
static uint8_t mode_of(const char *panel, const struct display_module *module, const char *more)
{
    char all[128];
    plug_in(panel, module);
    snprintf(all, sizeof all, "--frames 1 --test-card %s", more);
    assert_int_equal(play(panel, all), 0);
    return fake.mode;
}

static void the_mode_of_spi_is_the_modules_unless_it_is_given(void **state)
{
    (void)state;
    const struct display_module oled = {.w_px = 128, .h_px = 64};
    assert_int_equal(mode_of("st7789", &glass_module, "--size 96x72 --offset 11,12"), 3);
    assert_int_equal(mode_of("st7789", &glass_module, "--size 96x72 --offset 11,12 --mode 0"), 0);
    assert_int_equal(mode_of("ssd1306", &oled, ""), 0);
    assert_int_equal(mode_of("ssd1306", &oled, "--mode 3"), 3);
}

/* What a card's run says on standard error; it succeeds. */
static const char *notes_of(const char *panel, const struct display_module *module, const char *more)
{
    static char text[1024];
    const int before = dup(STDERR_FILENO);
    FILE *file = tmpfile();
    assert_non_null(file);
    fflush(stderr);
    assert_int_equal(dup2(fileno(file), STDERR_FILENO), STDERR_FILENO);
    (void)mode_of(panel, module, more);
    fflush(stderr);
    assert_int_equal(dup2(before, STDERR_FILENO), STDERR_FILENO);
    __real_close(before);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    return text;
}

static void what_is_chosen_or_changes_nothing_is_told(void **state)
{
    (void)state;
    const struct display_module oled = {.w_px = 128, .h_px = 64}, memory_lcd = {.w_px = 128, .h_px = 128};
    assert_string_equal(notes_of("st7789", &glass_module, "--size 96x72 --offset 11,12 --bgr"),
                        "limner: note: SPI mode 3, which most modules with st7789 want; --mode says otherwise\n");
    assert_string_equal(notes_of("st7789", &glass_module, "--size 96x72 --offset 11,12 --mode 3"), "");
    assert_string_equal(notes_of("ssd1306", &oled, "--invert"), "");
    assert_string_equal(notes_of("ssd1306", &oled, "--bgr"),
                        "limner: note: --bgr: ssd1306 has no colours; nothing changes\n");
    assert_string_equal(notes_of("ls013b7dh03", &memory_lcd, "--select GPIO2"),
                        "limner: note: --dc: ls013b7dh03 has no data/command pin; nothing changes\n"
                        "limner: note: --reset: ls013b7dh03 has no reset pin; nothing changes\n");
}

/* Only its supply would put it out: that is told, and is no failure. */
static void a_memory_lcd_without_its_pin_of_display_plays(void **state)
{
    (void)state;
    const struct display_module memory_lcd = {.w_px = 128, .h_px = 128};
    char *argv[] = {"play",        "--panel",  "ls013b7dh03", "--spi", "/dev/spidev0.0", "--select", "GPIO2",
                    "--test-card", "--frames", "1",           NULL};
    plug_in("ls013b7dh03", &memory_lcd);
    assert_int_equal(cmd_play(10, argv), 0);
    assert_true(fake_is_clean());
}

static void a_turned_display_shows_it_turned(void **state)
{
    (void)state;
    static uint16_t expected[W_PX * H_PX];
    draw_expected("st7789", H_PX, W_PX, 0, PANEL_UPRIGHT, expected);
    plug_in("st7789", &glass_module);
    assert_int_equal(play("st7789", "--size 96x72 --offset 11,12 --rotate 90 --frames 1 sim/scenes/icosahedron.obj"),
                     0);
    emulated_dcs_show(&glass.chip.dcs, 1, NULL, raw);
    for (size_t i = 0; i < W_PX * H_PX; i++)
        assert_int_equal(raw[i], expected[i]);
    assert_ended();
}

/* The card ------------------------------------------------------------------------------------ */

static void the_card_is_right_in_all_rotations(void **state)
{
    (void)state;
    static const char *const turns[] = {"0", "90", "180", "270"};
    for (unsigned i = 0; i < 4; i++) {
        char more[80];
        const unsigned w_px = i % 2 ? H_PX : W_PX, h_px = i % 2 ? W_PX : H_PX;
        plug_in("st7789", &glass_module);
        snprintf(more, sizeof more, "--size 96x72 --offset 11,12 --rotate %s --frames 1 --test-card", turns[i]);
        assert_int_equal(play("st7789", more), 0);
        emulated_dcs_show(&glass.chip.dcs, i, NULL, raw);
        for (unsigned at = 0; at < W_PX * H_PX; at++)
            assert_int_equal(raw[at], test_card_px(at % w_px, at / w_px, w_px, h_px));
        assert_ended();
    }
}

/* Of a chip that turns by half a turn alone; the brightest corner, green, tells. */
static unsigned bright_in_corner(unsigned x_px, unsigned y_px)
{
    unsigned bright = 0;
    for (unsigned i = 0; i < 64; i++)
        bright += emulated_pages_is_bright(&glass.chip.pages, x_px + i % 8, y_px + i / 8);
    return bright;
}

static const struct pin *light; /* what the backlight's line reaches */
static unsigned corner_bright[4];

static int look_before_dark(void *ctx, bool high)
{
    static const unsigned at[4][2] = {{4, 4}, {52, 4}, {52, 52}, {4, 52}}; /* clockwise, inside of the edge */
    for (unsigned i = 0; i < 4 && !high; i++)
        corner_bright[i] = bright_in_corner(at[i][0], at[i][1]);
    (void)ctx;
    return light->set(light->ctx, high);
}

static bool kept[64 * 64]; /* which pixels were bright */

static int keep_before_dark(void *ctx, bool high)
{
    for (unsigned i = 0; i < 64 * 64 && !high; i++)
        kept[i] = emulated_pages_is_bright(&glass.chip.pages, i % 64, i / 64);
    (void)ctx;
    return light->set(light->ctx, high);
}

static void a_scene_is_turned_by_the_camera_where_the_chip_cannot(void **state)
{
    (void)state;
    static uint16_t expected[64 * 64];
    draw_expected("ssd1306", 64, 64, 1, PANEL_TURNED_270, expected);
    plug_in("ssd1306", &(struct display_module){.w_px = 64, .h_px = 64, .ox_px = 32});
    const struct pin wired = emulated_port_backlight(fake.display);
    light = &wired;
    fake.chips[0].lines[3].wire = (struct pin){NULL, keep_before_dark};
    assert_int_equal(play("ssd1306", "--size 64x64 --rotate 270 --frames 2 sim/scenes/icosahedron.obj"), 0);
    for (unsigned i = 0; i < 64 * 64; i++)
        assert_int_equal(kept[i], expected[i] != 0);
}

static void a_quarter_turn_that_the_chip_cannot_make_is_made(void **state)
{
    (void)state;
    static const char *const turns[] = {"0", "90", "180", "270"};
    for (unsigned turn = 0; turn < 4; turn++) {
        char more[80];
        plug_in("ssd1306", &(struct display_module){.w_px = 64, .h_px = 64, .ox_px = 32});
        const struct pin wired = emulated_port_backlight(fake.display);
        light = &wired;
        fake.chips[0].lines[3].wire = (struct pin){NULL, look_before_dark};
        snprintf(more, sizeof more, "--size 64x64 --rotate %s --frames 1 --test-card", turns[turn]);
        assert_int_equal(play("ssd1306", more), 0);
        for (unsigned i = 0; i < 4; i++) {
            const unsigned green = (1 + turn) % 4;
            if (i != green && corner_bright[i] >= corner_bright[green])
                fail_msg("turned by %s: corner %u is as bright as corner %u", turns[turn], i, green);
        }
        assert_true(fake_is_clean());
    }
}

/* Faults ---------------------------------------------------------------------------------------- */

static struct {
    struct port port;
    struct display display;
    struct player player;
    int gone, bad; /* frames that fail from now on: the bridge is unplugged, and then for other reasons */
    uint64_t drawn[8];
    size_t count;
} rig;

static int draw_some(void *ctx, uint64_t frame)
{
    (void)ctx;
    if (rig.gone > 0 && rig.gone--) return -ENODEV;
    if (rig.bad > 0 && rig.bad--) return -EREMOTEIO;
    rig.drawn[rig.count++ % 8] = frame;
    const uint8_t bytes[100] = {0};
    return bus_write(&rig.player.bus, bytes, sizeof bytes);
}

static void start_player(uint64_t frames)
{
    struct panel_choice choice;
    struct error err;
    plug_in("st7789", &glass_module);
    memset(&rig, 0, sizeof rig);
    rig.port = emulated_port_whole(fake.display);
    player_init(&rig.player, &rig.port);
    struct port counted = rig.port;
    counted.bus = rig.player.bus;
    assert_true(panel_choice_parse("st7789", NULL, &choice, &err));
    assert_true(display_setup(&rig.display, &choice, &glass_module, &counted, &err));
    rig.player.panel = rig.display.panel;
    rig.player.draw = draw_some;
    rig.player.frames = frames;
}

static void frames_and_their_bytes_are_counted(void **state)
{
    (void)state;
    struct error err;
    start_player(4);
    assert_true(player_run(&rig.player, &err));
    assert_int_equal(rig.player.drawn, 4);
    assert_int_equal(rig.player.drawn_b, 400); /* without those of setting up */
    assert_true(rig.player.sent_b > 400);
    assert_int_equal(rig.player.failed, 0);
}

static void a_frame_that_fails_is_drawn_again(void **state)
{
    (void)state;
    struct error err;
    start_player(3);
    assert_true(player_run(&rig.player, &err));
    const uint64_t calm_b = rig.player.sent_b;
    start_player(3);
    rig.bad = PLAYER_FAILURES_MAX - 1;
    assert_true(player_run(&rig.player, &err));
    assert_true(rig.player.sent_b >= calm_b + 5 * (PLAYER_FAILURES_MAX - 1)); /* the panel was set up anew */
    assert_int_equal(rig.player.failed, PLAYER_FAILURES_MAX - 1);
    assert_int_equal(rig.count, 3);
    for (uint64_t i = 0; i < 3; i++)
        assert_int_equal(rig.drawn[i], i);
}

static void what_fails_again_and_again_is_given_up(void **state)
{
    (void)state;
    struct error err;
    start_player(3);
    rig.bad = PLAYER_FAILURES_MAX;
    assert_false(player_run(&rig.player, &err));
    assert_string_equal(err.text, "frame 1: Remote I/O error (-121); given up after 10 failures in a row");
    assert_int_equal(rig.count, 0);
    assert_true(glass.chip.dcs.asleep); /* all the same */
}

/* A bridge that is plugged in again may not be open to us at once. */
static void what_was_long_unplugged_may_fail_otherwise_as_well(void **state)
{
    (void)state;
    struct error err;
    start_player(3);
    rig.gone = 2 * PLAYER_FAILURES_MAX;
    rig.bad = PLAYER_FAILURES_MAX - 1;
    assert_true(player_run(&rig.player, &err));
    assert_int_equal(rig.count, 3);
    start_player(3);
    rig.gone = 2 * PLAYER_FAILURES_MAX;
    rig.bad = PLAYER_FAILURES_MAX;
    assert_false(player_run(&rig.player, &err));
    start_player(3);
    rig.gone = PLAYER_GONE_MAX;
    assert_false(player_run(&rig.player, &err));
    assert_int_equal(rig.player.failed, PLAYER_GONE_MAX);
}

/* Every call of a run fails once: before the first frame that ends it, later it costs a frame. */
static void a_fault_anywhere_leaves_nothing_open(void **state)
{
    (void)state;
    unsigned refused = 0, survived = 0;
    for (long n = 0; n == 0 || fake.failed; n++) {
        plug_in("st7789", &glass_module);
        fake_fail_at(n, EREMOTEIO);
        const int status = play("st7789", "--size 16x12 --offset 11,12 --frames 1 --te GPIO6 --test-card");
        refused += status != 0;
        survived += status == 0 && fake.failed;
        assert_true(fake_is_clean());
    }
    assert_true(refused > 10 && survived > 5);
}

/* As when the panel lost its power: what it showed is gone. */
static int forget_picture(void *ctx, bool high)
{
    const struct pin *wired = ctx;
    for (unsigned y = 0; y < EMULATED_MAX_H_PX && !high; y++)
        for (unsigned x = 0; x < EMULATED_MAX_W_PX; x++)
            glass.chip.dcs.memory[y][x].raw ^= 0xFFFF;
    return wired->set(wired->ctx, high);
}

/* --delta knows what the panel shows, until it is set up anew: whatever the call that failed, here the last wait. */
static void a_frame_after_a_fault_is_whole(void **state)
{
    (void)state;
    static const char more[] = "--size 96x72 --offset 11,12 --te GPIO6 --delta --frames 3 sim/scenes/icosahedron.obj";
    static uint16_t expected[W_PX * H_PX];
    draw_expected("st7789", W_PX, H_PX, 2, PANEL_UPRIGHT, expected);
    plug_in("st7789", &glass_module);
    fake_fail_at(-1, 0);
    assert_int_equal(play("st7789", more), 0);
    const long last_wait = fake.waited_at;
    plug_in("st7789", &glass_module);
    const struct pin wired = emulated_port_reset(fake.display);
    signal(SIGINT, SIG_DFL); /* whatever the test itself was started with */
    fake.chips[0].lines[4].wire = (struct pin){(void *)(uintptr_t)&wired, forget_picture};
    fake_fail_at(last_wait, EREMOTEIO);
    assert_int_equal(play("st7789", more), 0);
    assert_string_equal(fake.failed, "line_wait");
    emulated_dcs_show(&glass.chip.dcs, 0, NULL, raw);
    for (size_t i = 0; i < W_PX * H_PX; i++)
        assert_int_equal(raw[i], expected[i]);
}

static int sent; /* the signal that comes while the panel is being set up */

static int interrupt_reset(void *ctx, bool high)
{
    const struct pin *wired = ctx;
    if (!high) raise(sent);
    return wired->set(wired->ctx, high);
}

/* The program in a process of its own, which says whether it released everything, and then dies of the signal. */
static void play_until_interrupted(int told)
{
    const struct pin wired = emulated_port_reset(fake.display);
    signal(sent, SIG_DFL); /* whatever the test itself was started with */
    fake.chips[0].lines[4].wire = (struct pin){(void *)(uintptr_t)&wired, interrupt_reset};
    fake.chips[0].lines[3].released = told;
    _exit(play("st7789", "--size 96x72 --offset 11,12 --test-card") + 64);
}

static void dies_after_releasing_all(int signal_number)
{
    int told[2], status;
    sent = signal_number;
    char last = 0;
    plug_in("st7789", &glass_module);
    assert_int_equal(pipe(told), 0);
    fflush(NULL);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) play_until_interrupted(told[1]);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == signal_number);
    assert_int_equal(write(told[1], "-", 1), 1); /* read() below does not wait, whatever happened */
    assert_int_equal(__real_read(told[0], &last, 1), 1);
    assert_int_equal(last, '0'); /* the backlight was low when its line was let go */
    assert_int_equal(__real_close(told[0]), 0);
    assert_int_equal(__real_close(told[1]), 0);
}

static void the_program_dies_of_the_signal_after_releasing_all(void **state)
{
    (void)state;
    static const int signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU};
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++)
        dies_after_releasing_all(signals[i]);
}

/* A signal that comes in the middle of frame 2. */
static int draw_interrupted(void *ctx, uint64_t frame)
{
    if (frame == 1) raise(SIGTERM);
    return draw_some(ctx, frame);
}

/* The last test: from now on the process has seen a signal. */
static void a_signal_ends_it_in_the_dark(void **state)
{
    (void)state;
    struct error err;
    start_player(0);
    rig.player.draw = draw_interrupted;
    assert_true(player_run(&rig.player, &err));
    assert_int_equal(rig.player.drawn, 2);
    assert_int_equal(interrupt_signal(), SIGTERM);
    assert_true(glass.chip.dcs.asleep && glass.port->backlight_low);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_display_shows_what_the_simulator_does),
        cmocka_unit_test(the_mode_of_spi_is_the_modules_unless_it_is_given),
        cmocka_unit_test(what_is_chosen_or_changes_nothing_is_told),
        cmocka_unit_test(a_memory_lcd_without_its_pin_of_display_plays),
        cmocka_unit_test(a_turned_display_shows_it_turned),
        cmocka_unit_test(the_card_is_right_in_all_rotations),
        cmocka_unit_test(a_scene_is_turned_by_the_camera_where_the_chip_cannot),
        cmocka_unit_test(a_quarter_turn_that_the_chip_cannot_make_is_made),
        cmocka_unit_test(frames_and_their_bytes_are_counted),
        cmocka_unit_test(a_frame_that_fails_is_drawn_again),
        cmocka_unit_test(what_fails_again_and_again_is_given_up),
        cmocka_unit_test(what_was_long_unplugged_may_fail_otherwise_as_well),
        cmocka_unit_test(a_fault_anywhere_leaves_nothing_open),
        cmocka_unit_test(a_frame_after_a_fault_is_whole),
        cmocka_unit_test(the_program_dies_of_the_signal_after_releasing_all),
        cmocka_unit_test(a_signal_ends_it_in_the_dark),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
