/* SPDX-License-Identifier: MIT
 *
 * The second stage of the RP2040's start: the boot ROM copies these 256 bytes from flash to the end of SRAM5, and enters
 * them there when the checksum in the last four is right. They set the flash interface (SSI) up for execution in place,
 * and enter the image whose vector table follows them. The code runs wherever it is. It may also be called, as a
 * function, by who has written the flash, at any rate of the processor and in whatever state the flash is.
 *
 * A flash that says it is Winbond's (9Fh: EFh) is read by EBh, four bits a clock, with mode bits by which the reads that
 * follow need no command: 20 clocks for a word, of two cycles each, 62.5 MHz. That needs the bit QE of its status
 * register 2. Where it is 0 it is set, by 01h with both registers, which all W25Q know: for ever, so once. Any other
 * flash, one whose QE stays 0, and one from which a word that is known cannot be read so, is read by 03h, a bit a clock,
 * of four cycles: 64 clocks for a word, 31.25 MHz, which every flash can do. Three attempts are made: a flash that was
 * left in continuous reading misses the first command, and one whose QE was set is looked at anew.
 *
 * RP2040 Datasheet, 2.6.3 (execution in place), 2.8.1.3.1 (checksum), 2.19.6.3 (pads), 4.10.13 (SSI). Clock divider,
 * pads and sample delay for 62.5 MHz: raspberrypi/pico-sdk, src/boards/include/boards/pico.h (PICO_FLASH_SPI_CLKDIV) and
 * src/rp2040/boot_stage2/boot2_w25q080.S. W25Q16JV data sheet, 7.1 and 8.2. Not tried on hardware. */
    .syntax unified
    .cpu cortex-m0plus
    .thumb

    .equ PADS_QSPI, 0x40020000
    .equ PAD_SCLK, 0x04
    .equ PAD_SD0, 0x08
    .equ PAD_8_MA_FAST, 0x21
    .equ PAD_4_MA_PULLED_UP, 0x58 /* no Schmitt trigger: it takes time */

    .equ XIP_SSI, 0x18000000
    .equ SSI_CTRLR0, 0x00
    .equ SSI_CTRLR1, 0x04
    .equ SSI_SSIENR, 0x08
    .equ SSI_BAUDR, 0x14
    .equ SSI_SR, 0x28
    .equ SSI_DR0, 0x60
    .equ SSI_RX_SAMPLE_DLY, 0xF0
    .equ SSI_SPI_CTRLR0, 0xF4
    .equ SR_BUSY_TFE, 5
    .equ SR_TFE, 4
    .equ SR_RFNE_BIT, 3

    .equ CTRLR0_BYTES, 7            /* << 16: frames of 8 bits, sent and received */
    .equ CTRLR0_DFS_32, 31 << 16
    .equ CTRLR0_TMOD_EEPROM, 3 << 8 /* sends command and address, then receives */
    .equ CTRLR0_READ, CTRLR0_DFS_32 | CTRLR0_TMOD_EEPROM
    .equ CTRLR0_READ_QUAD, CTRLR0_READ | 2 << 21
    .equ INST_L_8, 2 << 8
    .equ ADDR_L_24, 6 << 2
    .equ ADDR_L_24_MODE_8, 8 << 2
    .equ WAIT_4, 4 << 11
    .equ TYPE_1C4A, 1               /* command on one line, address on four */
    .equ TYPE_4C4A, 2

    .equ READ, 0x03
    .equ READ_QUAD, 0xEB
    .equ MODE_CONTINUOUS, 0xA0
    .equ SPI_READ, READ << 24 | INST_L_8 | ADDR_L_24
    .equ SPI_READ_QUAD, WAIT_4 | INST_L_8 | ADDR_L_24_MODE_8 | TYPE_1C4A
    .equ SPI_READ_ON, MODE_CONTINUOUS << 24 | WAIT_4 | ADDR_L_24_MODE_8 | TYPE_4C4A

    .equ IDENTIFY, 0x9F
    .equ WINBOND, 0xEF
    .equ READ_STATUS_1, 0x05
    .equ READ_STATUS_2, 0x35
    .equ WRITE_ENABLE, 0x06
    .equ WRITE_STATUS, 0x01
    .equ QE, 2

    .equ UNCACHED, 0x13000000
    .equ IMAGE, 0x10000100
    .equ VTOR, 0xE000ED08

    .section .text
    .global boot2
