// SPDX-License-Identifier: MIT
//
// Serial NOR flash, clock by clock, as on an RP2040's pins: what a second stage of the start does with it, and what it
// gets back. Wrong sequences are complained about; what a chip does not know it ignores, as chips do.
// Winbond's W25Q80DV, W25Q16JV and W25Q64JV data sheets: 7.1 (status registers), 8.2 (instructions): identification
// (9Fh), write enable (06h), status registers read (05h, 35h) and written (01h, 31h), read (03h), fast read quad I/O
// with continuous read mode (EBh: M5-4 = 10). Clock limits and identifications: adafruit/nvm.toml, flash/winbond.
const QE = 2; // of status register 2
const BUSY = 1, WEL = 2; // of status register 1
const WRITE_NS = 10e6; // W25Q16JV, 9.6: status register, 10 ms

const WINBOND = { id: [0xef, 0x40, 0x15], sr2: 0, quad: true, pair: true, single: true, readHz: 50e6, quadHz: 133e6 };

// sr2: status register 2 when the chip leaves the factory. pair: 01h takes two bytes, for both registers. single: 31h.
// stays: QE cannot be set. lines: how many reach the chip. A W25X has no more than two.
export const CHIPS = {
    w25q080: { ...WINBOND, id: [0xef, 0x40, 0x14], single: false, quadHz: 104e6 },
    w25q16jv: { ...WINBOND, sr2: QE }, // -IQ, of the Raspberry Pi Pico: QE is set and cannot be cleared
    'w25q16jv-im': { ...WINBOND, id: [0xef, 0x70, 0x15] },
    w25q64jv: { ...WINBOND, id: [0xef, 0x40, 0x17] },
    w25q128jv: { ...WINBOND, id: [0xef, 0x40, 0x18] },
    'one-byte-01h': { ...WINBOND, pair: false }, // 31h alone sets QE
    w25x10cl: { ...WINBOND, id: [0xef, 0x30, 0x11], quad: false, pair: false, single: false, quadHz: 0 },
    unknown: { ...WINBOND, id: [0x68, 0x40, 0x15], quad: false, pair: false, single: false, readHz: 33e6, quadHz: 0 },
    silent: { ...WINBOND, id: [0xff, 0xff, 0xff], quad: false, pair: false, single: false, readHz: 33e6, quadHz: 0 },
    'qe-stays-0': { ...WINBOND, stays: true },
    'two-lines': { ...WINBOND, sr2: QE, lines: 2 }, // a board that does not connect IO2 and IO3
};

export class SerialFlash {
    // `now()` in nanoseconds; `complain(text)` of what software does wrong.
    constructor(memory, name, now, complain) {
        if (!CHIPS[name]) throw new Error(`no flash chip ${name}; there are: ${Object.keys(CHIPS).join(', ')}`);
        this.memory = memory;
        this.kind = CHIPS[name];
        this.now = now;
        this.complain = complain;
        this.sr1 = 0;
        this.sr2 = this.kind.sr2;
        this.busyUntil = -1;
        this.isContinuous = false;
        this.ignored = [];
        this.statusWrites = 0;
        this.isSelected = false;
    }

    get isBusy() {
        return this.now() < this.busyUntil;
    }

    select(hz) {
        Object.assign(this, { isSelected: true, hz, bits: 0, value: 0, clocks: 0, command: null, taken: [] });
        if (this.isContinuous) this.begin(0xeb);
    }

    // One clock. `lines`: levels of IO0..IO3 that are driven, others are null. Returns what the chip drives.
    clock(lines) {
        const seen = lines.map((level, line) => (level === null || line >= (this.kind.lines ?? 4) ? 1 : level));
        this.clocks++;
        if (this.phase) return this.phase(seen);
        return this.commandBit(seen[0]);
    }

    deselect() {
        this.isSelected = false;
        this.phase = null;
        if (this.command === null) return;
        const wholeBytes = this.bits === 0;
        switch (this.command) {
        case 0x06: case 0x04: return this.setWel(this.command === 0x06, this.taken.length === 0 && wholeBytes);
        case 0x01: case 0x31: return this.writeStatus(wholeBytes);
        default:
        }
    }

    commandBit(bit) {
        this.value = (this.value << 1) | bit;
        if (++this.bits === 8) this.begin(this.value);
        return [null, null, null, null];
    }

    begin(command) {
        Object.assign(this, { command, bits: 0, value: 0, clocks: 0 });
        this.phase = this.phaseOf(command);
    }

