"""Reads every format that POV-Ray writes, to numbers as they are stored. PIL knows too few of them."""
import struct
import zlib

import numpy
from PIL import Image


class BrokenPicture(Exception):
    pass


def read(path):
    """Rows x columns x channels of floats, and what else the file says."""
    reader = {"png": read_png, "ppm": read_pnm, "hdr": read_hdr, "exr": read_exr,
              "bmp": read_bmp}.get(str(path).rsplit(".", 1)[1], read_with_pil)
    with open(path, "rb") as file:
        data = file.read()
    try:
        return reader(data) if reader is not read_with_pil else read_with_pil(path)
    except (IndexError, ValueError, struct.error, zlib.error) as error:
        raise BrokenPicture(f"{path}: {error}") from error


def read_with_pil(path):
    with Image.open(path) as image:
        return numpy.asarray(image).astype(float), image.mode


def read_pnm(data):
    tokens, at = [], 0
    while len(tokens) < 4:
        while data[at:at + 1].isspace():
            at += 1
        if data[at:at + 1] == b"#":
            at = data.index(b"\n", at)
            continue
        end = at
        while not data[end:end + 1].isspace():
            end += 1
        tokens.append(data[at:end])
        at = end
    width, height, most = (int(token) for token in tokens[1:])
    channels = 3 if tokens[0] == b"P6" else 1
    count = width * height * channels
    # POV-Ray's grey PPM has two bytes a value whatever its header says.
    kind = ">u2" if len(data) - at - 1 >= 2 * count else "u1"
    return (numpy.frombuffer(data, kind, count, at + 1).reshape(height, width, channels)
            .astype(float)), most


def read_bmp(data):
    start, = struct.unpack_from("<I", data, 10)
    width, height, _, bits = struct.unpack_from("<iiHH", data, 18)
    stride = (width * bits // 8 + 3) // 4 * 4
    rows = numpy.frombuffer(data, "u1", stride * height, start).reshape(height, stride)
    pixels = rows[::-1, :width * bits // 8].reshape(height, width, bits // 8)
    order = [2, 1, 0] + ([3] if bits == 32 else [])
    return pixels[..., order].astype(float), bits


def read_hdr(data):
    at = data.index(b"\n\n") + 2
    end = data.index(b"\n", at)
    _, height, _, width = data[at:end].split()
    height, width, at = int(height), int(width), end + 1
    rgbe = numpy.zeros((height, width, 4), "u1")
    for y in range(height):
        if width < 8 or data[at] != 2 or data[at + 1] != 2 or data[at + 2] & 128:
            rgbe[y] = numpy.frombuffer(data, "u1", 4 * width, at).reshape(width, 4)
            at += 4 * width
            continue
        at += 4
        for channel in range(4):
            x = 0
            while x < width:
                count = data[at]
                if count > 128:
                    count -= 128
                    rgbe[y, x:x + count, channel] = data[at + 1]
                    at += 2
                else:
                    rgbe[y, x:x + count, channel] = numpy.frombuffer(data, "u1", count, at + 1)
                    at += 1 + count
                x += count
    scale = numpy.ldexp(1.0, rgbe[..., 3].astype(int) - 136)
    return rgbe[..., :3] * scale[..., None], None


def read_exr(data):
    at, attributes = 8, {}
    while data[at]:
        end = data.index(0, at)
        name = data[at:end].decode()
        at = data.index(0, end + 1) + 1
        size, = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    names, kinds, text, k = [], [], attributes["channels"], 0
    while text[k]:
        end = text.index(0, k)
        names.append(text[k:end].decode())
        kinds.append({1: "<f2", 2: "<f4"}[struct.unpack_from("<i", text, end + 1)[0]])
        k = end + 17
    lines = {0: 1, 2: 1, 3: 16}[attributes["compression"][0]]
    offsets = struct.unpack_from(f"<{(height + lines - 1) // lines}Q", data, at + 1)
    pixels = numpy.zeros((height, width, len(names)))
    for offset in offsets:
        first, size = struct.unpack_from("<ii", data, offset)
        first -= top
        rows = min(lines, height - first)
        raw = data[offset + 8:offset + 8 + size]
        if size < sum(numpy.dtype(kind).itemsize for kind in kinds) * width * rows:
            steps = numpy.frombuffer(zlib.decompress(raw), "u1").astype(int)
            steps[1:] -= 128
            halves = numpy.cumsum(steps).astype("u1")
            middle = (len(halves) + 1) // 2
            bytes_ = numpy.zeros(len(halves), "u1")
            bytes_[0::2], bytes_[1::2] = halves[:middle], halves[middle:]
            raw = bytes_.tobytes()
        at = 0
        for row in range(rows):
            for channel, kind in enumerate(kinds):
                pixels[first + row, :, channel] = numpy.frombuffer(raw, kind, width, at)
                at += width * numpy.dtype(kind).itemsize
    return pixels, names


def read_png(data):
    if data[:8] != b"\x89PNG\r\n\x1a\n" or data[-8:-4] != b"IEND":
        raise ValueError("no whole PNG")
    at, packed, chunks = 8, b"", {}
    while at < len(data):
        size, = struct.unpack_from(">I", data, at)
        kind, content = data[at + 4:at + 8], data[at + 8:at + 8 + size]
        if struct.unpack_from(">I", data, at + 8 + size)[0] != zlib.crc32(kind + content):
            raise ValueError("wrong checksum")
        at += 12 + size
        if kind == b"IDAT":
            packed += content
        else:
            chunks[kind] = content
    width, height, bits, color = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
    step = channels * bits // 8
    stride = width * step
    raw = zlib.decompress(packed)
    above = numpy.zeros(stride, int)
    rows = []
    for y in range(height):
        method = raw[y * (stride + 1)]
        row = numpy.frombuffer(raw, "u1", stride, y * (stride + 1) + 1).astype(int)
        for x in range(stride if method else 0):
            a = row[x - step] if x >= step else 0
            b = above[x]
            c = above[x - step] if x >= step else 0
            if method == 1:
                guess = a
            elif method == 2:
                guess = b
            elif method == 3:
                guess = (a + b) // 2
            else:
                p = a + b - c
                guess = min(((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c)))[2]
            row[x] = (row[x] + guess) & 255
        rows.append(row)
        above = row
    values = numpy.array(rows, "u1").tobytes()
    pixels = numpy.frombuffer(values, ">u2" if bits == 16 else "u1")
    return pixels.reshape(height, width, channels).astype(float), (bits, chunks.get(b"gAMA"))
