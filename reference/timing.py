"""Alternating timed runs of durer and povray on one scene, and the summary over many."""
import math
import statistics
from dataclasses import dataclass

import renderers

HEAVY = 0.5              # CPU seconds of povray from which a scene counts in the mean
LIGHT_ALLOWANCE = 0.05   # CPU seconds that a light scene may always take
MEMORY_ALLOWANCE_MB = 24


@dataclass
class Timing:
    scene: str
    durer_cpu: float
    povray_cpu: float
    cpu_ratio: float
    durer_wall: float
    povray_wall: float
    wall_ratio: float
    durer_mb: float
    povray_mb: float
    error: str = ""

    @property
    def heavy(self):
        return self.povray_cpu >= HEAVY

    @property
    def too_slow(self):
        return self.durer_cpu > max(self.povray_cpu, LIGHT_ALLOWANCE)

    @property
    def too_large(self):
        return self.durer_mb > self.povray_mb + MEMORY_ALLOWANCE_MB

    def line(self):
        if self.error:
            return f"{self.scene}: {self.error}"
        return (f"{self.scene}: CPU {self.durer_cpu:.2f} s, povray {self.povray_cpu:.2f} s, "
                f"{self.cpu_ratio:.2f}x; wall {self.wall_ratio:.2f}x; {self.durer_mb:.0f} MB, povray "
                f"{self.povray_mb:.0f} MB")


def measure(scene, binary, options, runs, limit):
    """Medians over alternating runs; None if povray does not render the scene within the limit."""
    ours, theirs, error = [], [], ""
    for _ in range(runs):
        picture = renderers.durer(binary, scene, options, None, limit, nice=0)
        if picture.error:
            error = picture.error
            break
        ours.append(picture)
        reference = renderers.run_povray(scene, options, limit, nice=0)
        if reference.code != 0:
            return None
        theirs.append(reference)
    if error:
        return Timing(scene.label, 0, 0, 0, 0, 0, 0, 0, 0, error)

    def median(pictures, what):
        return statistics.median(getattr(picture, what) for picture in pictures)

    cpu, povray_cpu = median(ours, "cpu"), median(theirs, "cpu")
    wall, povray_wall = median(ours, "wall"), median(theirs, "wall")
    return Timing(scene.label, cpu, povray_cpu, povray_cpu / max(cpu, 0.001), wall, povray_wall,
                  povray_wall / max(wall, 0.001), median(ours, "peak_kb") / 1024,
                  median(theirs, "peak_kb") / 1024)


def geometric_mean(values):
    return math.exp(sum(math.log(value) for value in values) / len(values))


def percentile(values, share):
    """Nearest rank."""
    return sorted(values)[max(0, math.ceil(share * len(values)) - 1)]


def summary(timings):
    done = [timing for timing in timings if not timing.error]
    failed = [timing for timing in timings if timing.error]
    heavy = [timing for timing in done if timing.heavy]
    lines = []
    if heavy:
        ratios = [timing.cpu_ratio for timing in heavy]
        lines += [f"{len(heavy)} scenes on which povray spends at least {HEAVY} CPU s:",
                  f"  CPU: geometric mean {geometric_mean(ratios):.2f}x, "
                  f"10th percentile {percentile(ratios, 0.1):.2f}x, "
                  f"lowest {min(ratios):.2f}x, highest {max(ratios):.2f}x",
                  f"  wall: geometric mean {geometric_mean([timing.wall_ratio for timing in heavy]):.2f}x",
                  "  worst five:"]
        lines += [f"    {timing.cpu_ratio:6.2f}x {timing.scene}: durer {timing.durer_cpu:.2f} s, povray "
                  f"{timing.povray_cpu:.2f} s" for timing in sorted(heavy, key=lambda one: one.cpu_ratio)[:5]]
    light = [timing for timing in done if not timing.heavy]
    over = [timing for timing in light if timing.too_slow]
    lines.append(f"{len(light)} lighter scenes: {len(over)} over max(povray's CPU, {LIGHT_ALLOWANCE} s)")
    lines += [f"    {timing.scene}: durer {timing.durer_cpu:.3f} s, povray {timing.povray_cpu:.3f} s"
              for timing in over]
    large = [timing for timing in done if timing.too_large]
    lines.append(f"memory: {len(large)} scenes over povray's + {MEMORY_ALLOWANCE_MB} MB")
    lines += [f"    {timing.scene}: durer {timing.durer_mb:.0f} MB, povray {timing.povray_mb:.0f} MB"
              for timing in large]
    if failed:
        lines.append(f"{len(failed)} scenes that durer does not render are not counted")
        lines += [f"    {timing.scene}: {timing.error}" for timing in failed]
    return "\n".join(lines)
