// One period of each tiling by polygons of unit side.
#pragma once

#include <cstdint>

#include "tracer/math/vector.h"

namespace durer {

struct TilingPolygon {
  uint8_t tile_class;
  double scale;  // distance from an edge at which the value has fallen to the class
  uint16_t first_vertex;
  uint8_t vertex_count;  // counter-clockwise in (x, z)
};

struct TilingTable {
  uint8_t classes;
  Vec2 lattice[2];
  uint16_t first_polygon;
  uint8_t polygon_count;
};

extern const Vec2 kTilingVertices[];
extern const TilingPolygon kTilingPolygons[];
extern const TilingTable kTilings[24];

}  // namespace durer
