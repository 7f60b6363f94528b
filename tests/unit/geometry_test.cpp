// Values of spec/geometry.md 18 and what follows from its rules.
#include <gtest/gtest.h>

#include <random>

#include "tracer/world/world.h"

namespace durer {
namespace {

ObjectPtr object(ShapeNode shape, decltype(ObjectNode::modifiers) modifiers = {}) {
  auto node = std::make_shared<ObjectNode>();
  node->shape = std::make_shared<const ShapeNode>(std::move(shape));
  node->modifiers = std::move(modifiers);
  return node;
}

ObjectPtr csg(CsgKind kind, std::vector<ObjectPtr> children, decltype(ObjectNode::modifiers) modifiers = {}) {
  CsgNode node;
  node.kind = kind;
  node.children = std::move(children);
  return object(node, std::move(modifiers));
}

void expect_hit(const ObjectPtr& target, const Vec3& origin, const Vec3& direction,
                const Vec3& point, const Vec3& normal) {
  const auto query = ObjectQuery::build(target, 370);
  Vec3 p, n;
  ASSERT_TRUE(query->trace(origin, direction / length(direction), p, n));
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(p[i], point[i], 1e-8) << i;
    EXPECT_NEAR(n[i], normal[i], 1e-8) << i;
  }
}

bool misses(const ObjectPtr& target, const Vec3& origin, const Vec3& direction) {
  Vec3 p, n;
  return !ObjectQuery::build(target, 370)->trace(origin, direction / length(direction), p, n);
}

const Vec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);
const BoxNode kCube{Vec3(-1), Vec3(1)};

TEST(Shapes, HitAsMeasured) {
  expect_hit(object(BoxNode{Vec3(-1), Vec3(1)}, {Transform::rotation({0, 45, 0})}), {0.3, 0, -5},
             kZ, {0.3, 0, -1.114213562}, {0.7071067811865, 0, -0.7071067811865});
  expect_hit(object(kCube), {3, 3, -3}, {-1, -1, 1}, {1, 1, -1}, kX);
  expect_hit(object(ConeNode{Vec3(0), {0, 2, 0}, 1, 0.5, false}), {0, 1, -3}, kZ, {0, 1, -0.75},
             {0, 0.24253562503, -0.97014250014});
  expect_hit(object(ConeNode{Vec3(0), {0, 2, 0}, 1, -1, false}), {0, 1.5, -3}, kZ, {0, 1.5, -0.5},
             {0, -0.7071067811865, -0.7071067811865});
  expect_hit(object(TorusNode{1, 0.25, false}), {0.9, 3, 0}, -kY, {0.9, 0.22912878475, 0},
             {-0.4, 0.91651513899, 0});
  expect_hit(object(TorusNode{1, 0.25, false},
                    {Transform::rotation({90, 0, 0}), Transform::scaling({1, 2, 1})}),
             {0.9, 3, 0.1}, -kY, {0.9, 1.674225277, 0.1},
             {0.797694081, 0.370977665, 0.475457385});
  expect_hit(object(QuadricNode{{1, 0, 1}, Vec3(0), {0, -1, 0}, 0}), {0.5, 5, 0}, -kY,
             {0.5, 0.25, 0}, {0.7071067811865, -0.7071067811865, 0});
  expect_hit(object(SmoothTriangleNode{{Vec3(0), {1, 0, 0}, {0, 1, 0}},
                                       {Vec3(-1, 0, 1), {1, 0, 1}, {0, 1, 1}}}),
             {0.2, 0.2, -3}, kZ, {0.2, 0.2, 0}, {-0.365148372, 0.182574186, 0.912870929});
}

