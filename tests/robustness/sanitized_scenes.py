"""Every scene under the address and undefined behaviour sanitizers: no report, and leaks count.

Registered in the preset asan only. Pictures are small, every third with antialiasing.

    sanitized_scenes.py DURER FOLDER... [--filter PART OF A NAME] [--size WxH]
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SECONDS = 600
REPORT = re.compile(r"ERROR: \w+Sanitizer.*|runtime error: .*")
NOT_SUPPORTED = 3
# The leak check of g++ 12 itself crashes after this scene ("LeakSanitizer has encountered
# a fatal error"); without that check there is no report.
LEAKS_UNCHECKED = ("images/transparency.pov",)


def render(durer, scene, size, antialias, folder):
    """Exit status and first report of a run (None: no report)."""
    width, height = size.split("x")
    options = [f"+W{width}", f"+H{height}", "-D", "-GD", "-GR", "-GS", f"+O{folder}/picture.png",
               *(("+A0.3", "+AM2") if antialias else ("-A",))]
    leaks = 0 if str(scene).endswith(LEAKS_UNCHECKED) else 1
    environment = dict(os.environ, UBSAN_OPTIONS="print_stacktrace=1",
                       ASAN_OPTIONS=f"detect_leaks={leaks}:detect_stack_use_after_return=1")
    done = subprocess.run([durer, scene.name, *options], cwd=scene.parent, env=environment,
                          stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS,
                          check=False)
    report = REPORT.search(done.stderr.decode("latin-1"))
    return done.returncode, report[0] if report else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("durer")
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--filter", default="")
    parser.add_argument("--size", default="48x36")
    arguments = parser.parse_args()
    scenes = sorted(scene for folder in arguments.folders for scene in folder.rglob("*.pov")
                    if arguments.filter in str(scene))
    if not scenes:
        sys.exit("no scenes")
    rendered, unsupported, wrong = 0, 0, []
    with tempfile.TemporaryDirectory() as folder:
        for number, scene in enumerate(scenes):
            status, report = render(arguments.durer, scene, arguments.size, number % 3 == 0, folder)
            rendered += status == 0
            unsupported += status == NOT_SUPPORTED
            if report or status not in (0, NOT_SUPPORTED):
                wrong.append(scene)
                print(f"{scene}: status {status}: {report}", flush=True)
    print(f"{len(scenes)} scenes: {rendered} rendered, {unsupported} not supported yet, "
          f"{len(wrong)} with reports or stopped")
    return 1 if wrong or rendered == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
