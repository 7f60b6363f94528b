#!/usr/bin/python3
"""No scene of the gallery allocates memory per ray: four times as many rays, as many allocations.

Both pictures are one block of one thread, so that what blocks and threads allocate is the same.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

# What pictures of different sizes may allocate differently: rows of the writer, growth of stacks.
ALLOWANCE = 40
# OpenImageIO shares its work on input files among its threads and ours, so what ours allocates for them
# varies from run to run. What rays allocate is there in every run: the least growth counts.
REPEATS = 5


def allocations(durer, library, scene, size, scratch):
    count = scratch / "count"
    count.unlink(missing_ok=True)
    environment = dict(os.environ, LD_PRELOAD=str(library), ALLOCATION_COUNT=str(count))
    command = [durer, scene.name, f"+W{size}", f"+H{size}", "+WT1", "-V", f"+O{scratch}/picture.png"]
    result = subprocess.run(command, cwd=scene.parent, env=environment, capture_output=True, timeout=300)
    if result.returncode == 3:
        return None  # not rendered yet
    if result.returncode != 0:
        raise RuntimeError(f"{scene}: durer ends with {result.returncode}")
    return int(count.read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("durer")
    parser.add_argument("library", type=Path)
    parser.add_argument("gallery", type=Path)
    arguments = parser.parse_args()
    failures, counted = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        for scene in sorted(arguments.gallery.rglob("*.pov")):
            growth = None
            for _ in range(REPEATS):
                few = allocations(arguments.durer, arguments.library, scene, 16, scratch)
                if few is None:
                    break
                many = allocations(arguments.durer, arguments.library, scene, 32, scratch)
                growth = many - few if growth is None else min(growth, many - few)
                if growth <= ALLOWANCE:
                    break
            if growth is None:
                continue
            counted += 1
            if growth > ALLOWANCE:
                failures += 1
                print(f"{scene}: {growth} more allocations for 768 more pixels")
    print(f"{counted} scenes, {failures} that allocate per ray")
    return 1 if failures or counted < 60 else 0


if __name__ == "__main__":
    sys.exit(main())
