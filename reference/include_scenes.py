"""A scene for every texture, pigment, material, finish, interior, sky_sphere and color_map of the standard includes.

The includes declare 602 of them; each is put on the same few shapes, so that all can be compared with
povray and looked at side by side. The scenes are written when they are asked for, below build/includes/FILE.inc/.
"""
import re
from pathlib import Path

INCLUDES = Path("/usr/share/povray-3.7/include")
FILES = ("textures.inc", "stones1.inc", "stones2.inc", "stoneold.inc", "woods.inc", "woodmaps.inc", "metals.inc",
         "golds.inc", "glass.inc", "glass_old.inc", "skies.inc", "stars.inc", "finish.inc")

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
DECLARATION = re.compile(r"#\s*declare\s+(\w+)\s*=\s*(\w+)")

# The shapes of a texture stand on a floor whose pattern shows through glass.
HEAD = """// {name} of {file}.
#version 3.7;
global_settings {{ assumed_gamma 1 }}
#include "colors.inc"
#include "{file}"
"""
STAGE = """camera { location <0, 1.4, -7> look_at <0, -0.1, 0> angle 32 }
light_source { <-8, 9, -9> rgb 1 }
background { rgb <0.35, 0.5, 0.75> }
plane { y, -1.01 pigment { checker rgb 0.75, rgb <0.45, 0.5, 0.55> } }
"""
SHAPES = "sphere {{ <-0.85, 0, 0>, 1 {look} }}\nbox {{ <0.4, -1, -0.5>, <1.6, 0.5, 0.7> {look} rotate 25*y }}\n"
SKY_CAMERA = "camera { location 0 look_at <0, 0.6, 1> angle 75 }\nlight_source { <-8, 9, -9> rgb 1 }\n"

LOOKS = {
    "texture": "texture {{ {name} }}",
    "pigment": "pigment {{ {name} }}",
    "material": "material {{ {name} }}",
    "finish": "pigment {{ rgb <0.8, 0.5, 0.25> }} finish {{ {name} }}",
    "interior": "pigment {{ rgbt 1 }} finish {{ reflection 0.1 }} interior {{ {name} }}",
    "color_map": "pigment {{ bozo color_map {{ {name} }} scale 0.3 }}",
    "colour_map": "pigment {{ bozo color_map {{ {name} }} scale 0.3 }}",
}


def declared(file):
    """Names of an include file with their kinds, in the order of the text."""
    text = COMMENT.sub("", (INCLUDES / file).read_text(encoding="latin-1"))
    kinds = {}
    for name, value in DECLARATION.findall(text):
        kind = kinds.get(value, value)  # or another name for something declared above
        if kind in LOOKS or kind == "sky_sphere":
            kinds[name] = kind
    return kinds


def scene_text(file, name, kind):
    head = HEAD.format(name=name, file=file)
    if kind == "sky_sphere":
        return head + SKY_CAMERA + f"sky_sphere {{ {name} }}\n"
    return head + STAGE + SHAPES.format(look=LOOKS[kind].format(name=name))


def write(folder, files=FILES):
    """Writes the scenes as FOLDER/FILE.inc/NAME.pov; what is there with the same text is left alone."""
    for file in files:
        (folder / file).mkdir(parents=True, exist_ok=True)
        for name, kind in declared(file).items():
            path, text = folder / file / f"{name}.pov", scene_text(file, name, kind)
            if not path.exists() or path.read_text() != text:
                path.write_text(text)
