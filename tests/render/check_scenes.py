#!/usr/bin/python3
"""Pictures of one pixel whose values are known: spec/shading.md 19, and furnaces, whose light must stay.

usage: check_scenes.py DURER [TEST...]
"""
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

PRELUDE = """
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 2e-5*x up 2e-5*y look_at 0 }
#declare Color = rgb <.5, .25, .8>;
#macro P(F) plane { -z, 0 pigment { Color } finish { F } } #end
#macro L() light_source { <0, 3, -4> rgb 1 } #end
#macro White() plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } #end
"""

BLOCKER = """
intersection {
  box { <-50, -50, -2.001>, <50, 50, -1.999> }
  plane { -vnormalize(<1, .37, 0>), -.013 / vlength(<1, .37, 0>) }
  pigment { rgb 0 } no_image
}
"""
BACKGROUND = "background { rgb <.1, .2, .3> }"
FILTER_PLANE = ("plane { -z, 0 pigment { rgbft <.5, .25, .8, .3, .2> } finish { ambient 0 diffuse .7 } } L() "
                + BACKGROUND)
TILTED = "plane { <0, .6, -.8>, 0 pigment { Color } finish { ambient 0 diffuse 0 %s } %s } " + BACKGROUND

# name: scene text, expected linear rgb
SECTION_19 = {
    "diffuse": ("P(finish { ambient 0 diffuse .7 }) L()", (0.28, 0.14, 0.448)),
    "brilliance": ("P(finish { ambient 0 diffuse .7 brilliance 3 }) L()", (0.1792, 0.0896, 0.28672)),
    "diffuse_albedo": ("P(finish { ambient 0 diffuse albedo .7 brilliance 3 }) L()",
                       (0.3584, 0.1792, 0.57344)),
    "phong": ("P(finish { ambient 0 diffuse 0 phong .6 phong_size 7 }) L()", (0.12583,) * 3),
    "phong_metallic": ("P(finish { ambient 0 diffuse 0 phong .6 phong_size 7 metallic }) L()",
                       (0.064, 0.03309, 0.1011)),
    "specular": ("P(finish { ambient 0 diffuse 0 specular .6 }) L()", (0.20921,) * 3),
    "specular_albedo": ("P(finish { ambient 0 diffuse 0 specular albedo .1 roughness .1 }) L()",
                        (0.08998,) * 3),
    "irid": ("P(finish { ambient 0 diffuse .7 irid { .3 thickness .2 } }) L()",
             (0.19634, 0.12511, 0.448)),
    "filter_transmit": (FILTER_PLANE, (0.175, 0.125, 0.356)),
    "filter_transmit_36": ("#version 3.6;" + FILTER_PLANE, (0.1918, 0.1334, 0.38288)),
    "reflection": (TILTED % ("reflection { .1, .9 falloff 3 }", ""), (0.01064, 0.02128, 0.03192)),
    "fresnel": (TILTED % ("reflection { .8 fresnel }", "interior { ior 1.5 }"),
                (0.00351, 0.00702, 0.01053)),
    "spotlight": ("White() light_source { <0, 0, -5> rgb .5 spotlight "
                  "point_at <5*tan(radians(35)), 0, 0> }", (0.39516,) * 3),
    "cylinder": ("White() light_source { <.9, 0, -5> rgb .5 cylinder point_at <.9, 0, 0> }",
                 (0.176,) * 3),
    "fading": ("White() light_source { <0, 3, -4> rgb .5 fade_distance 3 fade_power 2 }",
               (0.21176,) * 3),
    "filtered_shadow": ("White() light_source { <0, 0, -4> rgb 1 } box { <-1, -1, -2.1>, <1, 1, -2> "
                        "pigment { rgbft <.5, .25, .8, .3, .2> } no_image }",
                        (0.1225, 0.07563, 0.1936)),
    # Colours of the sky show where the ray goes: here they are its direction.
    "refraction": ("plane { <0, .6, -.8>, 0 pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 } "
                   "interior { ior 1.5 } } sky_sphere { pigment { function { abs(y) } color_map "
                   "{ [0 rgb 0] [1 rgb 1] } } }", (0.22991,) * 3),
    "sky_sphere": ("sky_sphere { pigment { rgb <.9, .1, .2> } pigment { rgbft <.5, .25, .8, .3, .2> } "
                   "emission <1, .5, 2> }", (0.565, 0.07625, 0.976)),
    "fog": ("P(finish { ambient 0 diffuse 0 emission 1 }) fog { distance 7 rgb <.9, .1, .3> }",
            (0.70418, 0.17343, 0.54477)),
    "area_3": ("White() light_source { <0, 0, -4> rgb 1 area_light 2*x, 2*y, 3, 3 }" + BLOCKER,
               (0.625,) * 3),
    "area_5": ("White() light_source { <0, 0, -4> rgb 1 area_light 2*x, 2*y, 5, 5 }" + BLOCKER,
               (0.53125,) * 3),
}