TEST(Shapes, TorusLosesTheRaysThatPovRayLoses) {
  const ObjectPtr spindle = object(TorusNode{0.5, 1, false});
  const auto query = ObjectQuery::build(spindle, 370);
  Vec3 p, n;
  ASSERT_TRUE(query->trace({0, 3, 0}, -kY, p, n));
  EXPECT_NEAR(p.y, 0.866025412, 2e-9);
  ASSERT_TRUE(query->trace({0.0005, 3, 0}, -kY, p, n));
  EXPECT_NEAR(p.y, 0.866313858, 1e-9);
  EXPECT_FALSE(query->trace({0.001, 3, 0}, -kY, p, n));
  ASSERT_TRUE(query->trace({0.0015, 3, 0}, -kY, p, n));
  EXPECT_NEAR(p.y, 0.866889696, 1e-9);
  EXPECT_TRUE(query->inside(Vec3(0)));
}

TEST(Shapes, EqualDepthsGoToTheLastPushed) {
  expect_hit(object(BoxNode{Vec3(0), {1, 1, 0}}), {0.5, 0.5, -3}, kZ, {0.5, 0.5, 0}, kZ);
}

TEST(Shapes, TransformedTrianglesTurnOver) {
  const TriangleNode exchanged{{Vec3(0), kY, kX}};
  expect_hit(object(exchanged), {0.2, 0.2, -3}, kZ, {0.2, 0.2, 0}, kZ);
  expect_hit(object(exchanged, {Transform::translation(Vec3(0))}), {0.2, 0.2, -3}, kZ,
             {0.2, 0.2, 0}, -kZ);
}

// Every hit lies on the surface, and the state changes across each: against stepping along the ray.
TEST(Shapes, AgreeWithSteppingAlongTheRay) {
  const ObjectPtr shapes[] = {
      object(SphereNode{{0.1, 0.2, 0.3}, 1.1}),
      object(SphereNode{Vec3(0), 1}, {Transform::scaling({1, 2, 0.5}), Transform::rotation({10, 20, 30})}),
      object(kCube, {Transform::rotation({30, 40, 50})}),
      object(CylinderNode{{-1, 0, 0.5}, {1, 1, 0}, 0.6, false}),
      object(ConeNode{{0, -1, 0}, {0.5, 1, 0}, 1, 0.25, false}),
      object(TorusNode{1, 0.4, false}, {Transform::rotation({25, 0, 70})}),
      csg(CsgKind::difference, {object(kCube), object(SphereNode{{1, 1, 1}, 1})}),
      csg(CsgKind::intersection, {object(kCube), object(SphereNode{Vec3(0), 1.3})}),
      csg(CsgKind::merge, {object(kCube), object(SphereNode{{1, 0, 0}, 0.9})}),
  };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const ObjectPtr& shape : shapes) {
    const auto query = ObjectQuery::build(shape, 370);
    for (int i = 0; i < 400; ++i) {
      const Vec3 target(uniform(random), uniform(random), uniform(random));
      Vec3 direction(uniform(random), uniform(random), uniform(random));
      if (i % 4 == 0) direction = i % 8 ? kX : -kZ;
      direction /= length(direction);
      const Vec3 origin = target - 6.0 * direction;
      // First entry by steps.
      constexpr double kStep = 0.004;
      double entered = -1;
      for (double t = 0; t < 12; t += kStep) {
        if (query->inside(origin + t * direction)) {
          entered = t;
          break;
        }
      }
      Vec3 p, n;
      if (!query->trace(origin, direction, p, n)) {
        EXPECT_LT(entered, 0);
        continue;
      }
      const double t = dot(p - origin, direction);
      if (entered >= 0) {
        EXPECT_LE(t, entered + 1e-9);
      }
      EXPECT_NE(query->inside(p + 1e-7 * n), query->inside(p - 1e-7 * n));
      EXPECT_NEAR(length(n), 1, 1e-12);
    }
  }
}

