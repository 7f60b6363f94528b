"""Every output format against the file that povray writes: the same numbers in every pixel."""
import subprocess
import time
import unittest

import picture_files
from render_case import DURER, EXACT_SCENE, HEIGHT, WIDTH, RenderCase, input_picture

EXTENSIONS = {"N": "png", "T": "tga", "C": "tga", "J": "jpg", "P": "ppm", "B": "bmp", "E": "exr",
              "H": "hdr"}
SIZE = (f"+W{WIDTH}", f"+H{HEIGHT}")


class Formats(RenderCase):
    def setUp(self):
        super().setUp()
        (self.folder / "in.ppm").write_bytes(input_picture())
        self.write("linear.pov", EXACT_SCENE.format(gamma="1.0", more=""))
        self.write("curved.pov", EXACT_SCENE.format(gamma="2.2", more=""))
        self.write("clear.pov", EXACT_SCENE.format(gamma="1.0", more="transmit all 0.4"))
        old = EXACT_SCENE.format(gamma="1.0", more="").replace("assumed_gamma 1.0", "")
        self.write("old.pov", old.replace("#version 3.7", "#version 3.6"))

    def compare(self, scene, *options):
        with self.subTest(scene=scene, options=options):
            extension = EXTENSIONS[options[0][2]]
            self.povray(scene, *SIZE, *options, f"+Otheirs.{extension}")
            self.durer(scene, *SIZE, *options, f"+Oours.{extension}", "-GA")
            theirs, _ = picture_files.read(self.folder / f"theirs.{extension}")
            ours, _ = picture_files.read(self.folder / f"ours.{extension}")
            self.assertEqual(ours.shape, theirs.shape)
            self.assertEqual(abs(ours - theirs).max(), 0)

    def test_every_format(self):
        for letter in EXTENSIONS:
            self.compare("linear.pov", "+F" + letter)
        for letter in "NHP":
            self.compare("curved.pov", "+F" + letter)

    def test_alpha(self):
        for letter in EXTENSIONS:
            self.compare("clear.pov", "+F" + letter, "+UA")
        self.compare("clear.pov", "+FN16", "+UA")
        self.compare("clear.pov", "+FNg", "+UA")

    def test_bits_and_grey(self):
        for options in ("+FN16", "+FN5", "+FN11", "+FNg", "+FP16", "+FP10", "+FP6", "+FPg"):
            self.compare("linear.pov", options)
        self.compare("curved.pov", "+FPg", "Bits_Per_Color=16")
        self.compare("linear.pov", "+FJ", "Compression=40")

    def test_file_gamma(self):
        for gamma in ("1.0", "1.8", "srgb"):
            self.compare("curved.pov", "+FN", "File_Gamma=" + gamma)
        self.compare("linear.pov", "+FT", "File_Gamma=2.2")
        self.compare("linear.pov", "+FE", "File_Gamma=2.2")

    def test_scenes_without_gamma_count_as_srgb(self):
        for letter in EXTENSIONS:
            self.compare("old.pov", "+F" + letter, "File_Gamma=1.5")
        self.compare("old.pov", "+FN")
        theirs, ours = ((self.folder / name).read_bytes() for name in ("theirs.png", "ours.png"))
        for chunk in (b"gAMA", b"sRGB"):
            start = theirs.index(chunk)
            self.assertIn(theirs[start - 4:start + 8], ours)

    def test_headers_of_bmp(self):
        for scene, options in (("linear.pov", ()), ("clear.pov", ("+UA",))):
            self.compare(scene, "+FB", *options)
            theirs, ours = ((self.folder / name).read_bytes() for name in ("theirs.bmp", "ours.bmp"))
            self.assertEqual(ours[:54], theirs[:54])

    def test_bytes_of_targa(self):
        """All but the extension area, where povray says when and where it was compiled."""
        for scene, options in (("linear.pov", ("+FT",)), ("clear.pov", ("+FT", "+UA")),
                               ("linear.pov", ("+FC",)), ("clear.pov", ("+FC", "+UA")),
                               ("curved.pov", ("+FC", "File_Gamma=1.8")), ("curved.pov", ("+FT",)),
                               ("linear.pov", ("+FT", "File_Gamma=1.0")), ("old.pov", ("+FT",))):
            self.compare(scene, *options)
            theirs, ours = ((self.folder / name).read_bytes() for name in ("theirs.tga", "ours.tga"))
            extension = int.from_bytes(theirs[-26:-22], "little")
            self.assertEqual(ours[:extension + 2], theirs[:extension + 2])
            self.assertEqual(ours[extension + 470:], theirs[extension + 470:])

    def test_dithering(self):
        for method in ("B2", "B3", "B4", "D1", "D2", "FS"):
            self.compare("linear.pov", "+FN", "+TH" + method)
        for letter in "BHJE":
            self.compare("linear.pov", "+F" + letter, "+THFS")
        self.compare("clear.pov", "+FN", "+UA", "+THFS")
        self.compare("curved.pov", "+FN5", "+THB3")

    def test_pictures_are_the_same_in_every_run(self):
        for name in ("jpeg", "exr", "hdr", "tiff", "tga-rle", "bmp", "png"):
            with self.subTest(format=name):
                contents = []
                for folder in ("first", "second"):
                    (self.folder / folder).mkdir(exist_ok=True)
                    self.durer("linear.pov", *SIZE, "--type", name, f"+O{folder}/", "-GA")
                    contents.append({path.name: path.read_bytes()
                                     for path in (self.folder / folder).iterdir()})
                    # Longer than the resolution of dates in files.
                    time.sleep(1.1)
                self.assertEqual(contents[0], contents[1])

    def test_standard_output(self):
        for letter in "NTPBH":
            with self.subTest(format=letter):
                self.durer("linear.pov", *SIZE, "+F" + letter, "+Ofile", "-GA")
                with open(self.folder / "piped", "wb") as pipe:
                    subprocess.run([DURER, "linear.pov", *SIZE, "+F" + letter, "+O-", "-GA"],
                                   cwd=self.folder, stdout=pipe, check=True)
                self.assertEqual(self.bytes_of("piped"),
                                 self.bytes_of("file." + EXTENSIONS[letter]))


if __name__ == "__main__":
    unittest.main()
