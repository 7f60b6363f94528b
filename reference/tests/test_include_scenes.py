"""The scenes made of the standard includes."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import include_scenes


class IncludeScenes(unittest.TestCase):
    def test_every_kind_is_found(self):
        kinds = {kind for file in include_scenes.FILES for kind in include_scenes.declared(file).values()}
        self.assertEqual(kinds, {*include_scenes.LOOKS, "sky_sphere"})

    def test_a_name_is_of_the_kind_of_what_it_names(self):
        golds = include_scenes.declared("golds.inc")
        self.assertEqual(golds["T_Gold_1A"], "texture")
        self.assertEqual(golds["F_MetalA"], "finish")
        self.assertNotIn("P_Gold1", golds)  # a colour

    def test_scenes_are_written_once(self):
        with tempfile.TemporaryDirectory() as folder:
            include_scenes.write(Path(folder), ["skies.inc"])
            paths = sorted(Path(folder).rglob("*.pov"))
            self.assertEqual(len(paths), 12)
            self.assertIn("sky_sphere { S_Cloud1 }", (Path(folder) / "skies.inc/S_Cloud1.pov").read_text())
            times = [path.stat().st_mtime_ns for path in paths]
            include_scenes.write(Path(folder), ["skies.inc"])
            self.assertEqual([path.stat().st_mtime_ns for path in paths], times)


if __name__ == "__main__":
    unittest.main()
