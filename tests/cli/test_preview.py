"""--preview: whoever opens the growing picture finds a whole, valid one."""
import subprocess
import time
import unittest

import picture_files
from render_case import DURER, SLOW_SCENE, RenderCase


class Preview(RenderCase):
    def watch(self, letter, extension):
        self.write("scene.pov", SLOW_SCENE)
        name = f"picture.{extension}"
        command = [DURER, "scene.pov", "+W120", "+H90", "+A0.1", "+BS8", "+WT2", "+F" + letter,
                   "--preview", "0.02", "-GA", "+O" + name]
        run = subprocess.Popen(command, cwd=self.folder, stderr=subprocess.DEVNULL)
        filled = []
        while run.poll() is None:
            try:
                pixels, _ = picture_files.read(self.folder / name)
            except FileNotFoundError:
                time.sleep(0.005)
                continue
            self.assertEqual(pixels.shape[:2], (90, 120))
            filled.append((pixels > 0).any(axis=2).mean())
        self.assertEqual(run.returncode, 0)
        self.assertGreaterEqual(len(filled), 2, "no preview was seen")
        self.assertEqual(filled, sorted(filled), "the picture does not grow")
        self.assertLess(filled[0], 1)
        previewed = self.bytes_of(name)
        self.durer(*command[1:-4], "-GA", "+O" + name)
        self.assertEqual(self.bytes_of(name), previewed)
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_png(self):
        self.watch("N", "png")

    def test_targa(self):
        self.watch("T", "tga")


if __name__ == "__main__":
    unittest.main()
