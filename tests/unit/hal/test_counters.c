/* SPDX-License-Identifier: MIT
 *
 * Clocks over counters that run, as a second thread's do: a wait succeeds, and takes no less than was asked for. Long
 * waits take longer steps, so that none needs both threads to run for more than some microseconds. */
#include "mcu/avr_timer.h"
#include "mcu/mcu.h"
#include "mcu/mtime.h"
#include "mcu/systick.h"
#include "rigs/cmocka_ready.h"

#include <pthread.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { STEP_MIN = 16, STEPS = 256, ENOUGH = 6, WAITS_S = 2, PATIENCE_S = 60 };

/* Counts on, and shows it in all three. */
static struct {
    uint64_t counted, step; /* atomic */
    bool stops;             /* atomic */
    pthread_t thread;
    struct systick_registers systick;
    struct avr_timer_registers timer;
    volatile uint32_t mtime;
} counter;

static void *count(void *ctx)
{
    (void)ctx;
    while (!__atomic_load_n(&counter.stops, __ATOMIC_RELAXED)) {
        const uint64_t step = __atomic_load_n(&counter.step, __ATOMIC_SEQ_CST);
        const uint64_t counted = __atomic_add_fetch(&counter.counted, step, __ATOMIC_SEQ_CST);
        *(volatile uint32_t *)&counter.systick.cvr = (uint32_t)-counted & 0xFFFFFF;
        *(volatile uint16_t *)&counter.timer.tcnt = (uint16_t)counted;
        counter.mtime = (uint32_t)counted;
    }
    return NULL;
}

/* Begins short of the end of 32 bits, so that all of them begin anew. */
static int begin(void **state)
{
    (void)state;
    memset(&counter, 0, sizeof counter);
    counter.counted = UINT32_MAX - 100000u;
    counter.step = STEP_MIN;
    return pthread_create(&counter.thread, NULL, count, NULL);
}

static int end(void **state)
{
    (void)state;
    __atomic_store_n(&counter.stops, true, __ATOMIC_RELAXED);
    return pthread_join(counter.thread, NULL);
}

/* On one processor the counter stands still while it is looked at. */
static void needs_two_processors(void)
{
    if (sysconf(_SC_NPROCESSORS_ONLN) < 2) skip();
}

static uint64_t counted(void)
{
    return __atomic_load_n(&counter.counted, __ATOMIC_SEQ_CST);
}

/* Until the counters show what was counted, whatever a start of them has written there. */
static void settle(uint64_t step)
{
    const uint64_t before = counted();

    while (counted() < before + 4 * step)
        continue;
}

/* Some of the waits find the counter still, on a busy machine. It is a step behind what was counted, or none. */
static void assert_waits(const struct clock *clock, uint32_t delay_us, uint64_t counts)
{
    const uint64_t step = counts / STEPS > STEP_MIN ? counts / STEPS : STEP_MIN;
    unsigned successes = 0;
    const time_t began = time(NULL);

    __atomic_store_n(&counter.step, step, __ATOMIC_SEQ_CST);
    settle(step);
    while (successes < ENOUGH && time(NULL) < began + (successes ? WAITS_S : PATIENCE_S)) {
        const uint64_t before = counted();
        const int err = clock_delay(clock, delay_us);
        assert_true(err == 0 || err == MCU_ERR_TIMEOUT);
        if (err) continue;
        successes++;
        assert_true(counted() - before + 2 * step >= counts);
    }
    assert_true(successes > 0);
}

static void systick_waits_as_long_as_asked(void **state)
{
    struct systick systick;

    (void)state;
    needs_two_processors();
    assert_int_equal(systick_init(&systick, &counter.systick, 125000000), 0);
    const struct clock clock = systick_clock(&systick);
    assert_waits(&clock, 0, 1);
    assert_waits(&clock, 40, 5000);
    assert_waits(&clock, 100000, 12500000);
}

static void the_timer_of_avr_waits_as_long_as_asked(void **state)
{
    struct avr_timer timer;

    (void)state;
    needs_two_processors();
    assert_int_equal(avr_timer_init(&timer, &counter.timer, 16000000), 0);
    const struct clock clock = avr_timer_clock(&timer);
    assert_waits(&clock, 0, 1);
    assert_waits(&clock, 2500, 5000);
    assert_waits(&clock, 100000, 200000);
}

static void mtime_waits_as_long_as_asked(void **state)
{
    struct mtime mtime = {.low = &counter.mtime, .rate_hz = 32768};

    (void)state;
    needs_two_processors();
    const struct clock clock = mtime_clock(&mtime);
    assert_waits(&clock, 0, 1);
    assert_waits(&clock, 1000000, 32768);
    assert_waits(&clock, 200000000, 6553600);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(systick_waits_as_long_as_asked, begin, end),
        cmocka_unit_test_setup_teardown(the_timer_of_avr_waits_as_long_as_asked, begin, end),
        cmocka_unit_test_setup_teardown(mtime_waits_as_long_as_asked, begin, end),
    };
    return cmocka_run_group_tests_name("counters", tests, NULL, NULL);
}