boot2: /* r3: the SSI, r4: attempts left, r5: CTRLR0, r6: the divider, r7: where `ask` is */
    push {r4, r5, r6, r7, lr}
    ldr r3, =PADS_QSPI
    movs r0, #PAD_8_MA_FAST
    str r0, [r3, #PAD_SCLK]
    movs r0, #PAD_4_MA_PULLED_UP
    str r0, [r3, #PAD_SD0]
    str r0, [r3, #PAD_SD0 + 4]
    str r0, [r3, #PAD_SD0 + 8]
    str r0, [r3, #PAD_SD0 + 12]
    movs r3, #XIP_SSI >> 24
    lsls r3, #24
    adr r7, ask
    adds r7, #1
    movs r4, #3

by_bytes: /* a flash that reads on without commands takes 9Fh for mode bits that end it, and answers the next time */
    movs r6, #4
    movs r5, #CTRLR0_BYTES
    lsls r5, #16
    bl set
    movs r0, #IDENTIFY
    blx r7
    subs r4, #1
    beq plain
    cmp r0, #WINBOND
    bne by_bytes
    movs r0, #READ_STATUS_2
    blx r7
    movs r1, #QE
    tst r0, r1
    bne quad

    orrs r1, r0
    mov r12, r1
    movs r0, #WRITE_ENABLE
    bl tell
    movs r0, #READ_STATUS_1
    blx r7
    movs r1, #WRITE_STATUS
    str r1, [r3, #SSI_DR0]
    str r0, [r3, #SSI_DR0]
    mov r0, r12
    bl tell
1:  movs r0, #READ_STATUS_1
    blx r7
    lsrs r0, #1
    bcc by_bytes
    subs r5, #1 /* 70000h looks: 370 ms at 125 MHz, and more at less; a chip takes 15 */
    bne 1b
    b by_bytes

quad:
    movs r6, #2
    ldr r5, =CTRLR0_READ_QUAD
    ldr r1, =SPI_READ_QUAD
    bl set
    movs r1, #READ_QUAD
    str r1, [r3, #SSI_DR0]
    movs r0, #MODE_CONTINUOUS
    bl tell
    ldr r1, =SPI_READ_ON
    bl set
    ldr r0, where
    ldr r1, [r0]
    cmp r0, r1
    bne by_bytes
    b done

plain:
    ldr r5, =CTRLR0_READ
    ldr r1, =SPI_READ
    bl set
done:
    pop {r4, r5, r6, r7}
    pop {r0}
    cmp r0, #0
    beq enter_image
    bx r0
enter_image:
    ldr r0, =IMAGE
    ldr r1, =VTOR
    str r0, [r1]
    ldmia r0!, {r1, r2}
    msr msp, r1
    bx r2

set: /* r5: CTRLR0, r1: SPI_CTRLR0 */
    movs r0, #0
    str r0, [r3, #SSI_SSIENR] /* takes no settings while enabled */
    str r5, [r3, #SSI_CTRLR0]
    str r0, [r3, #SSI_CTRLR1] /* one frame at a time */
    str r6, [r3, #SSI_BAUDR]
    movs r2, #SSI_RX_SAMPLE_DLY
    adds r2, r3
    movs r0, #1
    stmia r2!, {r0, r1}
    str r0, [r3, #SSI_SSIENR]
    bx lr

    .align 2
ask: /* r0: a command, and some byte behind it */
    str r0, [r3, #SSI_DR0]
tell: /* r0: the last byte; returns what came with it, when all is over */
    str r0, [r3, #SSI_DR0]
1:  ldr r2, [r3, #SSI_SR]
    movs r1, #SR_BUSY_TFE
    ands r1, r2
    cmp r1, #SR_TFE
    bne 1b
2:  ldr r0, [r3, #SSI_DR0]
    ldr r2, [r3, #SSI_SR]
    lsls r2, #31 - SR_RFNE_BIT
    bmi 2b
    bx lr

    .align 2
where: /* the word whose value is its own address in flash */
    .word UNCACHED + where - boot2
    .ltorg
