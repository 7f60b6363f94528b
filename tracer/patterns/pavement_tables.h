// Which edges and corners of a grid belong to the borders of a pavement's tiles.
#pragma once

#include <cstdint>

namespace durer {

// Cell (q, r): with m = floor(r / rows), entry (r - m rows) columns + (q - m shift) mod columns.
struct PavementTable {
  uint8_t sides, tiles, pattern;
  uint8_t columns, rows, shift;
  uint16_t first_cell;  // triangles take two entries a cell: upright, inverted
};

constexpr int kPavementCount = 112;
extern const PavementTable kPavements[kPavementCount];
// Squares: edges 1 top, 2 right, 4 bottom, 8 left; dotted corners 16 top left, 32 top right,
// 64 bottom right, 128 bottom left.
// Triangles: bits 0-2 edges (left, right, bottom), 3-5 dots (A apex, L left, R right), then two bits
// each for the pivot of A, L, R: 0 none, 1 A, 2 L, 3 R.
extern const uint16_t kPavementCells[];

}  // namespace durer
