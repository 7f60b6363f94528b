#!/usr/bin/python3
"""Patterns at random points against the installed povray (fails where povray is missing).

For each noise generator one scene calls every pattern as a function at 200 points and writes the
values; both programs run it. Doubles must agree within 1e-9, single precision values within 2e-6.
Usage: random_points.py DURER
"""
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

POINTS = 200
DATA = Path(__file__).resolve().parent.parent / "data"

# As function { pattern { } }: double precision.
PATTERNS = """
agate | agate agate_turb 0.4 turbulence 0.3 octaves 4 omega 0.6 lambda 2.3 | boxed | boxed frequency 3 phase 0.2
bozo | bozo turbulence <0.3, 0.1, -0.4> | spotted | bumps sine_wave frequency 2 | dents | granite | granite turbulence 0.5
wrinkles | wrinkles triangle_wave | brick | brick brick_size <0.7, 0.3, 0.5> mortar 0.04 | cells | cells turbulence 0.2
checker | checker scale <0.3, 0.7, 1.1> rotate <10, 20, 30> | crackle | crackle form <1, 0.2, -0.3>
crackle metric 1 | crackle metric 2.5 form <0, 1, 0> | crackle offset 0.3 form <0.5, 0.2, 0> | crackle solid
crackle metric 0.6 solid | cubic | cylindrical | cylindrical poly_wave 2.5 | density_file df3 "d1.df3"
density_file df3 "d2.df3" interpolate 1 | density_file df3 "d4.df3" interpolate 2 | gradient x | gradient <1, -2, 0.5> frequency -1.5 phase 0.3
gradient y scallop_wave | hexagon | hexagon turbulence 0.2 scale 0.4 | image_pattern { ppm "a.ppm" }
image_pattern { png "g8.png" } scale 3 | image_pattern { png "palt.png" interpolate 3 use_alpha } | julia <0.353, 0.288>, 12 exterior 6, 0.3 | julia <-0.4, 0.6>, 9 exponent 3
julia <0.3, 0.5>, 15 exponent 6 interior 1, 1 exterior 0, 0.3 | leopard | leopard scale 0.1 cubic_wave
magnet 1 mandel 9 | magnet 2 mandel 9 interior 1, 0.3 | magnet 1 julia <0.8, 0.6>, 7 exterior 2, 0.01
magnet 2 julia <1.2, 0.3>, 7 exterior 4, 0.001 | mandel 15 | mandel 12 exponent 5 interior 4, 2 exterior 5, 0.1 | mandel 3 exponent 8 exterior 2, 1 scale 0.2
marble | marble turbulence 0.7 | marble turbulence <0.4, 5, 5> octaves 9 ramp_wave | object { sphere { 0, 1.3 } }
object { difference { box { -1, 1 } cylinder { -2*z, 2*z, 0.6 } rotate 20*x } } | onion | onion phase 0.4 sine_wave
pigment_pattern { checker rgb <1, 0.3, 0.2>, rgb <0.1, 0.5, 0.9> } | planar | planar rotate 30*z
quilted | quilted control0 0.3 control1 1.7 | quilted control0 -1.1 control1 1.4 phase 0.3 frequency 2 | radial | radial frequency 5 | ripples | ripples frequency 2.5 phase 0.3
spherical | spherical turbulence 0.4 | spiral1 3 | spiral1 -2 turbulence 0.3 | spiral2 4 | spiral2 2 turbulence 0.5 ramp_wave
waves | waves frequency 0.4 phase 0.6 | wood | wood turbulence <0.1, 0.3, 0> | wood turbulence 0.2 octaves 3 sine_wave
function { x*x - y*z } | function { sin(x*4) + y } frequency 0 | bozo warp { repeat 0.7*x flip <1, 0, 1> offset <0, 0.2, 0.1> }
gradient x warp { black_hole <0.2, 0.3, 0.1>, 1.5 strength 1.3 falloff 1.5 } scale <0.3, 1, 1>
bozo warp { black_hole 0.5, 0.4 repeat <1.2, 1.2, 1.2> turbulence <0.2, 0.1, 0.3> inverse } | bozo warp { cylindrical dist_exp 0.5 }
bozo warp { spherical orientation <1, 2, 3> dist_exp 1 } | bozo warp { toroidal major_radius 0.7 orientation y }
bozo warp { planar <1, 1, 0>, 0.3 } | bozo warp { cubic } | bozo warp { turbulence 0.4 octaves 3 } rotate 30*y turbulence 0.2
bozo scale 0.3 rotate <10, 50, 30> translate <1, -2, 3> matrix <1, 0.2, 0, 0, 1, 0.1, 0.3, 0, 1, 0.5, 0, 0>
"""
# As function { pigment { } }.red: single precision.
PIGMENTS = ["square", "triangular", "hexagon", "cubic", "checker", "brick", "bozo scale 0.2", "agate", "wood", "marble turbulence 1",
            "radial", "mandel 15", "average pigment_map { [1 bozo] [2 gradient x] }",
            "gradient x pigment_map { [0.2 bozo] [0.7 checker] } turbulence 0.3",
            "marble pigment_map { [0.2 bozo] [0.7 checker scale 0.3] } turbulence 0.3"]
