/* SPDX-License-Identifier: MIT
 *
 * SPI devices on a fake machine that are not as one would have them: controllers without a flag of the mode, chip
 * selects that are GPIO lines, devices that spidev does not have, and why. The names are those of real machines. */
#include "fakes/fake_linux.h"
#include "linux/linux_port.h"
#include "linux/spi_devices.h"
#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <linux/spi/spi.h>
#include <stdio.h>
#include <string.h>

static struct port port;

static int set_up(void **state)
{
    (void)state;
    fake_linux_init();
    return 0;
}

static const struct linux_port_config bare = {.spi = "/dev/spidev0.0", .speed_hz = 1000000};

static void assert_refused(const struct linux_port_config *config, int err_no, const char *text)
{
    assert_int_equal(linux_port_open(&port, config), -err_no);
    assert_string_equal(port.error, text);
    assert_true(fake_is_clean());
}

/* It opens in that mode, and says so. */
static void assert_opened(const struct linux_port_config *config, uint8_t mode, const char *text)
{
    assert_int_equal(linux_port_open(&port, config), 0);
    assert_string_equal(port.notice, text);
    assert_int_equal(fake.mode, mode);
    assert_int_equal(port.spi_mode, mode & SPI_MODE_3);
    assert_int_equal(fake.word_bits, 8);
    port_close(&port);
    assert_true(fake_is_clean());
}

/* Modes ----------------------------------------------------------------------------------------- */

/* drivers/spi/spi-dw-core.c: CPOL, CPHA and LOOP. */
static void set_up_pi_5(void)
{
    fake.mode_bits = SPI_CPOL | SPI_CPHA | SPI_LOOP;
    fake.nodes[0] = (struct fake_node){.path = "/sys/class/spi_master/spi0/device/driver",
                                       .link = "../../../../../bus/platform/drivers/dw_spi_mmio"};
}

static void a_chip_select_that_must_be_driven_is_driven(void **state)
{
    (void)state;
    struct linux_port_config config = bare;
    set_up_pi_5();
    config.no_cs = true;
    assert_opened(&config, 0,
                  "/dev/spidev0.0: its controller (dw_spi_mmio) refuses SPI_NO_CS; chip select is driven, so leave its "
                  "pin open");
    config.mode = 3;
    assert_opened(&config, 3,
                  "/dev/spidev0.0: its controller (dw_spi_mmio) refuses SPI_NO_CS; chip select is driven, so leave its "
                  "pin open");
    fake.nodes[0] = (struct fake_node){0};
    assert_opened(&config, 3,
                  "/dev/spidev0.0: its controller refuses SPI_NO_CS; chip select is driven, so leave its pin open");
    fake.mode_bits = 0xFF;
    assert_opened(&config, 0x43, "");
}

static void a_polarity_that_the_controller_lacks_is_an_error(void **state)
{
    (void)state;
    struct linux_port_config config = bare;
    set_up_pi_5();
    config.cs_high = true;
    assert_refused(&config, EINVAL, "/dev/spidev0.0: its controller (dw_spi_mmio) refuses SPI_CS_HIGH");
}

/* drivers/spi/spi-bcm2835aux.c, SPI1 and SPI2 of a Raspberry Pi: no CPHA. */
static void set_up_aux(void)
{
    fake.spi_path = "/dev/spidev1.2";
    fake.mode_bits = SPI_CPOL | SPI_CS_HIGH | SPI_NO_CS;
    fake.nodes[0] = (struct fake_node){.path = "/sys/class/spi_master/spi1/device/driver", .link = "spi-bcm2835aux"};
}

static void a_mode_that_was_asked_for_is_not_exchanged(void **state)
{
    (void)state;
    struct linux_port_config config = bare;
    set_up_aux();
    config.spi = "/dev/spidev1.2";
    config.mode = 3;
    assert_refused(&config, EINVAL, "/dev/spidev1.2: its controller (spi-bcm2835aux) refuses SPI_CPHA");
    config.mode = 2;
    assert_opened(&config, 2, "");
}

