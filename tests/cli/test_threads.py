"""+WT holds in every phase: reading, building with Embree, rendering, images in and out.

Counted are threads that have used more than one tick of processor time. A library that comes along
with OpenImageIO (log4cplus) starts four when it is loaded, which sleep from their first moment on, and
OpenImageIO's pool one that ends after two milliseconds, when it is told the limit: the kernel's clock
may charge it a whole tick.
"""
import os
import subprocess
import time
import unittest

from render_case import DURER, RenderCase

# A mesh large enough for Embree, an image for OpenImageIO, and some work.
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -3> look_at 0 }
light_source { <5, 8, -6>, 1 area_light 2*x, 2*z, 7, 7 }
#declare N = 150;
mesh2 {
  vertex_vectors { N*N
    #for (I, 0, N - 1) #for (J, 0, N - 1) , <I/N - 0.5, 0.1*sin(I*0.3)*cos(J*0.2), J/N - 0.5>*3 #end #end }
  face_indices { 2*(N - 1)*(N - 1)
    #for (I, 0, N - 2) #for (J, 0, N - 2)
      , <I*N + J, I*N + J + 1, (I + 1)*N + J>, <I*N + J + 1, (I + 1)*N + J, (I + 1)*N + J + 1>
    #end #end }
  pigment { image_map { exr "in.exr" } rotate 90*x scale 3 }
}
"""


class Threads(RenderCase):
    def test_no_phase_starts_more(self):
        self.write("flat.pov", "#version 3.7; global_settings { assumed_gamma 1 }"
                   "plane { z, 1 pigment { bozo } finish { ambient 1 } }")
        self.durer("flat.pov", "+W64", "+H64", "+FE", "+Oin.exr", "-GA")
        self.write("scene.pov", SCENE)
        for threads in (1, 2, 3):
            with self.subTest(threads=threads):
                most, samples = self.most_threads(threads)
                self.assertGreater(samples, 20)
                self.assertLessEqual(most, threads)
                if threads > 1:
                    self.assertEqual(most, threads)

    def most_threads(self, threads):
        run = subprocess.Popen(
            [DURER, "scene.pov", "+W480", "+H360", "+A0.1", "+FE", "+Oout.exr", f"+WT{threads}",
             "-GA"],
            cwd=self.folder, stderr=subprocess.DEVNULL)
        most = samples = 0
        while run.poll() is None:
            working = 0
            try:
                for task in os.listdir(f"/proc/{run.pid}/task"):
                    with open(f"/proc/{run.pid}/task/{task}/stat") as status:
                        fields = status.read().rsplit(")", 1)[1].split()
                    working += int(fields[11]) + int(fields[12]) > 1
                samples += 1
            except (FileNotFoundError, ProcessLookupError):
                pass
            most = max(most, working)
            time.sleep(0.002)
        self.assertEqual(run.returncode, 0)
        return most, samples


if __name__ == "__main__":
    unittest.main()
