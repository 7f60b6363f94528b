"""The harness against stand-ins for durer that succeed, fail, crash and hang."""
import os
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REFERENCE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(REFERENCE))
import animations
import grades
import known_differences
import renderers
import report
import suites

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
light_source { <2, 4, -3> rgb 1 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } }
"""


class Compare(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR", "/tmp"))
        self.folder = Path(self.holder.name)
        (self.folder / "scene").mkdir()
        self.scene = self.folder / "scene" / "ball.pov"
        self.scene.write_text(SCENE)

    def tearDown(self):
        self.holder.cleanup()

    def compare(self, script, *options):
        stand_in = self.folder / "durer"
        stand_in.write_text("#!/bin/sh\n" + script + "\n")
        stand_in.chmod(stand_in.stat().st_mode | stat.S_IXUSR)
        out = self.folder / "out"
        done = subprocess.run([REFERENCE / "compare", self.scene, "--durer", stand_in, "--out", out,
                               "--antialias", "no", *options],
                              capture_output=True, text=True, check=False,
                              env={**os.environ, "XDG_CACHE_HOME": str(self.folder / "cache")})
        self.assertTrue((out / "compare.tsv").exists(), done.stdout + done.stderr)
        rows = report.read_tsv(out / "compare.tsv")
        self.assertEqual(len(rows), 1)
        return rows[0], done, out

    def test_povray_itself_is_exact(self):
        row, _, out = self.compare('HOME=$(dirname "$PWD") exec povray "$@"')
        self.assertEqual((row.grade, row.verdict, row.random), ("exact", "pass", "no"), row.error)
        self.assertIn("file_ball", (out / "index.html").read_text())
        self.assertEqual(len(list((out / "pictures").iterdir())), 3)

    def test_failures(self):
        for script, grade, error in (
                ("echo 'ball.pov:5: not supported yet: sphere' >&2; exit 3", "unsupported",
                 "ball.pov:5: not supported yet: sphere"),
                ("echo working; echo 'ball.pov:1:2: error: bad' >&2; exit 1", "error",
                 "ball.pov:1:2: error: bad"),
                ("kill -SEGV $$", "crash", "SIGSEGV"),
                ("exit 0", "error", "exit code 0 but no picture")):
            row, _, _ = self.compare(script)
            self.assertEqual((row.grade, row.verdict, row.error), (grade, "fail", error))

    def test_endless_loop(self):
        row, _, _ = self.compare("while :; do :; done", "--timeout", "1")
        self.assertEqual(row.grade, "timeout")

    def test_diff_finds_what_got_worse(self):
        _, _, out = self.compare("exit 3")
        old = self.folder / "old.tsv"
        old.write_bytes((out / "compare.tsv").read_bytes())
        _, same, _ = self.compare("exit 3", "--diff", old)
        self.assertEqual(same.returncode, 0, same.stdout)
        _, worse, _ = self.compare("kill -SEGV $$", "--diff", old)
        self.assertEqual(worse.returncode, 1)
        self.assertIn("unsupported -> crash", worse.stdout)


class Frames(unittest.TestCase):
    """Scenes that povray renders only as a frame of an animation."""
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.scene = Path(self.holder.name) / "scene" / "shelf.pov"
        self.scene.parent.mkdir()
        self.scene.write_text("#declare Colors = array[5] {rgb 1, rgb 1, rgb <0, 1, 0>, rgb 1, rgb 1}\n"
                              + SCENE.replace("rgb <1, 0.5, 0.2>", "Colors[frame_number - 1]"))

    def tearDown(self):
        self.holder.cleanup()

    def write_ini(self, text):
        self.scene.with_suffix(".ini").write_bytes(text)

    def test_ini_beside_the_scene_names_the_frames(self):
        self.assertEqual(animations.frame_options(self.scene), ())
        self.write_ini(b"+w200 ; not these\r\nInitial_Frame=1\r\n;Final_Frame=9\r\nFinal_Frame= 4\r\n"
                       b"Initial_Clock=0\r\nFinal_Clock=2.5\r\n")
        self.assertEqual(animations.frame_options(self.scene),
                         ("+KFI1", "+KFF4", "+KI0", "+KF2.5", "+SF2", "+EF2"))
        self.write_ini(b"Initial_Frame=1\nFinal_Frame=\nInitial_Clock=0\n")
        self.assertEqual(animations.frame_options(self.scene), ())

    def test_the_frame_is_the_picture(self):
        scene = suites.Scene("file", "shelf", self.scene)
        still = renderers.run_povray(scene, ("+W8", "+H6"), 30, 10,
                                     self.scene.parent / "still.png")
        self.assertIsNone(still.path)
        self.write_ini(b"Initial_Frame=1\nFinal_Frame=5\n")
        framed = suites.Scene("file", "shelf", self.scene, animations.frame_options(self.scene))
        self.assertNotEqual(framed.options, ())
        picture = renderers.run_povray(framed, ("+W8", "+H6"), 30, 10,
                                       self.scene.parent / "frame.png")
        self.assertIsNotNone(picture.path, picture.error)
        red, green, blue = grades.read_pixels(picture.path)[3, 4]
        self.assertEqual((red, blue), (0, 0))
        self.assertGreater(green, 50)

    def test_survey_draws_as_frames_only_what_needs_it(self):
        survey = suites.read_survey("examples")
        framed = {scene.name: scene for scene in suites.find_scenes(["examples"]) if scene.options}
        self.assertEqual(set(framed), {name for name, entry in survey.items() if entry.options})
        for scene in framed.values():
            self.assertEqual(survey[scene.name].renders, "yes")
            self.assertEqual(scene.options, animations.frame_options(scene.path))
        self.assertIn("portfolio/t_woods", framed)
        self.assertNotIn("portfolio/o_shapes", framed)


class Scenes(unittest.TestCase):
    def test_hash_depends_on_includes_but_not_on_neighbours(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "one.pov"
            path.write_text(SCENE)
            scene = suites.Scene("file", "one", path)
            first = scene.content_hash()
            (Path(folder) / "neighbour.pov").write_text(SCENE)
            self.assertEqual(scene.content_hash(), first)
            (Path(folder) / "shapes.inc").write_text("")
            self.assertNotEqual(scene.content_hash(), first)

    def test_examples_are_all_there(self):
        self.assertEqual(len(suites.find_scenes(["examples"])), 396)
        self.assertGreater(len(suites.find_scenes(["examples/textures"])), 10)

    def test_survey_names_scenes_that_exist(self):
        names = {scene.name for scene in suites.find_scenes(["examples"])}
        survey = suites.read_survey("examples")
        self.assertEqual(set(survey), names)
        self.assertGreater(sum(entry.renders == "yes" for entry in survey.values()), 385)

    def test_known_differences_are_well_formed(self):
        known = known_differences.read()
        labels = {scene.label for scene in suites.find_scenes(["examples", "ours"])}
        self.assertLessEqual(set(known), labels)


if __name__ == "__main__":
    unittest.main()
