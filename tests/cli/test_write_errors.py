"""Pictures that cannot be written: a clear message, status 1, and no half picture under its name."""
import resource
import subprocess
import unittest

from render_case import DURER, RenderCase

SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
plane { z, 1 pigment { granite scale 0.1 } finish { ambient 1 diffuse 0 } }"""


class WriteErrors(RenderCase):
    def setUp(self):
        super().setUp()
        self.write("scene.pov", SCENE)

    def fails(self, *options, expect, limit=None, **keywords):
        def set_limit():
            if limit is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        run = subprocess.run([DURER, "scene.pov", "+W64", "+H48", *options], cwd=self.folder,
                             stderr=subprocess.PIPE, text=True, timeout=60, preexec_fn=set_limit,
                             **keywords)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn(expect, run.stderr)
        return run.stderr

    def test_missing_folder(self):
        self.fails("+Onowhere/picture.png", expect="nowhere/picture.png")

    def test_folder_of_that_name(self):
        (self.folder / "picture.png").mkdir()
        self.fails("+Opicture.png", expect="it is a folder")

    def test_full_disk(self):
        """Each file may have a few kilobytes: the picture does not fit."""
        for letter, extension in (("N", "png"), ("T", "tga"), ("P", "ppm"), ("B", "bmp"),
                                  ("E", "exr"), ("J", "jpg")):
            with self.subTest(format=letter):
                message = self.fails("+F" + letter, f"+Opicture.{extension}", "Compression=100",
                                     expect="cannot write 'picture", limit=2000)
                self.assertIn("File too large", message)
                self.assertEqual(list(self.folder.glob(f"picture.{extension}*")), [])

    def test_continue_after_a_failed_write(self):
        """Neither the blocks nor the picture had room; +C makes the picture once there is some."""
        message = self.fails("+Opicture.png", "+FN16", expect="cannot write", limit=2000)
        self.assertIn("cannot be kept", message)
        self.durer("scene.pov", "+W64", "+H48", "+FN16", "+Owhole.png")
        self.durer("scene.pov", "+W64", "+H48", "+FN16", "+Opicture.png", "+C")
        self.assertEqual(self.bytes_of("picture.png"), self.bytes_of("whole.png"))

    def test_full_standard_output(self):
        for letter in "NPT":
            with self.subTest(format=letter), open("/dev/full", "wb") as full:
                self.fails("+O-", "+F" + letter, expect="No space left", stdout=full)


if __name__ == "__main__":
    unittest.main()
