#!/usr/bin/python3
"""Makes the Targa, BMP and GIF files of mapped_files.pov next to itself, byte by byte: palettes of all
depths, runs, words with an alpha bit, and rows that are interlaced."""
import struct
from pathlib import Path

import numpy
from PIL import Image

HERE = Path(__file__).parent
W, H = 18, 17
Y, X = numpy.mgrid[0:H, 0:W]
INDEX = ((X + 2 * Y) % 13).astype("u1")
PALETTE = numpy.random.default_rng(3).integers(0, 256, (13, 3)).astype("u1")


def word(color, opaque):
    red, green, blue = (int(c) >> 3 for c in color)
    return struct.pack("<H", opaque << 15 | red << 10 | green << 5 | blue)


def tga(name, kind, bits, pixels, entries=(), entry_bits=0, flags=0, comment=b""):
    head = struct.pack("<BBBHHBHHHHBB", len(comment), len(entries) > 0, kind, 0, len(entries),
                       entry_bits, 0, 0, W, H, bits, flags)
    (HERE / name).write_bytes(head + comment + b"".join(entries) + pixels)


def bmp(name, bits, rows, packing=0, entry_size=4, size=40):
    entries = b"".join(bytes([c[2], c[1], c[0], 0])[:entry_size] for c in PALETTE[:2 ** bits])
    if bits > 8:
        entries = b""
    if size == 12:  # has no number of entries: all of them
        entries = entries.ljust(entry_size * 2 ** bits, b"\0")
        head = struct.pack("<IHHHH", size, W, H, 1, bits)
    else:
        used = min(len(PALETTE), 2 ** bits) if bits <= 8 else 0
        head = struct.pack("<IiiHHIIiiII", size, W, H, 1, bits, packing, len(rows), 0, 0, used, 0)
    start = 14 + len(head) + len(entries)
    (HERE / name).write_bytes(b"BM" + struct.pack("<IHHI", start + len(rows), 0, 0, start) + head +
                              entries + rows)


def runs(row):
    """Two indices as a run, the others as they are."""
    rest = row[2:].tobytes()
    return bytes([2, row[0], 0, len(rest)]) + rest + bytes(len(rest) % 2) + b"\0\0"


def padded(rows):
    return b"".join(row + bytes(-len(row) % 4) for row in rows)


def main():
    upward = INDEX[::-1]
    entries = [bytes([c[2], c[1], c[0]]) for c in PALETTE]
    tga("mapped.tga", 1, 8, upward.tobytes(), entries, 24, comment=b"from below")
    alpha = [bytes([c[2], c[1], c[0], 255 - c[0]]) for c in PALETTE]
    tga("mapped_alpha.tga", 1, 8, INDEX[:, ::-1].tobytes(), alpha, 32, flags=0x30)
    packed = b"".join(bytes([0x81, r[0], W - 3]) + r[2:].tobytes() for r in upward)
    tga("mapped_runs.tga", 9, 8, packed, [word(c, c[0] > 99) for c in PALETTE], 16)
    words = b"".join(word(PALETTE[i], i % 3 > 0) for i in upward.flat)
    tga("words.tga", 2, 16, words)
    tga("words15.tga", 2, 15, words)

    bmp("one_bit.bmp", 1, padded(numpy.packbits(r % 2).tobytes() for r in upward))
    bmp("nibbles.bmp", 4, padded((r[0::2] << 4 | r[1::2]).tobytes() for r in upward))
    bmp("short_entries.bmp", 4, padded((r[0::2] << 4 | r[1::2]).tobytes() for r in upward),
        entry_size=3, size=12)
    bmp("runs.bmp", 8, b"".join(runs(r) for r in upward) + b"\0\1", packing=1)
    rgba = numpy.dstack([PALETTE[upward][..., ::-1], PALETTE[upward][..., 0]]).astype("u1")
    bmp("alpha.bmp", 32, rgba.tobytes())

    indexed = Image.fromarray(INDEX, "P")
    indexed.putpalette(PALETTE.tobytes())
    indexed.save(HERE / "interlaced.gif", interlace=1)


if __name__ == "__main__":
    main()
