// Lattice noise, gradient noise, turbulence (spec/textures.md 2, 3).
#include "tracer/patterns/noise.h"

#include <emmintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tracer/math/kernel.h"
#include "tracer/math/lattice_hash.h"
#include "tracer/math/min_max.h"

namespace durer {
namespace {

// Figures at the lattice points: a quarter of a value and its three slopes start at each of
// 0..255 (spec/textures.md 2.2).
constexpr double kLatticeFigures[267] = {
    -1.0, 0.604974, -0.937102, 0.414115, 0.576226, -0.0161593, 0.432334, 0.103685,
    0.590539, 0.0286412, 0.46981, -0.84622, -0.0734112, -0.304097, -0.40206, -0.210132,
    -0.919127, 0.652033, -0.83151, -0.183948, -0.671107, 0.852476, 0.043595, -0.404532,
    0.75494, -0.335653, 0.618433, 0.605707, 0.708583, -0.477195, 0.899474, 0.490623,
    0.221729, -0.400381, -0.853727, -0.932586, 0.659113, 0.961303, 0.325948, -0.750851,
    0.842466, 0.734401, -0.649866, 0.394491, -0.466056, -0.434073, 0.109026, 0.0847028,
    -0.738857, 0.241505, 0.16228, -0.71426, -0.883665, -0.150408, -0.90396, -0.686549,
    -0.785214, 0.488548, 0.0246433, 0.142473, -0.602136, 0.375845, -0.00779736, 0.498955,
    -0.268147, 0.856382, -0.386007, -0.596094, -0.867735, -0.570977, -0.914366, 0.28896,
    0.672206, -0.233783, 0.94815, 0.895262, 0.343252, -0.173388, -0.767971, -0.314748,
    0.824308, -0.342092, 0.721431, -0.24004, -0.63653, 0.553277, 0.376272, 0.158984,
    -0.452659, 0.396323, -0.420676, -0.454154, 0.122179, 0.295857, 0.0664225, -0.202075,
    -0.724788, 0.453513, 0.224567, -0.908812, 0.176349, -0.320516, -0.697139, 0.742702,
    -0.900786, 0.471489, -0.133532, 0.119127, -0.889769, -0.23183, -0.669673, -0.046891,
    -0.803433, -0.966735, 0.475578, -0.652644, 0.0112459, -0.730007, 0.128283, 0.145647,
    -0.619318, 0.272023, 0.392966, 0.646418, -0.0207675, -0.315908, 0.480797, 0.535668,
    -0.250172, -0.83093, -0.653773, -0.443809, 0.119982, -0.897642, 0.89453, 0.165789,
    0.633875, -0.886839, 0.930877, -0.537194, 0.587732, 0.722011, -0.209461, -0.0424659,
    -0.814267, -0.919432, 0.280262, -0.66302, -0.558099, -0.537469, -0.598779, 0.929656,
    -0.170794, -0.537163, 0.312581, 0.959442, 0.722652, 0.499931, 0.175616, -0.534874,
    -0.685115, 0.444999, 0.17171, 0.108202, -0.768704, -0.463828, 0.254231, 0.546014,
    0.869474, 0.875212, -0.944427, 0.130724, -0.110185, 0.312184, -0.33138, -0.629206,
    0.0606546, 0.722866, -0.0979477, 0.821561, 0.0931258, -0.972808, 0.0318151, -0.867033,
    -0.387228, 0.280995, -0.218189, -0.539178, -0.427359, -0.602075, 0.311971, 0.277974,
    0.773159, 0.592493, -0.0331884, -0.630854, -0.269947, 0.339132, 0.581079, 0.209461,
    -0.317433, -0.284993, 0.181323, 0.341634, 0.804959, -0.229572, -0.758907, -0.336721,
    0.605463, -0.991272, -0.0188754, -0.300191, 0.368307, -0.176135, -0.3832, -0.749569,
    0.62356, -0.573938, 0.278309, -0.971313, 0.839994, -0.830686, 0.439078, 0.66128,
    0.694514, 0.0565042, 0.54342, -0.438804, -0.0228428, -0.687068, 0.857267, 0.301991,
    -0.494255, -0.941039, 0.775509, 0.410575, -0.362081, -0.671534, -0.348379, 0.932433,
    0.886442, 0.868681, -0.225666, -0.062211, -0.0976425, -0.641444, -0.848112, 0.724697,
    0.473503, 0.998749, 0.174701, 0.559625, -0.029099, -0.337392, -0.958129, -0.659785,
    0.236042, -0.246937, 0.659449, -0.027512, 0.821897, -0.226215, 0.0181735, 0.500481,
    -0.420127, -0.427878, 0.566186,
};

using Pair = double __attribute__((vector_size(16)));
using Row = double __attribute__((vector_size(32)));

// Row k: {R[k]/2, R[k+1], R[k+2], R[k+3]}, a corner's value and slopes (performance.md 5).
struct alignas(32) LatticeRows {
  Row row[264];
};
constexpr LatticeRows make_rows() {
  LatticeRows rows{};
  for (int i = 0; i < 264; ++i)
    rows.row[i] = Row{kLatticeFigures[i] * 0.5, kLatticeFigures[i + 1], kLatticeFigures[i + 2],
                      kLatticeFigures[i + 3]};
  return rows;
}
constexpr LatticeRows kLatticeRows = make_rows();

DURER_INLINE double s_curve(double f) { return f * f * (3 - 2 * f); }

// Beyond 2^31 the cell is -2^31, as on every x86: offsets are huge there and the noise is 0 or 1, in
// POV-Ray's pictures too (the horizon of a plane of clouds).
DURER_INLINE uint32_t locate(double v, double& offset) {
  const int32_t cell = _mm_cvttsd_si32(_mm_set_sd(v - (v >= 0 ? 0 : 1 - 1e-10)));
  offset = v - static_cast<double>(cell);
  return (static_cast<uint32_t>(cell) + 10000) & 4095;
}

// The eight corners of a cell: the rows of figures that belong to them, for one value, and their
// weights; corner i lies at (i & 1, i >> 1 & 1, i >> 2).
struct Corners {
  const Row* row[8];
  double weight[8];
  double fx, fy, fz;
};

DURER_INLINE Corners corners_of(const Vec3& p) {
  Corners c;
  const uint32_t ix = locate(p.x, c.fx), iy = locate(p.y, c.fy), iz = locate(p.z, c.fz);
  // Fourteen look-ups: those of x and xy are shared.
  const uint32_t hx0 = kLatticeHash[ix], hx1 = kLatticeHash[ix + 1];
  const uint32_t hash[4] = {kLatticeHash[hx0 ^ iy], kLatticeHash[hx1 ^ iy],
                            kLatticeHash[hx0 ^ (iy + 1)], kLatticeHash[hx1 ^ (iy + 1)]};
  const double sx = s_curve(c.fx), sy = s_curve(c.fy), sz = s_curve(c.fz);
  const double tx = 1 - sx, ty = 1 - sy, tz = 1 - sz;
  const double weight[4] = {tx * ty, sx * ty, tx * sy, sx * sy};
  for (int i = 0; i < 4; ++i) {
    c.row[i] = kLatticeRows.row + (kLatticeHash[hash[i] ^ iz] & 255);
    c.row[i + 4] = kLatticeRows.row + (kLatticeHash[hash[i] ^ (iz + 1)] & 255);
    c.weight[i] = weight[i] * tz;
    c.weight[i + 4] = weight[i] * sz;
  }
  return c;
}

// One value: the weighted rows are summed up first, and what the offsets fx - 1, fy - 1, fz - 1 of the
// far corners have less than fx, fy, fz is taken off at last.
DURER_INLINE void corner_sum(const Vec3& p, Row& sum) {
  const Corners c = corners_of(p);
  Row a[8];
  for (int i = 0; i < 8; ++i) a[i] = *c.row[i] * c.weight[i];
  const Row b0 = a[0] + a[1], b1 = a[2] + a[3], b2 = a[4] + a[5], b3 = a[6] + a[7];
  const Row far_x = (a[1] + a[3]) + (a[5] + a[7]), far_y = b1 + b3, far_z = b2 + b3;
  const Row offsets{1, c.fx, c.fy, c.fz}, excess{0, far_x[1], far_y[2], far_z[3]};
  sum = ((b0 + b1) + far_z) * offsets - excess;
}

// Up to three values share the offsets: each corner's are weighted once.
template <int kValues>
DURER_INLINE void add_corners(const Vec3& p, Row sums[kValues]) {
  const Corners c = corners_of(p);
  const Pair x0{1, c.fx}, x1{1, c.fx - 1};
  const Pair yz[4] = {{c.fy, c.fz}, {c.fy - 1, c.fz}, {c.fy, c.fz - 1}, {c.fy - 1, c.fz - 1}};
  // Pairs of corners along x: short chains of additions let the processor overlap them.
  Row pair[4][kValues];
  for (int i = 0; i < 4; ++i) {
    const Row offsets0 = __builtin_shufflevector(x0, yz[i], 0, 1, 2, 3) * c.weight[2 * i];
    const Row offsets1 = __builtin_shufflevector(x1, yz[i], 0, 1, 2, 3) * c.weight[2 * i + 1];
    for (int k = 0; k < kValues; ++k) {
      pair[i][k] = c.row[2 * i][4 * k] * offsets0 + c.row[2 * i + 1][4 * k] * offsets1;
    }
  }
  for (int k = 0; k < kValues; ++k)
    sums[k] += (pair[0][k] + pair[1][k]) + (pair[2][k] + pair[3][k]);
}

DURER_INLINE double total(const Row& row) { return (row[0] + row[1]) + (row[2] + row[3]); }

DURER_INLINE double lattice_noise(const Vec3& p) {
  Row sum;
  corner_sum(p, sum);
  return total(sum);
}

DURER_INLINE double clamped(double v) { return smaller_of(larger_of(v, 0), 1); }
// Far corners that cancel out leave NaN, which counts as 1; of a point that is NaN the noise is 0.
DURER_INLINE double clamped_noise(double v, const Vec3& p) {
  if (v != v) [[unlikely]] return p.x != p.x || p.y != p.y || p.z != p.z ? 0 : 1;
  return clamped(v);
}
DURER_INLINE double corrected_noise(const Vec3& p) {
  return clamped_noise((lattice_noise(p) + 1.05242) * 0.48985582, p);
}
DURER_INLINE double original_noise(const Vec3& p) {
  return clamped_noise(lattice_noise(p) + 0.5, p);
}

// Generator 3: gradients on a lattice of 2048 (spec/textures.md 2.5).
struct GradientLattice {
  std::array<Vec3, 4098> gradient;
  std::array<uint16_t, 4098> permutation;

