#!/usr/bin/python3
"""Fails when a room includes a header of a room that it must not know (design.md 2, "Direction")."""
import pathlib
import re
import sys

# room -> the rooms it may include, besides itself
BASE = {"tracer/math", "tracer/field", "tracer/system"}
SCENE = BASE | {"tracer/scene"}
GEOMETRY = SCENE | {"tracer/shapes", "tracer/patterns", "tracer/functions"}
TEXTURE = GEOMETRY | {"tracer/texture", "tracer/image"}
RENDER = TEXTURE | {"tracer/lights", "tracer/cameras", "tracer/volumes", "tracer/world",
                    "tracer/intersect", "tracer/shading", "tracer/sampling"}
ALLOWED = {
    "tracer/system": set(),
    "tracer/math": set(),
    "tracer/field": {"tracer/math"},
    "tracer/scene": BASE,
    "tracer/functions": SCENE | {"tracer/patterns", "tracer/image"},
    "tracer/patterns": SCENE | {"tracer/functions", "tracer/image"},
    "tracer/shapes": SCENE | {"tracer/functions", "tracer/image"},
    "tracer/image": SCENE,
    "tracer/texture": TEXTURE,
    "tracer/lights": RENDER,
    "tracer/cameras": RENDER,
    "tracer/volumes": RENDER,
    "tracer/world": RENDER - {"tracer/shading", "tracer/sampling"},
    "tracer/intersect": GEOMETRY | {"tracer/world"},
    "tracer/shading": RENDER - {"tracer/sampling"},
    "tracer/sampling": RENDER,
    "gi": RENDER,
    "parser": RENDER,
    "cli": RENDER | {"gi", "parser"},
}
# Headers of these libraries stay in .cpp files; only GLM may appear in headers.
HEAVY = re.compile(r'#include <(embree3|OpenImageIO|boost|tbb|oneapi|ft2build|freetype|fmt|CLI|hwy)/')


def room_of(path):
    for room in sorted(ALLOWED, key=len, reverse=True):
        if path == room or path.startswith(room + "/"):
            return room
    return None


def main():
    root = pathlib.Path(sys.argv[1])
    wrong = []
    for top in ("parser", "tracer", "gi", "cli"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            path = file.relative_to(root).as_posix()
            room = room_of(path)
            for number, line in enumerate(file.read_text(errors="replace").splitlines(), 1):
                if file.suffix == ".h" and HEAVY.search(line):
                    wrong.append(f"{path}:{number}: header of a library that must stay in .cpp files")
                match = re.match(r'\s*#include "([^"]+)"', line)
                target = room_of(match.group(1)) if match else None
                if target and target != room and target not in ALLOWED[room]:
                    wrong.append(f"{path}:{number}: {room} must not include {match.group(1)}")
    print("\n".join(wrong), end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
