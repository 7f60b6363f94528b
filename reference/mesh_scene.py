"""Write the scene of a mesh2 with a million triangles: too large for git (about 36 MB)."""
import math
from pathlib import Path


def write(path, cells=708):
    """A wavy field of 2 * cells^2 triangles (708: 1,002,528)."""
    count = cells + 1
    with open(Path(path), "w") as file:
        file.write("#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
                   "camera { location <0.5, 0.7, -0.6> look_at <0.5, 0, 0.45> }\n"
                   "light_source { <2, 3, -2> rgb 1 }\n"
                   f"mesh2 {{\n  vertex_vectors {{\n    {count * count}")
        for row in range(count):
            for column in range(count):
                u, v = column / cells, row / cells
                height = 0.06 * math.sin(23 * u) * math.cos(17 * v) + 0.004 * math.sin(211 * u * v)
                file.write(f",\n    <{u:.6f}, {height:.6f}, {v:.6f}>")
        file.write(f"\n  }}\n  face_indices {{\n    {2 * cells * cells}")
        for row in range(cells):
            for column in range(cells):
                corner = row * count + column
                file.write(f",\n    <{corner}, {corner + 1}, {corner + count}>"
                           f", <{corner + 1}, {corner + count + 1}, {corner + count}>")
        file.write("\n  }\n  pigment { rgb <0.5, 0.6, 0.8> }\n}\n")
