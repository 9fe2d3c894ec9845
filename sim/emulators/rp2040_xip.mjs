// SPDX-License-Identifier: MIT
//
// Execution in place: the cache between the bus and the SSI, and what its misses take.
// Known: 16 KB, two ways, 8 bytes a line, a hit without a wait, the aliases by which it is passed by (RP2040 Datasheet,
// 2.6.3, 2.6.3.1). A line has a valid bit for each of its words, and a miss reads one word (raspberrypi/pico-feedback,
// issue 307, answer of the chip's maker). A miss takes the clocks that the SSI's settings make (rp2040_ssi.mjs).
// Not published: which of two ways a miss replaces (`policy`), and what the bus and the SSI add to a transfer
// (`busCycles`, 0). The processor fetches ahead, which is wasted where a branch is taken: `ahead` fetches the next word
// with each instruction, which is more than it does. Left out: the second master on this bus, DMA.
const LINE_B = 8, WORDS = 2, WAYS = 2, CACHE_B = 16384;
const SETS = CACHE_B / LINE_B / WAYS;
const ALIASES = { CACHED: 0x10, NO_ALLOCATE: 0x11, NO_LOOK: 0x12, UNCACHED: 0x13 };

// Which way of a set is replaced, both taken: the one not used for longest, the one filled first, or either. For a frame
// of rooms the second misses most, and is taken where nothing is said.
const POLICIES = {
    lru: (set) => (set.used ^ 1),
    fifo: (set) => (set.filled ^ 1),
    random: (set, next) => next() & 1,
};

// The same numbers in each run.
function xorshift() {
    let state = 0x2545f491;
    return () => {
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        return state >>> 7;
    };
}

export class Cache {
    constructor(policy = 'fifo') {
        if (!POLICIES[policy]) throw new Error(`no policy ${policy}; there are: ${Object.keys(POLICIES).join(', ')}`);
        this.victim = POLICIES[policy];
        this.random = xorshift();
        this.flush();
    }

    flush() {
        this.sets = Array.from({ length: SETS }, () => ({ tags: [-1, -1], valid: [0, 0], used: 0, filled: 1 }));
    }

    // Whether the word was there; if not, it is now.
    access(offset) {
        const set = this.sets[Math.floor(offset / LINE_B) % SETS], tag = Math.floor(offset / LINE_B / SETS);
        const word = 1 << (Math.floor(offset / 4) % WORDS);
        const at = set.tags.indexOf(tag);
        const way = at < 0 ? this.replace(set, tag) : at;
        const isHit = (set.valid[way] & word) !== 0;
        set.valid[way] |= word;
        set.used = way;
        return isHit;
    }

    replace(set, tag) {
        const free = set.tags.indexOf(-1);
        const way = free < 0 ? this.victim(set, this.random) : free;
        set.tags[way] = tag;
        set.valid[way] = 0;
        set.filled = way;
        return way;
    }

    has(offset) {
        const set = this.sets[Math.floor(offset / LINE_B) % SETS];
        const way = set.tags.indexOf(Math.floor(offset / LINE_B / SETS));
        return way >= 0 && (set.valid[way] & (1 << (Math.floor(offset / 4) % WORDS))) !== 0;
    }
}

export class Xip {
    constructor(chip, ssi, { policy, busCycles = 0, ahead = false }) {
        Object.assign(this, { chip, ssi, busCycles, ahead, cache: new Cache(policy), misses: 0, codeMisses: 0, waits: 0 });
        this.watchCore();
    }

    // The processor's reads alone; what DMA reads goes past.
    watchCore() {
        const { chip } = this, { core } = chip;
        for (const [name, mask] of [['readUint32', 0xffffffff], ['readUint16', 0xffff], ['readUint8', 0xff]]) {
            const read = core[name].bind(core), isHalf = name === 'readUint16';
            core[name] = (address) => {
                const alias = address >>> 24;
                if (alias < ALIASES.CACHED || alias > ALIASES.UNCACHED) return read(address);
                const isCode = isHalf && (address === core.PC || address === core.PC + 2);
                const word = this.access(alias, address & 0xfffffc, isCode);
                if (isCode && this.ahead) this.access(alias, (address + 4) & 0xfffffc, true);
                return word === undefined ? read(address) : ((word >>> (8 * (address & 3))) & mask) >>> 0;
            };
        }
    }

    // Undefined: what is in flash. An access past the cache gives what came over the wires.
    access(alias, offset, isCode) {
        const { cache } = this;
        if (alias === ALIASES.CACHED && cache.access(offset)) return undefined;
        if (alias === ALIASES.NO_ALLOCATE && cache.has(offset)) return undefined;
        if (alias === ALIASES.NO_LOOK) cache.access(offset);
        return this.miss(alias, offset, isCode);
    }

    miss(alias, offset, isCode) {
        const { ssi, chip } = this, cycles = ssi.cyclesOfWord + this.busCycles;
        const word = ssi.word(offset), right = chip.flashView.getUint32(offset, true);
        if (alias !== ALIASES.UNCACHED && word !== right) {
            const [at, is, should] = [offset, word, right].map((value) => value.toString(16));
            throw new Error(`flash at ${at} is read as ${is} instead of ${should}`);
        }
        this.misses++;
        if (isCode) this.codeMisses++;
        this.waits += cycles;
        chip.core.cycles += cycles;
        return word;
    }
}