TEST(Csg, CoincidentSurfacesFollowTheInsideRules) {
  // The cutter's face on the opening is kept, the box's own is not.
  const ObjectPtr opened =
      csg(CsgKind::difference, {object(kCube), object(BoxNode{{-.5, -.5, -1}, {.5, .5, 0}})});
  expect_hit(opened, {0, 0, -3}, kZ, {0, 0, -1}, kZ);
  // Two identical inclusive solids merged are invisible, exclusive ones are not.
  EXPECT_TRUE(misses(csg(CsgKind::merge, {object(kCube), object(kCube)}), {0.1, 0.1, -3}, kZ));
  EXPECT_FALSE(misses(csg(CsgKind::merge, {object(SphereNode{}), object(SphereNode{})}),
                      {0.1, 0.1, -3}, kZ));
}

TEST(Csg, ManyMembersAreTheSameAsFew) {
  // The hierarchy over members changes nothing: against nested pairs.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<ObjectPtr> flat{object(kCube)};
  ObjectPtr nested = object(kCube);
  for (int i = 0; i < 60; ++i) {
    const ObjectPtr ball =
        object(SphereNode{{uniform(random), uniform(random), uniform(random)}, 0.3});
    flat.push_back(ball);
    nested = csg(CsgKind::difference, {nested, ball});
  }
  const auto many = ObjectQuery::build(csg(CsgKind::difference, flat), 370);
  const auto pairs = ObjectQuery::build(nested, 370);
  for (int i = 0; i < 500; ++i) {
    const Vec3 direction = normalize_or_zero({uniform(random), uniform(random), uniform(random)});
    const Vec3 origin = Vec3(uniform(random), uniform(random), 0.0) - 4.0 * direction;
    Vec3 p, n, q, m;
    const bool hit = many->trace(origin, direction, p, n);
    ASSERT_EQ(hit, pairs->trace(origin, direction, q, m));
    if (hit) {
      EXPECT_EQ(p, q);
      EXPECT_EQ(n, m);
    }
    const Vec3 point(uniform(random), uniform(random), uniform(random));
    EXPECT_EQ(many->inside(point), pairs->inside(point));
  }
}

TEST(Csg, InverseOfAUnionShowsTheUnionFromInside) {
  const ObjectPtr both = csg(CsgKind::union_,
                             {object(SphereNode{{-0.5, 0, 0}, 1}), object(SphereNode{{0.5, 0, 0}, 1})},
                             {SetFlag{ObjectFlag::inverse, true}});
  expect_hit(both, {-3, 0, 0}, kX, {-1.5, 0, 0}, kX);
}

TEST(Boxes, AreThoseOfPovRay) {
  const auto cut = ObjectQuery::build(
      csg(CsgKind::difference, {object(kCube), object(PlaneNode{kZ, 0})}), 370);
  EXPECT_EQ(cut->extents().min, Vec3(-1, -1, 0));
  EXPECT_EQ(cut->extents().max, Vec3(1, 1, 1));
  const auto bowl = ObjectQuery::build(
      object(QuadricNode{{1, 0, 1}, Vec3(0), {0, -1, 0}, 0},
             {AddClips{std::vector{object(PlaneNode{kY, 2})}}}),
      370);
  EXPECT_NEAR(bowl->extents().max.x, 1.41421, 1e-5);
  EXPECT_NEAR(bowl->extents().max.y, 2, 1e-6);
  EXPECT_NEAR(bowl->extents().min.y, 0, 1e-6);
  const auto bounded = ObjectQuery::build(
      object(SphereNode{Vec3(0), 1},
             {AddBounds{std::vector{object(BoxNode{Vec3(5), Vec3(6)})}}}),
      370);
  EXPECT_EQ(bounded->extents().min, Vec3(5));
  EXPECT_TRUE(bounded->inside(Vec3(0)));
}