PIGMENTS += [f"tiling {number} color_map {{ [0 rgb 0] [1 rgb 1] }}" for number in range(1, 28)]
PIGMENTS += [f"pavement number_of_sides {sides} number_of_tiles {tiles} pattern {pattern} exterior {exterior} "
             f"interior {interior} form {form} color_map {{ [0 rgb 0] [1 rgb 1] }}"
             for sides, tiles, pattern, exterior, interior, form in
             ((3, 4, 2, 1, 1, 0), (3, 6, 11, 2, 2, 1), (3, 5, 3, 0, 1, 2), (4, 4, 4, 1, 2, 3), (4, 6, 33, 2, 0, 2),
              (4, 3, 2, 0, 1, 1), (6, 5, 17, 0, 2, 0), (6, 4, 6, 1, 1, 1), (6, 3, 2, 2, 0, 2))]


def cases():
    doubles = [text.strip() for line in PATTERNS.strip().splitlines() for text in line.split("|")]
    return ([(text, f"pattern {{ {text} }}", "", 1e-9) for text in doubles]
            + [(text, f"pigment {{ {text} }}", ".red", 2e-6) for text in PIGMENTS])


def scene(generator):
    lines = ["#version 3.7;", f"global_settings {{ assumed_gamma 1 noise_generator {generator} }}",
             '#fopen Out "values.txt" write', f"#declare Random = seed({generator});",
             f"#declare Place = array[{POINTS}];",
             f"#for (I, 0, {POINTS - 1})",
             "  #declare Place[I] = <rand(Random), rand(Random), rand(Random)> * 8 - 4;", "#end"]
    for number, (_, body, member, _) in enumerate(cases()):
        lines += [f"#declare F{number} = function {{ {body} }}", f"#for (I, 0, {POINTS - 1})",
                  f"  #write (Out, str(F{number}(Place[I].x, Place[I].y, Place[I].z){member}, 0, 12), \"\\n\")", "#end"]
    return "\n".join(lines) + "\n#fclose Out\n"


def values(command, folder):
    output = folder / "values.txt"
    output.unlink(missing_ok=True)
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if not output.exists() or result.returncode != 0:
        raise SystemExit(f"{command[0]} fails:\n{result.stderr[-1500:]}")
    return [float(word) for word in output.read_text().split()]


def main():
    durer = sys.argv[1]
    if shutil.which("povray") is None:
        raise SystemExit("random_points: povray is not installed")
    passed = failed = 0
    for generator in (1, 2, 3):
        with tempfile.TemporaryDirectory(prefix="durer-random-points-") as name:
            folder = Path(name)
            for file in DATA.glob("*.*"):
                if file.suffix != ".json":
                    shutil.copy(file, folder)
            (folder / "points.pov").write_text(scene(generator))
            expected = values(["povray", "+Ipoints.pov", "-D", "-GA", "+W4", "+H3", "+Oout.png"], folder)
            found = values([durer, "points.pov", "--parse-only"], folder)
        if len(expected) != len(found) or len(expected) != POINTS * len(cases()):
            raise SystemExit(f"povray wrote {len(expected)} values, durer {len(found)}")
        for number, (text, _, _, tolerance) in enumerate(cases()):
            part = slice(number * POINTS, (number + 1) * POINTS)
            wrong = [(i, a, b) for i, (a, b) in enumerate(zip(expected[part], found[part]))
                     if not (abs(a - b) <= tolerance or (math.isnan(a) and math.isnan(b)))]
            failed += len(wrong)
            passed += POINTS - len(wrong)
            if wrong:
                i, a, b = wrong[0]
                print(f"noise_generator {generator}, {text}: {len(wrong)} wrong; point {i}: {b}, povray {a}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
