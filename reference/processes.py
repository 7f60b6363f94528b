"""Run a renderer in a scratch copy of a scene's folder in memory and say what it cost."""
import json
import os
import shutil
import signal
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

SCRATCH_ROOT = "/dev/shm" if os.access("/dev/shm", os.W_OK) else tempfile.gettempdir()
# Of larger files a scratch folder holds links only.
LARGEST_COPIED_FILE = 16 << 20


@dataclass
class Result:
    code: int          # exit status; negative: the signal that ended the process
    cpu: float         # user + system seconds
    wall: float        # seconds
    peak_kb: int       # peak resident memory
    timed_out: bool
    stdout: str
    stderr: str

    @property
    def crashed(self):
        return self.code < 0 and not self.timed_out


class Scratch:
    """A folder in memory that holds the files of the scene's folder; scenes may write there."""

    def __init__(self, scene):
        self.root = Path(tempfile.mkdtemp(prefix="durer-reference-", dir=SCRATCH_ROOT))
        self.folder = self.root / scene.path.parent.name
        shutil.copytree(scene.path.parent, self.folder, copy_function=copy_or_link)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.root, ignore_errors=True)


def copy_or_link(source, target):
    """A file for a scratch folder: large ones, which no scene writes, are linked."""
    if os.stat(source).st_size > LARGEST_COPIED_FILE:
        os.symlink(source, target)
    else:
        shutil.copy2(source, target)


def run(command, folder, cpu_limit, root, environment=None, nice=0, memory_limit=0):
    """Run `command` in `folder`; `root` is a scratch folder for the bookkeeping files."""
    order = {
        "command": [str(word) for word in command],
        "folder": str(folder),
        "cpu_limit": int(cpu_limit) + 1,
        "wall_limit": 6 * cpu_limit + 30,
        "memory_limit": memory_limit,
        "nice": nice,
        "environment": environment or {},
        "stdout": str(root / ".stdout"),
        "stderr": str(root / ".stderr"),
        "result": str(root / ".result"),
    }
    (root / ".order").write_text(json.dumps(order))
    launcher = Path(__file__).parent / "measure_child.py"
    subprocess.run(["/usr/bin/python3", "-S", "-E", str(launcher), str(root / ".order")], check=True)
    result = json.loads((root / ".result").read_text())
    return Result(stdout=read_text(root / ".stdout"), stderr=read_text(root / ".stderr"), **result)


def read_text(path):
    try:
        return path.read_bytes().decode("utf-8", errors="replace")
    except FileNotFoundError:
        return ""


def signal_name(code):
    try:
        return signal.Signals(-code).name
    except ValueError:
        return f"signal {-code}"
