#!/usr/bin/python3
"""Makes the TIFF and OpenEXR pictures that the scenes of this folder read, next to itself.

Both formats are put together by hand: grey, colour, palettes, the kinds of alpha, 8 and 16 bits,
compressions and orientations of TIFF; channels, types of numbers, compressions and windows of EXR.
"""
import struct
import zlib

import numpy

from make_images import H, HERE, W, alpha_ramp, ramp

GREY, COLOR, PALETTE = 1, 2, 3
NO_ALPHA, ASSOCIATED, STRAIGHT = 0, 1, 2


def packbits(data):
    parts = [data[i:i + 100] for i in range(0, len(data), 100)]
    return b"".join(bytes([len(part) - 1]) + part for part in parts)


def tiff(name, values, photometric, order="<", compression=1, strip=5, **tags):
    """values: integers of the size that is stored. tags: the rarer ones."""
    values = values.reshape(H, W, -1)
    samples, bits = values.shape[2], values.itemsize * 8
    body, offsets, sizes = b"", [], []
    for y in range(0, H, strip):
        rows = [row.astype(values.dtype.newbyteorder(order)).tobytes()
                for row in values[y:y + strip]]
        data = b"".join(packbits(row) if compression == 32773 else row for row in rows)
        data = zlib.compress(data) if compression == 8 else data
        offsets.append(8 + len(body))
        sizes.append(len(data))
        body += data + b"\0" * (len(data) % 2)
    numbers = {"alpha": 338, "color_map": 320, "orientation": 274, "sample_format": 339}
    fields = {256: [W], 257: [H], 258: [bits] * samples, 259: [compression], 262: [photometric],
              273: offsets, 277: [samples], 278: [strip], 279: sizes, 284: [1]}
    fields |= {numbers[tag]: value for tag, value in tags.items()}
    start = 8 + len(body)
    directory, more = struct.pack(order + "H", len(fields)), b""
    for tag, content in sorted(fields.items()):
        data = struct.pack(f"{order}{len(content)}H", *content)
        if len(data) > 4:
            place = struct.pack(order + "I", start + 2 + 12 * len(fields) + 4 + len(more))
            data, more = place, more + data
        directory += struct.pack(order + "HHI", tag, 3, len(content)) + data.ljust(4, b"\0")
    head = (b"II" if order == "<" else b"MM") + struct.pack(order + "HI", 42, start)
    (HERE / name).write_bytes(head + body + directory + struct.pack(order + "I", 0) + more)


def as_bytes(values):
    return (values * 255).round().astype("u1")


def as_words(values):
    return (values * 65535).round().astype("u2")


