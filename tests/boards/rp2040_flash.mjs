// SPDX-License-Identifier: MIT
//
// What an RP2040's second stage does to flash chips, and what the cache before them makes a program wait, on the
// emulator of sim/emulators: node rp2040_flash.mjs MODULES BOOT2.bin [FROM]. MODULES: the folder of npm.sh; BOOT2: the
// code without its checksum. Prints TAP without a plan, numbered behind FROM. Figures that are expected were worked out
// by hand.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';

import { makeChip } from '../../sim/emulators/rp2040_chip.mjs';
import { CHIPS } from '../../sim/emulators/serial_flash.mjs';

const [modules, boot2, from] = process.argv.slice(2);
const emulator = createRequire(`${modules}/package.json`)('rp2040js');
const FLASH = 0x10000000, RAM = 0x20000000, BOOT2_AT = 0x20041f00, STACK = 0x20040000, IMAGE = 0x100;
const STEPS_MAX = 3e6;

// -- A chip, its flash, and programs of a few halfwords ------------------------------------------------------------------

function chipWith(flash, policy = 'fifo', more = {}) {
    const chip = makeChip(emulator, { flash, policy, ...more }, () => {}, () => true);
    const code = fs.readFileSync(boot2);
    chip.flash.set(code, 0);
    chip.sram.set(code, BOOT2_AT - RAM);
    chip.flashView.setUint32(IMAGE, STACK, true);
    chip.flashView.setUint32(IMAGE + 4, FLASH + 0x201, true); // bit 0: Thumb
    return chip;
}

function step(chip) {
    const before = chip.core.cycles;
    chip.core.executeInstruction();
    chip.clock.tick(((chip.core.cycles - before) * 1e9) / chip.clkSys);
}

function runTo(chip, address) {
    for (let steps = 0; chip.core.PC !== address; steps++) {
        assert.ok(steps < STEPS_MAX, `${address.toString(16)} is not reached from ${chip.core.PC.toString(16)}`);
        step(chip);
    }
}

// As the boot ROM enters the second stage; up to the image's first instruction.
function boot(chip) {
    chip.ssi.asRomLeavesIt();
    Object.assign(chip.core, { SP: BOOT2_AT, LR: 0, PC: BOOT2_AT });
    runTo(chip, FLASH + 0x200);
}

const NOP = 0x46c0;

function put(chip, offset, halfwords) {
    halfwords.forEach((halfword, i) => chip.flashView.setUint16(offset + 2 * i, halfword, true));
}

// BL, which goes as far as flash does, from one offset to another; LR is lost.
function bl(from, to) {
    const by = (to - from - 4) >> 1;
    return [0xf000 | ((by >> 11) & 0x3ff) | (by < 0 ? 0x400 : 0), 0xf800 | (by & 0x7ff)];
}

// NOPs, and a jump back to the first: `bytes` in all.
function putLoop(chip, offset, bytes) {
    for (let at = offset; at < offset + bytes - 4; at += 2) put(chip, at, [NOP]);
    put(chip, offset + bytes - 4, bl(offset + bytes - 4, offset));
}

// Misses of one time round, and cycles.
function round(chip, offset) {
    const { xip, core } = chip, before = { misses: xip.misses, cycles: core.cycles, waits: xip.waits };
    step(chip);
    runTo(chip, FLASH + offset);
    return { misses: xip.misses - before.misses, cycles: core.cycles - before.cycles, waits: xip.waits - before.waits };
}

function enter(chip, offset) {
    boot(chip);
    Object.assign(chip.core, { PC: FLASH + offset });
}

let count = Number(from ?? 0);
function test(name, run) {
    try {
        run();
        console.log(`ok ${++count} - ${name}`);
    } catch (error) {
        console.log(`not ok ${++count} - ${name}\n${error.stack.replace(/^/gm, '# ')}`);
    }
}

// -- The second stage ---------------------------------------------------------------------------------------------------