static void a_mode_that_is_only_usual_is_exchanged_as_a_whole(void **state)
{
    (void)state;
    struct linux_port_config config = bare;
    set_up_aux();
    config.spi = "/dev/spidev1.2";
    config.mode = 3;
    config.any_mode = true;
    assert_opened(&config, 0,
                  "/dev/spidev1.2: its controller (spi-bcm2835aux) refuses SPI_CPHA; mode 0 is taken, in which a "
                  "display whose chip select is not wired may stay dark");
    config.cs_high = true;
    assert_opened(&config, SPI_CS_HIGH,
                  "/dev/spidev1.2: its controller (spi-bcm2835aux) refuses SPI_CPHA; mode 0 is taken, in which a "
                  "display whose chip select is not wired may stay dark");
}

/* drivers/spi/spi-mt7621.c. */
static void a_controller_may_lack_them_all(void **state)
{
    (void)state;
    struct linux_port_config config = bare;
    fake.mode_bits = SPI_LSB_FIRST;
    config.mode = 3;
    config.no_cs = true;
    assert_refused(&config, EINVAL, "/dev/spidev0.0: its controller refuses SPI_CPHA, SPI_CPOL, SPI_NO_CS");
    config.any_mode = true;
    assert_opened(&config, 0,
                  "/dev/spidev0.0: its controller refuses SPI_CPHA, SPI_CPOL, SPI_NO_CS; mode 0 is taken, in which a "
                  "display whose chip select is not wired may stay dark; chip select is driven, so leave its pin open");
    assert_true(strlen(port.notice) < PORT_ERROR_B - 1);
}

static void a_level_that_the_device_tree_sets_is_told(void **state)
{
    static const char text[] = "/dev/spidev0.0: its chip select is a GPIO line, whose level the device tree says "
                               "(cs-gpios); SPI_CS_HIGH changes nothing";
    (void)state;
    for (uint8_t mode = 0; mode < 4; mode += 3) {
        struct linux_port_config config = bare;
        config.mode = mode;
        for (int told = 0; told < 2; told++) {
            fake.cs_is_told_high = told;
            fake.cs_is_gpio = true;
            config.cs_high = true;
            assert_opened(&config, mode | SPI_CS_HIGH, text);
            config.cs_high = false;
            assert_opened(&config, mode | SPI_CS_HIGH, "");
            fake.cs_is_gpio = false;
            config.cs_high = true;
            assert_opened(&config, mode | SPI_CS_HIGH, "");
        }
    }
}

/* Devices that spidev does not have ------------------------------------------------------------- */

static void set_up_device(const char *device, const char *driver_path, const char *driver)
{
    fake.spi_path = NULL;
    fake.nodes[0] = (struct fake_node){.path = device};
    fake.nodes[1] = (struct fake_node){.path = driver_path, .link = driver};
}

static void assert_missing(const char *text)
{
    char whole[PORT_ERROR_B];
    snprintf(whole, sizeof whole, "/dev/spidev0.0: no such device%s", text);
    assert_refused(&bare, ENOENT, whole);
}

static void set_up_held(const char *driver_link)
{
    set_up_device("/sys/bus/spi/devices/spi0.0", "/sys/bus/spi/devices/spi0.0/driver", driver_link);
}

