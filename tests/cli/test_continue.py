"""Interrupted renders: whatever stops them, +C gives the file that one run gives."""
import os
import signal
import subprocess
import time
import unittest

import numpy

import picture_files
from render_case import DURER, SLOW_SCENE, RenderCase

OPTIONS = ("scene.pov", "+W120", "+H90", "+A0.1", "+BS8", "-GA")
WINDOWS = (("+EC50", "+ER40"), ("+SC51", "+ER40"), ("+EC50", "+SR41"), ("+SC51", "+SR41"))

ENDLESS = "#declare I = 0;\n#while (I < 1)\n  #declare I = I / 2;\n#end\n"


class Continue(RenderCase):
    def setUp(self):
        super().setUp()
        self.write("scene.pov", SLOW_SCENE)

    def interrupted(self, name, threads, number, *more):
        """Starts a render and sends the signal once some blocks are kept. Returns the status."""
        state = self.folder / f"{name}.pov-state"
        run = subprocess.Popen([DURER, *OPTIONS, *more, f"+WT{threads}", f"+O{name}.png"],
                               cwd=self.folder, stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 60
        while run.poll() is None and time.monotonic() < deadline:
            if state.exists() and state.stat().st_size > 12000:
                break
            time.sleep(0.002)
        run.send_signal(number)
        status = run.wait(timeout=60)
        self.assertTrue(state.exists(), "the render was finished before it was stopped")
        self.assertGreater(state.stat().st_size, 12000)
        return status

    def test_kill_and_continue(self):
        self.durer(*OPTIONS, "+WT2", "+Owhole.png")
        for threads in (1, 2, 7):
            for number, status in ((signal.SIGKILL, -signal.SIGKILL), (signal.SIGINT, 2)):
                with self.subTest(threads=threads, signal=number):
                    name = f"part{threads}"
                    self.assertEqual(self.interrupted(name, threads, number), status)
                    self.assertFalse((self.folder / f"{name}.png").exists())
                    self.durer(*OPTIONS, "+C", f"+WT{threads}", f"+O{name}.png")
                    self.assertEqual(self.bytes_of(f"{name}.png"), self.bytes_of("whole.png"))
                    self.assertFalse((self.folder / f"{name}.pov-state").exists())
                    os.remove(self.folder / f"{name}.png")

    def test_terminated_render(self):
        """SIGTERM ends a render as Ctrl-C does."""
        self.durer(*OPTIONS, "+Owhole.png")
        self.assertEqual(self.interrupted("part", 2, signal.SIGTERM), 2)
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["part.pov-state", "scene.pov", "whole.png"])
        self.durer(*OPTIONS, "+C", "+Opart.png")
        self.assertEqual(self.bytes_of("part.png"), self.bytes_of("whole.png"))

    def test_stopped_while_the_scene_is_read(self):
        """There is nothing to keep yet: status 2, and the folder is as it was."""
        self.write("loop.pov", '#version 3.7;\n#debug "reading\\n"\n' + ENDLESS)
        before = sorted(os.listdir(self.folder))
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                self.assertEqual(self.stopped_while_reading("loop.pov", number, "+Oloop.png"), 2)
                self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_stopped_while_the_scene_is_read_again(self):
        """What an interrupted render has kept outlives a continuation that is stopped at once."""
        self.durer(*OPTIONS, "+Owhole.png")
        self.interrupted("part", 1, signal.SIGTERM)
        kept = self.bytes_of("part.pov-state")
        self.write("scene.pov", SLOW_SCENE + '#debug "reading\\n"\n' + ENDLESS)
        self.assertEqual(
            self.stopped_while_reading("scene.pov", signal.SIGTERM, "+C", "+Opart.png"), 2)
        self.assertEqual(self.bytes_of("part.pov-state"), kept)
        self.write("scene.pov", SLOW_SCENE)
        self.durer(*OPTIONS, "+C", "+Opart.png")
        self.assertEqual(self.bytes_of("part.png"), self.bytes_of("whole.png"))

    def stopped_while_reading(self, scene, number, *more):
        # Without -GA: the scene says when it is being read.
        run = subprocess.Popen([DURER, scene, *OPTIONS[1:-1], *more], cwd=self.folder,
                               stderr=subprocess.PIPE, text=True)
        while not run.stderr.readline().startswith("reading"):
            self.assertIsNone(run.poll())
        run.send_signal(number)
        run.communicate(timeout=60)
        return run.returncode

    def test_foreign_state_file(self):
        """What durer did not write is no state: the picture is rendered from the start."""
        self.durer(*OPTIONS, "+Owhole.png")
        for content in (b"", b"POV-Ray Render State File", b"durer state 0", bytes(range(256)) * 100):
            with self.subTest(content=content[:20]):
                (self.folder / "part.pov-state").write_bytes(content)
                self.durer(*OPTIONS, "+C", "+Opart.png")
                self.assertEqual(self.bytes_of("part.png"), self.bytes_of("whole.png"))
                self.assertFalse((self.folder / "part.pov-state").exists())
                os.remove(self.folder / "part.png")

    def test_preview_of_a_killed_run_is_continued(self):
        self.durer(*OPTIONS, "+WT1", "+Owhole.png")
        self.interrupted("part", 1, signal.SIGKILL, "--preview", "0.01")
        self.durer(*OPTIONS, "+C", "+Opart.png")
        self.assertEqual(self.bytes_of("part.png"), self.bytes_of("whole.png"))

    def test_finished_picture_is_left_alone(self):
        (self.folder / "old.png").write_bytes(b"not empty")
        self.durer(*OPTIONS, "+C", "+Oold.png")
        self.assertEqual(self.bytes_of("old.png"), b"not empty")

    def test_torn_state_file(self):
        """A block whose end is missing is rendered again."""
        self.durer(*OPTIONS, "+WT1", "+Owhole.png")
        self.interrupted("part", 1, signal.SIGKILL)
        os.truncate(self.folder / "part.pov-state",
                    (self.folder / "part.pov-state").stat().st_size - 100)
        self.durer(*OPTIONS, "+C", "+Opart.png")
        self.assertEqual(self.bytes_of("part.png"), self.bytes_of("whole.png"))

    def test_damaged_state_file(self):
        """Blocks that are not what was written are rendered again."""
        self.durer(*OPTIONS, "+WT1", "+Owhole.png")
        self.interrupted("part", 1, signal.SIGKILL)
        state = self.folder / "part.pov-state"
        data = bytearray(state.read_bytes())
        for place in range(3000, len(data), 1700):
            data[place] ^= 255
        state.write_bytes(data)
        self.durer(*OPTIONS, "+C", "+Opart.png")
        self.assertEqual(self.bytes_of("part.png"), self.bytes_of("whole.png"))

    def test_state_of_another_picture_is_not_used(self):
        self.interrupted("part", 1, signal.SIGKILL)
        others = OPTIONS[:3] + ("+A0.4",) + OPTIONS[4:]
        self.durer(*others, "+Owhole.png")
        self.durer(*others, "+C", "+Opart.png")
        self.assertEqual(self.bytes_of("part.png"), self.bytes_of("whole.png"))

    def test_windows_make_up_the_picture(self):
        self.durer(*OPTIONS, "+Owhole.png")
        whole, _ = picture_files.read(self.folder / "whole.png")
        total = numpy.zeros_like(whole)
        for number, window in enumerate(WINDOWS):
            self.durer(*OPTIONS, *window, f"+Owindow{number}.png", f"+WT{1 + number}")
            part, _ = picture_files.read(self.folder / f"window{number}.png")
            self.assertEqual(part.shape, whole.shape)
            self.assertEqual(numpy.count_nonzero((part > 0) & (total > 0)), 0)
            total += part
        self.assertEqual(abs(total - whole).max(), 0)

    def test_picture_kept_on_the_disk(self):
        """+MI0: nothing is held in memory."""
        self.durer(*OPTIONS, "+Owhole.png")
        self.durer(*OPTIONS, "+MI0", "+Odisk.png")
        self.assertEqual(self.bytes_of("disk.png"), self.bytes_of("whole.png"))
        self.assertEqual(sorted(os.listdir(self.folder)), ["disk.png", "scene.pov", "whole.png"])


if __name__ == "__main__":
    unittest.main()
