// SPDX-License-Identifier: MIT
//
// Runs an RP2040's image in rp2040js, and prints what goes over a display's wires as a wire log (sim/glass/wire_log.h) and,
// as comments, what each frame took, and all but the first in the mean:
//   node rp2040.mjs MODULES IMAGE.uf2 SYMBOLS FRAMES --spi 0 --pin dc=16 --pin led=25 ...
// MODULES: the folder of npm.sh; SYMBOLS: what nm says of the image. A frame has been shown when the LED changes after
// frame_end() and nothing is left to be sent; without a pin of that name, when nothing is left. Ends after FRAMES of
// them, or with a failure when the next one does not come, or something is done to flash that is wrong.
//   --stop-after BYTES --for RESETS   the SPI stops then, and works again after so many resets of it
//   --flash CHIP    what the image is read from (serial_flash.mjs); w25q16jv is a Pico's
//   --cache POLICY  which of two ways a miss replaces (rp2040_xip.mjs): lru, fifo, random
//   --bus-cycles N  what a miss takes beside the clocks of its transfer
//   --press GPIO=FROM-TO   a button to ground is down from when FROM frames were shown until TO were; up otherwise
//   --ahead         the next word is fetched with each instruction
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { parseArgs } from 'node:util';

import { makeChip } from './rp2040_chip.mjs';
import { Cycles } from './rp2040_cycles.mjs';
import { enterBoot2, loadUf2 } from './rp2040_flash.mjs';

const INSTRUCTIONS_MAX = 3e8; // for a frame
const BYTES_A_LINE = 64;
const PAUSE_NS = 5000; // between bytes: time that a chip may be waiting for
const LED_AFTER_CYCLES = 50000; // between the end of a frame and the LED that tells it: that may come from flash

class Log {
    constructor(chip) {
        this.chip = chip;
        this.bytes = [];
        this.last = 0; // nanoseconds, of the last byte
    }

    byte(value) {
        const { nanos } = this.chip.clock;
        if (nanos - this.last > PAUSE_NS) this.time();
        this.last = nanos;
        this.bytes.push(value.toString(16).padStart(2, '0'));
        if (this.bytes.length === BYTES_A_LINE) this.flush();
    }

    flush() {
        if (this.bytes.length) this.line(`b ${this.bytes.join(' ')}\n`);
        this.bytes = [];
    }

    time() {
        this.flush();
        this.line(`t ${Math.round(this.chip.clock.nanos)}\n`);
    }

    pin(name, isHigh) {
        this.time();
        this.line(`p ${name} ${isHigh ? 1 : 0}\n`);
    }

    line(text) {
        fs.writeSync(1, text);
    }
}

function readArguments() {
    const options = {
        spi: { type: 'string', default: '0' }, pin: { type: 'string', multiple: true, default: [] },
        'stop-after': { type: 'string', default: 'Infinity' }, for: { type: 'string', default: '1' },
        flash: { type: 'string', default: 'w25q16jv' }, cache: { type: 'string', default: 'fifo' },
        press: { type: 'string', multiple: true, default: [] },
        'bus-cycles': { type: 'string', default: '0' }, ahead: { type: 'boolean', default: false },
    };
    const { values, positionals } = parseArgs({ options, allowPositionals: true });
    const [modules, image, symbols, frames] = positionals;
    if (!(frames > 0)) throw new Error('usage: rp2040.mjs MODULES IMAGE.uf2 SYMBOLS FRAMES --pin NAME=GPIO...');
    return {
        emulator: createRequire(`${modules}/package.json`)('rp2040js'),
        image: fs.readFileSync(image), symbols: fs.readFileSync(symbols, 'utf8'), frames: Number(frames),
        spi: Number(values.spi), pins: values.pin.map((pin) => pin.split('=')),
        stopAfter: Number(values['stop-after']), resets: Number(values.for), flash: values.flash, policy: values.cache,
        presses: values.press.map((press) => press.split(/[=-]/).map(Number)),
        busCycles: Number(values['bus-cycles']), ahead: values.ahead,
    };
}

class Run {
    constructor(options) {
        this.options = options;
        this.bytes = this.frames = this.instructions = 0;
        this.chip = makeChip(options.emulator, options, (byte) => this.byteLeft(byte), () => this.spiWorks());
        this.spi = this.chip.spi[options.spi];
        this.log = new Log(this.chip);
        loadUf2(this.chip.flash, options.image);
        enterBoot2(this.chip);
        this.cycles = new Cycles(this.chip, options.symbols);
        for (const [name, number] of options.pins) this.watch(name, this.chip.gpio[Number(number)]);
        this.press();
        this.hasLed = options.pins.some(([name]) => name === 'led');
    }

    press() {
        const down = new Map();
        for (const [gpio, from, to] of this.options.presses) {
            down.set(gpio, down.get(gpio) || (this.frames >= from && this.frames < to));
        }
        for (const [gpio, is] of down) this.chip.gpio[gpio].setInputValue(!is);
    }

    // What is no output is neither high nor low.
    watch(name, pin) {
        const { High, Low } = this.options.emulator.GPIOPinState;
        pin.addListener((level) => {
            if (level !== High && level !== Low) return;
            this.log.pin(name, level === High);
            if (name === 'led') this.ledChanged();
        });
    }

    ledChanged() {
        const { cycles, chip } = this;
        if (this.spi.busy || cycles.ended < 0 || chip.core.cycles - cycles.ended > LED_AFTER_CYCLES) return;
        this.log.line(cycles.report(this.frames, (8 * chip.clkSys) / this.spi.clockFrequency));
        cycles.ended = -1;
        this.frames++;
        this.press();
        this.instructions = 0;
    }

    byteLeft(byte) {
        this.bytes++;
        this.cycles.byteLeft();
        this.log.byte(byte);
    }

    spiWorks() {
        const { stopAfter, resets } = this.options;
        if (this.stoppedAt === undefined && this.bytes >= stopAfter) {
            this.stoppedAt = this.spi.resets;
            this.log.flush();
            this.log.line(`# the SPI stops after ${this.bytes} bytes\n`);
        }
        return this.stoppedAt === undefined || this.spi.resets - this.stoppedAt >= resets;
    }

    step() {
        const { chip } = this, { core } = chip;
        const before = core.cycles;
        this.cycles.at(core.PC);
        core.executeInstruction();
        chip.clock.tick(((core.cycles - before) * 1e9) / chip.clkSys);
        if (!this.hasLed) this.ledChanged();
        if (++this.instructions > INSTRUCTIONS_MAX) throw new Error(`frame ${this.frames} does not come`);
        if (chip.complaints.length) throw new Error(`flash: ${chip.complaints[0]}`);
        if (core.waiting) throw new Error('sleeps for ever: nothing interrupts');
    }
}

try {
    const options = readArguments();
    const run = new Run(options);
    while (run.frames < options.frames) run.step();
    run.log.line(run.cycles.mean(run.chip.clkSys));
} catch (error) {
    console.error(`rp2040: ${error.message}`);
    process.exitCode = 1;
}
