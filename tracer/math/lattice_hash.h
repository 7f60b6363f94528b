// The permutation of 0..4095 behind noise, cell patterns and antialiasing jitter
// (spec/textures.md 2.1).
#pragma once

#include <array>
#include <cstdint>

namespace durer {

// Doubled: kLatticeHash[i + 4096] = kLatticeHash[i].
extern const std::array<uint16_t, 8192> kLatticeHash;

// 0..4095 for an integer cell.
inline int hash_cell(int a, int b, int c) {
  return kLatticeHash[kLatticeHash[kLatticeHash[a & 4095] ^ (b & 4095)] ^ (c & 4095)];
}

}  // namespace durer
