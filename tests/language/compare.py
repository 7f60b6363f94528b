#!/usr/bin/env python3
"""Run language scenes through durer --parse-only and the installed povray and compare what they say.

  compare.py [--durer PATH] [--filter TEXT] [--verbose] [FILE ...]

A file NAME.pov is one scene. A file NAME.cases holds many small ones: each begins with a line
`==== name` and reaches to the next such line; text before the first is put in front of every case.
A case may write `---- file NAME` to begin the text of a further file beside it (an include).

Compared: whether the scene is accepted; the #debug stream; the files that it writes; of a refused
scene the file and line of the error; of warnings where they stand (file, line and kind).
Exit code 1 if anything differs; 2 where povray is missing.
"""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
SCENE = "scene.pov"
OWN_FILES = {"debug.txt", "fatal.txt", "warning.txt", ".povray"}
TIME_LIMIT = 120


@dataclass
class Case:
    name: str
    text: bytes
    files: dict = field(default_factory=dict)
    folder: Path | None = None       # files beside the scene are copied from here
    prefix: bytes | None = None      # what the text begins with in every case of its file
    options: tuple = ()


@dataclass
class Said:
    """What a renderer made of a case."""
    accepted: bool
    debug: str
    files: dict
    error: str                       # "file:line"; empty: none
    warnings: list                   # "kind file:line"
    text: str                        # the message itself, for the reader


def read_cases(path):
    data = path.read_bytes()
    if path.suffix == ".pov":
        return [Case(path.stem, data, folder=path.parent)]
    parts = re.split(rb"^==== *(.*)\n", data, flags=re.M)
    cases = []
    for title, body in zip(parts[1::2], parts[2::2]):
        name, _, options = title.decode().partition(" +")
        pieces = re.split(rb"^---- file (\S+)\n", body, flags=re.M)
        files = {n.decode(): t for n, t in zip(pieces[1::2], pieces[2::2])}
        text = pieces[0] if name.startswith("bare ") else parts[0] + pieces[0]
        cases.append(Case(f"{path.stem}: {name}", text, files,
                          path.parent / "files",
                          None if name.startswith("bare ") else parts[0],
                          tuple(("+" + options).split() if options else ())))
    return cases


def run(case, command, read_messages):
    root = Path(tempfile.mkdtemp(prefix="durer-language-"))
    try:
        folder = root / "scene"
        folder.mkdir()
        if case.folder and case.folder.is_dir():
            for other in case.folder.iterdir():
                if other.is_file() and other.suffix not in (".pov", ".cases"):
                    shutil.copy(other, folder)
        (folder / SCENE).write_bytes(case.text)
        for name, text in case.files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(text)
        before = {p.name: p.stat().st_mtime_ns for p in folder.iterdir()}
        result = subprocess.run([*command, *case.options], cwd=folder, capture_output=True,
                                timeout=TIME_LIMIT, env={"HOME": str(root), "PATH": "/usr/bin:/bin"})
        texts = {name: (folder / name).read_bytes().decode("latin-1")
                 if (folder / name).exists() else "" for name in OWN_FILES if name[0] != "."}
        written = {p.name: p.read_bytes() for p in sorted(folder.iterdir())
                   if p.is_file() and p.name not in OWN_FILES
                   and before.get(p.name) != p.stat().st_mtime_ns}
        written.pop("scene.png", None)
        written.pop("scene.pov-state", None)
        error, warnings, text = read_messages(texts, result)
        return Said(result.returncode == 0, texts["debug.txt"].rstrip("\n"), written, error, warnings,
                    text)
    finally:
        shutil.rmtree(root, ignore_errors=True)


# An error shows the lines before it between its place and its text.
PLACE = re.compile(r"File: (\S+)  Line: (\d+)\s(?:File Context \(\d+ lines\):.*?\s)?"
                   r"(Possible )?Parse (Error|Warning):")

# Of a token that cannot be read povray names the one before (docs/decisions/0049).
UNREADABLE = re.compile(r"Illegal character|closing comment|No end quote|End of File found")

# What is said at the end of the parse, for which durer names no place.
END_OF_PARSE = re.compile(r" (No objects in scene|This (scene|rendering)|Your scene)")


