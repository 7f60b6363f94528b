"""Input that nobody means: nesting without end, files that are no scenes, torn and flipped images.

Each run has little processor time and memory. It ends with a whole picture, or with an error that names
a place and leaves no picture; it never crashes or hangs.

    absurd_input_test.py DURER
"""
import random
import re
import resource
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

SECONDS = 10  # of processor time; sanitizers make it ten times as long
BYTES = 4 << 30
HEAD = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 } light_source { <1, 2, -3>, 1 }
"""
DEEP = 100000
REPORT = re.compile(r"Sanitizer|runtime error: |Assertion ")
PLACE = re.compile(r"^.+:\d+:\d+: error: .+\n  .*\n *\^$", re.MULTILINE)


def within(before, middle, after, levels=DEEP):
    return HEAD + before * levels + middle + after * levels


def again(declaration, name, times=20000):
    """A declaration that contains what it declares, again and again."""
    return HEAD + f"{declaration[0]} #for (I, 1, {times}) #declare {name} = {declaration[1]} #end"


# These stop with an error.
NESTED = {
    "unions": within("union { ", "sphere { 0, 1 }", " }"),
    "differences": within("difference { ", "sphere { 0, 1 }", " sphere { 1, 1 } }"),
    "objects": within("object { ", "sphere { 0, 1 }", " }"),
    "blocks without end": HEAD + "union { " * DEEP,
    "parentheses": within("(", "1", ")").replace("(", "#declare X = (", 1),
    "signs": HEAD + "#declare X = " + "-" * DEEP + "1;",
    "vectors": within("<", "1", ">").replace("<(", "#declare X = <(", 1),
    "float functions": HEAD + "#declare X = " + "sin(" * DEEP + "1" + ")" * DEEP + ";",
    "functions": HEAD + "#declare F = function { " + "sin(" * DEEP + "x" + ")" * DEEP + " }",
    "strings": HEAD + "#debug " + "concat(" * DEEP + '"a"' + ")" * DEEP,
    "macro calls": HEAD + "#macro M(A) A #end #declare X = " + "M(" * DEEP + "1" + ")" * DEEP + ";",
    "unions that double": again(("#declare A = sphere { 0, 1 }",
                                 "union { object { A } object { A } }"), "A", 60) + " A",
    "differences that double": again(("#declare A = sphere { 0, 1 }",
                                      "difference { object { A } object { A } }"), "A", 60) + " A",
    "unions in clips that double": again(("#declare A = sphere { 0, 1 }",
                                          "union { object { A } object { A } }"), "A", 60)
    + " object { A bounded_by { object { A } } clipped_by { object { A } } }",
    "clips that double": again(("#declare A = sphere { 0, 1 }",
                                "object { A clipped_by { object { A } } }"), "A", 60) + " A",
    "an include without end": HEAD + '#include "/dev/zero"',
    "data without end": HEAD + '#fopen F "/dev/zero" read #read (F, A)',
    "a font that is none": HEAD + 'text { ttf "/dev/null" "abc" 1, 0 }',
    "densities that are none": HEAD + 'plane { y, 0 pigment { density_file df3 "/dev/null" } }',
    "macros that call themselves": HEAD + "#macro M(A) M(A + 1) #end M(0)",
    "conditions": HEAD + "#if (1)\n" * DEEP + "#end\n" * DEEP,
    "loops without end": HEAD + "#while (1) #end",
    "includes": HEAD + '#include "scene.pov"',
    "maps": HEAD + "sphere { 0, 1 pigment { " + "gradient x pigment_map { [0 " * DEEP,
    "lights' looks": HEAD + "light_source { 0, 1 looks_like { " * DEEP,
    "declared solids": again(("#declare A = sphere { 0, 1 }",
                              "difference { object { A } sphere { I, 1 } }"), "A"),
    "declared clips": again(("#declare A = sphere { 0, 1 }",
                             "object { A clipped_by { object { A } } }"), "A"),
    "declared pigments": again(("#declare P = pigment { rgb 1 }",
                                "pigment { gradient x pigment_map { [0 P] [1 P] } }"), "P"),
    "declared patterns": again(("#declare O = sphere { 0, 1 }",
                                "sphere { 0, 1 pigment { object { O rgb 0 rgb 1 } } }"), "O"),
    "declared arrays": again(("#declare A = array[1] { 1 }", "array[1] { A }"), "A"),
    "strings that double": again(('#declare S = "a";', "concat(S, S)"), "S", 60),
    "arrays": HEAD + "#declare A = array[1000000000][1000000000]",
    "prisms": HEAD + "prism { 0, 1, 2000000000, <0, 0> }",
    "meshes": HEAD + "mesh2 { vertex_vectors { 2000000000, <0, 0, 0> } }",
    "faces": HEAD + "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 20000> } }",
}
NO_SCENES = {
    "a picture": b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR",
    "all bytes": bytes(range(256)),
    "16-bit text": b"\xff\xfe" + HEAD.encode("utf-16-le"),
    "a string without end": HEAD.encode() + b'#debug "' + b"a" * DEEP,
    "a comment without end": HEAD.encode() + b"/*" * DEEP,
}
# These are rendered.
SCENES = {
    "nothing": b"",
    "a zero": HEAD.encode() + b"sphere { 0, 1\0pigment { rgb 1 } }",
    "a mark of UTF-8": b"\xef\xbb\xbf" + HEAD.encode() + b"sphere { 0, 1 }",
    "old line ends": (HEAD + "sphere { 0, 1 }").replace("\n", "\r").encode(),
    "a long line": HEAD.encode() + b"".join(b"sphere { %d, 1 }" % i for i in range(20000)),
    "spheres in one place": HEAD.encode() + b"sphere { 0, 1 }" * 5000,
    "a long line of blanks": HEAD.encode() + b" " * 10000000,
    "a long sum": (HEAD + "#declare X = " + "1 + " * DEEP + "1;").encode(),
    "a spline of many points": (HEAD + "#declare S = spline { natural_spline "
                                + " ".join(f"{i}, <{i}, 0, 0>" for i in range(DEEP))
                                + " } sphere { S(7.5), 1 }").encode(),
    "no numbers": (HEAD + "#declare I = 1e308*10; #declare N = I - I;\n"
                   "#declare S = spline { cubic_spline N, x N, y 2, z 3, x 4, y }\n"
                   "sphere { S(N), 1 } sphere { S(2.5), 1 } sphere { 0, N } box { N, I }\n"
                   "blob { threshold 0.5 #for (I, 0, 40) sphere { <N, I, 0>, 1, 1 } #end }\n"
                   "sphere_sweep { b_spline 5 #for (I, 0, 4) <I, N, 0>, 0.5 #end }\n"
                   "sphere { 0, 1 pigment { bozo turbulence N scale <N, 1, I> } rotate I*x }").encode(),
}


def png():
    rows = b"".join(b"\0" + bytes((x * y) % 4 for x in range(9)) for y in range(7))
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", 9, 7, 8, 3, 0, 0, 0)), (b"PLTE", bytes(range(12))),
              (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks)


IMAGES = {
    "png": png(),
    "ppm": b"P6\n3 2\n255\n" + bytes(range(18)),
    "pgm": b"P2\n# grey\n3 2\n65535\n0 9 99 999 9999 65535\n",
    "gif": b"GIF89a\x03\0\x02\0\xf0\0\0\0\0\0\xff\xff\xff,\0\0\0\0\x03\0\x02\0\0\x02\x03\x84\x1fQ\0;",
    "tga": b"\0\0\x0a" + b"\0" * 9 + struct.pack("<HHBB", 3, 2, 24, 0) + b"\x85abc",
    "bmp": b"BM\x4e\0\0\0\0\0\0\0\x36\0\0\0" + struct.pack("<IiiHHIIiiII", 40, 3, 2, 1, 24, 0, 24, 0, 0, 0, 0)
           + bytes(range(24)),
    "hdr": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n" + (b"\2\2\0\x09" + b"\x89\x50" * 4) * 2,
}


def broken(data, seed):
    """Torn at some places, single bytes and numbers changed at others."""
    draw = random.Random(seed)
    for length in sorted(draw.sample(range(len(data)), 6)):
        yield data[:length]
    for _ in range(8):
        place = draw.randrange(len(data))
        yield data[:place] + bytes([draw.choice((0, 1, 127, 128, 255))]) + data[place + 1:]
    for _ in range(4):
        place = draw.randrange(min(32, len(data) - 4))
        yield data[:place] + draw.choice((b"\xff\xff\xff\xff", b"\x7f\xff", b"\0\0\0\0")) + data[place + 4:]


class AbsurdInput(unittest.TestCase):
    durer, sanitized = "", False

    def run_durer(self, content, files=()):
        """Exit status, once all that holds for any input was looked at."""
        seconds = SECONDS * (10 if self.sanitized else 1)

        def limits():
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if not self.sanitized:
                resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "scene.pov").write_bytes(content)
            for file, data in files:
                (folder / file).write_bytes(data)
            done = subprocess.run(
                [self.durer, "scene.pov", "+W8", "+H6", "+WT1", "-D", "-GR", "-GS", "+Opicture.png",
                 "--max-loop-turns", "100000"], cwd=folder, stdin=subprocess.DEVNULL,
                capture_output=True, timeout=20 * seconds, preexec_fn=limits, check=False)
            messages = done.stderr.decode("latin-1")
            self.assertNotRegex(messages, REPORT)
            self.assertIn(done.returncode, (0, 1), messages[-2000:])
            left = {file.name for file in folder.iterdir()} - {"scene.pov", *(f for f, _ in files)}
            self.assertEqual(left, set() if done.returncode else {"picture.png"})
            if done.returncode:
                self.assertRegex(messages, PLACE)
            else:
                self.assertIn(b"IEND", (folder / "picture.png").read_bytes())
        return done.returncode

    def test_nesting_and_size(self):
        for name, text in NESTED.items():
            with self.subTest(name):
                self.assertEqual(self.run_durer(text.encode()), 1)

    def test_no_scenes(self):
        for name, content in NO_SCENES.items():
            with self.subTest(name):
                self.assertEqual(self.run_durer(content), 1)

    def test_odd_scenes(self):
        for name, content in SCENES.items():
            with self.subTest(name):
                self.assertEqual(self.run_durer(content), 0)

    def test_broken_images(self):
        for number, (kind, data) in enumerate(IMAGES.items()):
            use = HEAD + (f'plane {{ z, 0 pigment {{ image_map {{ {kind} "image.{kind}" }} '
                          "} finish { ambient 1 } }")
            with self.subTest(kind):
                self.assertEqual(self.run_durer(use.encode(), [(f"image.{kind}", data)]), 0)
            for case, torn in enumerate(broken(data, 1525 + number)):
                with self.subTest(kind, case=case):
                    self.run_durer(use.encode(), [(f"image.{kind}", torn)])


if __name__ == "__main__":
    AbsurdInput.durer = str(Path(sys.argv[1]).resolve())
    AbsurdInput.sanitized = "__asan_init" in subprocess.run(
        ["nm", "-D", AbsurdInput.durer], capture_output=True, text=True, check=False).stdout
    unittest.main(argv=sys.argv[:1])
