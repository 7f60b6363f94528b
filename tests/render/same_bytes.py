#!/usr/bin/python3
"""The same bytes and counts on 1, 2 and 7 threads, and the same bytes in four windows put together
(design.md rule 4).

same_bytes.py DURER SCENES_FOLDER: renders scenes of the gallery with the settings below; exit code 1
and a line for each picture that differs.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from PIL import Image

SIZE = ("+W90", "+H70", "+BS16")
METHODS = {
    "none": ("-A",),
    "method 1": ("+A0.1", "+AM1", "+R3"),
    "method 2": ("+A0.1", "+AM2", "+R2"),
    "grid": ("--supersampling", "grid", "2"),
    "jitter": ("--supersampling", "jitter", "2"),
}
# scene -> methods
CASES = {
    "cameras/perspective_look_at": METHODS,
    "cameras/blur_min_max": ("none", "method 1", "method 2"),
    "cameras/blur_bokeh": ("none",),
    "cameras/mesh_two_rays": ("none", "method 1"),
    "cameras/mesh_baking": ("none", "method 2"),
    "cameras/normal_spherical": ("none", "jitter"),
    "cameras/fisheye": ("method 1", "method 2"),
    "antialiasing/edges": METHODS,
    "antialiasing/transparency": METHODS,
}
# Left, right, top, bottom, counted from 1; the borders cut through blocks.
WINDOWS = ((1, 37, 1, 41), (38, 90, 1, 41), (1, 37, 42, 70), (38, 90, 42, 70))


def render(durer, scene, options, picture):
    """The picture's bytes, and how many samples, rays and tests of shapes it took."""
    counts = picture.with_suffix(".json")
    run = subprocess.run([durer, scene.name, f"+O{picture}", "+FN16", "-GA", "--stats", str(counts),
                          *SIZE, *options], cwd=scene.parent, capture_output=True, text=True)
    if run.returncode != 0:
        raise SystemExit(f"{scene}: durer ends with {run.returncode}\n{run.stderr}")
    frame = json.loads(counts.read_text())["frames"][0]
    return picture.read_bytes(), [frame[key] for key in ("samples", "rays", "shape_tests")]


def pixels(path):
    with Image.open(path) as image:
        return numpy.asarray(image).copy()


def windows_agree(durer, scene, method, folder, whole):
    for left, right, top, bottom in WINDOWS:
        part = folder / "part.png"
        render(durer, scene, (*method, "+WT2", f"+SC{left}", f"+EC{right}", f"+SR{top}",
                              f"+ER{bottom}"), part)
        area = (slice(top - 1, bottom), slice(left - 1, right))
        if not numpy.array_equal(pixels(part)[area], whole[area]):
            return False
    return True


def main():
    durer, scenes = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
    failures = pictures = 0
    for name, methods in CASES.items():
        scene = scenes / f"{name}.pov"
        for method in methods:
            options = METHODS[method]
            pictures += 1
            with tempfile.TemporaryDirectory(prefix="durer-same-bytes-") as folder:
                whole = Path(folder) / "whole.png"
                one = render(durer, scene, (*options, "+WT1"), whole)
                for threads in (2, 7):
                    if render(durer, scene, (*options, f"+WT{threads}"),
                              Path(folder) / "more.png") != one:
                        print(f"{name}, {method}: {threads} threads give other bytes or counts than one")
                        failures += 1
                if not windows_agree(durer, scene, options, Path(folder), pixels(whole)):
                    print(f"{name}, {method}: four windows differ from the whole picture")
                    failures += 1
    print(f"{pictures} pictures, {failures} differences")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
