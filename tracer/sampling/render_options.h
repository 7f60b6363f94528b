// What rendering needs to know besides the scene; defaults are POV-Ray's (spec/language.md 31).
#pragma once

#include "tracer/image/framebuffer.h"

namespace durer {

enum class IntegratorKind { whitted, raycast };
// method1 (+AM1: where neighbours differ) and method2 (+AM2: where corners differ) are POV-Ray's; grid
// and jitter are for teaching.
enum class Supersampling { none, method1, method2, grid, jitter };

struct RenderOptions {
  int width = 160;
  int height = 120;
  PixelWindow window{0, 0, 160, 120};
  int threads = 1;
  int block_size = 32;
  int quality = 9;
  bool output_alpha = false;
  IntegratorKind integrator = IntegratorKind::whitted;
  Supersampling supersampling = Supersampling::none;
  int grid_samples = 3;  // per axis, for grid and jitter
  double antialias_threshold = 0.3;
  int antialias_depth = 3;
  double jitter_amount = 1;  // 0: no jitter
  double antialias_gamma = 2.5;
};

}  // namespace durer
