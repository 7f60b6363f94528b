"""povray (with a cache of its pictures) and durer, started with the same options."""
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import uuid
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path

import processes

# What every picture is made with (docs: design.md, Fidelity): no window, 16-bit PNG.
COMMON_OPTIONS = ("-D", "+FN16")
POVRAY_STREAMS = ("-V", "-GA", "+GDdebug_stream.txt", "+GFfatal_stream.txt")
DURER_STREAMS = ("-V", "-GD", "-GR", "-GS")
DURER_MEMORY_LIMIT = 12 << 30
BUSY_MACHINE = "worker thread startup"  # povray gives up where its threads wait for long
STARTS = 5
PICTURE = "reference_picture.png"
STOPPED = (-signal.SIGINT, -signal.SIGTERM)  # from outside


@dataclass
class Picture:
    path: Path | None      # None: no picture
    code: int
    cpu: float
    wall: float
    peak_kb: int
    timed_out: bool
    error: str             # first line that says what is wrong
    debug: str = ""        # the #debug stream (povray only)

    @property
    def crashed(self):
        return self.code < 0 and not self.timed_out


def cache_root():
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "durer-reference"


@lru_cache
def povray_version():
    """Version of povray and of its standard includes, which are part of what decides the picture."""
    packages = ("povray", "povray-includes", "fonts-povray")
    query = subprocess.run(["dpkg-query", "-W", *packages], capture_output=True, text=True)
    if query.returncode != 0 or shutil.which("povray") is None:
        raise SystemExit("reference: povray is not installed: apt-get install povray povray-includes "
                         "povray-examples fonts-povray")
    return query.stdout


def povray(scene, options, cpu_limit=180, nice=10):
    """povray's picture of a scene, from the cache where it is there."""
    key = hashlib.sha256("\0".join((povray_version(), scene.content_hash(), scene.path.name,
                                    *scene.options, *options)).encode()).hexdigest()
    entry = cache_root() / key[:2] / key
    record = entry / "result.json"
    if record.exists():
        stored = json.loads(record.read_text())
        if not (stored["timed_out"] and stored["cpu"] < cpu_limit - 1):
            picture = entry / "picture.png"
            return Picture(path=picture if picture.exists() else None, **stored)

    fresh = entry.parent / f".{uuid.uuid4().hex}"
    fresh.mkdir(parents=True)
    for _ in range(STARTS):
        run = run_povray(scene, options, cpu_limit, nice, fresh / "picture.png")
        if BUSY_MACHINE not in run.error:
            break
    else:
        shutil.rmtree(fresh, ignore_errors=True)
        raise RuntimeError(f"povray does not start on this busy machine: {run.error}")
    if run.code in STOPPED and not run.timed_out:  # which says nothing of the scene
        shutil.rmtree(fresh, ignore_errors=True)
        return run
    stored = asdict(run)
    del stored["path"]
    # Written aside and renamed: several worktrees may share the cache at one time.
    (fresh / "result.json").write_text(json.dumps(stored))
    if entry.exists():
        shutil.rmtree(entry, ignore_errors=True)
    try:
        fresh.rename(entry)
    except OSError:
        shutil.rmtree(fresh, ignore_errors=True)
    picture = entry / "picture.png"
    return Picture(path=picture if picture.exists() else None, **stored)


def run_povray(scene, options, cpu_limit, nice, kept_picture=None):
    """povray's picture of a scene, rendered now."""
    with processes.Scratch(scene) as scratch:
        output = scratch.folder / PICTURE
        command = ["povray", f"+I{scene.path.name}", f"+O{output.name}", *COMMON_OPTIONS,
                   *POVRAY_STREAMS, *scene.options, *options]
        # povray's I/O rules let it read below the home folder and the current one.
        result = processes.run(command, scratch.folder, cpu_limit, scratch.root,
                               {"HOME": str(scratch.root)}, nice)
        error = ""
        if result.code != 0:
            fatal = processes.read_text(scratch.folder / "fatal_stream.txt")
            error = first_error(fatal) or first_error(result.stderr)
        debug = processes.read_text(scratch.folder / "debug_stream.txt")
        path = keep(drawn_picture(scratch.folder), kept_picture) if result.code == 0 else None
    return Picture(path, result.code, result.cpu, result.wall, result.peak_kb, result.timed_out, error,
                   debug)


def drawn_picture(folder):
    """The picture of a run; a frame's has the frame's number behind its name. None: there is none."""
    pictures = list(folder.glob(f"{Path(PICTURE).stem}*.png"))
    return pictures[0] if len(pictures) == 1 else None


def keep(picture, kept_picture):
    """Copy the picture out of the scratch folder if it is wanted."""
    if kept_picture is None or picture is None:
        return None
    kept_picture.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(picture, kept_picture)
    return kept_picture


def durer(binary, scene, options, kept_picture, cpu_limit=120, nice=10):
    """durer's picture of a scene, rendered now; copied to `kept_picture` if that is given."""
    with processes.Scratch(scene) as scratch:
        output = scratch.folder / PICTURE
        command = [binary, f"+I{scene.path.name}", f"+O{output.name}", *COMMON_OPTIONS,
                   *DURER_STREAMS, *scene.options, *options]
        result = processes.run(command, scratch.folder, cpu_limit, scratch.root, nice=nice,
                               memory_limit=DURER_MEMORY_LIMIT)
        picture = drawn_picture(scratch.folder)
        drawn = result.code == 0 and picture is not None
        path = keep(picture, kept_picture) if drawn else None
    error = ""
    if result.crashed:
        error = processes.signal_name(result.code)
    if result.code != 0:
        error = " ".join(filter(None, (error, first_error(result.stderr or result.stdout))))
    elif not drawn:
        error = "exit code 0 but no picture"
    return Picture(path, result.code, result.cpu, result.wall, result.peak_kb, result.timed_out, error)


# Our own messages first: a scene may write the word "error" to the console itself.
OWN_MESSAGE = re.compile(r"\S+:\d+.*(error|not supported yet)")
ERROR_WORDS = ("not supported yet", "error", "fatal", "cannot", "sanitizer", "terminate")


def first_error(text):
    """The first line that tells what is wrong, else the last line."""
    lines = [line.strip() for line in text.replace("\r", "\n").splitlines()
             if line.strip() and "user configuration file" not in line]
    for wanted in (OWN_MESSAGE.search, lambda line: any(word in line.lower() for word in ERROR_WORDS)):
        for line in lines:
            if wanted(line):
                return line[:300]
    return lines[-1][:300] if lines else ""
