#!/usr/bin/python3
"""Makes the pictures that the scenes of this folder read, next to itself.

One per kind of file that textures can meet: grey, colour, palette, alpha, 8 and 16 bits, floats, and
the PNG chunks that tell of gamma. Those of libpng's rarer kinds are put together by hand.
"""
import struct
import subprocess
import tempfile
import zlib
from pathlib import Path

import numpy
from PIL import Image

HERE = Path(__file__).parent
W, H = 20, 14


def ramp():
    """RGB of 0..1: red to the right, green downward, a blue checker and two marked corners."""
    y, x = numpy.mgrid[0:H, 0:W]
    rgb = numpy.stack([x / (W - 1), y / (H - 1), ((x // 3 + y // 3) % 2) * 0.8 + 0.1], axis=2)
    rgb[0, 0] = 1, 1, 1
    rgb[H - 1, 0] = 1, 0.5, 0
    return rgb


def alpha_ramp():
    y, x = numpy.mgrid[0:H, 0:W]
    return ((x + y) % 9) / 8


def png(name, pixels, color_type, bits, chunks=()):
    """pixels: rows of bytes as PNG stores them."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", W, H, bits, color_type, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + bytes(row) for row in pixels), 9)
    data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head)
    for kind, content in chunks:
        data += chunk(kind, content)
    (HERE / name).write_bytes(data + chunk(b"IDAT", body) + chunk(b"IEND", b""))


def words(values):
    return [row.astype(">u2").tobytes() for row in values.reshape(H, -1)]


def main():
    rgb, alpha = ramp(), alpha_ramp()
    bytes8 = (rgb * 255).round().astype("u1")
    words16 = (rgb * 65535).round()
    grey8 = (rgb[..., 0] * 0.7 + rgb[..., 1] * 0.3) * 255
    grey8 = grey8.round().astype("u1")
    rgba = numpy.dstack([bytes8, (alpha * 255).round().astype("u1")])

    png("rgb.png", bytes8.reshape(H, -1), 2, 8)
    png("rgb_srgb.png", bytes8.reshape(H, -1), 2, 8, [(b"sRGB", b"\0")])
    png("rgb_gama_linear.png", bytes8.reshape(H, -1), 2, 8, [(b"gAMA", struct.pack(">I", 100000))])
    png("rgb_gama_1_8.png", bytes8.reshape(H, -1), 2, 8, [(b"gAMA", struct.pack(">I", 55556))])
    png("rgb16.png", words(words16), 2, 16)
    png("rgb_key.png", bytes8.reshape(H, -1), 2, 8, [(b"tRNS", struct.pack(">HHH", 255, 255, 255))])
    png("grey.png", grey8, 0, 8)
    png("grey16.png", words((grey8.astype("u4") * 257 + 31).clip(0, 65535)), 0, 16)
    png("grey_alpha.png", numpy.dstack([grey8, rgba[..., 3]]).reshape(H, -1), 4, 8)
    png("rgba.png", rgba.reshape(H, -1), 6, 8)
    png("rgba16.png", words(numpy.dstack([words16, (alpha * 65535).round()])), 6, 16)

    palette = numpy.array([[255, 0, 0], [0, 200, 0], [40, 40, 255], [255, 220, 0], [30, 30, 30],
                           [255, 255, 255]], "u1")
    y, x = numpy.mgrid[0:H, 0:W]
    index = (((x // 2) + (y // 2) * 2) % 6).astype("u1")
    png("palette.png", index, 3, 8, [(b"PLTE", palette.tobytes())])
    png("palette_alpha.png", index, 3, 8,
        [(b"PLTE", palette.tobytes()), (b"tRNS", bytes([255, 128, 0, 200]))])
    packed = (index[:, 0::2] << 4) | index[:, 1::2]
    png("palette4.png", packed, 3, 4, [(b"PLTE", palette.tobytes())])

    indexed = Image.fromarray(index, "P")
    indexed.putpalette(palette.tobytes())
    indexed.save(HERE / "palette.gif")
    indexed.save(HERE / "palette.bmp")
    color = Image.fromarray(bytes8, "RGB")
    color.save(HERE / "rgb.bmp")
    color.save(HERE / "rgb.tga", compression="tga_rle")
    color.save(HERE / "rgb.tif")
    color.save(HERE / "rgb.jpg", quality=95, subsampling=0)
    Image.fromarray(grey8, "L").save(HERE / "grey.jpg", quality=95)
    Image.fromarray(grey8, "L").save(HERE / "grey.tga")
    Image.fromarray(rgba, "RGBA").save(HERE / "rgba.tga")
    Image.fromarray(rgba, "RGBA").save(HERE / "rgba.tif")
    (HERE / "rgb.ppm").write_bytes(b"P6\n# raw\n20 14\n255\n" + bytes8.tobytes())
    (HERE / "rgb16.ppm").write_bytes(b"P6\n20 14\n65535\n" + b"".join(words(words16)))
    (HERE / "plain.ppm").write_text("P3\n20 14\n31\n" + "\n".join(
        " ".join(str(v) for v in row) for row in (rgb.reshape(H, -1) * 31).round().astype(int)))
    (HERE / "grey.pgm").write_bytes(b"P5\n20 14\n255\n" + grey8.tobytes())

    # Floats come from povray: values above 1, and alpha.
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "floats.pov"
        scene.write_text("""#version 3.7; global_settings { assumed_gamma 1 }
            camera { orthographic location <0.5, 0.5, -1> right x up y direction z }
            plane { z, 0 pigment { image_map { ppm "%s" transmit all 0.4 } }
                    finish { ambient 2.5 diffuse 0 } }
            background { rgbt <0.1, 0.2, 0.6, 1> }""" % (HERE / "rgb.ppm"))
        for kind, extra in (("exr", ("+FE", "+UA")), ("hdr", ("+FH",))):
            subprocess.run(["povray", str(scene), f"+W{W}", f"+H{H}", "-D", "-GA", *extra,
                            f"+O{HERE}/floats.{kind}"], check=True, capture_output=True)


if __name__ == "__main__":
    main()
