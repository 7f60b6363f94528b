// What each shape's statement said; all in the shape's own space (spec/geometry.md 12-14).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tracer/scene/rare.h"
#include "tracer/scene/texture.h"

namespace durer {

struct FunctionNode;
struct ObjectNode;
using ObjectPtr = std::shared_ptr<const ObjectNode>;

struct SphereNode {
  Vec3 center{0};
  double radius = 1;
};
struct BoxNode {
  Vec3 corner1{0}, corner2{0};
};
struct PlaneNode {
  Vec3 normal{0, 1, 0};
  double distance = 0;
};
struct CylinderNode {
  Vec3 base{0}, apex{0};
  double radius = 1;
  bool open = false;
};
struct ConeNode {
  Vec3 base{0}, apex{0};
  double base_radius = 1, apex_radius = 0;
  bool open = false;
};
struct DiscNode {
  Vec3 center{0}, normal{0, 0, 1};
  double radius = 1, hole_radius = 0;
};
struct TorusNode {
  double major_radius = 1, minor_radius = 0.25;
  bool sturm = false;
};
struct SuperellipsoidNode {
  Vec2 exponents{1, 1};
};
struct OvusNode {
  double bottom_radius = 1, top_radius = 0.5;
  bool sturm = false;
};
struct TriangleNode {
  std::array<Vec3, 3> vertex;
};
struct SmoothTriangleNode {
  std::array<Vec3, 3> vertex;
  std::array<Vec3, 3> normal;
};
struct PolygonNode {
  std::vector<Vec3> points;  // sub-polygons closed by repeating their first point
};
struct QuadricNode {
  Vec3 square{0}, mixed{0}, linear{0};
  double constant = 0;
};
// cubic, quartic, poly, polynomial: coefficients in poly's order for the order given.
struct PolyNode {
  int order = 2;
  std::vector<double> coefficients;
  bool sturm = false;
};
enum class SplineKind : uint8_t { linear, quadratic, cubic, bezier, b_spline };
struct LatheNode {
  SplineKind spline = SplineKind::linear;
  std::vector<Vec2> points;
  bool sturm = false;
};
struct SorNode {
  std::vector<Vec2> points;
  bool open = false;
  bool sturm = false;
};
struct PrismNode {
  SplineKind spline = SplineKind::linear;
  bool conic_sweep = false;
  double height1 = 0, height2 = 1;
  std::vector<Vec2> points;
  bool open = false;
  bool sturm = false;
};
struct SphereSweepNode {
  SplineKind spline = SplineKind::linear;
  std::vector<Vec3> centers;
  std::vector<double> radii;
  double tolerance = 1e-6;  // hits nearer than this are dropped
};
struct BlobComponent {
  bool is_cylinder = false;
  Vec3 center{0}, apex{0};  // cylinder: its two ends
  double radius = 1, strength = 1;
  Transform transform;  // of this component, after the points above
  TexturePtr texture;   // null: the blob's
};
struct BlobNode {
  double threshold = 1;
  std::vector<BlobComponent> components;
  bool sturm = false;
  bool hierarchy = true;
};
struct TextNode {
  std::string font;  // path as found
  std::u16string text;
  bool unicode = false;  // else the font's table of 8-bit characters is preferred
  double depth = 1;
  Vec3 offset{0};
};
struct HeightFieldNode {
  std::shared_ptr<const ImageSource> image;
  double water_level = 0;
  bool smooth = false;
  bool hierarchy = true;
};
struct BicubicPatchNode {
  int type = 0;
  double flatness = 0;
  int u_steps = 0, v_steps = 0;
  double accuracy = 0;
  std::array<Vec3, 16> points;
  std::optional<std::array<Vec2, 4>> uv;
};
// mesh and mesh2. Indices of -1: none. Vertices and normals are single precision, as in POV-Ray.
struct MeshFace {
  std::array<int32_t, 3> vertex;
  std::array<int32_t, 3> normal{-1, -1, -1};
  std::array<int32_t, 3> uv{-1, -1, -1};
  std::array<int32_t, 3> texture{-1, -1, -1};
};
// The plane of a triangle, dot(normal, p) = distance.
struct MeshPlane {
  glm::vec3 normal{0};  // of length 1; 0 without area
  float distance = 0;
};
// What the normals of a smooth triangle are mixed by.
struct MeshAltitude {
  glm::vec3 altitude{0};  // in the plane; dot(altitude, p - p1) is 0 at p1 and 1 on the edge p2 p3
  bool is_exchanged = false;  // the altitude stands on the edge p1 p3, with p2 at its foot
};
struct MeshNode {
  std::vector<glm::vec3> vertices;
  std::vector<glm::vec3> normals;
  std::vector<Vec2> uv;
  std::vector<TexturePtr> textures;
  // Faces as parallel arrays; the optional ones are empty when no face has them.
  std::vector<std::array<int32_t, 3>> face_vertices;
  std::vector<std::array<int32_t, 3>> face_normals;
  std::vector<std::array<int32_t, 3>> face_uv;
  std::vector<std::array<int32_t, 3>> face_textures;
  // Of the corners as they were before they became single precision; empty: of the vertices.
  std::vector<MeshPlane> face_planes;
  std::vector<MeshAltitude> face_altitudes;  // likewise, up to the last smooth face
  std::optional<Vec3> inside_vector;
  bool hierarchy = true;
};
struct ContainerNode {
  bool is_sphere = false;
  Vec3 corner1{-1}, corner2{1};
  Vec3 center{0};
  double radius = 1;
};
struct IsosurfaceNode {
  std::shared_ptr<const FunctionNode> function;
  ContainerNode container;
  double threshold = 0;
  double accuracy = 0.001;
  double max_gradient = 1.1;
  bool evaluate = false;
  Vec3 evaluate_parameters{0};
  bool open = false;
  int max_trace = 1;
  bool all_intersections = false;
};
struct ParametricNode {
  std::array<std::shared_ptr<const FunctionNode>, 3> function;
  Vec2 u_range{0, 1}, v_range{0, 1};  // (min, max)
  ContainerNode container;
  double accuracy = 0.001;
  double max_gradient = 1;
  int precompute_depth = 0;
  std::array<bool, 3> precompute{false, false, false};
};
struct JuliaFractalNode {
  enum class Algebra : uint8_t { quaternion, hypercomplex };
  enum class Function : uint8_t {
    sqr, cube, exp, reciprocal, sin, asin, sinh, asinh, cos, acos, cosh, acosh, tan, atan, tanh,
    atanh, log, pwr
  };
  Vec4 parameter{1, 0, 0, 0};
  Vec4 slice{0, 0, 0, 1};
  double slice_distance = 0;
  int max_iteration = 20;
  double precision = 20;
  Algebra algebra = Algebra::quaternion;
  Function function = Function::sqr;
  Vec2 power{0, 0};
};
enum class CsgKind : uint8_t { union_, merge, intersection, difference };
struct CsgNode {
  CsgKind kind = CsgKind::union_;
  bool is_light_group = false;
  bool global_lights = true;  // light_group only
  std::vector<ObjectPtr> children;  // a difference's later ones are *not* yet inverted here
};
struct LightNode;

using ShapeNode =
    std::variant<SphereNode, BoxNode, PlaneNode, CylinderNode, ConeNode, DiscNode, TorusNode,
                 SuperellipsoidNode, OvusNode, TriangleNode, Rare<SmoothTriangleNode>, PolygonNode,
                 Rare<QuadricNode>, PolyNode, LatheNode, SorNode, PrismNode, SphereSweepNode, BlobNode,
                 Rare<TextNode>, HeightFieldNode, Rare<BicubicPatchNode>, Rare<MeshNode>, Rare<IsosurfaceNode>,
                 Rare<ParametricNode>, Rare<JuliaFractalNode>, CsgNode, std::shared_ptr<const LightNode>>;

}  // namespace durer
