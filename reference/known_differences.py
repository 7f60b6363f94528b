"""The list of scenes that are allowed to differ from povray, each with the settings that make them match.

reference/known_differences.tsv, one line per scene, columns:
  scene            label, such as examples/objects/isosurface
  class            max_gradient (holes from a too small max_gradient), thread_history (randomness that
                   depends on which thread drew which pixel before), undefined_value
  edit             OLD=>NEW: literal text replaced in the scene for both programs, or empty
  durer_switches   added for durer, or empty
  povray_switches  added for povray, or empty
  reason           one sentence
With the edit and switches the pictures must reach the grade asked of the scene; `compare` runs that too.
At most 2 % of a suite may be listed.
"""
import csv
import shlex
import shutil
from dataclasses import dataclass, replace
from pathlib import Path

import suites

PATH = suites.REFERENCE / "known_differences.tsv"
COLUMNS = ("scene", "class", "edit", "durer_switches", "povray_switches", "reason")
CLASSES = ("max_gradient", "thread_history", "undefined_value")
LARGEST_SHARE = 0.02


@dataclass
class KnownDifference:
    scene: str
    kind: str
    edit: tuple            # () or (old, new)
    durer_switches: tuple
    povray_switches: tuple
    reason: str

    def edited(self, scene, root):
        """The scene with the edit applied, in a copy of its folder below `root`."""
        if not self.edit:
            return scene
        folder = Path(root) / scene.path.parent.name
        shutil.copytree(scene.path.parent, folder, dirs_exist_ok=True)
        path = folder / scene.path.name
        text = path.read_bytes().decode("latin-1")
        if self.edit[0] not in text:
            raise SystemExit(f"{PATH}: {self.scene} does not contain {self.edit[0]!r}")
        path.write_bytes(text.replace(*self.edit).encode("latin-1"))
        return replace(scene, path=path)


def read(path=PATH):
    known = {}
    with open(path, newline="") as file:
        reader = csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE)
        if tuple(reader.fieldnames or ()) != COLUMNS:
            raise SystemExit(f"{path}: the columns must be {', '.join(COLUMNS)}")
        for row in reader:
            where = f"{path}: {row['scene']}"
            if row["class"] not in CLASSES:
                raise SystemExit(f"{where}: class {row['class']!r} is none of {', '.join(CLASSES)}")
            if not (row["edit"] or row["durer_switches"] or row["povray_switches"]):
                raise SystemExit(f"{where}: names no setting with which the pictures match")
            edit = tuple(row["edit"].split("=>")) if row["edit"] else ()
            if len(edit) not in (0, 2):
                raise SystemExit(f"{where}: the edit must be OLD=>NEW")
            known[row["scene"]] = KnownDifference(
                row["scene"], row["class"], edit, tuple(shlex.split(row["durer_switches"])),
                tuple(shlex.split(row["povray_switches"])), row["reason"])
    return known