// A thousand spheres: the hierarchy finds what a list finds.
TEST(World, FindsTheNearestOfMany) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-10, 10);
  Scene scene;
  std::vector<SphereNode> spheres;
  for (int i = 0; i < 1000; ++i) {
    spheres.push_back({{uniform(random), uniform(random), uniform(random)}, 0.4});
    scene.objects.push_back(object(spheres.back()));
  }
  const auto world = World::build(scene, {});
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin(uniform(random), uniform(random), uniform(random));
    Vec3 direction = normalize_or_zero({uniform(random), uniform(random), uniform(random)});
    if (i % 5 == 0) direction = {0, 1, 0};
    if (i % 7 == 0) direction = normalize_or_zero({uniform(random), 0, uniform(random)});
    double nearest = 1e30;
    for (const SphereNode& s : spheres) {
      const Vec3 to = s.center - origin;
      const double along = dot(to, direction);
      const double half2 = s.radius * s.radius - dot(to, to) + along * along;
      if (half2 <= 0) continue;
      for (const double t : {along - std::sqrt(half2), along + std::sqrt(half2)}) {
        if (t >= 1e-4) nearest = std::min(nearest, t);
      }
    }
    Hit hit;
    const bool found = world->closest_hit(origin, direction, {}, 1e10, hit);
    ASSERT_EQ(found, nearest < 1e30);
    if (found) {
      EXPECT_NEAR(hit.t, nearest, 1e-12);
      ++hits;
    }
  }
  EXPECT_GT(hits, 300);
}

// Copies that share one original are hit, shaded and told apart like whole objects.
TEST(World, SharesCopiesOfBigUnions) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<ObjectPtr> members;
  for (int i = 0; i < 50; ++i) {
    const Vec3 corner(uniform(random), uniform(random), uniform(random));
    members.push_back(object(BoxNode{corner, corner + Vec3(0.1)}));
  }
  const auto texture = std::make_shared<TextureNode>();
  const ObjectPtr original = csg(CsgKind::union_, members, {SetTexture{texture}});
  Scene shared, whole;
  for (int i = 0; i < 12; ++i) {
    const Transform place = Transform::rotation({10.0 * i, 30, 5.0 * i})
                                .then(Transform::translation({3.0 * (i % 4), 3.0 * (i / 4), 0}));
    auto copy = std::make_shared<ObjectNode>();
    copy->base = original;
    copy->modifiers = {place};
    shared.objects.push_back(copy);
    // A node of its own for each: nothing is shared.
    whole.objects.push_back(csg(CsgKind::union_, members, {SetTexture{texture}, place}));
  }
  const auto a = World::build(shared, {}), b = World::build(whole, {});
  EXPECT_LT(a->interiors().size(), 20u);
  int hits = 0;
  for (int i = 0; i < 12000; ++i) {
    const Vec3 origin(10 * uniform(random) + 4, 10 * uniform(random) + 3, -8);
    const Vec3 direction = normalize_or_zero({0.2 * uniform(random), 0.2 * uniform(random), 1});
    Hit hit, other;
    const bool found = a->closest_hit(origin, direction, {}, 1e10, hit);
    ASSERT_EQ(found, b->closest_hit(origin, direction, {}, 1e10, other));
    if (!found) continue;
    ++hits;
    EXPECT_NEAR(hit.t, other.t, 1e-10);
    SurfacePoint p, q;
    a->surface_point(origin, direction, hit, p);
    b->surface_point(origin, direction, other, q);
    EXPECT_NEAR(dot(p.normal, q.normal), 1, 1e-9);
    EXPECT_EQ(p.share_count, q.share_count);
    int inside[4], also[4];
    const Vec3 within = p.point - 1e-4 * p.normal;
    ASSERT_EQ(a->containing_interiors(within, inside, 4), b->containing_interiors(within, also, 4));
  }
  EXPECT_GT(hits, 100);
}

