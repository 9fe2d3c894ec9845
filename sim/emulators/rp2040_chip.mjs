// SPDX-License-Identifier: MIT
//
// rp2040js's RP2040, and what a display's driver could do wrong there unseen: a byte takes its time to leave the SPI,
// peripherals are held in reset until they are released, lose their state when they are reset, and do not work without
// a clock. Flash is read as the second stage has set it up, and a cache stands before it. RP2040 Datasheet, 2.14
// (resets), 4.4 (SPI).
import { Ssi } from './rp2040_ssi.mjs';
import { Xip } from './rp2040_xip.mjs';
import { SerialFlash } from './serial_flash.mjs';

const RESETS = 0x4000c000;
const RESET_DONE = 8;
const ALL = 0x01ffffff;
const SYSTICK_CVR = 0x18;
const SSI = 0x18000;

// Bits of RESETS: what a display's driver touches. Others are not held.
const HELD = [
    [2, 0x50000000, 'DMA'],
    [5, 0x40014000, 'IO_BANK0'],
    [8, 0x4001c000, 'PADS_BANK0'],
    [12, 0x40028000, 'PLL_SYS'],
    [16, 0x4003c000, 'SPI0'],
    [17, 0x40040000, 'SPI1'],
];

// Who looks at SysTick waits: so many nanoseconds pass with each look, that long waits take few of them.
const LOOK_NS = 5000;

function resetSpi(spi) {
    spi.alarm.cancel();
    spi.busy = false;
    spi.txFIFO.reset();
    spi.rxFIFO.reset();
    spi.control0 = spi.control1 = spi.clockDivisor = spi.dmaControl = 0;
    spi.fifosUpdated();
    spi.resets++;
}

function resetDma(dma) {
    for (const channel of dma.channels) {
        channel.abort();
        channel.reset();
    }
}

function holdInReset(chip) {
    const resets = chip.findPeripheral(RESETS);
    const find = chip.findPeripheral.bind(chip);
    const held = new Map(HELD.map(([bit, address, name]) => [find(address), { bit: 1 << bit, name }]));
    const reset = new Map([[chip.dma, resetDma], [chip.spi[0], resetSpi], [chip.spi[1], resetSpi]]);
    const read = resets.readUint32.bind(resets), write = resets.writeUint32.bind(resets);

    resets.reset = ALL;
    resets.readUint32 = (offset) => (offset === RESET_DONE ? ~resets.reset & ALL : read(offset));
    resets.writeUint32 = (offset, value) => {
        const before = resets.reset;
        write(offset, value);
        for (const [peripheral, { bit }] of held) {
            if (~before & resets.reset & bit && reset.has(peripheral)) reset.get(peripheral)(peripheral);
        }
    };
    chip.findPeripheral = (address) => {
        const peripheral = find(address), is = held.get(peripheral);
        if (is && resets.reset & is.bit) throw new Error(`${is.name} is used while it is held in reset`);
        return peripheral;
    };
}

// `leaves(byte)` when a byte's last bit does. `works()`: whether the SPI still sends.
function takeTime(chip, spi, leaves, works) {
    let value;

    spi.resets = 0;
    spi.alarm = chip.clock.createAlarm(() => {
        leaves(value);
        spi.completeTransmit(0);
    });
    spi.onTransmit = (byte) => {
        value = byte;
        if (!works() || !spi.enabled || !chip.clocks.periFreq) return;
        spi.alarm.schedule((spi.dataBits * 1e9) / spi.clockFrequency);
    };
}

function hurryWaits(chip) {
    const read = chip.ppb.readUint32.bind(chip.ppb);

    chip.ppb.readUint32 = (offset) => {
        if (offset === SYSTICK_CVR) chip.clock.tick(LOOK_NS);
        return read(offset);
    };
}

// chip.serialFlash, chip.ssi, chip.xip; chip.complaints of what is done with them that is wrong.
function putFlash(chip, name, cache) {
    const complain = (text) => chip.complaints.push(text);

    chip.complaints = [];
    chip.serialFlash = new SerialFlash(chip.flash, name, () => chip.clock.nanos, complain);
    chip.ssi = new Ssi(chip.serialFlash, () => chip.clkSys, (call) => chip.clock.createAlarm(call), complain);
    chip.peripherals[SSI] = chip.ssi;
    chip.xip = new Xip(chip, chip.ssi, cache);
}

export function makeChip({ RP2040, ConsoleLogger, LogLevel }, { spi: spiNumber = 0, flash, ...cache }, leaves, works) {
    const chip = new RP2040();

    chip.logger = new ConsoleLogger(LogLevel.Error);
    chip.onBreak = (code) => {
        throw new Error(`breakpoint ${code}`);
    };
    takeTime(chip, chip.spi[spiNumber], leaves, works);
    takeTime(chip, chip.spi[1 - spiNumber], () => {}, () => true);
    putFlash(chip, flash, cache);
    holdInReset(chip);
    hurryWaits(chip);
    return chip;
}
