/* SPDX-License-Identifier: MIT
 *
 * The second stage of the RP2040's start: the boot ROM copies these 256 bytes from flash to the end of SRAM5, and enters
 * them there when the checksum in the last four is right. They set the flash interface up for execution in place, and
 * enter the image whose vector table follows them. The code runs wherever it is.
 * Manual: RP2040 Datasheet, 2.8.1.3.1 (checksum), 4.10.13 (SSI registers). Not tried on hardware.
 *
 * The flash is read by command 03h, a bit a clock, at a quarter of the processor's rate: every SPI flash can do so up to
 * 31 MHz without being told anything, so no chip's own registers are written. A miss of the cache of 16 KB takes 64
 * clocks of the flash for each word. */
    .syntax unified
    .cpu cortex-m0plus
    .thumb

    .equ XIP_SSI, 0x18000000
    .equ SSI_CTRLR0, 0x00
    .equ SSI_CTRLR1, 0x04
    .equ SSI_SSIENR, 0x08
    .equ SSI_BAUDR, 0x14
    .equ SSI_SPI_CTRLR0, 0xF4

    .equ CTRLR0_DFS_32, 31 << 16    /* 32 bits a frame */
    .equ CTRLR0_TMOD_EEPROM, 3 << 8 /* sends command and address, then receives */
    .equ SPI_CTRLR0_READ, 0x03 << 24
    .equ SPI_CTRLR0_INST_L_8, 2 << 8
    .equ SPI_CTRLR0_ADDR_L_24, 6 << 2

    .equ IMAGE, 0x10000100
    .equ VTOR, 0xE000ED08

    .section .text
    .global boot2
boot2:
    push {lr}
    ldr r3, =XIP_SSI
    movs r0, #0
    str r0, [r3, #SSI_SSIENR] /* takes no settings while enabled */
    movs r1, #4
    str r1, [r3, #SSI_BAUDR]
    ldr r1, =CTRLR0_DFS_32 | CTRLR0_TMOD_EEPROM
    str r1, [r3, #SSI_CTRLR0]
    str r0, [r3, #SSI_CTRLR1] /* one frame at a time */
    ldr r1, =SPI_CTRLR0_READ | SPI_CTRLR0_INST_L_8 | SPI_CTRLR0_ADDR_L_24
    movs r2, #SSI_SPI_CTRLR0
    str r1, [r3, r2]
    movs r0, #1
    str r0, [r3, #SSI_SSIENR]

    pop {r0}
    cmp r0, #0
    beq enter_image
    bx r0 /* called as a function, by who has written the flash */

enter_image:
    ldr r0, =IMAGE
    ldr r1, =VTOR
    str r0, [r1]
    ldmia r0!, {r1, r2}
    msr msp, r1
    bx r2
    .ltorg
