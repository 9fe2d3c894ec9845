// SPDX-License-Identifier: MIT
//
// The cycles of a frame, by marks that the image's symbols set: all between frame_begin() and frame_end(), of them
// those within the painting of lines, and those of waiting for the bus; what is left walks and projects. So does what is
// done of the next frame instead of waiting for the bus, in the middle of painting. All have the waits for flash in
// them that the cache's misses make, which are told apart as well.
const FLASH = 0x10000000;
const BEGIN = 1, END = 2, PAINT = 3, WAIT = 4, AHEAD = 5;
const MARKS = new Map([
    ['frame_begin', BEGIN], ['frame_end', END], ['lim_paint_band', PAINT],
    ['rp2040_dma_wait', WAIT], ['pl022_flush', WAIT], ['scene_work', AHEAD],
]);

// Lines of `nm`: address, perhaps size, type, name, perhaps with what the compiler appended.
function marksOf(symbols, flashB) {
    const marks = new Uint8Array(flashB / 2);
    const found = new Set();
    for (const line of symbols.split('\n')) {
        const [address, ...rest] = line.trim().split(/\s+/);
        const name = (rest.at(-1) ?? '').replace(/\..*/, '');
        if (!MARKS.has(name)) continue;
        marks[(parseInt(address, 16) - FLASH) >> 1] = MARKS.get(name);
        found.add(name);
    }
    for (const name of ['frame_begin', 'frame_end']) {
        if (!found.has(name)) throw new Error(`the image has no ${name}()`);
    }
    return marks;
}

export class Cycles {
    constructor(chip, symbols) {
        this.core = chip.core;
        this.xip = chip.xip;
        this.marks = marksOf(symbols, 1 << 24);
        this.waiting = this.painting = this.leading = null; // where and with which stack what was entered returns
        this.running = false;
        this.ended = -1; // when the last frame did
        this.sum = {};
    }

    // Before each instruction.
    at(pc) {
        if (this.waiting && this.waiting.pc === pc && this.waiting.sp === this.core.SP) this.leaveWait();
        if (this.painting && this.painting.pc === pc && this.painting.sp === this.core.SP) this.leavePaint();
        if (this.leading && this.leading.pc === pc && this.leading.sp === this.core.SP) this.leaveAhead();
        const mark = this.marks[(pc - FLASH) >> 1];
        if (mark) this.enter(mark);
    }

    begin() {
        Object.assign(this, { running: true, began: this.core.cycles, paint: 0, wait: 0, ahead: 0, bytes: 0, besides: 0 });
        const { misses, codeMisses, waits } = this.xip;
        this.before = { misses, codeMisses, waits };
    }

    // What flash took since the frame began.
    flash() {
        const { xip, before } = this;
        return Object.fromEntries(Object.keys(before).map((name) => [name, xip[name] - before[name]]));
    }

    enter(mark) {
        const { core } = this;
        if (mark === BEGIN) this.begin();
        if (mark === END) Object.assign(this, { running: false, ended: core.cycles, took: this.flash() });
        const here = { pc: core.LR & ~1, sp: core.SP, since: core.cycles };
        if (mark === WAIT && !this.waiting) this.waiting = here;
        if (mark === AHEAD && !this.leading) this.leading = here;
        if (mark === PAINT && !this.painting) this.painting = { ...here, besides: this.wait + this.ahead };
    }

    leaveWait() {
        this.wait += this.core.cycles - this.waiting.since;
        this.waiting = null;
    }

    leaveAhead() {
        this.ahead += this.core.cycles - this.leading.since;
        this.leading = null;
    }

    leavePaint() {
        this.paint += this.core.cycles - this.painting.since - (this.wait + this.ahead - this.painting.besides);
        this.painting = null;
    }

    byteLeft() {
        if (!this.running) return;
        this.bytes++;
        if (!this.waiting) this.besides++;
    }

    // Of the frame that ended last.
    report(frame, cyclesOfByte) {
        const total = this.ended - this.began;
        const walk = total - this.paint - this.wait;
        const { misses, codeMisses: code, waits } = this.took;
        if (frame) this.add({ frames: 1, total, cpu: total - this.wait, misses, waits });
        return `# cycles frame ${frame} total ${total} walk ${walk} paint ${this.paint} wait ${this.wait}\n` +
            `# bus frame ${frame} bytes ${this.bytes} cycles ${Math.round(this.bytes * cyclesOfByte)} ` +
            `besides work ${this.besides}\n` +
            `# flash frame ${frame} misses ${misses} code ${code} data ${misses - code} waits ${waits}\n`;
    }

    // Not the first, which nothing goes before and for which everything has to come from flash.
    add(costs) {
        for (const [name, value] of Object.entries(costs)) this.sum[name] = (this.sum[name] ?? 0) + value;
    }

    mean(clockHz) {
        const { frames, total, cpu, misses, waits } = this.sum;
        if (!frames) return '';
        const [rate, cpuRate] = [total, cpu].map((cycles) => ((clockHz * frames) / cycles).toFixed(1));
        const [each, missed, waited] = [cpu, misses, waits].map((value) => Math.round(value / frames));
        return `# mean of ${frames} frames: ${rate} a second; by the processor alone ${cpuRate}, ${each} cycles, ` +
            `of which ${waited} wait for flash, for ${missed} misses of the cache\n`;
    }
}
