# SPDX-License-Identifier: MIT
#
# Reads an RP2350's UF2 file as its boot ROM would, and says what is wrong with it: od -An -v -tu1 FILE | awk -f
# tests/boards/rp2350_image.awk. Written from Microsoft's "USB Flashing Format" and the RP2350 Datasheet: 5.5.3 (families), 5.1.4
# and 5.9 (blocks), 5.9.3.1 (image types), 5.9.5 (the least that an image needs), 2.2 (addresses). Prints what it has found and
# exits with 0, or prints a line that begins with "wrong:" and exits with 1.

{ for (i = 1; i <= NF; i++) byte[total++] = $i }

END {
    check(total > 0 && total % 512 == 0, total " bytes are no row of blocks")
    for (at = 0; at < total; at += 512) block(at)
    check(blocks == promised, blocks " blocks of " promised)
    check(absolute, "no absolute block comes first (RP2350-E10)")
    find_definition()
    vectors()
    printf "%d bytes of flash, defined at 0x%x, begins at 0x%x with its stack at 0x%x\n", 256 * blocks, definition, entry, stack
}

function check(holds, why) {
    if (holds) return
    print "wrong: " why
    exit 1
}

function word(at) {
    return byte[at] + 256 * (byte[at + 1] + 256 * (byte[at + 2] + 256 * byte[at + 3]))
}

# -- UF2 ----------------------------------------------------------------------------------------------------------

function block(at,   family, to, i) {
    check(word(at) == 171066965 && word(at + 4) == 2656915799 && word(at + 508) == 179400496, "a block without its magic numbers")
    check(word(at + 16) == 256, "a block of other than 256 bytes")
    family = word(at + 28)
    if (at == 0) { absolute_block(family); return }
    check(word(at + 8) == 8192, "flags of a block: " word(at + 8))
    check(family == 3834380121, "family " family " is not RP2350-ARM-S")
    check(word(at + 20) == blocks, "block " word(at + 20) " comes as " blocks)
    if (blocks == 0) promised = word(at + 24)
    check(word(at + 24) == promised, "blocks do not agree how many they are")
    to = word(at + 12)
    check(to == 268435456 + 256 * blocks, "a block for another address")
    check(to < 268435456 + 4194304, "more than the 4 MB of a Pico 2")
    for (i = 0; i < 256; i++) flash[256 * blocks + i] = byte[at + 32 + i]
    blocks++
}

# As picotool writes and recognises it.
function absolute_block(family,   i) {
    check(family == 3834380119, "no absolute block comes first (RP2350-E10)")
    check(word(8) == 40960 && word(12) == 285212416 && word(20) == 0 && word(24) == 2, "the absolute block is none")
    for (i = 32; i < 288; i++) check(byte[i] == 239, "the absolute block has other bytes")
    check(word(288) == 2572673796, "the absolute block does not say that it may be ignored")
    absolute = 1
}

# -- Blocks of the boot ROM -----------------------------------------------------------------------------------------

function at_word(at) {
    return flash[at] + 256 * (flash[at + 1] + 256 * (flash[at + 2] + 256 * flash[at + 3]))
}

# One alone, in the first 4 KB, whose loop leads back to it.
function find_definition(   at, found) {
    for (at = 0; at + 20 <= 256 * blocks; at += 4)
        if (at_word(at) == 4294958803) {
            found++
            if (found == 1) definition = at
        }
    check(found, "no block begins")
    check(definition < 4096, "the first block begins at " definition ", beyond 4 KB")
    check(found == 1, found " blocks begin")
    items(definition + 4)
}

# Each item has its kind, and its size in words in one byte, or in two where the kind's bit 7 is set.
function items(at,   first, kind, words, size) {
    for (first = at; ; at += 4 * words) {
        kind = flash[at]
        words = flash[at + 1]
        if (kind >= 128) words += 256 * flash[at + 2]
        if (kind == 255) break
        check(words > 0 && at + 4 * words < definition + 384, "an item without an end")
        check(kind == 66 && at == first, "an item of kind " kind)
        image_type(flash[at + 2] + 256 * flash[at + 3])
    }
    check(at > first, "no item says what image it is")
    size = (at - first) / 4
    check(words == size, "the last item says " words " words, and there are " size)
    check(flash[at + 3] == 0, "the last item's last byte is not 0")
    check(at_word(at + 4) == 0, "the next block is elsewhere")
    check(at_word(at + 8) == 2870097273, "the block does not end")
}

# From bit 0: what, 4 bits; security, 2 from bit 4; processor, 3 from bit 8; chip, 3 from bit 12; on trial, bit 15.
function image_type(flags) {
    check(flags % 16 == 1, "no executable")
    check(int(flags / 16) % 4 == 2, "not for secure state")
    check(int(flags / 256) % 8 == 0, "not for Arm")
    check(int(flags / 4096) % 8 == 1, "not for an RP2350")
    check(int(flags / 32768) == 0, "on trial: it must be bought first")
}

# Without an item for them they are where the image begins, and the ROM goes there.
function vectors(   i, at) {
    stack = at_word(0)
    entry = at_word(4) - 1
    check(stack % 8 == 0 && stack > 536870912 && stack <= 536870912 + 532480, "the stack is not in RAM")
    for (i = 1; i < 16; i++) {
        at = at_word(4 * i)
        check(at % 2 == 1, "vector " i " is no Thumb address")
        check(at > 268435456 + 64 && at < 268435456 + 256 * blocks, "vector " i " is not in the image")
    }
    check(entry < 268435456 + definition || entry >= definition + 268435456 + 20, "it begins in its own definition")
}