// Cycles of a word: 20 clocks (6 of address, 2 of mode bits, 4 of nothing, 8 of data) of 2; or 64 (8, 24, 32) of 4.
const QUAD = 40, PLAIN = 256;
const EXPECTED = {
    w25q080: { cycles: QUAD, writes: 1 }, w25q16jv: { cycles: QUAD, writes: 0 }, 'w25q16jv-im': { cycles: QUAD, writes: 1 },
    w25q64jv: { cycles: QUAD, writes: 1 }, w25q128jv: { cycles: QUAD, writes: 1 },
    'one-byte-01h': { cycles: PLAIN, writes: 0 }, w25x10cl: { cycles: PLAIN, writes: 0 },
    unknown: { cycles: PLAIN, writes: 0 }, silent: { cycles: PLAIN, writes: 0 },
    'qe-stays-0': { cycles: PLAIN, writes: 2 }, 'two-lines': { cycles: PLAIN, writes: 0 },
};

// Pads: SCLK with 8 mA and a fast slew rate; SD0 to SD3 read, with 4 mA, pulled up, and without a Schmitt trigger.
const PADS_QSPI = 0x40020004, PADS = [0x21, 0x58, 0x58, 0x58, 0x58];

function assertReads(chip, { cycles }) {
    assert.deepEqual(PADS.map((_, i) => chip.readUint32(PADS_QSPI + 4 * i)), PADS);
    assert.deepEqual(chip.complaints, []);
    assert.equal(chip.ssi.cyclesOfWord, cycles);
    assert.equal(chip.serialFlash.isContinuous, cycles === QUAD);
    for (const offset of [0, 0x104, 0x8000, 0xfffffc]) { // what is read is what is there
        assert.equal(chip.ssi.word(offset), chip.flashView.getUint32(offset, true));
    }
    assert.deepEqual(chip.complaints, []);
}

for (const name of Object.keys(CHIPS)) {
    test(`${name} is read in ${EXPECTED[name].cycles} cycles a word, and the image is entered`, () => {
        const chip = chipWith(name);
        for (let at = 0x8000; at < 0x8100; at++) chip.flash[at] = (at * 167) & 255;
        boot(chip);
        assertReads(chip, EXPECTED[name]);
        assert.equal(chip.serialFlash.statusWrites, EXPECTED[name].writes);
        assert.equal(chip.core.SP, STACK);
        assert.equal(chip.core.VTOR, FLASH + IMAGE);
    });
}

test('QE is set for ever: the next start writes nothing', () => {
    const chip = chipWith('w25q080');
    boot(chip);
    chip.serialFlash.isContinuous = false; // the boot ROM ends it
    boot(chip);
    assertReads(chip, { cycles: QUAD });
    assert.equal(chip.serialFlash.statusWrites, 1);
});

test('what protects blocks of flash stays as it was', () => {
    for (const name of ['w25q080', 'w25q128jv']) {
        const chip = chipWith(name);
        chip.serialFlash.sr1 = 0x9c;
        chip.serialFlash.sr2 = 0x40;
        boot(chip);
        assert.equal(chip.serialFlash.sr1, 0x9c);
        assert.equal(chip.serialFlash.sr2, 0x42);
    }
});

test('a chip that is busy for ever does not stop the start', () => {
    const chip = chipWith('unknown');
    Object.defineProperty(chip.serialFlash, 'isBusy', { get: () => chip.serialFlash.statusWrites > 0 });
    Object.assign(chip.serialFlash, { kind: { ...CHIPS['qe-stays-0'] } });
    chip.ssi.asRomLeavesIt();
    Object.assign(chip.core, { SP: BOOT2_AT, LR: 0, PC: BOOT2_AT });
    const enough = 125e6; // cycles, of which the bound leaves a good part
    while (chip.core.PC >>> 24 !== 0x10 && chip.core.cycles < enough) {
        try {
            step(chip);
        } catch {
            break; // what cannot be read is not entered
        }
    }
    assert.ok(chip.core.cycles < enough);
});