  GradientLattice() {
    uint32_t state = 1;
    auto draw = [&] {
      state = state * 1812433253u + 12345u;
      return static_cast<int>((state >> 16) & 0x7fff);
    };
    for (int i = 0; i < 2048; ++i) {
      Vec3 v;
      double squared;
      do {
        for (int axis = 0; axis < 3; ++axis) v[axis] = ((draw() % 4096) - 2048) / 2048.0;
        squared = dot(v, v);
      } while (squared > 1 || squared < 1e-5);
      gradient[i] = v / std::sqrt(squared);
    }
    // POV-Ray shuffles every second entry and starts one beyond the end.
    for (int i = 0; i < 2048; ++i) permutation[i] = static_cast<uint16_t>(i);
    permutation[2048] = 0;
    for (int i = 2048; i > 0; i -= 2) std::swap(permutation[i], permutation[draw() % 2048]);
    for (int i = 0; i < 2050; ++i) {
      permutation[2048 + i] = permutation[i];
      gradient[2048 + i] = gradient[i];
    }
  }
};

double gradient_noise(const Vec3& p) {
  static const GradientLattice lattice;
  int low[3], high[3];
  Vec3 r, s;
  for (int axis = 0; axis < 3; ++axis) {
    const double t = p[axis] + 10000000.023157213;
    const double cell = std::floor(t);
    low[axis] = static_cast<int>(static_cast<int64_t>(cell) & 2047);
    high[axis] = (low[axis] + 1) & 2047;
    r[axis] = t - cell;
    s[axis] = s_curve(r[axis]);
  }
  const auto& perm = lattice.permutation;
  auto corner = [&](int bx, int by, int bz, double dx, double dy, double dz) {
    const Vec3& g = lattice.gradient[perm[perm[bx] + by] + bz];
    return dot(g, Vec3(r.x - dx, r.y - dy, r.z - dz));
  };
  auto mix = [](double t, double a, double b) { return a + t * (b - a); };
  const double q00 = mix(s.x, corner(low[0], low[1], low[2], 0, 0, 0),
                         corner(high[0], low[1], low[2], 1, 0, 0));
  const double q10 = mix(s.x, corner(low[0], high[1], low[2], 0, 1, 0),
                         corner(high[0], high[1], low[2], 1, 1, 0));
  const double q01 = mix(s.x, corner(low[0], low[1], high[2], 0, 0, 1),
                         corner(high[0], low[1], high[2], 1, 0, 1));
  const double q11 = mix(s.x, corner(low[0], high[1], high[2], 0, 1, 1),
                         corner(high[0], high[1], high[2], 1, 1, 1));
  return mix(s.z, mix(s.y, q00, q10), mix(s.y, q01, q11));
}

DURER_KERNEL double lattice_noise_of(const Vec3& p, int generator) {
  return generator == 2 ? corrected_noise(p) : original_noise(p);
}

// Octaves after the first, with the frequency and amplitude they start at.
DURER_KERNEL double lattice_turbulence(const Vec3& p, int octaves, double omega, double lambda,
                                       int generator) {
  double frequency = lambda, amplitude = omega;
  if (generator != 2) {
    double sum = original_noise(p);
    for (int i = 1; i < octaves; ++i) {
      sum += amplitude * original_noise(p * frequency);
      frequency *= lambda;
      amplitude *= omega;
    }
    return sum;
  }
  double sum = clamped(2 * corrected_noise(p) - 0.5);
  for (int i = 1; i < octaves; ++i) {
    sum += amplitude * (2 * corrected_noise(p * frequency) - 0.5);
    frequency *= lambda;
    amplitude *= omega;
  }
  return sum;
}

// Terms of granite and wrinkles (spec/textures.md 6).
DURER_INLINE double granite_term(double n, int generator) {
  return generator == 1 ? std::abs(0.5 - n) : std::min(0.5, std::abs(1.0 - 2.0 * n));
}
DURER_INLINE double wrinkles_term(double n, int generator) {
  return generator == 1 ? n : clamped(2 * n - 0.5);
}

DURER_KERNEL double lattice_granite(const Vec3& p, int generator) {
  double sum = 0, frequency = 4, share = 1;
  for (int i = 0; i < 6; ++i, frequency *= 2, share *= 0.5) {
    const Vec3 q = p * frequency;
    sum += granite_term(generator == 1 ? original_noise(q) : corrected_noise(q), generator) * share;
  }
  return sum;
}

DURER_KERNEL double lattice_wrinkles(const Vec3& p, int generator) {
  double sum = 0, frequency = 1, share = 1;
  for (int i = 0; i < 10; ++i, frequency *= 2, share *= 0.5) {
    const Vec3 q = p * frequency;
    sum += wrinkles_term(generator == 1 ? original_noise(q) : corrected_noise(q), generator) * share;
  }
  return sum / 2;
}

double perlin_noise(const Vec3& p) { return clamped(0.5 * (1.59 * gradient_noise(p) + 0.985)); }

double perlin_turbulence(const Vec3& p, int octaves, double omega, double lambda) {
  double sum = clamped(2 * perlin_noise(p) - 0.5);
  double frequency = lambda, amplitude = omega;
  for (int i = 1; i < octaves; ++i) {
    sum += amplitude * (2 * perlin_noise(p * frequency) - 0.5);
    frequency *= lambda;
    amplitude *= omega;
  }
  return sum;
}

}  // namespace

double noise(const Vec3& p, int generator) {
  return generator == 3 ? perlin_noise(p) : lattice_noise_of(p, generator);
}

DURER_KERNEL Vec3 vector_noise(const Vec3& p) {
  Row sums[3] = {};
  add_corners<3>(p, sums);
  return {total(sums[0]), total(sums[1]), total(sums[2])};
}

namespace {

template <int kValues>
DURER_INLINE void sum_octaves(const Vec3& p, int octaves, double omega, double lambda,
                              double out[kValues]) {
  // Partial sums stay in rows until the last octave.
  Row sums[kValues] = {};
  add_corners<kValues>(p, sums);
  double frequency = lambda, amplitude = omega;
  for (int i = 1; i < octaves; ++i) {
    Row octave[kValues] = {};
    add_corners<kValues>(p * frequency, octave);
    for (int k = 0; k < kValues; ++k) sums[k] += octave[k] * amplitude;
    frequency *= lambda;
    amplitude *= omega;
  }
  for (int k = 0; k < kValues; ++k) out[k] = total(sums[k]);
}

}  // namespace

DURER_KERNEL Vec3 vector_turbulence(const Vec3& p, int octaves, double omega, double lambda) {
  double sum[3];
  sum_octaves<3>(p, octaves, omega, lambda, sum);
  return {sum[0], sum[1], sum[2]};
}

DURER_KERNEL Vec2 vector_turbulence_xy(const Vec3& p, int octaves, double omega, double lambda) {
  double sum[2];
  sum_octaves<2>(p, octaves, omega, lambda, sum);
  return {sum[0], sum[1]};
}

DURER_KERNEL Vec3 vector_wrinkles(const Vec3& p) {
  Vec3 result(0);
  double frequency = 1, share = 1;
  for (int i = 0; i < 10; ++i, frequency *= 2, share *= 0.5) {
    Row sums[3] = {};
    add_corners<3>(p * frequency, sums);
    result.x += std::abs(total(sums[0])) * share;
    result.y += std::abs(total(sums[1])) * share;
    result.z += std::abs(total(sums[2])) * share;
  }
  return result;
}

double granite(const Vec3& p, int generator) {
  if (generator != 3) return lattice_granite(p, generator);
  double sum = 0, frequency = 4, share = 1;
  for (int i = 0; i < 6; ++i, frequency *= 2, share *= 0.5)
    sum += granite_term(perlin_noise(p * frequency), generator) * share;
  return sum;
}

double wrinkles(const Vec3& p, int generator) {
  if (generator != 3) return lattice_wrinkles(p, generator);
  double sum = 0, frequency = 1, share = 1;
  for (int i = 0; i < 10; ++i, frequency *= 2, share *= 0.5)
    sum += wrinkles_term(perlin_noise(p * frequency), generator) * share;
  return sum / 2;
}

double turbulence(const Vec3& p, int octaves, double omega, double lambda, int generator) {
  return generator == 3 ? perlin_turbulence(p, octaves, omega, lambda)
                        : lattice_turbulence(p, octaves, omega, lambda, generator);
}

const std::vector<double>& pattern_random_table() {
  static const std::vector<double> table = [] {
    std::mt19937 generator(5489u);
    std::vector<double> result(32768);
    for (double& value : result) value = static_cast<double>(generator()) / 4294967296.0;
    return result;
  }();
  return table;
}

Vec3 random_vector_of_cell(const Vec3& cell) {
  const auto whole = [](double v) { return static_cast<int>(static_cast<int64_t>(v) & 4095); };
  const int q = hash_cell(whole(cell.x), whole(cell.y), whole(cell.z));
  const std::vector<double>& table = pattern_random_table();
  return {table[q], table[(q + 1) & 32767], table[(q + 2) & 32767]};
}

}  // namespace durer