# An even dome of lights: a white surface sends back half a unit.
DOME = """
#declare N = 3000;
#for (I, 0, N - 1)
  #declare Z = (I + .5)/N;
  #declare A = I*pi*(3 - sqrt(5));
  light_source { 1000*<sqrt(1 - Z*Z)*cos(A), sqrt(1 - Z*Z)*sin(A), -Z> rgb 1/N }
#end
"""
FURNACES = {
    "glass": ("global_settings { max_trace_level 60 adc_bailout 0 } background { rgb .5 } "
              "sphere { <.6, .3, 3>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 "
              "reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.5 } }", 1e-4),
    "mirror_box": ("global_settings { max_trace_level 40 adc_bailout 0 } background { rgb .5 } "
                   "#for (I, 0, 5) sphere { <sin(I)*1.2, cos(I)*1.2, 3>, 1 pigment { rgb 0 } "
                   "finish { ambient 0 diffuse 0 reflection 1 } } #end", 1e-4),
    "diffuse_albedo": ("diffuse albedo 1 brilliance 4", 0.01),
    "diffuse": ("diffuse 1", 0.01),
    "phong_albedo": ("diffuse 0 phong albedo 1 phong_size 9", 0.01),
    "specular_albedo": ("diffuse 0 specular albedo 1 roughness 0.2", 0.01),
}


def pixel(durer, text):
    """The only pixel of a scene in linear light, each channel 0 to 1."""
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.pov"
        scene.write_text(PRELUDE + text)
        run = subprocess.run([durer, "+Iscene.pov", "+Oout.png", "+W1", "+H1", "+FN16", "-A", "-D",
                              "File_Gamma=1.0", "-GA"], cwd=folder, capture_output=True, text=True)
        if run.returncode != 0:
            raise AssertionError(run.stderr)
        return decode((Path(folder) / "out.png").read_bytes())


def decode(png):
    """Of a PNG of one pixel with 16 bits per channel: every row filter leaves one pixel as it is."""
    data, place = b"", 8
    while place < len(png):
        size, kind = struct.unpack(">I4s", png[place:place + 8])
        if kind == b"IDAT":
            data += png[place + 8:place + 8 + size]
        place += 12 + size
    return [value / 65535 for value in struct.unpack(">3H", zlib.decompress(data)[1:7])]


class CheckScenes(unittest.TestCase):
    durer = ""

    def test_section_19(self):
        for name, (text, expected) in SECTION_19.items():
            with self.subTest(name):
                for channel, value in zip(pixel(self.durer, text), expected):
                    self.assertAlmostEqual(channel, value, delta=2.5e-5)

    def test_furnaces(self):
        for name, (text, tolerance) in FURNACES.items():
            with self.subTest(name):
                if "albedo" in name or name == "diffuse":
                    text = (f"plane {{ -z, 0 pigment {{ rgb 1 }} finish {{ ambient 0 {text} }} }}"
                            + DOME)
                for channel in pixel(self.durer, text):
                    self.assertAlmostEqual(channel, 0.5, delta=tolerance)


if __name__ == "__main__":
    CheckScenes.durer = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