static void an_overlay_that_has_the_bus_is_named(void **state)
{
    static const struct {
        const char *driver, *text;
    } cases[] = {
        {"../../../../bus/spi/drivers/panel-mipi-dbi-spi",
         ": the kernel's driver panel-mipi-dbi-spi has spi0.0, by an overlay (dtoverlay=mipi-dbi-spi); put "
         "dtparam=spi=on in its place in /boot/firmware/config.txt, and start anew"},
        {"../drivers/fb_ili9341",
         ": the kernel's driver fb_ili9341 has spi0.0, by an overlay (dtoverlay=fbtft, or a display's, such as "
         "piscreen); put dtparam=spi=on in its place in /boot/firmware/config.txt, and start anew"},
        {"../drivers/ssd130x-spi",
         ": the kernel's driver ssd130x-spi has spi0.0, by an overlay (dtoverlay=ssd1306-spi or sh1106-spi); put "
         "dtparam=spi=on in its place in /boot/firmware/config.txt, and start anew"},
        {"../drivers/st7735r",
         ": the kernel's driver st7735r has spi0.0, by an overlay (dtoverlay=adafruit-st7735r); put dtparam=spi=on in "
         "its place in /boot/firmware/config.txt, and start anew"},
        {"../drivers/mi0283qt",
         ": the kernel's driver mi0283qt has spi0.0; put dtparam=spi=on in the place of its dtoverlay in "
         "/boot/firmware/config.txt, and start anew"},
        {"../drivers/mcp251x",
         ": the kernel's driver mcp251x has spi0.0; put dtparam=spi=on in the place of its dtoverlay in "
         "/boot/firmware/config.txt, and start anew"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        set_up_held(cases[i].driver);
        fake.nodes[2] = (struct fake_node){.path = "/boot/firmware/config.txt"};
        fake.nodes[3] = (struct fake_node){.path = "/boot/config.txt"};
        assert_missing(cases[i].text);
    }
}

static void the_file_of_older_systems_is_named_where_it_is(void **state)
{
    (void)state;
    set_up_held("../drivers/fb_st7789v");
    fake.nodes[2] = (struct fake_node){.path = "/boot/config.txt"};
    assert_missing(
        ": the kernel's driver fb_st7789v has spi0.0, by an overlay (dtoverlay=fbtft, or a display's, such as "
        "piscreen); put dtparam=spi=on in its place in /boot/config.txt, and start anew");
}

static void elsewhere_it_is_the_device_trees_affair(void **state)
{
    (void)state;
    set_up_held("../drivers/panel-mipi-dbi-spi");
    assert_missing(": the kernel's driver panel-mipi-dbi-spi has spi0.0, as the device tree says (on a Raspberry Pi "
                   "dtoverlay=mipi-dbi-spi); hal/linux/README.md says how to free it");
    set_up_held("../drivers/jedec,spi-nor");
    assert_missing(": the kernel's driver jedec,spi-nor has spi0.0, as the device tree says; hal/linux/README.md "
                   "says how to free it");
}

static void a_device_that_no_driver_has_is_told(void **state)
{
    static const struct {
        const char *uevent, *text;
    } cases[] = {
        {"OF_NAME=spidev\nOF_COMPATIBLE_0=spidev\nOF_COMPATIBLE_N=1\nMODALIAS=spi:spidev\n",
         ": no driver has spi0.0; load spidev (sudo modprobe spidev)"},
        {"MODALIAS=spi:spidev\n", ": no driver has spi0.0; load spidev (sudo modprobe spidev)"},
        {"OF_NAME=display\nOF_COMPATIBLE_0=ilitek,ili9341\nOF_COMPATIBLE_N=1\n",
         ": spi0.0 is kept for another driver (ilitek,ili9341), which is not loaded; hal/linux/README.md says how "
         "to free it"},
        {"OF_COMPATIBLE_0=a-company-of-some-length,its-display-of-some-length",
         ": spi0.0 is kept for another driver (a-company-of-some-length,its-di), which is not loaded; "
         "hal/linux/README.md"
         " says how to free it"},
        {"", ": spi0.0 is kept for another driver (device), which is not loaded; hal/linux/README.md says how to "
             "free it"},
        {NULL, ": spi0.0 is kept for another driver (device), which is not loaded; hal/linux/README.md says how "
               "to free it"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        fake.spi_path = NULL;
        fake.nodes[0] = (struct fake_node){.path = "/sys/bus/spi/devices/spi0.0"};
        fake.nodes[1] = (struct fake_node){.path = "/sys/bus/spi/devices/spi0.0/uevent", .text = cases[i].uevent};
        assert_missing(cases[i].text);
    }
}

static void a_node_that_is_not_made_is_told(void **state)
{
    (void)state;
    set_up_held("../../../../bus/spi/drivers/spidev");
    assert_missing(": spidev has spi0.0, but its node is missing; udev makes them, and containers want them passed on");
}

static void spi_that_is_off_is_told(void **state)
{
    (void)state;
    fake.spi_path = NULL;
    assert_missing(", nor any other; load spidev and the controller's driver (Raspberry Pi: dtparam=spi=on)");
    fake.nodes[2] = (struct fake_node){.path = "/boot/firmware/config.txt"};
    assert_missing(", nor any other; SPI is off; put dtparam=spi=on into /boot/firmware/config.txt, and start anew");
}

/* Whoever asks for another place is told of the one that there is. */
static void another_place_that_is_held_is_named(void **state)
{
    (void)state;
    struct linux_port_config config = bare;
    set_up_held("../drivers/fb_ili9341");
    config.spi = "/dev/spidev1.0";
    assert_refused(
        &config, ENOENT,
        "/dev/spidev1.0: no such device, nor any other; the kernel's driver fb_ili9341 has spi0.0, as the "
        "device tree says (on a Raspberry Pi dtoverlay=fbtft, or a display's, such as piscreen); hal/linux/README.md"
        " says how to free it");
    fake.spi_path = "/dev/spidev0.1";
    assert_refused(&config, ENOENT, "/dev/spidev1.0: no such device; there are /dev/spidev0.1");
}

static void names_that_are_no_places_are_no_places(void **state)
{
    static const char *const names[] = {"/dev/display",    "/dev/spidev",    "/dev/spidev0",    "/dev/spidev0.",
                                        "/dev/spidev0.0x", "/dev/spidevx.0", "/dev/spidev0.0/", ""};
    struct spi_place place;
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        assert_false(spi_place_of(&place, names[i]));
    assert_true(spi_place_of(&place, "/dev/spidev12.3"));
    assert_int_equal(place.bus, 12);
    assert_int_equal(place.select, 3);
    fake.nodes[0] = (struct fake_node){.path = "/dev/display", .link = "spidev1.0"};
    assert_true(spi_place_of(&place, "/dev/display"));
    assert_int_equal(place.bus, 1);
}

/* As `limner devices` lists them. */
static void devices_without_a_node_are_listed(void **state)
{
    struct spi_place place;
    (void)state;
    fake.nodes[0] = (struct fake_node){.path = "/sys/bus/spi/devices/spi0.0"};
    fake.nodes[1] = (struct fake_node){.path = "/sys/bus/spi/devices/spi0.1"};
    fake.nodes[2] = (struct fake_node){.path = "/sys/bus/spi/devices/spi10.0"};
    fake.nodes[3] = (struct fake_node){.path = "/sys/bus/spi/devices/spi-PRP0001:00"};
    assert_true(spi_place_without_node(&place, 0));
    assert_int_equal(place.bus, 0);
    assert_int_equal(place.select, 1); /* of 0.0 there is a node */
    assert_true(spi_place_without_node(&place, 1));
    assert_int_equal(place.bus, 10);
    assert_false(spi_place_without_node(&place, 2));
    assert_true(fake_is_clean());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_chip_select_that_must_be_driven_is_driven, set_up),
        cmocka_unit_test_setup(a_polarity_that_the_controller_lacks_is_an_error, set_up),
        cmocka_unit_test_setup(a_mode_that_was_asked_for_is_not_exchanged, set_up),
        cmocka_unit_test_setup(a_mode_that_is_only_usual_is_exchanged_as_a_whole, set_up),
        cmocka_unit_test_setup(a_controller_may_lack_them_all, set_up),
        cmocka_unit_test_setup(a_level_that_the_device_tree_sets_is_told, set_up),
        cmocka_unit_test_setup(an_overlay_that_has_the_bus_is_named, set_up),
        cmocka_unit_test_setup(the_file_of_older_systems_is_named_where_it_is, set_up),
        cmocka_unit_test_setup(elsewhere_it_is_the_device_trees_affair, set_up),
        cmocka_unit_test_setup(a_device_that_no_driver_has_is_told, set_up),
        cmocka_unit_test_setup(a_node_that_is_not_made_is_told, set_up),
        cmocka_unit_test_setup(spi_that_is_off_is_told, set_up),
        cmocka_unit_test_setup(another_place_that_is_held_is_named, set_up),
        cmocka_unit_test_setup(names_that_are_no_places_are_no_places, set_up),
        cmocka_unit_test_setup(devices_without_a_node_are_listed, set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
