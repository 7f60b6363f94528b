// The sweep over convex solids against the general way, which a member that is not convex asks for.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/unit/parsed_text.h"
#include "tracer/world/world.h"

namespace durer {
namespace {

// Contains all points that rays of this test pass; its surface is far away.
const char* const kEverything = "union { sphere { 0, 1000 } torus { 5000, 1 } } ";

std::string number(double value) { return std::to_string(value); }

class RandomMembers {
 public:
  std::string next() {
    std::string text;
    switch (random_() % 7) {
      case 0: text = "sphere { " + place() + ", " + number(size()); break;
      case 1: text = "box { -" + number(size()) + ", " + number(size()); break;
      case 2: text = "cylinder { " + place() + ", " + place() + "+y, " + number(size()); break;
      case 3: text = "cone { " + place() + ", " + number(size()) + ", " + place() + "-y, 0.2"; break;
      case 4:
      case 5: text = quadric(); break;
      default: text = "plane { " + place() + "+y*0.1, " + number(0.3 * size()); break;
    }
    if (random_() % 2) text += " rotate <" + number(90 * size()) + ", 20, 0>";
    if (random_() % 3 == 0) text += " scale <1, " + number(size()) + ", 1>";
    if (random_() % 3 == 0) text += " inverse";
    return text + " } ";
  }
  // A CSG of two or three parts, nested as deep.
  std::string tree(int depth) {
    if (depth == 0) return next();
    static const char* const kKinds[] = {"union", "merge", "intersection", "difference"};
    std::string text = std::string(kKinds[random_() % 4]) + " { ";
    for (uint32_t i = 2 + random_() % 2; i > 0; --i) text += tree(random_() % 4 ? depth - 1 : 0);
    return text + (random_() % 5 ? "} " : "inverse } ");
  }
  Vec3 vector() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }

 private:
  // Ellipsoids, cylinders, paraboloids, slabs, and their outsides; cones and hyperboloids, that no line
  // is sure to meet in one interval.
  std::string quadric() {
    static const char* const kForms[] = {
        "<1, 2, 3>, <0.2, 0, 0.1>, <0.1, 0, 0>, -0.4", "<1, 0, 1>, 0, 0, -0.2",
        "<1, 0, 2>, 0, <0, -0.5, 0>, 0",               "<1, 0, 0>, 0, 0, -0.1",
        "<-1, -2, -3>, 0, <0.1, 0, 0>, 0.4",           "<-1, 0, -1>, 0, 0, 0.2",
        "<1, -0.5, 1>, 0, 0, 0",                       "<1, -1, 1>, 0, 0, -0.2"};
    // Turned, so that no automatic box of povray's cuts them off (spec/geometry.md 14.2).
    return std::string("quadric { ") + kForms[random_() % 8] + " rotate <30, 20, 40>";
  }
  double size() { return 0.7 + 0.5 * uniform_(random_); }
  std::string place() {
    const Vec3 p = 0.6 * vector();
    return "<" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ">";
  }

  std::mt19937 random_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

std::shared_ptr<const ObjectQuery> query_of(const std::string& statement) {
  const ParsedText parsed = parse_text("#version 3.7; global_settings { assumed_gamma 1 } " + statement);
  EXPECT_TRUE(parsed.scene) << parsed.error;
  return parsed.scene ? ObjectQuery::build(parsed.scene->objects.front(), 370) : nullptr;
}

// Returns how many rays met the CSG.
int compare_ways(RandomMembers& random, const std::string& members) {
  const auto swept = query_of("intersection { " + members + "}");
  const auto general = query_of("intersection { " + members + kEverything + "}");
  if (!swept || !general) return 0;
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 direction = normalize_or_zero(random.vector());
    // From outside, and from among the members.
    const Vec3 origin = random.vector() - (i % 2 ? 5.0 : 0.0) * direction;
    Vec3 p, n, q, m;
    const bool hit = swept->trace(origin, direction, p, n) && length(p) < 500;
    const bool expected = general->trace(origin, direction, q, m) && length(q) < 500;
    EXPECT_EQ(hit, expected) << members;
    if (!hit || !expected) continue;
    ++met;
    EXPECT_EQ(p, q) << members;
    EXPECT_EQ(n, m) << members;
  }
  return met;
}

TEST(ConvexCsg, SweptAsInTheGeneralWay) {
  RandomMembers random;
  int met = 0;
  for (int scene = 0; scene < 150; ++scene) {
    std::string members;
    for (int i = 0; i < 2 + scene % 5; ++i) members += random.next();
    met += compare_ways(random, members);
  }
  EXPECT_GT(met, 4000);
}

TEST(ConvexCsg, NestedOnesSweptAsInTheGeneralWay) {
  RandomMembers random;
  int met = 0;
  for (int scene = 0; scene < 300; ++scene) {
    met += compare_ways(random, random.tree(1 + scene % 2) + random.tree(scene % 3));
  }
  EXPECT_GT(met, 8000);
}

TEST(ConvexCsg, CoincidentFacesFollowTheInsideRules) {
  for (const char* members : {"box { -1, 1 } box { <-.5, -.5, -1>, <.5, .5, 0> inverse } ",
                              "box { -1, 1 } box { -1, 1 } ", "sphere { 0, 1 } sphere { 0, 1 inverse } ",
                              "box { -1, 1 } plane { y, 1 } plane { -y, 1 } "}) {
    const auto swept = query_of(std::string("intersection { ") + members + "}");
    const auto general = query_of(std::string("intersection { ") + members + kEverything + "}");
    ASSERT_TRUE(swept && general);
    for (const Vec3& origin : {Vec3(0.1, 0.2, -3), Vec3(0.7, 0.7, -3), Vec3(0.2, 3, 0.1)}) {
      for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(0, -1, 0)}) {
        Vec3 p, n, q, m;
        const bool hit = swept->trace(origin, direction, p, n) && length(p) < 500;
        const bool expected = general->trace(origin, direction, q, m) && length(q) < 500;
        ASSERT_EQ(hit, expected) << members;
        if (!hit) continue;
        EXPECT_EQ(p, q) << members;
        EXPECT_EQ(n, m) << members;
      }
    }
  }
}

}  // namespace
}  // namespace durer