    phaseOf(command) {
        const { kind } = this;
        if (this.isBusy && command !== 0x05 && command !== 0x35) {
            this.complain(`command ${hex(command)} while it writes its status`);
            return this.ignore;
        }
        switch (command) {
        case 0x9f: return this.answer(kind.id);
        case 0x05: return this.status(() => (this.sr1 & ~BUSY) | (this.isBusy ? BUSY : 0));
        case 0x35: if (kind.quad) return this.status(() => this.sr2); break;
        case 0x06: case 0x04: return this.take;
        case 0x01: return this.take;
        case 0x31: if (kind.single) return this.take; break;
        case 0x03: return this.read;
        case 0xeb: if (kind.quad) return this.readQuad; break;
        case 0xff: return this.ignore;
        default:
        }
        this.ignored.push(command);
        return this.ignore;
    }

    ignore() {
        return [null, null, null, null];
    }

    // Bytes on IO1, again and again.
    answer(bytes) {
        return () => this.drive(bytes[((this.clocks - 1) >> 3) % bytes.length], (this.clocks - 1) & 7);
    }

    status(get) {
        return () => this.drive(get(), (this.clocks - 1) & 7);
    }

    drive(byte, bit) {
        return [null, (byte >> (7 - bit)) & 1, null, null];
    }

    take(seen) {
        this.value = (this.value << 1) | seen[0];
        if (++this.bits === 8) {
            this.taken.push(this.value);
            Object.assign(this, { bits: 0, value: 0 });
        }
        return [null, null, null, null];
    }

    setWel(isOn, endsInTime) {
        if (!endsInTime) return this.complain('select goes up later than with the last bit of 06h: it is not enabled');
        this.sr1 = isOn ? this.sr1 | WEL : this.sr1 & ~WEL;
    }

    writeStatus(wholeBytes) {
        const { command, kind, taken } = this;
        if (!(this.sr1 & WEL)) return this.complain(`${hex(command)} without 06h before: it is not written`);
        if (!wholeBytes || taken.length < 1 || taken.length > (command === 0x01 && kind.pair ? 2 : 1)) {
            return this.tooLong();
        }
        const sr1 = command === 0x01 ? taken[0] : this.sr1;
        const cleared = kind.pair && !kind.single ? 0 : this.sr2; // by one byte: older ones do that
        const sr2 = command === 0x31 ? taken[0] : taken[1] ?? cleared;
        this.statusWrites++;
        this.sr1 = sr1 & ~(BUSY | WEL);
        this.sr2 = kind.stays ? this.sr2 : sr2;
        this.busyUntil = this.now() + WRITE_NS;
    }

    // 01h with two bytes, of a chip that takes one: it is not executed, and the enable stays.
    tooLong() {
        if (this.command !== 0x01 || this.kind.pair || this.taken.length !== 2) {
            this.complain(`${hex(this.command)} with ${this.taken.length} bytes and ${this.bits} bits`);
        }
    }

    read(seen) {
        if (this.clocks <= 24) {
            this.value = (this.value << 1) | seen[0];
            if (this.clocks === 1 && this.hz > this.kind.readHz) this.complain(`03h at ${this.hz / 1e6} MHz`);
            return [null, null, null, null];
        }
        const n = this.clocks - 25;
        return this.drive(this.memory[(this.value + (n >> 3)) & 0xffffff], n & 7);
    }

    // Six clocks of address, two of mode, four of nothing, then a byte in two.
    readQuad(seen) {
        const { clocks } = this;
        if (clocks === 1) this.checkQuad();
        const nibble = seen[0] | (seen[1] << 1) | (seen[2] << 2) | (seen[3] << 3);
        if (clocks <= 6) this.value = (this.value << 4) | nibble;
        if (clocks === 7) this.isContinuous = (nibble & 3) === 2;
        if (clocks <= 12 || !(this.sr2 & QE)) return [null, null, null, null];
        const n = clocks - 13, byte = this.memory[(this.value + (n >> 1)) & 0xffffff];
        const out = n & 1 ? byte & 15 : byte >> 4;
        return [0, 1, 2, 3].map((line) => (line < (this.kind.lines ?? 4) ? (out >> line) & 1 : null));
    }

    checkQuad() {
        if (!(this.sr2 & QE)) this.complain('EBh while QE is 0');
        if (this.hz > this.kind.quadHz) this.complain(`EBh at ${this.hz / 1e6} MHz`);
    }
}

function hex(value) {
    return `${value.toString(16).padStart(2, '0').toUpperCase()}h`;
}
