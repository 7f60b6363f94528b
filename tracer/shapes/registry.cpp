// Which file compiles which statement. To add a shape: declare its `compile` here.
#include "tracer/scene/light.h"
#include "tracer/shapes/shape.h"

namespace durer {

PlacedShape compile(const SphereNode& node, const ShapeContext& context);
PlacedShape compile(const BoxNode& node, const ShapeContext& context);
PlacedShape compile(const PlaneNode& node, const ShapeContext& context);
PlacedShape compile(const CylinderNode& node, const ShapeContext& context);
PlacedShape compile(const ConeNode& node, const ShapeContext& context);
PlacedShape compile(const DiscNode& node, const ShapeContext& context);
PlacedShape compile(const TorusNode& node, const ShapeContext& context);
PlacedShape compile(const TriangleNode& node, const ShapeContext& context);
PlacedShape compile(const SmoothTriangleNode& node, const ShapeContext& context);
PlacedShape compile(const PolygonNode& node, const ShapeContext& context);
PlacedShape compile(const QuadricNode& node, const ShapeContext& context);
PlacedShape compile(const SuperellipsoidNode& node, const ShapeContext& context);
PlacedShape compile(const OvusNode& node, const ShapeContext& context);
PlacedShape compile(const IsosurfaceNode& node, const ShapeContext& context);
PlacedShape compile(const ParametricNode& node, const ShapeContext& context);
PlacedShape compile(const BlobNode& node, const ShapeContext& context);
PlacedShape compile(const PolyNode& node, const ShapeContext& context);
PlacedShape compile(const BicubicPatchNode& node, const ShapeContext& context);
PlacedShape compile(const LatheNode& node, const ShapeContext& context);
PlacedShape compile(const SorNode& node, const ShapeContext& context);
PlacedShape compile(const PrismNode& node, const ShapeContext& context);
PlacedShape compile(const HeightFieldNode& node, const ShapeContext& context);
PlacedShape compile(const SphereSweepNode& node, const ShapeContext& context);
PlacedShape compile(const JuliaFractalNode& node, const ShapeContext& context);

namespace {

template <typename Node>
concept Compilable = requires(const Node& node, const ShapeContext& context) {
  compile(node, context);
};

}  // namespace

PlacedShape compile_shape(const ShapeNode& node, const ShapeContext& context) {
  return std::visit(
      [&](const auto& shape) -> PlacedShape {
        if constexpr (Compilable<std::decay_t<decltype(shape)>>) {
          return compile(shape, context);
        } else {
          return {};
        }
      },
      node);
}

}  // namespace durer
