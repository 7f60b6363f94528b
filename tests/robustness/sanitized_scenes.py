"""Every scene under a sanitizer: no report. The preset asan looks for leaks, too; under the preset
tsan four threads share small blocks.

Registered in these presets only. Pictures are small, every third with antialiasing; a scene that
renders only as a frame of an animation is rendered as one.

    sanitized_scenes.py address|thread DURER FOLDER... [--filter PART OF A NAME] [--every N]
                        [--size WxH] [--jobs N] [--logs FOLDER] [--repeat N]
"""
import argparse
import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SECONDS = 600
REPORT = re.compile(r"(?:ERROR|WARNING): \w+Sanitizer|runtime error: |Assertion ")
REPORT_LENGTH = 6000
ERROR = 1
NOT_SUPPORTED = 3
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "reference"))
import animations

# The thread-local blocks of libraries that are loaded late (OpenImageIO's) are not followed: the leak
# check of g++ 12 mistakes their places and crashes there ("LeakSanitizer has encountered a fatal error").
ENVIRONMENTS = {
    "address": {"UBSAN_OPTIONS": "print_stacktrace=1",
                "ASAN_OPTIONS": "detect_leaks=1:detect_stack_use_after_return=1:"
                                "intercept_tls_get_addr=0"},
    "thread": {"TSAN_OPTIONS": f"suppressions={HERE}/thread_sanitizer_suppressions.txt:history_size=4"},
}
OPTIONS = {"address": ("+WT1",), "thread": ("+WT4", "+BS8")}


def render(arguments, scene, antialias, folder, frame=()):
    """Exit status and report of a run (None: no report)."""
    width, height = arguments.size.split("x")
    options = [f"+W{width}", f"+H{height}", "-D", "-GD", "-GR", "-GS",
               f"+O{folder}/picture.png", *OPTIONS[arguments.sanitizer],
               *(("+A0.3", "+AM2") if antialias else ("-A",)), *frame]
    environment = dict(os.environ, **ENVIRONMENTS[arguments.sanitizer])
    try:
        done = subprocess.run([arguments.durer, scene.name, *options], cwd=scene.parent,
                              env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None, f"not done after {SECONDS} s"
    messages = done.stderr.decode("latin-1")
    report = REPORT.search(messages)
    if done.returncode == ERROR and not report and not frame and animations.frame_options(scene):
        return render(arguments, scene, antialias, folder, animations.frame_options(scene))
    if arguments.logs and (report or done.returncode not in (0, NOT_SUPPORTED)):
        name = "-".join(scene.parts[-2:]) + f"-{arguments.sanitizer}-{os.getpid()}"
        (arguments.logs / f"{name}-{time.monotonic_ns()}.log").write_text(
            " ".join([arguments.durer, str(scene), *options]) + "\n" + messages)
    return done.returncode, messages[report.start():][:REPORT_LENGTH] if report else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("sanitizer", choices=ENVIRONMENTS)
    parser.add_argument("durer", type=lambda path: str(Path(path).resolve()))
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--filter", default="")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--size", default="48x36")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--logs", type=Path, help="keeps all that a run with a report has said")
    parser.add_argument("--repeat", type=int, default=1, help="renders each scene so many times")
    arguments = parser.parse_args()
    if arguments.logs:
        arguments.logs.mkdir(parents=True, exist_ok=True)
    scenes = sorted(scene for folder in arguments.folders for scene in folder.rglob("*.pov")
                    if arguments.filter in str(scene))[::arguments.every]
    scenes *= arguments.repeat
    if not scenes:
        sys.exit("no scenes")

    def run(number):
        with tempfile.TemporaryDirectory() as folder:
            return render(arguments, scenes[number], number % 3 == 0, folder)

    rendered, unsupported, wrong = 0, 0, 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for scene, (status, report) in zip(scenes, pool.map(run, range(len(scenes)))):
            rendered += status == 0
            unsupported += status == NOT_SUPPORTED
            if report or status not in (0, NOT_SUPPORTED):
                wrong += 1
                print(f"{scene}: status {status}: {report}", flush=True)
    print(f"{len(scenes)} scenes: {rendered} rendered, {unsupported} not supported yet, "
          f"{wrong} with reports or stopped")
    return 1 if wrong or rendered == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
