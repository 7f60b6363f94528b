"""Results as TSV, as a printed summary and as an HTML page with the pictures side by side."""
import csv
import html
import re
from collections import Counter, defaultdict
from dataclasses import asdict, dataclass, fields

import numpy
from PIL import Image

import grades

AMPLIFICATION = 8


@dataclass
class Row:
    scene: str
    size: str
    options: str
    grade: str
    random: str               # yes: povray disagrees with itself, `close` is asked
    verdict: str              # pass, fail, or known: listed in known_differences.tsv and matching there
    within_2: float
    within_4: float
    blocks_beyond_6: float
    blocks_beyond_16: float
    largest_block: float
    bias: float
    durer_cpu: float
    povray_cpu: float
    ratio: float              # povray's CPU seconds divided by durer's
    exit_code: int
    error: str

    @property
    def key(self):
        return (self.scene, self.size, self.options)


FLOATS = {field.name for field in fields(Row) if field.type is float}


def write_tsv(rows, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, delimiter="\t", lineterminator="\n")
        writer.writerow([field.name for field in fields(Row)])
        for row in rows:
            writer.writerow([f"{value:.4g}" if isinstance(value, float) else
                             str(value).replace("\t", " ") for value in asdict(row).values()])


def read_tsv(path):
    with open(path, newline="") as file:
        rows = []
        for line in csv.DictReader(file, delimiter="\t"):
            line = {name: float(value) if name in FLOATS else value for name, value in line.items()}
            line["exit_code"] = int(line["exit_code"])
            rows.append(Row(**line))
        return rows


def regressions(old_rows, new_rows):
    """Pairs (old, new) of scenes whose grade got worse."""
    old = {row.key: row for row in old_rows}
    return [(old[row.key], row) for row in new_rows
            if row.key in old and grades.worse(row.grade, old[row.key].grade)]


def without_place(error):
    """An error line without file, line and column: equal for equal mistakes in different scenes."""
    text = re.sub(r"^\S+\.(pov|inc|ini|mcr)[:\s(]*\d*(:\d+)?\)?[:,]?\s*", "", error, flags=re.I)
    text = re.sub(r"found '[^']*', which is not declared", "found NAME, which is not declared", text)
    return re.sub(r"may not write '[^']*'", "may not write FILE", text)[:140]


def cause(row):
    """What failed, without the place where it did: failing scenes are grouped by it."""
    return f"{row.grade}: {without_place(row.error)}" if row.error else row.grade


def summary(rows):
    lines = []
    for options in dict.fromkeys((row.size, row.options) for row in rows):
        part = [row for row in rows if (row.size, row.options) == options]
        counts = Counter(row.grade for row in part)
        passed = sum(row.verdict != "fail" for row in part)
        lines.append(f"{options[0]} {options[1]}: {len(part)} scenes, {passed} pass "
                     f"({100 * passed / len(part):.1f} %); "
                     + ", ".join(f"{grade} {counts[grade]}" for grade in grades.ORDER if counts[grade]))
        rendered = [row for row in part if row.grade in grades.ORDER[:4]]
        if rendered:
            exact = sum(row.grade in ("exact", "match") for row in rendered)
            slower = [row for row in rendered if row.durer_cpu > max(row.povray_cpu, 0.05)]
            lines.append(f"  of {len(rendered)} rendered: {100 * exact / len(rendered):.1f} % match; "
                         f"{len(slower)} slower than povray (CPU); CPU durer "
                         f"{sum(row.durer_cpu for row in rendered):.1f} s, povray "
                         f"{sum(row.povray_cpu for row in rendered):.1f} s")
    return "\n".join(lines)


def failures_by_cause(rows):
    groups = defaultdict(list)
    for row in rows:
        if row.verdict == "fail":
            groups[cause(row)].append(row)
    lines = []
    for text, group in sorted(groups.items(), key=lambda item: -len(item[1])):
        lines.append(f"{len(group):4} {text}")
        for row in group:
            figures = ""
            if row.grade in grades.ORDER[:4]:
                figures = (f"  within 4: {100 * row.within_4:.1f} %, largest block {row.largest_block:.0f}"
                           f", bias {row.bias:+.1f}")
            place = f"  [{row.error[:160]}]" if row.error else ""
            lines.append(f"       {row.scene} {row.size} {row.options}{figures}{place}")
    return "\n".join(lines)


def picture_name(row):
    return re.sub(r"[^A-Za-z0-9_.-]", "_", f"{row.scene}_{row.size}_{row.options}")


def save_pictures(row, reference, picture, folder):
    """8-bit copies of both pictures and their difference, amplified around middle grey."""
    folder.mkdir(parents=True, exist_ok=True)
    name = picture_name(row)
    Image.fromarray(reference.astype(numpy.uint8)).save(folder / f"{name}.povray.png")
    if picture is not None:
        Image.fromarray(picture.astype(numpy.uint8)).save(folder / f"{name}.durer.png")
    if picture is not None and picture.shape == reference.shape:
        amplified = numpy.clip(128 + AMPLIFICATION * (picture - reference), 0, 255)
        Image.fromarray(amplified.astype(numpy.uint8)).save(folder / f"{name}.difference.png")


STYLE = """
body { font: 14px/1.4 sans-serif; margin: 2em; background: #fafaf8; color: #222 }
.scene { display: inline-block; vertical-align: top; margin: 0 1em 1.5em 0; padding: .6em;
         background: white; border: 1px solid #ddd; max-width: 540px }
.scene img { width: 160px; image-rendering: pixelated; background: #eee }
.fail { border-color: #c33 } .grade { font-weight: bold }
pre { background: white; padding: 1em; border: 1px solid #ddd; white-space: pre-wrap }
"""


def write_html(rows, folder, title):
    pictures = folder / "pictures"
    order = sorted(rows, key=lambda row: (row.verdict != "fail", -grades.ORDER.index(row.grade),
                                          row.within_4, row.scene))
    parts = [f"<!doctype html><meta charset=utf-8><title>{html.escape(title)}</title>",
             f"<style>{STYLE}</style><h1>{html.escape(title)}</h1>",
             f"<pre>{html.escape(summary(rows))}</pre>",
             f"<p>Left povray, middle durer, right their difference times {AMPLIFICATION} around middle "
             "grey. Failing scenes come first.</p>"]
    for row in order:
        images = ""
        for kind in ("povray", "durer", "difference"):
            file = pictures / f"{picture_name(row)}.{kind}.png"
            if file.exists():
                images += f'<img loading=lazy src="pictures/{html.escape(file.name)}" alt="{kind}"> '
        figures = (f"within 2: {100 * row.within_2:.2f} %, within 4: {100 * row.within_4:.2f} %, "
                   f"largest block {row.largest_block:.1f}, bias {row.bias:+.2f}")
        if row.error:
            figures = html.escape(row.error)
        times = f"CPU: durer {row.durer_cpu:.2f} s, povray {row.povray_cpu:.2f} s, ratio {row.ratio:.2f}"
        parts.append(f'<div class="scene {row.verdict}"><b>{html.escape(row.scene)}</b> {row.size} '
                     f'{html.escape(row.options)}<br>{images}<br><span class=grade>{row.grade}</span>'
                     f"{' (random)' if row.random == 'yes' else ''} {row.verdict}; {times}<br>"
                     f"{figures}</div>")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "index.html").write_text("\n".join(parts))
