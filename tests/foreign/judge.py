# SPDX-License-Identifier: MIT
#
# Whether glass shows a picture as its pixels can:  python3 judge.py WANTED.ppm PIXELS SHOWN.png
# PIXELS is colours (of 16 bits or more), greys (16 of them) or bits (black and white). Prints how many pixels differ and,
# if the picture is there but mirrored, turned or shifted, how; fails if any differs.
import sys

from PIL import Image, ImageChops


def luma(rgb):
    """Of ITU-R BT.601, to 1/1000 level."""
    return (299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2]) / 1000


def as_colours(rgb):
    return tuple(rgb)


def as_greys(rgb):
    return (int(luma(rgb)) // 16 * 17,) * 3


def as_bits(rgb):
    return (255 if luma(rgb) >= 128 else 0,) * 3


def shaded(image, shade):
    """As the glass shows it, to what a PNG file of the simulator's keeps of a pixel: 5, 6 and 5 bits."""
    seen = Image.new("RGB", image.size)
    seen.putdata([(r & 0xF8, g & 0xFC, b & 0xF8) for r, g, b in map(shade, image.convert("RGB").getdata())])
    return seen


def count_differing(wanted, shown):
    return sum(a != b for a, b in zip(wanted.getdata(), shown.getdata()))


def ways(image):
    """Every mirror and turn of the picture that keeps its size, and every shift of each, named."""
    turns = Image.Transpose
    for name, turned in (
        ("", image),
        ("mirrored left to right", image.transpose(turns.FLIP_LEFT_RIGHT)),
        ("mirrored top to bottom", image.transpose(turns.FLIP_TOP_BOTTOM)),
        ("turned by 180 degrees", image.transpose(turns.ROTATE_180)),
    ):
        yield name, turned
        for shift in range(1, image.width):
            yield f"{name} rolled right by {shift}".strip(), ImageChops.offset(turned, shift, 0)
        for shift in range(1, image.height):
            yield f"{name} rolled down by {shift}".strip(), ImageChops.offset(turned, 0, shift)


def explain(wanted, shown):
    shown_bytes = shown.tobytes()
    for name, image in ways(wanted):
        if image.tobytes() == shown_bytes:
            return f": it is {name}"
    return ""


def main(wanted_path, kind, shown_path):
    shade = {"colours": as_colours, "greys": as_greys, "bits": as_bits}[kind]
    wanted, shown = Image.open(wanted_path), Image.open(shown_path)
    if wanted.size != shown.size:
        sys.exit(f"judge: {shown_path} has {shown.size} pixels, not {wanted.size}")
    wanted, shown = shaded(wanted, shade), shaded(shown, as_colours)
    differing = count_differing(wanted, shown)
    print(f"{differing} of {wanted.width * wanted.height} pixels differ" + (explain(wanted, shown) if differing else ""))
    return differing > 0


if len(sys.argv) != 4:
    sys.exit("usage: judge.py WANTED.ppm colours|greys|bits SHOWN.png")
sys.exit(main(*sys.argv[1:]))
