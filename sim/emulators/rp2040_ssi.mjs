// SPDX-License-Identifier: MIT
//
// The RP2040's flash interface, SSI: the registers that a second stage sets, transfers of its own, and reads of words
// for execution in place, each clock of them seen by the flash (serial_flash.mjs). What software may not do with it is
// complained about: settings while it is enabled, transfers that are cut off, FIFOs that overflow or run dry.
// RP2040 Datasheet, 4.10.13 (registers), 2.6.3 (execution in place); raspberrypi/pico-sdk, src/rp2040/boot_stage2 (the
// meaning of INST_L for XIP_CMD, and of RX_SAMPLE_DLY).
const CTRLR0 = 0x00, CTRLR1 = 0x04, SSIENR = 0x08, SER = 0x10, BAUDR = 0x14, TXFLR = 0x20, RXFLR = 0x24, SR = 0x28;
const IDR = 0x58, VERSION = 0x5c, DR0 = 0x60, DR_END = 0xf0, RX_SAMPLE_DLY = 0xf0, SPI_CTRLR0 = 0xf4;
const SETTINGS = new Map([[CTRLR0, 'CTRLR0'], [CTRLR1, 'CTRLR1'], [BAUDR, 'BAUDR'], [RX_SAMPLE_DLY, 'RX_SAMPLE_DLY'],
    [SPI_CTRLR0, 'SPI_CTRLR0']]);
const SR_BUSY = 1, SR_TFNF = 2, SR_TFE = 4, SR_RFNE = 8;
const FIFO = 16;
const TMOD_BOTH = 0, TMOD_EEPROM = 3;
const SAMPLED_LATE_HZ = 40e6; // faster than that, what comes back comes after the edge that it is sampled at
const LINES = { 0: 1, 1: 2, 2: 4 }; // of SPI_FRF

export class Ssi {
    // `clkSys()` in Hz; `createAlarm(call)` of the emulator's clock; `complain(text)` of what software does wrong.
    constructor(flash, clkSys, createAlarm, complain) {
        Object.assign(this, { flash, clkSys, complain, tx: [], rx: [], isBusy: false });
        this.registers = new Map([[CTRLR0, 0], [CTRLR1, 0], [SSIENR, 0], [SER, 0], [BAUDR, 0], [RX_SAMPLE_DLY, 0],
            [SPI_CTRLR0, 0x03000000]]);
        this.alarm = createAlarm(() => this.frameEnds());
    }

    // As the boot ROM leaves it, which has read the second stage by 03h at a sixth.
    asRomLeavesIt() {
        for (const [at, value] of [[CTRLR0, 0x001f0300], [SER, 1], [BAUDR, 6], [SPI_CTRLR0, 0x03000218], [SSIENR, 1]]) {
            this.registers.set(at, value);
        }
    }

    get(at) {
        return this.registers.get(at);
    }

    get settings() {
        const ctrlr0 = this.get(CTRLR0), spi = this.get(SPI_CTRLR0);
        return {
            lines: LINES[(ctrlr0 >> 21) & 3], tmod: (ctrlr0 >> 8) & 3, bits: ((ctrlr0 >> 16) & 31) + 1,
            frames: this.get(CTRLR1) + 1, divider: this.get(BAUDR),
            instructionBits: [0, 4, 8, 16][(spi >> 8) & 3], addressBits: 4 * ((spi >> 2) & 15), wait: (spi >> 11) & 31,
            type: spi & 3, command: spi >>> 24,
        };
    }

    readUint32(offset) {
        if (offset >= DR0 && offset < DR_END) return this.receive();
        switch (offset) {
        case SR:
            return (this.isBusy ? SR_BUSY : 0) | (this.tx.length ? 0 : SR_TFE) | (this.tx.length < FIFO ? SR_TFNF : 0) |
                (this.rx.length ? SR_RFNE : 0);
        case TXFLR: return this.tx.length;
        case RXFLR: return this.rx.length;
        case IDR: return 0x51535049;
        case VERSION: return 0x3430312a;
        default: return this.registers.get(offset) ?? 0;
        }
    }

    writeUint32(offset, value) {
        if (offset >= DR0 && offset < DR_END) return this.send(value >>> 0);
        if (!this.registers.has(offset)) return;
        if (SETTINGS.has(offset) && this.get(SSIENR)) {
            return this.complain(`${SETTINGS.get(offset)} is set while the SSI is enabled`);
        }
        if (offset === BAUDR && (value & 1 || value < 2)) this.complain(`BAUDR is ${value}`);
        if (offset === SSIENR && !(value & 1)) this.disable();
        this.registers.set(offset, value >>> 0);
    }

    writeUint32Atomic(offset, value, kind) {
        if (kind) return this.complain('the SSI has no aliases that set or clear bits');
        this.writeUint32(offset, value);
    }

    disable() {
        if (this.isBusy || this.tx.length) this.complain('the SSI is disabled in the middle of a transfer');
        this.alarm.cancel();
        if (this.flash.isSelected) this.flash.deselect();
        Object.assign(this, { tx: [], rx: [], isBusy: false });
    }

