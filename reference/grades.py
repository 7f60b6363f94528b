"""How alike two pictures are: exact, match, close or differ.

On 8-bit values (the high byte of 16-bit files) of two pictures of equal size:
  exact  at least 99.5 % of the pixels within 2 codes in every channel, and of the means of 8x8 blocks
         all but 1 in 200 within 16 codes, none beyond 64
  match  at least 97 % of the pixels within 4 codes, blocks as above
  close  at least 95 % of the blocks within 6 codes, none beyond 40, mean signed difference of every
         channel within 1.5 codes
"""
from dataclasses import dataclass

import numpy
from PIL import Image

ORDER = ("exact", "match", "close", "differ", "timeout", "unsupported", "error", "crash")
BLOCK = 8


@dataclass
class Grade:
    grade: str
    within_2: float = 0.0        # share of the pixels
    within_4: float = 0.0
    blocks_beyond_6: float = 0.0  # share of the blocks
    blocks_beyond_16: float = 0.0
    largest_block: float = 0.0   # largest difference of block means, codes
    bias: float = 0.0            # mean signed difference of the worst channel, codes


def worse(new, old):
    return ORDER.index(new) > ORDER.index(old)


def good_enough(grade, random):
    """What is asked of a scene: match if povray agrees with itself, else close."""
    return grade in ("exact", "match") or (random and grade == "close")


def read_pixels(path):
    """Height x width x 3 codes from 0 to 255."""
    with Image.open(path) as image:
        if image.mode in ("I", "I;16", "I;16B"):
            gray = numpy.asarray(image).astype(numpy.int32) >> 8
            return numpy.repeat(gray[:, :, None], 3, axis=2)
        return numpy.asarray(image.convert("RGB")).astype(numpy.int32)


def block_means(pixels):
    """Means of 8x8 blocks anchored at the upper left corner; blocks at the edges may be smaller."""
    rows = numpy.arange(0, pixels.shape[0], BLOCK)
    columns = numpy.arange(0, pixels.shape[1], BLOCK)
    sums = numpy.add.reduceat(numpy.add.reduceat(pixels, rows, axis=0), columns, axis=1)
    heights = numpy.diff(numpy.append(rows, pixels.shape[0]))
    widths = numpy.diff(numpy.append(columns, pixels.shape[1]))
    return sums / (heights[:, None] * widths[None, :])[:, :, None]


def compare_pixels(reference, picture):
    if reference.shape != picture.shape:
        return Grade("differ", largest_block=255.0)
    difference = picture - reference
    largest = numpy.abs(difference).max(axis=2)
    within_2 = float((largest <= 2).mean())
    within_4 = float((largest <= 4).mean())
    blocks = numpy.abs(block_means(picture) - block_means(reference)).max(axis=2)
    biases = difference.reshape(-1, difference.shape[2]).mean(axis=0)
    bias = float(biases[numpy.abs(biases).argmax()])
    beyond_6 = float((blocks > 6).mean())
    beyond_16 = int((blocks > 16).sum())
    largest_block = float(blocks.max())

    blocks_hold = beyond_16 <= blocks.size // 200 and largest_block <= 64
    if within_2 >= 0.995 and blocks_hold:
        grade = "exact"
    elif within_4 >= 0.97 and blocks_hold:
        grade = "match"
    elif beyond_6 <= 0.05 and largest_block <= 40 and abs(bias) <= 1.5:
        grade = "close"
    else:
        grade = "differ"
    return Grade(grade, within_2, within_4, beyond_6, beyond_16 / blocks.size, largest_block, bias)


def grade_run(picture, reference_pixels):
    """The grade of a run of durer: of its picture, or of the way in which it failed."""
    if picture.timed_out:
        return Grade("timeout")
    if picture.crashed:
        return Grade("crash")
    if picture.code == 3:
        return Grade("unsupported")
    if picture.code != 0 or picture.path is None:
        return Grade("error")
    try:
        return compare_pixels(reference_pixels, read_pixels(picture.path))
    except OSError:
        return Grade("error")
