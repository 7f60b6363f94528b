"""Scenes with a mistake: durer stops where povray stops, says so in its own words, leaves no picture.

Each scene of malformed/ has one mistake. Both programs read it; the files and lines that they name
must be the same. durer's message must also hold a column inside that line, the line itself and a
caret. Nothing is cached, and without povray the test fails.

    malformed_test.py DURER [PART OF A NAME]
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import installed_povray  # noqa: E402

SCENES = Path(__file__).resolve().parent / "malformed"
LEAST_SCENES = 100
SECONDS = 60
OPTIONS = ["+Linc", "+W8", "+H6", "-D", "+WT1", "-GR", "-GS"]


def run(program, scene, folder):
    """Exit status and messages of a program that reads the scene and would write into the folder."""
    done = subprocess.run([program, f"+I{scene.name}", f"+O{folder}/", *OPTIONS], cwd=SCENES,
                          stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS, check=False)
    return done.returncode, done.stderr.decode("latin-1")


def place_in_povray(text):
    """File and line of povray's last message with a place, which is the one that it stopped with."""
    # Long lines are wrapped; a continuation begins with a blank.
    unwrapped = re.sub(r"\n +", " ", text)
    places = re.findall(r"File '([^']*)' line (\d+): (?:Possible )?Parse Error:", unwrapped)
    return (Path(places[-1][0]).name, int(places[-1][1])) if places else None


def check(scene, povray, durer):
    """What is wrong with durer's answer; empty: nothing."""
    with tempfile.TemporaryDirectory() as folder:
        status, text = run(povray, scene, folder)
        place = place_in_povray(text)
        if status != 1 or not place:
            return f"povray does not stop (status {status}): the scene has no mistake\n{text[-500:]}"
    with tempfile.TemporaryDirectory() as folder:
        try:
            status, text = run(durer, scene, folder)
        except subprocess.TimeoutExpired:
            return f"durer is not done after {SECONDS} s"
        left = sorted(file.name for file in Path(folder).iterdir())
    if re.search(r"Sanitizer|runtime error:", text):
        return f"durer trips a sanitizer\n{text[-2000:]}"
    if status != 1:
        return f"durer ends with status {status}, povray stops at {place}\n{text[-500:]}"
    if left:
        return f"durer leaves {left}"
    error = re.search(r"^(.+?):(\d+):(\d+): error: (.+)\n  (.*)\n( *)\^$", text, re.MULTILINE)
    if not error:
        return f"durer's error lacks its place, line or caret:\n{text}"
    file, line, column = error[1], int(error[2]), int(error[3])
    if (Path(file).name, line) != place:
        return f"durer names {file}:{line}, povray {place[0]}:{place[1]}\n{text}"
    lines = re.split("\r\n|\n\r|\n|\r", (SCENES / file).read_text("latin-1"))
    if not 1 <= column <= len(lines[line - 1]) + 1:
        return f"durer's column {column} lies outside the line\n{text}"
    return ""


def main():
    povray, durer, part = installed_povray.programs()
    scenes = sorted(scene for scene in SCENES.glob("*.pov") if part in scene.name)
    if not part and len(scenes) < LEAST_SCENES:
        print(f"only {len(scenes)} scenes in {SCENES}")
        return 1
    return installed_povray.exit_code(scenes, lambda scene: check(scene, povray, durer),
                                      lambda scene: scene.name, "scenes stop where povray stops")


if __name__ == "__main__":
    sys.exit(main())
