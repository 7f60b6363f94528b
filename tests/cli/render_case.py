"""A folder in memory, durer, povray and small scenes for the tests of this folder."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy

DURER = os.environ["DURER_BINARY"]

# Takes a second or two: glass and soft shadows.
SLOW_SCENE = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2, -6> look_at 0 }
light_source { <5, 8, -6>, 1 area_light 2*x, 2*z, 9, 9 }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.2 } finish { reflection 0.3 } }
#for (I, 0, 8)
  sphere { <mod(I, 3) - 1, div(I, 3)*0.7 - 0.5, mod(I, 2)>, 0.4
    pigment { bozo color_map { [0 rgbf <1, 0.8, 0.6, 0.7>] [1 rgbf <0.5, 0.8, 1, 0.9>] } scale 0.2 }
    finish { phong 0.6 reflection 0.2 } interior { ior 1.4 } }
#end
background { rgb <0.2, 0.3, 0.5> }
"""

# Each pixel is a pixel of in.ppm: both programs compute the same bits.
EXACT_SCENE = """#version 3.7;
global_settings {{ assumed_gamma {gamma} }}
camera {{ orthographic location <0.5, 0.5, -5> direction z right x up y }}
plane {{ z, 0 pigment {{ image_map {{ ppm "in.ppm" {more} }} }} finish {{ ambient 1 diffuse 0 }} }}
background {{ rgbt <0.1, 0.2, 0.3, 0.5> }}
"""
WIDTH, HEIGHT = 24, 16


def input_picture():
    """16-bit colours: ramps, nearly black, nearly white and noise."""
    y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH]
    noise = numpy.random.default_rng(1525).integers(0, 65536, (HEIGHT, WIDTH, 3))
    noise[..., 0] = x * 65535 // (WIDTH - 1)
    noise[5:11, :, 1] = (y * 3000 + x * 40)[5:11]
    noise[11:, :, 2] = x[11:] * 30
    return b"P6\n%d %d\n65535\n" % (WIDTH, HEIGHT) + noise.astype(">u2").tobytes()


class RenderCase(unittest.TestCase):
    def setUp(self):
        memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
        folder = tempfile.TemporaryDirectory(prefix="durer-cli-", dir=memory)
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def run_program(self, command, **keywords):
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True,
                              timeout=120, **keywords)

    def durer(self, *arguments, status=0):
        run = self.run_program([DURER, *arguments])
        self.assertEqual(run.returncode, status, run.stderr)
        return run

    def povray(self, *arguments):
        run = self.run_program(["povray", *arguments, "-D", "-GA", "+WT1"])
        self.assertEqual(run.returncode, 0, run.stderr)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()
