// media{} and density{} as written (spec/shading.md 14).
#pragma once

#include <memory>
#include <vector>

#include "tracer/scene/texture.h"

namespace durer {

struct MediaNode {
  int method = 3;
  int intervals = 1;
  int min_samples = 10;
  int max_samples = 10;
  float jitter = 0;
  float aa_threshold = 0.1f;
  int aa_level = 3;
  float confidence = 0.9f;
  float variance = 1.0f / 128.0f;
  float ratio = 0.9f;
  bool collect = true;  // photons
  RGB absorption{0.0f};
  RGB emission{0.0f};
  int scattering_type = 0;  // 0: none, 1..5
  RGB scattering{0.0f};
  float eccentricity = 0;
  float extinction = 1;
  std::vector<std::shared_ptr<const PigmentNode>> densities;  // multiply component-wise
  SourcePosition position;
};

}  // namespace durer
