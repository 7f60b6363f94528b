"""What scenes and INI files of strangers may do: write below two folders, run nothing."""
import os
import unittest

from render_case import RenderCase


class Safety(RenderCase):
    def setUp(self):
        super().setUp()
        for name in ("work", "work/sub", "elsewhere", "out"):
            (self.folder / name).mkdir()
        self.elsewhere = self.folder / "elsewhere"
        self.top, self.folder = self.folder, self.folder / "work"

    def try_to_write(self, path, *options, status):
        self.write("s.pov", f'#version 3.7; global_settings {{ assumed_gamma 1 }}\n'
                            f'#fopen F "{path}" write #write(F, "x") #fclose F sphere {{ 0, 1 }}')
        return self.durer("s.pov", "+W4", "+H3", *options, status=status).stderr

    def test_below_the_current_and_the_output_folder(self):
        for path in ("a.txt", "sub/a.txt", "sub/../b.txt", str(self.folder / "c.txt")):
            self.try_to_write(path, status=0)
            self.assertEqual((self.folder / path).read_text(), "x")
        self.try_to_write("../out/a.txt", f"+O{self.top}/out/", status=0)
        self.assertTrue((self.top / "out/s.png").exists())

    def test_nowhere_else(self):
        os.symlink(self.elsewhere, self.folder / "folder_link")
        os.symlink(self.elsewhere / "new.txt", self.folder / "link")
        for path in ("../elsewhere/a.txt", "sub/../../elsewhere/a.txt", "folder_link/a.txt", "link",
                     str(self.elsewhere / "a.txt"), "/dev/shm/durer_must_not_write_this"):
            self.assertIn("--allow-write", self.try_to_write(path, status=1))
        self.assertEqual(list(self.elsewhere.iterdir()), [])

    def test_allowed_folder(self):
        self.try_to_write("../elsewhere/a.txt", "--allow-write", "../elsewhere", status=0)
        self.try_to_write("../out/a.txt", "--allow-write", "../elsewhere", status=1)

    def run_ini(self, lines, *options, status):
        self.write("s.pov", "#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }")
        self.write("run.ini", "Input_File_Name=s.pov\nWidth=4\nHeight=3\n" + lines)
        return self.durer("run.ini", *options, status=status).stderr

    def test_commands_run_only_if_allowed(self):
        lines = "Pre_Scene_Command=touch before\nPost_Frame_Command=touch %s-%n-%wx%h\n"
        self.assertIn("--allow-shell", self.run_ini(lines, status=0))
        self.assertFalse((self.folder / "before").exists())
        self.run_ini(lines, "--allow-shell", status=0)
        self.assertTrue((self.folder / "before").exists())
        self.assertTrue((self.folder / "s.pov-0-4x3").exists())

    def test_what_the_exit_status_leads_to(self):
        ends = "User_Abort_Command=touch aborted\nFatal_Error_Command=touch failed\n"
        for action, status, made in (("I", 0, {"s.png"}), ("S", 0, set()), ("A", 0, set()),
                                     ("Q", 0, set()), ("U", 1, {"aborted"}), ("F", 1, {"failed"}),
                                     ("-F", 0, {"s.png"})):
            lines = f"Pre_Frame_Command=false\nPre_Frame_Return={action}\n" + ends
            message = self.run_ini(lines, "--allow-shell", status=status)
            self.assertEqual("Pre_Frame_Return" in message, "s.png" not in made)
            found = {name for name in ("s.png", "aborted", "failed") if (self.folder / name).exists()}
            self.assertEqual(found, made, action)
            for name in found:
                (self.folder / name).unlink()


if __name__ == "__main__":
    unittest.main()
