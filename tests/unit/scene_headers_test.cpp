#include <gtest/gtest.h>

#include "tracer/scene/scene.h"

namespace durer {
namespace {

TEST(SceneNodes, TransformsMergeAndMoveTheTexture) {
  PigmentNode pigment;
  pigment.pattern.edit().kind = PatternKind::bozo;
  auto node = std::make_shared<const PigmentNode>(pigment);
  node = transformed(node, Transform::translation({1, 0, 0}));
  node = transformed(node, Transform::scaling({2, 2, 2}));
  ASSERT_EQ(node->pattern->warps.size(), 1u);
  const auto& merged = std::get<Transform>(node->pattern->warps[0]);
  EXPECT_EQ(merged.point({0, 0, 0}), Vec3(2, 0, 0));
}

TEST(SceneNodes, CopiesKeepUvMappedTexturesInPlace) {
  auto texture = std::make_shared<TextureNode>();
  auto base = std::make_shared<ObjectNode>();
  base->shape = std::make_shared<const ShapeNode>(SphereNode{});
  base->modifiers = {SetFlag{ObjectFlag::uv_mapping, true}, SetTexture{texture}};
  ObjectNode copy;
  copy.base = base;
  copy.modifiers = {Transform::translation({1, 2, 3})};
  EXPECT_EQ(resolve_textures(copy).texture, texture);
  EXPECT_TRUE(std::holds_alternative<SphereNode>(shape_of(copy)));
}

TEST(Transforms, RotateAsTheManualSays) {
  const Vec3 p = Transform::rotation({30, 40, 50}).point({1, 2, 3});
  EXPECT_NEAR(p.x, 1.8012810619, 1e-9);
  EXPECT_NEAR(p.y, 2.5076901472, 1e-9);
  EXPECT_NEAR(p.z, 2.1134986779, 1e-9);
}

}  // namespace
}  // namespace durer
