"""The command line and INI files against the installed povray.

Each case runs both programs with the same arguments in equal folders. The exit status, the files that
appear, change and vanish, the pictures (in files and on standard output), and what the scene says
through #debug (its automatic identifiers: frame numbers, clocks, sizes) must be the same. Nothing is
cached, and without povray the test fails.

    compare_with_povray.py DURER [PART OF A CASE]
"""
import io
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import installed_povray  # noqa: E402

SECONDS = 120

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat("SAYS ", str(frame_number, 0, 0), " ", str(initial_frame, 0, 0), " ",
              str(final_frame, 0, 0), " ", str(initial_clock, 0, 6), " ", str(final_clock, 0, 6), "\\n")
#debug concat("SAYS ", str(clock_delta, 0, 8), " ", str(clock, 0, 9), " ", str(clock_on, 0, 0), " ",
              str(image_width, 0, 0), "x", str(image_height, 0, 0), " ", input_file_name, "\\n")
#ifdef (Given) #debug concat("SAYS Given ", str(Given, 0, 10), "\\n") #end
#ifdef (Text) #debug concat("SAYS Text ", Text, "\\n") #end
background { rgb <0.2, 0.4, 0.6> }
camera { location -3 * z look_at 0 }
light_source { <2, 4, -3> 1 }
light_source { <-4, 4, -3> 0.5 area_light x, y, 2, 2 }
sphere { 0, 1 pigment { rgbf <1, 0.5, 0.2, 0.5> quick_color rgb y } finish { reflection 0.3 }
  interior { ior 1.5 } }
