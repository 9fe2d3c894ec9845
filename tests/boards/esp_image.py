# SPDX-License-Identifier: MIT
"""Reads an image for an ESP32-C3 as Espressif describes it ("Firmware Image Format" of esptool's documentation, and the
addresses of esp-idf's soc.h and bootloader.memory.ld.in), and prints what it holds; fails on whatever is not as it says.
Shares nothing with what writes it."""
import hashlib
import struct
import sys

RAM = ((0x40380000, 0x403CAE00, "code"), (0x3FC80000, 0x3FCCAE00, "data"))


def need(is_so, what):
    if not is_so:
        sys.exit("esp_image.py: " + what)


def where(address, length):
    for start, end, kind in RAM:
        if start <= address and address + length <= end:
            return kind, address - start
    return None


def main(path):
    with open(path, "rb") as file:
        image = file.read()
    magic, segments, mode, size_speed, entry = struct.unpack_from("<BBBBI", image)
    need(magic == 0xE9, "no magic number")
    need(mode in range(4) and size_speed & 15 in (0, 1, 2, 15), "no way to read flash")
    chip, _, least, most, _, hashed = struct.unpack_from("<HBHH4sB", image, 12)
    need(chip == 5, f"chip {chip}, which is no ESP32-C3")
    need(least <= 3 <= most, "revision 0.3 is not among those that it is for")
    at, checksum, taken, begins = 24, 0xEF, set(), False
    for _ in range(segments):
        address, length = struct.unpack_from("<II", image, at)
        data = image[at + 8 : at + 8 + length]
        at += 8 + length
        need(len(data) == length and length % 4 == 0, "a segment is cut off or no words")
        place = where(address, length)
        need(place, f"{address:#x}, {length} bytes: not in RAM")
        need(place[0] == "data" or not address <= entry < address + length or not begins, "two beginnings")
        begins = begins or (place[0] == "code" and address <= entry < address + length)
        bytes_taken = set(range(place[1], place[1] + length, 4))
        need(not taken & bytes_taken, f"{address:#x}: RAM that another segment has")
        taken |= bytes_taken
        for byte in data:
            checksum ^= byte
        print(f"{place[0]} {address:#x} {length}")
    need(begins, "its entry is not in what it loads")
    end = at + (15 - at % 16)
    need(not any(image[at:end]), "padding that is not zero")
    need(image[end] == checksum, "a wrong checksum")
    need(hashed == 1 and image[end + 1 :] == hashlib.sha256(image[: end + 1]).digest(), "a wrong digest")
    print(f"entry {entry:#x}, checksum {checksum:#x}")


main(sys.argv[1])
