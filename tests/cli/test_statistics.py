"""--stats: counts that must come out for scenes simple enough to count by hand."""
import json
import unittest

from render_case import RenderCase


class Statistics(RenderCase):
    def figures(self, scene, *options):
        self.write("scene.pov", "#version 3.7; global_settings { assumed_gamma 1 }\n" + scene)
        self.durer("scene.pov", "+W20", "+H10", "+Oout.png", "--stats", "stats.json", "-GA", *options)
        return json.loads(self.bytes_of("stats.json"))

    def test_counts(self):
        scene = "plane { z, 5 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }"
        for threads in (1, 3):
            frame, = self.figures(scene, f"+WT{threads}", "+BS4")["frames"]
            self.assertEqual(frame["samples"], 200)
            self.assertEqual(frame["rays"]["primary"], 200)
            self.assertEqual(frame["rays"]["shadow"], 0)
            self.assertEqual(frame["shape_tests"], {"plane": {"tests": 200, "hits": 200}})

    def test_rays_by_kind(self):
        scene = """light_source { <0, 9, -9>, 1 }
            plane { z, 5 pigment { rgb 1 } finish { reflection 0.5 } }
            plane { z, -5 pigment { rgb 0.5 } finish { ambient 1 diffuse 0 } no_shadow }"""
        frame, = self.figures(scene)["frames"]
        self.assertEqual(frame["rays"]["reflected"], 200)
        self.assertGreater(frame["rays"]["shadow"], 0)

    def test_times_and_memory(self):
        run = self.figures("sphere { 0, 1 }")
        self.assertGreater(run["peak_memory_kilobytes"], 1000)
        self.assertGreater(run["cpu_seconds"], 0)
        for phase in ("parse", "build", "render", "write"):
            self.assertGreaterEqual(run["frames"][0][phase + "_seconds"], 0)

    def test_any_file_name(self):
        name = 'a "quoted" \\ \n b\u00e9 \udcff.pov'  # its last byte is no UTF-8
        (self.folder / name).write_text("#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }")
        self.durer("--input", name, "+W4", "+H3", "-GA", "--stats", "stats.json")
        run = json.loads(self.bytes_of("stats.json"))
        self.assertEqual(run["scene"], name)
        self.assertEqual(run["frames"][0]["output"], name.replace(".pov", ".png"))


if __name__ == "__main__":
    unittest.main()