// From wherever its caller has left the flash, at any state of the SSI; the caller's registers stay.
function callAgain(chip) {
    const saved = [4, 5, 6, 7, 8, 9, 10, 11], { core } = chip, back = RAM + 0x1000;
    for (const number of saved) core.registers[number] = 0x1000 * number + 7;
    Object.assign(core, { SP: STACK, LR: back + 1, PC: BOOT2_AT, VTOR: 0x20000000 });
    runTo(chip, back);
    for (const number of saved) assert.equal(core.registers[number], 0x1000 * number + 7);
    assert.equal(core.SP, STACK);
    assert.equal(core.VTOR, 0x20000000);
}

for (const name of ['w25q16jv', 'w25q080', 'unknown', 'two-lines']) {
    test(`called as a function, ${name} is read as before, from continuous reading and from commands`, () => {
        const chip = chipWith(name);
        boot(chip);
        callAgain(chip);
        assertReads(chip, EXPECTED[name]);
        chip.serialFlash.isContinuous = false;
        chip.ssi.registers.set(8, 0); // as the ROM's flash_exit_xip() does: disabled, bytes at a sixth
        chip.ssi.registers.set(0, 7 << 16).set(0x14, 6).set(8, 1);
        callAgain(chip);
        assertReads(chip, EXPECTED[name]);
    });
}

test('another image in flash: what is compared is not there, and reading is slow, but right', () => {
    const chip = chipWith('w25q16jv');
    chip.flash.fill(0xff, 0, 256);
    boot(chip);
    assertReads(chip, { cycles: PLAIN });
});

// -- What the emulated flash interface does not let pass -----------------------------------------------------------------

const REGISTERS = { CTRLR0: 0, SSIENR: 8, BAUDR: 0x14, DR0: 0x60, SAMPLE: 0xf0, SPI_CTRLR0: 0xf4 };

// Bytes in one transfer, or settings: [register, value]; then enough time.
function drive(chip, ...moves) {
    for (const move of moves) {
        if (Array.isArray(move)) chip.ssi.writeUint32(REGISTERS[move[0]], move[1]);
        else chip.ssi.writeUint32(REGISTERS.DR0, move);
    }
}

function settle(chip) {
    chip.clock.tick(1e6);
    while (chip.ssi.rx.length) chip.ssi.readUint32(REGISTERS.DR0);
}

const BYTES = [['SSIENR', 0], ['CTRLR0', 7 << 16], ['BAUDR', 4], ['SSIENR', 1]];
const QUAD_READ = [['SSIENR', 0], ['CTRLR0', 0x5f0300], ['SPI_CTRLR0', 0x2221], ['BAUDR', 2], ['SAMPLE', 1], ['SSIENR', 1]];

const WRONG = [
    ['settings while it is enabled', 'w25q16jv', [['SSIENR', 1], ['BAUDR', 2]], /BAUDR is set while/],
    ['an odd divider', 'w25q16jv', [['SSIENR', 0], ['BAUDR', 3]], /BAUDR is 3/],
    ['a transfer that is cut off', 'w25q16jv', [...BYTES, 0x9f, ['SSIENR', 0]], /in the middle of a transfer/],
    ['bytes while it is off', 'w25q16jv', [['SSIENR', 0], 0x9f], /while the SSI is off/],
    ['too many bytes', 'w25q16jv', [...BYTES, ...Array(18).fill(0x9f)], /sixteen frames/],
    ['a status register without 06h', 'w25q080', [...BYTES, 1, 0, 2], /without 06h/],
    ['06h with a byte behind it', 'w25q080', [...BYTES, 6, 6], /later than with the last bit/],
    ['EBh while QE is 0', 'w25q080', [...QUAD_READ, 0xeb, 0xa0], /while QE is 0/],
    ['EBh faster than the chip', 'w25q16jv', [...QUAD_READ.slice(0, -1), ['BAUDR', 2], ['SSIENR', 1], 0xeb, 0xa0], /EBh at/, 300e6],
    ['03h faster than the chip', 'unknown', [['SSIENR', 0], ['CTRLR0', 0x1f0300], ['SPI_CTRLR0', 0x03000218], ['BAUDR', 2],
        ['SAMPLE', 1], ['SSIENR', 1], 3, 0], /03h at 62.5 MHz/],
    ['no sample delay at 62.5 MHz', 'w25q16jv', [...QUAD_READ.filter(([name]) => name !== 'SAMPLE'), 0xeb, 0xa0], /without delay/],
];
for (const [name, flash, moves, pattern, clkSys] of WRONG) {
    test(`${name} is complained about`, () => {
        const chip = chipWith(flash);
        chip.ssi.asRomLeavesIt();
        if (clkSys) chip.clkSys = clkSys;
        drive(chip, ...moves);
        settle(chip);
        assert.match(chip.complaints.join('\n'), pattern);
    });
}