def ordered(warnings):
    return sorted(set(warnings), key=lambda w: (w.rsplit(":", 1)[0], int(w.rsplit(":", 1)[1])))


def povray_messages(texts, result):
    fatal = re.sub(r"\n", " ", texts["fatal.txt"])
    found = [m for m in PLACE.finditer(fatal) if m[4] == "Error" and not m[3]]
    error = f"{found[0][1]}:{found[0][2]}" if found else ""
    warnings = []
    text_of_warnings = re.sub(r"\n", " ", texts["warning.txt"])
    for m in PLACE.finditer(text_of_warnings):
        kind = "possible" if m[3] else "warning"
        if m[4] == "Error" and not m[3] or END_OF_PARSE.match(text_of_warnings, m.end()):
            continue
        warnings.append(f"{kind} {m[1]}:{m[2]}")
    text = fatal.strip() or result.stderr.decode("latin-1")[-300:]
    return error, ordered(warnings), text


OWN = re.compile(r"^([^\s:]+):(\d+):\d+: (error|warning|possible error): ", re.M)


def durer_messages(texts, result):
    stderr = result.stderr.decode("latin-1")
    error, warnings = "", []
    for m in OWN.finditer(stderr):
        if m[3] == "error":
            error = error or f"{m[1]}:{m[2]}"
        else:
            warnings.append(f"{'possible' if m[3] != 'warning' else 'warning'} {m[1]}:{m[2]}")
    if result.returncode not in (0, 1):
        error = f"exit {result.returncode}"
    return error, ordered(warnings), stderr


def run_povray(case):
    return run(case, ["povray", f"+I{SCENE}", "+W8", "+H6", "-D", "-F", "-V", "+WT1", "-GA",
                      "+GDdebug.txt", "+GFfatal.txt", "+GWwarning.txt"], povray_messages)


def run_durer(case, binary):
    return run(case, [binary, "--parse-only", f"+I{SCENE}", "+W8", "+H6", "-D", "-V", "-GD", "-GR",
                      "-GS", "+GDdebug.txt"], durer_messages)


def lines_that_differ(ours, theirs):
    out = []
    a, b = ours.splitlines(), theirs.splitlines()
    for i in range(max(len(a), len(b))):
        mine, his = (a[i] if i < len(a) else None), (b[i] if i < len(b) else None)
        if mine != his:
            out.append(f"    line {i + 1}: durer {mine!r}\n             povray {his!r}")
    return out[:12]


FARTHEST = 8


def same_places(ours, theirs):
    """As many warnings of each kind and file, near the same lines: of the lines of a statement's
    last and next token either will do."""
    if len(ours) != len(theirs):
        return False
    for mine, his in zip(ours, theirs):
        (kind, line), (other, number) = mine.rsplit(":", 1), his.rsplit(":", 1)
        if kind != other or abs(int(line) - int(number)) > FARTHEST:
            return False
    return True


def differences(ours, theirs, with_warnings):
    out = []
    if ours.accepted != theirs.accepted:
        word = {True: "accepts", False: "refuses"}
        out.append(f"    durer {word[ours.accepted]}, povray {word[theirs.accepted]}: "
                   f"durer {ours.text.strip()[:400]!r} povray {theirs.text.strip()[:400]!r}")
    elif (not ours.accepted and theirs.error and ours.error != theirs.error
          and not UNREADABLE.search(theirs.text)):
        out.append(f"    error at: durer {ours.error}, povray {theirs.error}: "
                   f"durer {ours.text.strip()[:300]!r} povray {theirs.text.strip()[:300]!r}")
    if ours.debug != theirs.debug:
        out += lines_that_differ(ours.debug, theirs.debug)
    for name in sorted(set(ours.files) | set(theirs.files)):
        if ours.files.get(name) != theirs.files.get(name):
            out.append(f"    file {name}: durer {ours.files.get(name)!r}\n"
                       f"             povray {theirs.files.get(name)!r}")
    if (with_warnings and ours.accepted and theirs.accepted
            and not same_places(ours.warnings, theirs.warnings)):
        out.append(f"    warnings: durer {ours.warnings}, povray {theirs.warnings}")
    return out