    receive() {
        if (!this.rx.length) this.complain('DR is read while nothing was received');
        return this.rx.shift() ?? 0;
    }

    send(value) {
        if (!this.isOn) return this.complain('DR is written while the SSI is off or selects nothing');
        if (this.tx.length === FIFO) return this.complain('more than sixteen frames are waiting to be sent');
        this.tx.push(value);
        if (!this.isBusy) this.frameBegins();
    }

    get isOn() {
        return this.get(SSIENR) && this.get(SER);
    }

    get hz() {
        return this.clkSys() / this.settings.divider;
    }

    frameBegins() {
        const { tmod, bits, lines, divider } = this.settings;
        let clocks = bits;
        if (tmod !== TMOD_BOTH) {
            const words = this.settings.instructionBits ? 2 : 1;
            if (this.tx.length < words) return; // begins with the address
            clocks = this.clocksOfRead();
        } else if (lines !== 1) {
            this.complain('several lines cannot send and receive at once');
        }
        this.isBusy = true;
        this.alarm.schedule((clocks * divider * 1e9) / this.clkSys());
    }

    frameEnds() {
        const { tmod, bits, instructionBits } = this.settings;
        this.isBusy = false;
        if (tmod === TMOD_BOTH) {
            if (!this.flash.isSelected) this.flash.select(this.hz);
            this.push(this.exchange(this.tx.shift(), bits));
            if (this.tx.length) return this.frameBegins();
            this.flash.deselect();
        } else {
            const instruction = instructionBits ? this.tx.shift() : 0;
            this.push(this.readBy(instruction, this.tx.shift()));
            if (this.tx.length) this.frameBegins();
        }
    }

    push(value) {
        if (this.rx.length === FIFO) return this.complain('more than sixteen frames were received and not read');
        this.rx.push(value);
    }

    // A bit a clock, out on IO0 and in from IO1.
    exchange(value, bits) {
        let received = 0;
        for (let bit = bits - 1; bit >= 0; bit--) {
            const seen = this.flash.clock([(value >>> bit) & 1, null, null, null]);
            received = (received << 1) | (seen[1] ?? 1);
        }
        return received >>> 0;
    }

    drive(value, bits, lines) {
        for (let left = bits - lines; left >= 0; left -= lines) {
            const levels = [null, null, null, null];
            for (let line = 0; line < lines; line++) levels[line] = (value >>> (left + line)) & 1;
            this.flash.clock(levels);
        }
    }

    sample(bits, lines) {
        let value = 0;
        for (let taken = 0; taken < bits; taken += lines) {
            const seen = this.flash.clock([null, null, null, null]);
            if (lines === 1) value = (value << 1) | (seen[1] ?? 1);
            else for (let line = lines - 1; line >= 0; line--) value = (value << 1) | (seen[line] ?? 1);
        }
        return value >>> 0;
    }

    clocksOfRead() {
        const { instructionBits, addressBits, wait, bits, lines, type } = this.settings;
        const instruction = instructionBits / (type === 2 ? lines : 1);
        return instruction + addressBits / (type === 0 ? 1 : lines) + wait + bits / lines;
    }

    // One transfer of instruction, address, and what is received behind.
    readBy(instruction, address) {
        const { instructionBits, addressBits, wait, bits, lines, type, tmod, frames } = this.settings;
        if (tmod !== TMOD_EEPROM || frames !== 1) this.complain(`mode ${tmod}, ${frames} frames: does not read a word`);
        if (this.hz > SAMPLED_LATE_HZ && !this.get(RX_SAMPLE_DLY)) {
            this.complain(`sampled without delay at ${this.hz / 1e6} MHz`);
        }
        this.flash.select(this.hz);
        this.drive(instruction, instructionBits, type === 2 ? lines : 1);
        this.drive(address, addressBits, type === 0 ? 1 : lines);
        for (let i = 0; i < wait; i++) this.flash.clock([null, null, null, null]);
        const value = this.sample(bits, lines);
        this.flash.deselect();
        return value;
    }

    // A word at an offset in flash, as the bus sees it: the byte at the lowest address is the lowest. Without an
    // instruction XIP_CMD goes behind the address.
    word(offset) {
        const { instructionBits, addressBits, command, bits } = this.settings;
        if (!this.isOn) this.complain('flash is read while the SSI is off');
        if (this.isBusy || this.tx.length) this.complain('flash is read in the middle of a transfer');
        if (bits !== 32) this.complain(`flash is read by frames of ${bits} bits`);
        const address = instructionBits || addressBits < 32 ? offset : ((offset << 8) | command) >>> 0;
        const value = this.readBy(command, address);
        return ((value & 0xff) << 24 | (value & 0xff00) << 8 | (value >>> 8 & 0xff00) | value >>> 24) >>> 0;
    }

    // That it takes, of clk_sys. What the bus and the SSI need before and after is not published, and not in it.
    get cyclesOfWord() {
        return this.clocksOfRead() * this.settings.divider;
    }
}