test('a command while the status is written is complained about, and 05h tells it', () => {
    const chip = chipWith('w25q080');
    chip.ssi.asRomLeavesIt();
    drive(chip, ...BYTES, 6);
    chip.clock.tick(1000);
    drive(chip, 1);
    drive(chip, 0x1c);
    drive(chip, 2);
    chip.clock.tick(1000);
    while (chip.ssi.rx.length) chip.ssi.readUint32(REGISTERS.DR0);
    drive(chip, 5, 5);
    chip.clock.tick(1000);
    assert.equal(chip.ssi.rx[1] & 1, 1);
    drive(chip, 0x9f);
    chip.clock.tick(1000);
    assert.match(chip.complaints.join('\n'), /9FH while|9Fh while/);
});

test('flash that is read wrongly ends the program', () => {
    const chip = chipWith('w25q16jv');
    put(chip, 0x200, [NOP]);
    boot(chip);
    chip.serialFlash.isContinuous = false; // it takes the address for a command
    chip.xip.cache.flush();
    assert.throws(() => step(chip), /is read as/);
});

// -- The cache: 2 ways of 1024 lines of 8 bytes, of which each word is fetched by itself ------------------------------------

const CACHE_B = 16384, WAY_B = 8192;

for (const policy of ['lru', 'fifo']) {
    test(`a loop as large as the cache misses in its first round alone (${policy})`, () => {
        const chip = chipWith('w25q16jv', policy);
        putLoop(chip, 0x4000, CACHE_B);
        enter(chip, 0x4000);
        const first = round(chip, 0x4000), second = round(chip, 0x4000), third = round(chip, 0x4000);
        assert.deepEqual([first.misses, second.misses, third.misses], [CACHE_B / 4, 0, 0]);
        assert.equal(first.waits, (CACHE_B / 4) * QUAD);
        assert.equal(first.cycles - second.cycles, (CACHE_B / 4) * QUAD);
        assert.equal(second.cycles, third.cycles);
    });

    test(`with ten lines more, the three that share a place each miss both words in each round (${policy})`, () => {
        const chip = chipWith('w25q16jv', policy);
        putLoop(chip, 0x4000, CACHE_B + 80);
        enter(chip, 0x4000);
        round(chip, 0x4000);
        for (let i = 0; i < 3; i++) assert.equal(round(chip, 0x4000).misses, 10 * 3 * 2);
    });

    test(`two words a way apart stay, three miss each time (${policy})`, () => {
        for (const [ways, misses] of [[1, 0], [2, 0], [3, 3], [4, 4]]) {
            const chip = chipWith('w25q16jv', policy);
            for (let way = 0; way < ways; way++) {
                const at = 0x4008 + way * WAY_B;
                put(chip, at, bl(at, 0x4008 + ((way + 1) % ways) * WAY_B));
            }
            enter(chip, 0x4008);
            for (let i = 0; i < 3; i++) for (let way = 0; way < ways; way++) step(chip);
            const { misses: before } = chip.xip;
            for (let way = 0; way < ways; way++) step(chip);
            assert.equal(chip.xip.misses - before, misses);
        }
    });
}

test('by chance, three words a way apart miss sometimes', () => {
    const chip = chipWith('w25q16jv', 'random');
    for (let way = 0; way < 3; way++) put(chip, 0x4008 + way * WAY_B, bl(0x4008 + way * WAY_B, 0x4008 + ((way + 1) % 3) * WAY_B));
    enter(chip, 0x4008);
    const { misses: before } = chip.xip;
    for (let i = 0; i < 3000; i++) step(chip);
    assert.ok(chip.xip.misses - before > 1000 && chip.xip.misses - before < 2500, `${chip.xip.misses - before}`);
});