BATCH = 30


def may_be_joined(case):
    return not case.options and not case.files and case.prefix is not None


def join(cases):
    """One scene of many: both must still say the same, and reach the end."""
    parts = [cases[0].prefix]
    for case in cases:
        title = case.name.replace("\\", "/").replace('"', "'")[:60]
        parts.append(f'\n#debug "\\n== {title}\\n"\n'.encode() + case.text[len(case.prefix):]
                     + b"\n#version 3.7;\n")
    return Case(f"{cases[0].name} and {len(cases) - 1} more", b"".join(parts) + LAST,
                folder=cases[0].folder)


LAST = b'\n#debug "\\nthe end\\n"\n'


class Comparison:
    def __init__(self, arguments):
        self.binary = str(Path(arguments.durer).resolve())
        self.warnings = not arguments.no_warnings
        self.verbose = arguments.verbose
        self.povray_runs = 0

    def both(self, case):
        self.povray_runs += 1
        return run_durer(case, self.binary), run_povray(case)

    def alone(self, case):
        ours, theirs = self.both(case)
        found = differences(ours, theirs, self.warnings)
        if self.verbose:
            print(f"{case.name}: durer {ours}\n   povray {theirs}")
        return [(case, found)] if found else []

    def group(self, cases):
        """Cases that durer accepts, in one run if that shows nothing; else one by one."""
        if len(cases) > 1:
            ours, theirs = self.both(join(cases))
            if (ours.accepted and theirs.accepted and "the end" in ours.debug
                    and not differences(ours, theirs, self.warnings)):
                return []
            if len(cases) > 8:
                half = len(cases) // 2
                return self.group(cases[:half]) + self.group(cases[half:])
        return [failure for case in cases for failure in self.alone(case)]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("--durer", default=str(HERE.parents[1] / "build/release/cli/durer"))
    parser.add_argument("--filter", default="")
    parser.add_argument("--jobs", type=int, default=8, help="povray sleeps most of its time")
    parser.add_argument("--no-warnings", action="store_true", help="do not compare warnings")
    parser.add_argument("--single", action="store_true", help="every case in a run of its own")
    parser.add_argument("--every", type=int, default=1, metavar="N",
                        help="of the cases that durer refuses, which need a run each, take every Nth")
    parser.add_argument("--verbose", action="store_true", help="show what both say to every case")
    arguments = parser.parse_args()
    if shutil.which("povray") is None:
        print("povray is not installed: apt-get install povray povray-includes", file=sys.stderr)
        return 2
    files = arguments.files or sorted([*HERE.glob("scenes/*.pov"), *HERE.glob("cases/*.cases")])
    comparison = Comparison(arguments)
    count, jobs = 0, []
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for path in files:
            cases = [case for case in read_cases(path) if arguments.filter in case.name]
            count += len(cases)
            joinable = [c for c in cases if may_be_joined(c)]
            said = dict(zip([c.name for c in joinable],
                            pool.map(lambda c: run_durer(c, comparison.binary).accepted, joinable)))
            accepted = [] if arguments.single else [c for c in joinable if said[c.name]]
            groups = [accepted[i:i + BATCH] for i in range(0, len(accepted), BATCH)]
            jobs += [pool.submit(comparison.group, group) for group in groups]
            taken = {c.name for c in accepted}
            others = [case for case in cases if case.name not in taken]
            refused = [case for case in others if said.get(case.name) is False]
            left_out = {case.name for i, case in enumerate(refused) if i % arguments.every}
            count -= len(left_out)
            jobs += [pool.submit(comparison.alone, case) for case in others
                     if case.name not in left_out]
        failures = [failure for job in jobs for failure in job.result()]
    # povray is stopped now and then where many runs share a machine: what differs is asked once more,
    # with nothing beside it.
    failures = [failure for case, _ in failures for failure in comparison.alone(case)]
    for case, found in failures:
        print(f"DIFFERS {case.name}", *found, sep="\n")
    print(f"{count} cases, {len(failures)} differ ({comparison.povray_runs} runs of povray)")
    return 1 if failures or not count else 0


if __name__ == "__main__":
    sys.exit(main())
