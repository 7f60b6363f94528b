// POV-Ray's noise (spec/textures.md 2, 3).
#pragma once

#include <vector>

#include "tracer/math/vector.h"

namespace durer {

// Scalar noise in [0,1]. generator: 1 original, 2 range-corrected, 3 Perlin.
double noise(const Vec3& p, int generator);
// Three smooth components around 0; the same for all generators.
Vec3 vector_noise(const Vec3& p);
// Sums of octaves: omega^i · noise(lambda^i · p). octaves >= 1.
Vec3 vector_turbulence(const Vec3& p, int octaves, double omega, double lambda);
Vec2 vector_turbulence_xy(const Vec3& p, int octaves, double omega, double lambda);  // without z
double turbulence(const Vec3& p, int octaves, double omega, double lambda, int generator);
// What the patterns granite and wrinkles, and the normal wrinkles (per component), sum up.
double granite(const Vec3& p, int generator);
double wrinkles(const Vec3& p, int generator);
Vec3 vector_wrinkles(const Vec3& p);

// 32768 uniform numbers (spec/textures.md 2.7), and the triple that belongs to an integer cell.
const std::vector<double>& pattern_random_table();
Vec3 random_vector_of_cell(const Vec3& cell);

}  // namespace durer