test('straight code misses once a word, at 64 clocks of four cycles where it is read by 03h', () => {
    const chip = chipWith('unknown');
    putLoop(chip, 0x4000, 0x1000);
    enter(chip, 0x4000);
    const { misses, waits } = round(chip, 0x4000);
    assert.equal(misses, 0x1000 / 4);
    assert.equal(waits, (0x1000 / 4) * PLAIN);
});

test('the other word of a line is a miss of its own', () => {
    const chip = chipWith('w25q16jv');
    put(chip, 0x4000, bl(0x4000, 0x5000)); // the line's first word
    put(chip, 0x4004, bl(0x4004, 0x4000)); // its second
    put(chip, 0x5000, bl(0x5000, 0x4004));
    enter(chip, 0x4000);
    assert.equal(round(chip, 0x4000).misses, 3);
    assert.equal(round(chip, 0x4000).misses, 0);
});

test('cycles of the bus come on top of each miss', () => {
    const chip = chipWith('w25q16jv', 'fifo', { busCycles: 10 });
    putLoop(chip, 0x4000, 0x1000);
    enter(chip, 0x4000);
    assert.equal(round(chip, 0x4000).waits, (0x1000 / 4) * (QUAD + 10));
});

test('a word fetched ahead is one more behind each jump', () => {
    for (const [ahead, misses] of [[false, 2], [true, 4]]) {
        const chip = chipWith('w25q16jv', 'fifo', { ahead });
        put(chip, 0x4000, bl(0x4000, 0x5000));
        put(chip, 0x5000, bl(0x5000, 0x4000));
        enter(chip, 0x4000);
        const { misses: before } = chip.xip;
        for (let i = 0; i < 8; i++) step(chip);
        assert.equal(chip.xip.misses - before, misses);
    }
});

// -- Data: r0 has the address, r1 the step: LDR r2, [r0]; ADDS r0, r1; B back ------------------------------------------------

const LDR = 0x6802, LDRB = 0x7802, ADDS = 0x1840, BACK = 0xe7fc;

function readData(load, address, stride, times) {
    const chip = chipWith('w25q16jv'), { registers } = chip.core, { xip } = chip;
    for (let at = 0x10000; at < 0x20000; at++) chip.flash[at] = (at * 89) & 255;
    put(chip, 0x4000, [load, ADDS, BACK]);
    enter(chip, 0x4000);
    registers.set([RAM, 0]);
    for (let i = 0; i < 3; i++) step(chip); // the code is there
    const { misses, codeMisses } = xip;
    registers.set([address, stride]);
    for (let i = 0; i < 3 * times; i++) step(chip);
    assert.equal(registers[2] & 255, chip.flash[(address + stride * (times - 1)) & 0xffffff]);
    const code = xip.codeMisses - codeMisses;
    return { data: xip.misses - misses - code, code };
}

test('data miss once a word, however small its parts that are read', () => {
    assert.deepEqual(readData(LDR, 0x10010000, 4, 64), { data: 64, code: 0 });
    assert.deepEqual(readData(LDRB, 0x10010000, 1, 64), { data: 16, code: 0 });
});

test('the same word is a hit behind the cache, and a transfer each time past it', () => {
    assert.deepEqual(readData(LDR, 0x10010000, 0, 50), { data: 1, code: 0 });
    assert.deepEqual(readData(LDR, 0x13010000, 0, 50), { data: 50, code: 0 });
    assert.deepEqual(readData(LDR, 0x12010000, 0, 50), { data: 50, code: 0 });
    assert.deepEqual(readData(LDR, 0x11010000, 0, 50), { data: 50, code: 0 });
});

test('what is read past the cache, or without allocating, evicts nothing; what is read through it evicts the code', () => {
    assert.equal(readData(LDR, 0x13010000, 4, 4096).code, 0);
    assert.equal(readData(LDR, 0x11010000, 4, 4096).code, 0);
    assert.ok(readData(LDR, 0x10010000, 4, 8192).code > 0);
    assert.ok(readData(LDR, 0x12010000, 4, 8192).code > 0);
});