def make_tiffs(rgb, grey, alpha):
    rgba, grey_alpha = numpy.dstack([rgb, alpha]), numpy.dstack([grey, alpha])
    premultiplied = numpy.dstack([rgb * alpha[..., None], alpha])
    tiff("grey.tif", as_bytes(grey), GREY)
    tiff("grey_white.tif", as_bytes(grey), 0)
    tiff("grey16.tif", as_words(grey), GREY, order=">")
    tiff("grey_signed.tif", (grey * 32767).astype("i2"), GREY, sample_format=[2])
    tiff("grey_straight.tif", as_bytes(grey_alpha), GREY, alpha=[STRAIGHT])
    tiff("grey_associated.tif", as_bytes(grey_alpha * alpha[..., None]), GREY, alpha=[ASSOCIATED])
    tiff("grey_unknown.tif", as_bytes(grey_alpha), GREY, alpha=[NO_ALPHA])
    tiff("packbits.tif", as_bytes(rgb), COLOR, compression=32773)
    tiff("deflate16.tif", as_words(rgb), COLOR, compression=8)
    tiff("associated.tif", as_bytes(premultiplied), COLOR, alpha=[ASSOCIATED])
    tiff("unknown.tif", as_bytes(rgba), COLOR, alpha=[NO_ALPHA])
    tiff("straight16.tif", as_words(rgba), COLOR, alpha=[STRAIGHT])
    tiff("five.tif", as_bytes(numpy.dstack([rgba, grey])), COLOR, alpha=[STRAIGHT, NO_ALPHA])
    tiff("turned.tif", as_bytes(rgb), COLOR, orientation=[3], strip=H)
    # Words that are no multiples of 257, and words that hold bytes.
    y, x = numpy.mgrid[0:H, 0:W]
    index = (((x // 2) + (y // 2) * 2) % 6).astype("u1")
    colors = numpy.array([[63568, 500, 0], [255, 49858, 129], [9971, 10000, 63568],
                          [62000, 54843, 300], [7000, 7200, 7400], [65279, 65280, 65535]])
    words = numpy.zeros((3, 256), int)
    words[:, :6] = colors.T
    tiff("palette.tif", index, PALETTE, color_map=list(words.flat))
    tiff("palette_bytes.tif", index, PALETTE, color_map=list((words // 257).flat), compression=8)


def exr(name, channels, compression=0, corner=(0, 0), display=None, sampling=1):
    """channels: by name, f2, f4 or u4; `sampling` is that of names of two letters, the chroma."""
    def attribute(key, kind, value):
        return b"%s\0%s\0" % (key, kind) + struct.pack("<i", len(value)) + value

    def step(key):
        return sampling if len(key) == 2 else 1

    kinds = {"u4": 0, "f2": 1, "f4": 2}
    names = sorted(channels)
    entries = b"".join(
        key.encode() + b"\0" + struct.pack("<iIii", kinds[channels[key].dtype.str[1:]], 0,
                                           step(key), step(key)) for key in names)
    left, top = corner
    window = (left, top, left + W - 1, top + H - 1)
    head = struct.pack("<Ii", 20000630, 2)
    head += attribute(b"channels", b"chlist", entries + b"\0")
    head += attribute(b"compression", b"compression", bytes([compression]))
    head += attribute(b"dataWindow", b"box2i", struct.pack("<4i", *window))
    head += attribute(b"displayWindow", b"box2i", struct.pack("<4i", *(display or window)))
    head += attribute(b"lineOrder", b"lineOrder", b"\0")
    head += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
    head += attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0))
    head += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0"
    rows = {0: 1, 2: 1, 3: 16}[compression]
    chunks = []
    for y in range(0, H, rows):
        lines = range(y, min(H, y + rows))
        data = b"".join(channels[key][line // step(key)].tobytes()
                        for line in lines for key in names if line % step(key) == 0)
        if compression:
            numbers = numpy.frombuffer(data, "u1")
            numbers = numpy.concatenate([numbers[0::2], numbers[1::2]]).astype(int)
            numbers[1:] = (numpy.diff(numbers) + 128) % 256
            data = min(data, zlib.compress(numbers.astype("u1").tobytes()), key=len)
        chunks.append(struct.pack("<ii", top + y, len(data)) + data)
    start = len(head) + 8 * len(chunks)
    offsets = numpy.cumsum([start] + [len(chunk) for chunk in chunks[:-1]])
    (HERE / name).write_bytes(head + offsets.astype("<u8").tobytes() + b"".join(chunks))


def make_exrs(rgb, grey, alpha):
    # Not representable as half floats.
    r, g, b = (rgb[..., i].astype("f4") * 1.3 + 0.0003 for i in range(3))
    y, a = grey.astype("f4") * 1.1 + 0.0007, alpha.astype("f4")

    def half(values):
        return values.astype("f2")

    colors = {"R": half(r), "G": half(g), "B": half(b)}
    exr("none.exr", colors)
    exr("zips.exr", colors, 2)
    exr("zip_float.exr", {"R": r, "G": g, "B": b}, 3)
    exr("rgba_mixed.exr", {"R": half(r * a), "G": g * a, "B": b * a, "A": half(a), "Z": y}, 3)
    exr("grey.exr", {"Y": half(y)}, 3)
    exr("grey_alpha.exr", {"Y": half(y * a), "A": half(a)}, 2)
    quarter = half(rgb[::2, ::2, 0] - 0.5) * half(numpy.float32(0.3))
    exr("chroma.exr", {"Y": half(y), "RY": quarter, "BY": quarter}, 3, sampling=2)
    exr("red.exr", {"R": half(r)}, 3)
    exr("layer.exr", {**colors, "x.R": half(b), "x.G": half(b), "x.B": half(r)}, 3)
    exr("unsigned.exr", {key: value.astype("u4") for key, value in zip("RGB", (r * 2, g * 3, b))})
    exr("negative.exr", {key: half(value - 0.5) for key, value in zip("RGB", (r, g, b))}, 3)
    exr("window.exr", colors, 3, corner=(5, 3), display=(0, 0, 29, 29))


def main():
    rgb, alpha = ramp(), alpha_ramp()
    grey = rgb[..., 0] * 0.7 + rgb[..., 1] * 0.3
    make_tiffs(rgb, grey, alpha)
    make_exrs(rgb, grey, alpha)


if __name__ == "__main__":
    main()
