#!/usr/bin/python3
"""durer's trace(), inside() and extents of many shapes are those of the installed povray.

Each scene of this folder writes numbers to the #debug stream; of each object at most a hundredth of
the lines may differ by more than 2e-7 (rays that graze, and double roots, differ in their last digits).
"""
import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TOLERANCE = 2e-7
ALLOWED_SHARE = 0.01
# Surfaces found by searches that stop within an accuracy: more of their digits differ.
LOOSE = {"latheq": 0.04, "poly5": 0.06, "para": 0.03, "text": 0.02, "amp": 0.02, "julia": 0.02}


def debug_stream(command, scene, folder):
    stream = folder / "debug.txt"
    stream.unlink(missing_ok=True)
    subprocess.run([*command, f"+I{scene.name}", f"+GD{stream.name}", "-GS", "-GR", "-GW"],
                   cwd=folder, capture_output=True, timeout=300, check=True)
    return [line.split() for line in stream.read_text().splitlines() if line.strip()]


def by_object(lines):
    objects, current = {}, None
    for words in lines:
        if words[0] == "object":
            current = " ".join(words[1:])
            objects[current] = []
        elif current is not None:
            objects[current].append(words)
    return objects


def number(word):
    try:
        return float(word)
    except ValueError:
        return None


def kind(words):
    return [word for word in words if number(word) is None]


def alike(ours, theirs):
    pairs = [(number(a), number(b)) for a, b in zip(ours, theirs)]
    return len(ours) == len(theirs) and all(
        a is None or b is None or abs(a - b) <= TOLERANCE * max(1, abs(b)) for a, b in pairs)


def differing(ours, theirs):
    """How many lines differ. A ray that only one of the two hits has lines the other lacks."""
    count = i = j = 0
    while i < len(ours) and j < len(theirs):
        if kind(ours[i]) != kind(theirs[j]):
            count += 1
            if "next" in ours[i]:
                i += 1
            else:
                j += 1
            continue
        count += not alike(ours[i], theirs[j])
        i, j = i + 1, j + 1
    return count + len(ours) - i + len(theirs) - j


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("durer")
    arguments = parser.parse_args()
    failures = objects = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "geometry"
        shutil.copytree(Path(__file__).resolve().parent, folder)
        for scene in sorted(Path(__file__).resolve().parent.glob("*.pov")):
            ours = by_object(debug_stream([arguments.durer, "--parse-only"], scene, folder))
            theirs = by_object(debug_stream(["povray", "-F", "-D", "+W4", "+H3", "+WT1"], scene, folder))
            if list(ours) != list(theirs):
                print(f"{scene.name}: durer and povray do not name the same objects")
                failures += 1
            for label in theirs:
                objects += 1
                count = differing(ours.get(label, []), theirs[label])
                allowed = LOOSE.get(label.split()[0], ALLOWED_SHARE) * len(theirs[label])
                if count > allowed:
                    failures += 1
                    print(f"{scene.name}: {label}: {count} of {len(theirs[label])} lines differ")
    print(f"{objects} objects, {failures} failures")
    return 1 if failures or objects < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