plane { y, -1 pigment { checker rgb 1 rgb 0.1 } normal { bumps 0.4 } }
fog { distance 20 rgb 0.5 }
"""

SETTINGS = """; a comment
+W9 +H7
Library_Path=inc , sub
Declare=Given=3
[one]
Width=12 ; another
[two]
Height=6
Output_File_Name=two.png
"""

FILES = {
    "s.pov": SCENE,
    "sub/q.pov": SCENE,
    "bad.pov": '#error "stop"\n',
    "out/keep": "",
    "inc/head.inc": "#declare Given = 77;\n",
    "a.ini": SETTINGS,
    "b.ini": "Input_File_Name=s.pov\nWidth=6 Height=9\nInclude_INI=a.ini[one]\n",
    "unknown.ini": "Nonsense=3\n",
    "shell.ini": "Pre_Scene_Command=touch before\nPost_Frame_Command=touch after%n\n",
    "stop.ini": "Pre_Scene_Command=false\nPre_Scene_Return=F\n",
    "switches.ini": 's.pov +W6 +H5 "+Oq w.png"\n',
    "old_mac.ini": "Width=7\rHeight=6\r",
    "animation.ini": "Final_Frame=2\nOutput_File_Name=an\n[cyclic]\nCyclic_Animation=on\n",
    "declares.ini": "Declare=Given=5,Other=6\n",
    "quoted.ini": 'Declare=Text="a b",Given=8\n',
    "skip.ini": "Final_Frame=2\nPost_Frame_Command=false\nPost_Frame_Return=S\n",
    "abort.ini": "Pre_Frame_Command=false\nPre_Frame_Return=U\n",
    "unknown_return.ini": "s.pov +W6 +H5\nPre_Scene_Command=false\nPre_Scene_Return=!X\nDebug_File=no\n",
    "late.ini": "Post_Scene_Command=false\nPost_Scene_Return=F\n",
    "blanks.ini": "Input_File_Name=s.pov  \nWidth=6\t\nHeight=5 \nOutput_File_Name=a b  \n",
    "blanks_behind.ini": "Input_File_Name=s.pov\nWidth=6 Height=5\nOutput_File_Name=abc  \n\n",
    "word_and_setting.ini": "Input_File_Name=s.pov\nWidth=6\nOutput_File_Name=abc Clock=1\nHeight=5\n",
    "word_and_switch.ini": "Input_File_Name=s.pov\nWidth=6\nOutput_File_Name=abc -J\nHeight=5\n",
    "two_words.ini": "a.ini s.pov\nWidth=6\nHeight=5\n",
    "old_comment.ini": "/* a.ini */\nInput_File_Name=s.pov\nWidth=6\nHeight=5\n",
    "empty_toggle.ini": "Input_File_Name=s.pov\nWidth=6\nHeight=5\nOutput_Alpha=\n",
    "rest_of_line.ini": "Clock=0.5 Quality=1\nAntialias_Depth=2 Antialias=on\n",
}

# Arguments separated by blanks; the size is +W10 +H8 unless a case says otherwise.
CASES = """
s.pov | +Is | sub/q.pov | +Isub/q.pov +Ox.png | nosuch.pov | nosuch | bad.pov
s.pov +Oout/ | s.pov +Oout | s.pov +O.png | sub/q.pov +Oout/.png | s.pov +Ofoo.tga | s.pov +Ofoo.PNG
s.pov +Ofoo. | s.pov +Onone/foo | s.pov +O- | s.pov +Ostdout | s.pov -F | s.pov +FX | s.pov +FE +O-
s.pov +FT | s.pov +FC | s.pov +FP | s.pov +FB | s.pov +FJ | s.pov +FNg | s.pov +FN16
s.pov +FTg | s.pov +FT +O- | s.pov +UA | s.pov +UA +FN16 | s.pov File_Gamma=1.0 | s.pov +THB2 +TH
s.pov +KFF3 | s.pov +KFF4 +KC | s.pov +KFF10 +SF9 | s.pov +KFF9 +KC +SF8 | s.pov +KFF1 +KFI1
s.pov +KFI0 +KFF0 | s.pov +K0.1 | s.pov +KFF3 +KI1 +KF4 | s.pov +KFI2 +KFF6 +STP2 | s.pov +KFF10 +SF0.9
s.pov +KFF10 +SF0.5 +EF0.6 | s.pov +KFF3 +SF3 +EF5 | s.pov +KFI-2 +KFF2 | s.pov +KFF2 +Oout/bar
s.pov +KFF2 +Obar.png | s.pov +KFF3 +KFI5
s.pov Declare=Given=1.23456789 | s.pov Declare='Text="abc"' | s.pov Declare=image_width=77
s.pov Declare=Given=5 Declare=Given=6 | s.pov Declare=Given=3,4 | s.pov Declare=Given | s.pov Declare=Given=
s.pov +SC3 +EC5 +SR2 +ER4 | s.pov +SR0.25 +ER0.75 | s.pov +ER4.9 | s.pov +SC0.7 | s.pov +EC0.7
s.pov +SR5 +ER2 | s.pov +SC1.5 +EC3.5
s.pov +Q0 | s.pov +Q2 | s.pov +Q4 | s.pov +Q5 | s.pov +Q6 | s.pov +Q8 | s.pov +Q9 | s.pov +Q-1 | s.pov +Q99
s.pov +A0.1 | s.pov +A0.1 +AM2 +R2 | s.pov +BS2 | s.pov +BS4 | s.pov +ZZ | s.pov Nonsense=3
s.pov +GDd.out | s.pov Debug_File=true | s.pov +GDd.out +Oout/x | s.pov All_File=sub/zz | s.pov -GD
s.pov +HIhead.inc +Linc | s.pov +HInone.inc | s.pov +MV3.5 | s.pov +RTR
s.pov a.ini | s.pov a | s.pov a[one] | s.pov a.ini[TWO] | s.pov a.ini[none] | b.ini | s.pov unknown.ini
s.pov shell.ini | s.pov stop.ini | switches.ini | s.pov old_mac.ini | s.pov animation.ini
s.pov animation.ini[cyclic] | s.pov declares.ini | s.pov rest_of_line.ini | s.pov a.ini +W3
s.pov Include_INI=a.ini | s.pov quoted.ini | s.pov skip.ini | s.pov abort.ini | s.pov late.ini
two_words.ini | old_comment.ini | empty_toggle.ini
s.pov Debug_File=off | s.pov Debug_File=0 | s.pov Debug_File= | s.pov Debug_File=tr | s.pov Debug_File=one.txt
s.pov +GDoff | s.pov Pre_Scene_Return=X | s.pov Post_Frame_Return= | s.pov Fatal_Error_Return=-Zebra
unknown_return.ini
blanks.ini | blanks_behind.ini | word_and_setting.ini | word_and_switch.ini
"""
SIZED = ("unknown_return", "a.ini", "two_words", "old_comment", "empty_toggle", "a", "a[", "b.ini", "blanks", "word_and", "switches.ini", "old_mac.ini", "Include_INI")

# Files that lie there before: a finished picture is skipped with +C, an empty one is not.
BEFORE = [
    ("s.pov +C", {"s.png": ""}),
    ("s.pov +C", {"s.png": "not a picture"}),
    ("s.pov +C +KFF2", {"s1.png": "not a picture"}),
    ("s.pov", {"s.png": "not a picture"}),
]
ENVIRONMENT = [
    ("s.pov", {"env.ini": "Width=5\nHeight=4\n"}, {"POVINI": "env.ini"}),
    ("s.pov", {"povray.ini": "Width=4\nHeight=4\n"}, {}),
    ("s.pov +HIhead", {}, {"POVINC": "inc"}),
    ("s.pov", {}, {"POVINI": "nothere.ini"}),
]


def cases():
    """(arguments, further files, environment) of each case."""
    for text in re.split(r"[|\n]", CASES):
        if text.strip():
            yield text.split(), {}, {}
    for text, files in BEFORE:
        yield text.split(), files, {}
    for text, files, environment in ENVIRONMENT:
        yield text.split(), files, environment


def content(folder):
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


class Outcome:
    """What a program does in a folder of its own."""

    def __init__(self, program, arguments, files, environment):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for path, text in {**FILES, **files}.items():
                (folder / path).parent.mkdir(exist_ok=True)
                (folder / path).write_text(text)
            before = content(folder)
            done = subprocess.run([program, *arguments], cwd=folder, stdin=subprocess.DEVNULL,
                                  capture_output=True, timeout=SECONDS, check=False,
                                  env={**os.environ, **environment})
            after = content(folder)
        self.status = done.returncode
        self.stdout = done.stdout
        self.messages = done.stderr.decode("latin-1")
        self.written = {path: data for path, data in after.items() if before.get(path) != data}
        self.removed = sorted(set(before) - set(after))

    def debug(self, text=None):
        # Lines are wrapped at 80 columns, with a blank lost or won there.
        unwrapped = re.sub(r"\n +", "", self.messages if text is None else text)
        return [line.replace(" ", "") for line in re.findall("^SAYS .*", unwrapped, re.MULTILINE)]


def picture(data):
    try:
        return Image.open(io.BytesIO(data))
    except OSError:
        return None


def compare_pictures(name, theirs, ours):
    a, b = picture(theirs), picture(ours)
    if not a or not b:
        return f"{name}: {'durer' if a else 'povray'} writes no picture" if a or b else ""
    if (a.size, a.mode) != (b.size, b.mode):
        return f"{name}: povray {a.size} {a.mode}, durer {b.size} {b.mode}"
    # JPEG loses differently in two libraries; 16-bit samples are compared as they are.
    most = 12 if a.format == "JPEG" else 512 if a.mode.startswith("I") else 2
    bands = [zip(x.getdata(), y.getdata()) for x, y in zip(a.split(), b.split())]
    pixels = a.size[0] * a.size[1]
    different = max(sum(abs(x - y) > most for x, y in band) for band in bands)
    return f"{name}: {different} of {pixels} pixels differ" if different > pixels / 50 else ""


def differences(povray, durer):
    found = []
    if povray.status != durer.status:
        found.append(f"status: povray {povray.status}, durer {durer.status}")
    if sorted(povray.written) != sorted(durer.written):
        found.append(f"written: povray {sorted(povray.written)}, durer {sorted(durer.written)}")
    if povray.removed != durer.removed:
        found.append(f"removed: povray {povray.removed}, durer {durer.removed}")
    if povray.debug() != durer.debug():
        found.append(f"#debug: povray {povray.debug()}, durer {durer.debug()}")
    for name in set(povray.written) & set(durer.written):
        if name.endswith(".out"):
            texts = [one.debug(one.written[name].decode("latin-1")) for one in (povray, durer)]
            if texts[0] != texts[1]:
                found.append(f"{name}: povray {texts[0]}, durer {texts[1]}")
        else:
            found.append(compare_pictures(name, povray.written[name], durer.written[name]))
    found.append(compare_pictures("standard output", povray.stdout, durer.stdout))
    return [one for one in found if one]


def main():
    povray, durer, part = installed_povray.programs()

    def check(case):
        arguments, files, environment = case
        size = [] if any(word.startswith(SIZED) for word in arguments[:2]) or files or environment \
            else ["+W10", "+H8"]
        arguments = [*size, *arguments, "-D", "+WT1"]
        return "\n    ".join(differences(Outcome(povray, [*arguments, "-P"], files, environment),
                                         Outcome(durer, arguments, files, environment)))

    return installed_povray.exit_code([case for case in cases() if part in " ".join(case[0])], check,
                                      lambda case: " ".join(case[0]), "cases do what povray does")


if __name__ == "__main__":
    sys.exit(main())
