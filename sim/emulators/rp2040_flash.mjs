// SPDX-License-Identifier: MIT
//
// From a UF2 file to flash and into its second stage, as the RP2040's boot drive and boot ROM do it. Microsoft's "USB
// Flashing Format (UF2)"; RP2040 Datasheet, 2.8.1 and 2.8.1.3.1.
const BLOCK_B = 512;
const MAGICS = [[0, 0x0a324655], [4, 0x9e5d5157], [508, 0x0ab16f30]];
const FLAG_FAMILY_ID = 0x2000;
const FAMILY_RP2040 = 0xe48bff56;
const FLASH = 0x10000000;
const BOOT2_B = 256;
const BOOT2_RUNS_AT = 0x20041f00; // the end of SRAM5
const STACK_OF_ROM = 0x20041f00;

function takeBlock(flash, file, number, count) {
    const at = number * BLOCK_B;
    const word = (offset) => file.readUInt32LE(at + offset);
    const refuse = (reason) => {
        throw new Error(`UF2 block ${number}: ${reason}`);
    };

    for (const [offset, magic] of MAGICS) if (word(offset) !== magic) refuse('not a block');
    if (!(word(8) & FLAG_FAMILY_ID) || word(28) !== FAMILY_RP2040) refuse('not for the RP2040');
    if (word(16) !== 256 || word(12) % 256 !== 0) refuse('not a page of flash');
    if (word(20) !== number || word(24) !== count) refuse(`is called ${word(20)} of ${word(24)}`);
    if (word(12) < FLASH || word(12) + 256 > FLASH + flash.length) refuse('not in flash');
    flash.set(file.subarray(at + 32, at + 32 + 256), word(12) - FLASH);
}

export function loadUf2(flash, file) {
    if (file.length === 0 || file.length % BLOCK_B) throw new Error('UF2: not whole blocks');
    const count = file.length / BLOCK_B;
    for (let number = 0; number < count; number++) takeBlock(flash, file, number, count);
}

// CRC-32, most significant bit first, from all ones.
function checksum(bytes) {
    let sum = 0xffffffff;
    for (const byte of bytes) {
        sum ^= byte << 24;
        for (let bit = 0; bit < 8; bit++) sum = sum & 0x80000000 ? (sum << 1) ^ 0x04c11db7 : sum << 1;
    }
    return sum >>> 0;
}

// Leaves the processor at the entry of the second stage, in RAM, with the link register that asks it to go on.
export function enterBoot2(chip) {
    const boot2 = chip.flash.subarray(0, BOOT2_B);
    const stored = new DataView(boot2.buffer, boot2.byteOffset).getUint32(BOOT2_B - 4, true);
    if (checksum(boot2.subarray(0, BOOT2_B - 4)) !== stored) {
        throw new Error('the second stage has a wrong checksum: the boot ROM would not enter it');
    }
    chip.sram.set(boot2, BOOT2_RUNS_AT - 0x20000000);
    chip.ssi.asRomLeavesIt();
    chip.core.SP = STACK_OF_ROM;
    chip.core.LR = 0;
    chip.core.PC = BOOT2_RUNS_AT;
}
