"""The scenes that are compared: Debian's povray-examples, our own, the standard includes' textures, or single files."""
import csv
import hashlib
from dataclasses import dataclass
from pathlib import Path

import include_scenes

REFERENCE = Path(__file__).resolve().parent
REPOSITORY = REFERENCE.parent
EXAMPLES = Path("/usr/share/doc/povray/examples")
OWN_FOLDERS = ("gallery", "teaching", "bench")
INCLUDE_SCENES = REPOSITORY / "build/includes"


@dataclass(frozen=True)
class Scene:
    suite: str
    name: str      # below the suite's root, without ".pov": "textures/patterns/agate"
    path: Path
    options: tuple = ()   # without which povray does not render it: those of one frame of an animation

    @property
    def label(self):
        return f"{self.suite}/{self.name}"

    def content_hash(self):
        """Of the scene and of every file below its folder that it may read.

        Other scenes of the folder count only if this one names them: a new scene in the gallery
        leaves the cached pictures of its neighbours valid.
        """
        text = self.path.read_bytes()
        digest = hashlib.sha256(text)
        for file in sorted(self.path.parent.rglob("*")):
            if not file.is_file() or file == self.path:
                continue
            if file.suffix.lower() in (".pov", ".md") and file.stem.encode() not in text:
                continue
            digest.update(str(file.relative_to(self.path.parent)).encode() + b"\0")
            digest.update(file.read_bytes())
        return digest.hexdigest()


@dataclass(frozen=True)
class Survey:
    """What povray makes of a scene at 160x120 (see the script `survey`)."""
    renders: str       # yes, no, slow (takes minutes: left out)
    random: bool       # povray disagrees with itself
    povray_cpu: float
    note: str          # povray's own first error line where it does not render
    options: tuple     # of the frame that is drawn where povray renders the scene only as a frame


def find_scenes(words, name_filter=""):
    """Scenes of suites ("examples", "examples/textures", "ours", "ours/gallery", "includes", "includes/stars.inc") and
    .pov files."""
    scenes = []
    for word in words:
        found = scenes_of(word)
        if not found and word != "ours":
            raise SystemExit(f"reference: no scenes in {word!r}; suites are: examples, examples/FOLDER, "
                             "ours, ours/gallery, ours/teaching, ours/bench, includes, includes/FILE.inc, or a .pov file")
        scenes += found
    unique = {scene.label: scene for scene in scenes}
    return [scene for scene in unique.values() if name_filter in scene.label]


def scenes_of(word):
    suite, _, folder = word.strip("/").partition("/")
    if suite == "examples" and not word.endswith(".pov"):
        return below("examples", EXAMPLES, folder)
    if suite == "ours" and not word.endswith(".pov"):
        own = REPOSITORY / "scenes"
        folders = [folder] if folder else [name for name in OWN_FOLDERS if (own / name).is_dir()]
        return [scene for name in folders for scene in below("ours", own, name)]
    if suite == "includes" and not word.endswith(".pov"):
        include_scenes.write(INCLUDE_SCENES)
        return below("includes", INCLUDE_SCENES, folder)
    path = Path(word).resolve()
    if path.is_file():
        return [Scene("file", path.stem, path)]
    return []


def below(suite, root, folder):
    survey = read_survey(suite)
    scenes = []
    for path in sorted((root / folder).rglob("*.pov")):
        name = str(path.relative_to(root).with_suffix(""))
        scenes.append(Scene(suite, name, path, survey[name].options if name in survey else ()))
    return scenes


def survey_path(suite):
    return REFERENCE / "suites" / f"{suite}.tsv"


def read_survey(suite):
    path = survey_path(suite)
    if not path.exists():
        return {}
    with open(path, newline="") as file:
        return {row["scene"]: Survey(row["renders"], row["random"] == "yes",
                                     float(row["povray_cpu_160"] or 0), row["note"],
                                     tuple(row["options"].split()))
                for row in csv.DictReader(file, delimiter="\t")}
