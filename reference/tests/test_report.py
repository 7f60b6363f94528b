"""TSV files, the grouping of failures and the summary of timings."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import report
import timing


def row(**changes):
    fields = {"scene": "examples/a", "size": "160x120", "options": "-A", "grade": "exact", "random": "no",
              "verdict": "pass", "within_2": 1.0, "within_4": 1.0, "blocks_beyond_6": 0.0,
              "blocks_beyond_16": 0.0, "largest_block": 0.5, "bias": -0.25, "durer_cpu": 0.5,
              "povray_cpu": 2.0, "ratio": 4.0, "exit_code": 0, "error": ""}
    return report.Row(**{**fields, **changes})


class Tables(unittest.TestCase):
    def test_round_trip(self):
        rows = [row(), row(scene="examples/b", grade="error", verdict="fail", exit_code=1, error="b.pov:1: x")]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "new" / "compare.tsv"
            report.write_tsv(rows, path)
            self.assertEqual(report.read_tsv(path), rows)

    def test_regressions(self):
        old = [row(), row(scene="examples/b", grade="match"), row(scene="examples/gone")]
        new = [row(grade="match"), row(scene="examples/b", grade="exact"), row(scene="examples/new")]
        self.assertEqual([pair[1].scene for pair in report.regressions(old, new)], ["examples/a"])

    def test_same_failure_in_two_scenes_is_one_cause(self):
        rows = [row(scene="examples/a", grade="unsupported", verdict="fail",
                    error="a.pov:12: not supported yet: blob"),
                row(scene="examples/b", grade="unsupported", verdict="fail",
                    error="b.inc:7:3: not supported yet: blob"),
                row(scene="examples/c", grade="differ", verdict="fail")]
        text = report.failures_by_cause(rows)
        self.assertIn("   2 unsupported: not supported yet: blob", text)
        self.assertIn("   1 differ", text)

    def test_summary_counts(self):
        text = report.summary([row(), row(scene="examples/b", grade="crash", verdict="fail"),
                               row(scene="examples/c", durer_cpu=3.0)])
        self.assertIn("3 scenes, 2 pass (66.7 %); exact 2, crash 1", text)
        self.assertIn("1 slower than povray", text)


class Timings(unittest.TestCase):
    @staticmethod
    def timing(name, cpu, povray_cpu, mb=10.0):
        return timing.Timing(name, cpu, povray_cpu, povray_cpu / cpu, cpu, povray_cpu, povray_cpu / cpu,
                             mb, 10.0)

    def test_mean_takes_heavy_scenes_only(self):
        text = timing.summary([self.timing("two", 1.0, 2.0), self.timing("eight", 1.0, 8.0),
                               self.timing("light", 0.04, 0.02)])
        self.assertIn("geometric mean 4.00x", text)
        self.assertIn("2 scenes on which", text)
        self.assertIn("1 lighter scenes: 0 over", text)

    def test_light_scene_over_its_allowance_and_memory(self):
        text = timing.summary([self.timing("light", 0.06, 0.02), self.timing("large", 1.0, 1.0, 34.5)])
        self.assertIn("light: durer 0.060 s", text)
        self.assertIn("large: durer 34 MB", text)

    def test_percentile_is_nearest_rank(self):
        self.assertEqual(timing.percentile(range(1, 11), 0.1), 1)
        self.assertEqual(timing.percentile(range(1, 21), 0.1), 2)


if __name__ == "__main__":
    unittest.main()
