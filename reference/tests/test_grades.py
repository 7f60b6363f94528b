"""The grades of design.md, Fidelity, at their limits."""
import sys
import tempfile
import unittest
from pathlib import Path

import numpy
from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import grades
import renderers


def gray(value=100):
    return numpy.full((120, 160, 3), value, dtype=numpy.int32)


def grade_of(change):
    picture = gray()
    change(picture)
    return grades.compare_pixels(gray(), picture)


class Exact(unittest.TestCase):
    def test_equal_pictures(self):
        grade = grades.compare_pixels(gray(), gray())
        self.assertEqual(grade.grade, "exact")
        self.assertEqual((grade.within_2, grade.largest_block, grade.bias), (1.0, 0.0, 0.0))

    def test_two_codes_everywhere(self):
        self.assertEqual(grades.compare_pixels(gray(100), gray(98)).grade, "exact")

    def test_share_of_pixels(self):
        # 0.5 % of 19200 pixels are 96; spread out, so that no block mean moves far.
        def spoil(count):
            def change(picture):
                picture.reshape(-1, 3)[:count * 199:199, 1] += 200
            return change
        self.assertEqual(grade_of(spoil(96)).grade, "exact")
        self.assertEqual(grade_of(spoil(97)).grade, "match")

    def test_one_channel_counts(self):
        def change(picture):
            picture[:, :, 2] += 3
        self.assertEqual(grade_of(change).grade, "match")


class Blocks(unittest.TestCase):
    @staticmethod
    def spoil_blocks(count, amount):
        # Few pixels of the block, so that only the block rule can object.
        def change(picture):
            for block in range(count):
                picture[0:8, block * 16:block * 16 + 8] += amount
        return change

    def test_one_block_in_200_may_be_beyond_16(self):
        # 300 blocks: one is allowed.
        self.assertEqual(grade_of(self.spoil_blocks(1, 20)).grade, "exact")
        self.assertEqual(grade_of(self.spoil_blocks(2, 20)).grade, "close")

    def test_none_beyond_64(self):
        self.assertEqual(grade_of(self.spoil_blocks(1, 64)).grade, "exact")
        self.assertEqual(grade_of(self.spoil_blocks(1, 65)).grade, "differ")

    def test_close_allows_no_block_beyond_40(self):
        self.assertEqual(grade_of(self.spoil_blocks(2, 40)).grade, "close")
        self.assertEqual(grade_of(self.spoil_blocks(2, 41)).grade, "differ")

    def test_blocks_at_the_edges_are_smaller(self):
        pixels = numpy.arange(10 * 9 * 3).reshape(10, 9, 3)
        means = grades.block_means(pixels)
        self.assertEqual(means.shape, (2, 2, 3))
        self.assertEqual(means[1, 1, 0], pixels[8:10, 8:9, 0].mean())
        self.assertEqual(means[0, 0, 2], pixels[:8, :8, 2].mean())


class Close(unittest.TestCase):
    def test_noise_without_bias(self):
        noise = numpy.random.default_rng(1).normal(0, 10, (120, 160, 3)).round().astype(int)
        self.assertEqual(grades.compare_pixels(gray(), gray() + noise).grade, "close")

    def test_bias_of_one_channel(self):
        noise = numpy.random.default_rng(1).normal(0, 10, (120, 160, 3)).round().astype(int)
        noise[:, :, 0] += 2
        grade = grades.compare_pixels(gray(), gray() + noise)
        self.assertEqual(grade.grade, "differ")
        self.assertGreater(grade.bias, 1.5)

    def test_five_percent_of_blocks(self):
        # 15 of 300 blocks may be beyond 6 codes; equal numbers up and down leave no bias.
        def change(count):
            def spoil(picture):
                for block in range(count):
                    row, column = divmod(block, 20)
                    picture[row * 8:row * 8 + 8, column * 8:column * 8 + 8] += 20 - 40 * (block % 2)
            return spoil
        self.assertEqual(grade_of(change(15)).grade, "close")
        self.assertEqual(grade_of(change(16)).grade, "differ")


class Failures(unittest.TestCase):
    @staticmethod
    def run_of(**changes):
        fields = {"path": None, "code": 0, "cpu": 0.0, "wall": 0.0, "peak_kb": 0, "timed_out": False,
                  "error": ""}
        return renderers.Picture(**{**fields, **changes})

    def test_grades_of_failed_runs(self):
        for changes, expected in (({"code": 3}, "unsupported"), ({"code": 1}, "error"),
                                  ({"code": -11}, "crash"), ({"code": 0}, "error"),
                                  ({"code": -9, "timed_out": True}, "timeout")):
            self.assertEqual(grades.grade_run(self.run_of(**changes), gray()).grade, expected)

    def test_broken_picture_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "picture.png"
            path.write_bytes(b"not a picture")
            self.assertEqual(grades.grade_run(self.run_of(path=path), gray()).grade, "error")

    def test_other_size_differs(self):
        self.assertEqual(grades.compare_pixels(gray(), gray()[:60]).grade, "differ")

    def test_what_is_asked(self):
        self.assertTrue(grades.good_enough("match", random=False))
        self.assertFalse(grades.good_enough("close", random=False))
        self.assertTrue(grades.good_enough("close", random=True))
        self.assertFalse(grades.good_enough("unsupported", random=True))

    def test_order(self):
        self.assertTrue(grades.worse("match", "exact"))
        self.assertTrue(grades.worse("crash", "unsupported"))
        self.assertFalse(grades.worse("exact", "exact"))


class Files(unittest.TestCase):
    def test_modes_of_png(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "picture.png"
            for mode in ("RGB", "RGBA", "L", "P"):
                Image.new("L", (4, 2), 77).convert(mode).save(path)
                self.assertTrue((grades.read_pixels(path) == 77).all(), mode)
            Image.fromarray(numpy.full((2, 4), 77 * 256 + 200, dtype=numpy.uint16)).save(path)
            self.assertTrue((grades.read_pixels(path) == 77).all(), "16-bit grey")


if __name__ == "__main__":
    unittest.main()
