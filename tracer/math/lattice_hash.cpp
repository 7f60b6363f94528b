#include "tracer/math/lattice_hash.h"

namespace durer {
namespace {

// Fisher-Yates, driven by a linear congruence.
constexpr std::array<uint16_t, 8192> make_hash() {
  std::array<uint16_t, 8192> table{};
  for (int i = 0; i < 4096; ++i) table[i] = static_cast<uint16_t>(i);
  uint32_t state = 0;
  for (int i = 4095; i >= 0; --i) {
    state = state * 1812433253u + 12345u;
    const uint32_t j = ((state >> 16) & 0x7fff) % 4096;
    const uint16_t kept = table[i];
    table[i] = table[j];
    table[j] = kept;
  }
  for (int i = 0; i < 4096; ++i) table[4096 + i] = table[i];
  return table;
}

}  // namespace

constinit const std::array<uint16_t, 8192> kLatticeHash = make_hash();

}  // namespace durer
