// Every pattern: its kind, its word in the language, its factory.
#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

struct Entry {
  PatternKind kind;
  const char* name;
  PatternFactory factory;
};

using K = PatternKind;
constexpr Entry kEntries[] = {
    {K::none, "none", nullptr},
    {K::agate, "agate", make_agate},
    {K::aoi, "aoi", make_aoi},
    {K::average, "average", nullptr},
    {K::boxed, "boxed", make_boxed},
    {K::bozo, "bozo", make_bozo},
    {K::brick, "brick", make_brick},
    {K::bump_map, "bump_map", nullptr},
    {K::bumps, "bumps", make_bozo},
    {K::cells, "cells", make_cells},
    {K::checker, "checker", make_checker},
    {K::crackle, "crackle", make_crackle},
    {K::cubic, "cubic", make_cubic},
    {K::cylindrical, "cylindrical", make_cylindrical},
    {K::density_file, "density_file", make_density_file},
    {K::dents, "dents", make_dents},
    {K::facets, "facets", make_facets},
    {K::function, "function", make_function},
    {K::gradient, "gradient", make_gradient},
    {K::granite, "granite", make_granite},
    {K::hexagon, "hexagon", make_hexagon},
    {K::image_map, "image_map", nullptr},
    {K::image_pattern, "image_pattern", make_image_pattern},
    {K::julia, "julia", make_julia},
    {K::leopard, "leopard", make_leopard},
    {K::magnet_julia, "magnet julia", make_magnet_julia},
    {K::magnet_mandel, "magnet mandel", make_magnet_mandel},
    {K::mandel, "mandel", make_mandel},
    {K::marble, "marble", make_marble},
    {K::object, "object", make_object},
    {K::onion, "onion", make_onion},
    {K::pavement, "pavement", make_pavement},
    {K::pigment_pattern, "pigment_pattern", make_pigment_pattern},
    {K::planar, "planar", make_planar},
    {K::quilted, "quilted", make_quilted},
    {K::radial, "radial", make_radial},
    {K::ripples, "ripples", make_ripples},
    {K::slope, "slope", make_slope},
    {K::spherical, "spherical", make_spherical},
    {K::spiral1, "spiral1", make_spiral1},
    {K::spiral2, "spiral2", make_spiral2},
    {K::spotted, "spotted", make_bozo},
    {K::square, "square", make_square},
    {K::tiling, "tiling", make_tiling},
    {K::triangular, "triangular", make_triangular},
    {K::uv_mapping, "uv_mapping", nullptr},
    {K::waves, "waves", make_waves},
    {K::wood, "wood", make_wood},
    {K::wrinkles, "wrinkles", make_wrinkles},
};

const Entry& entry_of(PatternKind kind) { return kEntries[static_cast<int>(kind)]; }

}  // namespace

PatternFactory find_pattern_factory(PatternKind kind) { return entry_of(kind).factory; }
const char* pattern_name(PatternKind kind) { return entry_of(kind).name; }

}  // namespace durer