TEST(World, GivesCoincidentSurfacesToTheFirst) {
  Scene scene;
  for (int i = 0; i < 4; ++i) scene.objects.push_back(object(kCube));
  const auto world = World::build(scene, {});
  Hit hit;
  ASSERT_TRUE(world->closest_hit({0, 0, -5}, kZ, {}, 1e10, hit));
  SurfacePoint surface;
  world->surface_point({0, 0, -5}, kZ, hit, surface);
  EXPECT_EQ(surface.object->interior, 0);
  EXPECT_EQ(surface.normal, -kZ);
}

// A wavy sheet, small enough for our hierarchy and large enough for Embree.
TEST(Meshes, AreHitOnTheirTrianglesAndNeverBetweenThem) {
  for (const int side : {20, 60}) {
    MeshNode mesh;
    for (int j = 0; j <= side; ++j) {
      for (int i = 0; i <= side; ++i) {
        const float x = 2.0f * static_cast<float>(i) / static_cast<float>(side) - 1;
        const float z = 2.0f * static_cast<float>(j) / static_cast<float>(side) - 1;
        mesh.vertices.push_back({x, 0.2f * std::sin(5 * x) * std::cos(4 * z), z});
      }
    }
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const int v = j * (side + 1) + i;
        mesh.face_vertices.push_back({v, v + 1, v + side + 1});
        mesh.face_vertices.push_back({v + 1, v + side + 2, v + side + 1});
      }
    }
    const std::vector<glm::vec3> vertices = mesh.vertices;
    const auto faces = mesh.face_vertices;
    const auto query = ObjectQuery::build(object(mesh), 370);
    const auto moved = ObjectQuery::build(object(mesh, {Transform::scaling(Vec3(20))}), 370);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-0.95, 0.95);
    for (int i = 0; i < 2000; ++i) {
      const auto& face = faces[random() % faces.size()];
      const Vec3 a(vertices[face[0]]), b(vertices[face[1]]), c(vertices[face[2]]);
      // Aimed at an inner point, or nearly at a vertex or an edge: what is aimed at these
      // themselves may slip through, since planes are single precision (measured on povray 3.7: one
      // ray in five).
      const Vec3 middle = (a + b + c) / 3.0;
      const Vec3 at_edge = i % 3 == 0 ? a : (i % 3 == 1 ? 0.5 * (a + b) : middle);
      const Vec3 target = at_edge + 1e-5 * (middle - at_edge);
      if (std::abs(target.x) > 0.95 || std::abs(target.z) > 0.95) continue;
      const Vec3 origin = target + Vec3(0.1 * uniform(random), 3, 0.1 * uniform(random));
      Vec3 p, n;
      ASSERT_TRUE(query->trace(origin, normalize_or_zero(target - origin), p, n));
      EXPECT_NEAR(p.y, target.y, 1e-6);
      ASSERT_TRUE(moved->trace(20.0 * origin, normalize_or_zero(target - origin), p, n));
      EXPECT_NEAR(p.y, 20 * target.y, 2e-5);
      // From the surface on: nothing, the sheet is met once from above.
      EXPECT_FALSE(query->trace(target, kY, p, n));
    }
  }
}

TEST(Meshes, HaveAnInsideOnlyWithAVector) {
  MeshNode mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.face_vertices = {{1, 2, 3}, {0, 1, 2}, {0, 1, 3}, {0, 2, 3}};
  expect_hit(object(mesh), {0.2, 0.2, 3}, -kZ, {0.2, 0.2, 0.6}, Vec3(-0.57735025882720947));
  EXPECT_FALSE(ObjectQuery::build(object(mesh), 370)->has_inside());
  mesh.inside_vector = Vec3(0.3, 0.5, 0.7);
  const auto solid = ObjectQuery::build(object(mesh), 370);
  EXPECT_TRUE(solid->has_inside());
  EXPECT_TRUE(solid->inside({0.1, 0.1, 0.1}));
  EXPECT_FALSE(solid->inside({0.5, 0.5, 0.5}));
}

}  // namespace
}  // namespace durer
