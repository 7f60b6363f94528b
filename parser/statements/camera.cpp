#include "parser/statements/camera.h"

#include <algorithm>
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/objects.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;
constexpr double kDegree = M_PI / 180;

class CameraReader {
 public:
  CameraReader(Parser& parser, CameraNode& camera)
      : parser_(parser), camera_(camera), stepwise_(parser.language_version() < 350) {}

  void read() {
    while (accept_kind()) {
    }
    while (accept_item()) {
    }
    if (!stepwise_) apply_in_order();
    finish();
  }

 private:
  bool accept_kind() {
    struct Word {
      Keyword keyword;
      CameraKind kind;
    };
    static constexpr Word kWords[] = {
        {Keyword::perspective, CameraKind::perspective},
        {Keyword::orthographic, CameraKind::orthographic},
        {Keyword::fisheye, CameraKind::fisheye},
        {Keyword::ultra_wide_angle, CameraKind::ultra_wide_angle},
        {Keyword::omnimax, CameraKind::omnimax},
        {Keyword::panoramic, CameraKind::panoramic},
        {Keyword::spherical, CameraKind::spherical},
    };
    if (parser_.at_any({Keyword::spherical, Keyword::mesh_camera})) require_version_3_5();
    for (const Word& word : kWords) {
      if (!parser_.accept(word.keyword)) continue;
      set_kind(word.kind);
      return true;
    }
    if (parser_.accept(Keyword::cylinder)) {
      const int type = parser_.parse_int();
      if (type < 1 || type > 4) parser_.error("a cylinder camera is of type 1, 2, 3 or 4");
      set_kind(static_cast<CameraKind>(static_cast<int>(CameraKind::cylinder1) + type - 1));
      return true;
    }
    if (parser_.accept(Keyword::mesh_camera)) {
      set_kind(CameraKind::mesh);
      parse_mesh();
      return true;
    }
    return false;
  }

  void require_version_3_5() {
    if (stepwise_) parser_.error("this word in a camera needs #version 3.5 or later");
  }

  void set_kind(CameraKind kind) {
    camera_.kind = kind;
    if (kind != CameraKind::perspective && kind != CameraKind::orthographic &&
        camera_.angle == 0) {
      camera_.angle = 90;
    }
    if (stepwise_ && kind == CameraKind::orthographic) scale_orthographic();
  }

  void parse_mesh() {
    parser_.note_experimental("mesh camera");
    parser_.expect_open("mesh_camera");
    // No commas in here.
    camera_.rays_per_pixel = parser_.parse_int();
    camera_.distribution = parser_.parse_int();
    if (camera_.rays_per_pixel < 1) parser_.error("a mesh_camera needs at least one ray");
    if (camera_.distribution < 0 || camera_.distribution > 3) {
      parser_.error("the distribution of a mesh_camera is 0, 1, 2 or 3");
    }
    if (camera_.distribution >= 2 && camera_.rays_per_pixel != 1) {
      parser_.error("distributions 2 and 3 of a mesh_camera take one ray for each pixel");
    }
    camera_.max_distance = parser_.parse_optional_float(0);
    while (parser_.at(Keyword::mesh)) {
      ObjectPtr mesh = parse_object(parser_);
      camera_.mesh_objects.push_back(std::move(mesh));
    }
    if (parser_.accept(Keyword::smooth)) {
      if (camera_.distribution != 3) {
        parser_.error("smooth belongs to distribution 3 of a mesh_camera only");
      }
      camera_.mesh_smooth = true;
    }
    const size_t meshes = camera_.mesh_objects.size();
    if (meshes == 0) parser_.error("a mesh_camera needs at least one mesh");
    if (camera_.distribution == 0 && static_cast<size_t>(camera_.rays_per_pixel) > meshes) {
      parser_.error("a mesh_camera of distribution 0 needs a mesh for each ray");
    }
    if (camera_.distribution == 3 && meshes > 1) {
      parser_.warning("distribution 3 of a mesh_camera uses the first mesh only");
    }
    parser_.expect_close("mesh_camera");
  }

  bool accept_item() {
    Transform transform;
    if (parser_.accept(Keyword::location)) {
      camera_.location = parser_.parse_vector();
    } else if (parser_.accept(Keyword::direction)) {
      camera_.direction = parser_.parse_vector();
    } else if (parser_.accept(Keyword::up)) {
      camera_.up = parser_.parse_vector();
      up_given_ = true;
    } else if (parser_.accept(Keyword::right)) {
      camera_.right = parser_.parse_vector();
      right_given_ = true;
    } else if (parser_.accept(Keyword::sky)) {
      camera_.sky = parser_.parse_vector();
    } else if (parser_.accept(Keyword::look_at)) {
      camera_.look_at = parser_.parse_vector();
      look_at_given_ = true;
      if (stepwise_) apply_look_at();
    } else if (parser_.accept(Keyword::angle)) {
      parse_angle();
    } else if (parser_.accept(Keyword::aperture)) {
      camera_.aperture = parser_.parse_float();
    } else if (parser_.accept(Keyword::blur_samples)) {
      const double first = parser_.parse_float();
      parser_.accept_comma();
      if (parser_.at_expression()) {
        camera_.min_blur_samples = count_of(first);
        camera_.blur_samples = parser_.parse_int();
      } else {
        camera_.blur_samples = count_of(first);
      }
      if (camera_.blur_samples <= 0 || camera_.min_blur_samples < 0) {
        parser_.error("the number of blur_samples must be positive");
      }
      if (camera_.min_blur_samples > camera_.blur_samples) {
        parser_.error("the least number of blur_samples is above the greatest");
      }
    } else if (parser_.accept(Keyword::confidence)) {
      camera_.confidence = parser_.parse_float();
      if (!(camera_.confidence > 0 && camera_.confidence < 1)) {
        parser_.warning("the camera's confidence must lie between 0 and 1; 0.9 is used");
        camera_.confidence = CameraNode{}.confidence;
      }
    } else if (parser_.accept(Keyword::variance)) {
      camera_.variance = parser_.parse_float();
      if (!(camera_.variance >= 0 && camera_.variance <= 1)) {
        parser_.warning("the camera's variance must lie between 0 and 1; 0.0001 is used");
        camera_.variance = CameraNode{}.variance;
      }
    } else if (parser_.accept(Keyword::focal_point)) {
      camera_.focal_point = parser_.parse_vector();
      focal_point_given_ = true;
      if (stepwise_) camera_.focal_distance = length(camera_.focal_point - camera_.location);
    } else if (parser_.accept(Keyword::bokeh)) {
      require_version_3_5();
      parser_.expect_open("bokeh");
      if (parser_.accept(Keyword::pigment)) {
        camera_.bokeh = parse_pigment(parser_, default_texture(parser_)->pigment);
      }
      parser_.expect_close("bokeh");
    } else if (parser_.accept(Keyword::normal)) {
      camera_.normal = parse_normal(
          parser_, camera_.normal ? camera_.normal : default_texture(parser_)->normal);
    } else if (accept_transformation(parser_, transform)) {
      if (stepwise_) {
        apply(transform);
      } else {
        transform_ = transform_.then(transform);
      }
    } else if (stepwise_ && accept_kind()) {
      return true;
    } else {
      return false;
    }
    return true;
  }

  void parse_angle() {
    const double angle = parser_.parse_float();
    if (angle < 0) parser_.error("the camera's angle must not be negative");
    if (camera_.kind == CameraKind::spherical) {
      camera_.spherical_angles.x = angle;
      parser_.accept_comma();
      camera_.spherical_angles.y = parser_.parse_optional_float(angle / 2);
      return;
    }
    camera_.angle = angle;
    angle_given_ = true;
    if (stepwise_) apply_angle();
  }

  static int count_of(double number) {
    return number >= 1 ? static_cast<int>(std::min(number, 1e9)) : 0;
  }

  bool has_flat_image() const {
    return camera_.kind == CameraKind::perspective || camera_.kind == CameraKind::orthographic;
  }

  void apply_angle() {
    if (!angle_given_ || !has_flat_image() || camera_.angle == 0) return;
    if (camera_.angle >= 180) parser_.error("the camera's angle must be less than 180 degrees");
    const double distance =
        length(camera_.right) / (2 * std::tan(camera_.angle / 2 * kDegree));
    camera_.direction = unit_or_zero(camera_.direction) * distance;
    default_focus_ = distance;
  }

  void apply_look_at() {
    const double d = length(camera_.direction), h = length(camera_.up),
                 w = length(camera_.right);
    const double handedness =
        dot(cross(camera_.up, camera_.direction), camera_.right) > 0 ? 1 : -1;
    const Vec3 towards = camera_.look_at - camera_.location;
    if (dot(towards, towards) < kEpsilon) {
      parser_.error("the camera's location and look_at are the same point");
    }
    const Vec3 forward = unit_or_zero(towards);
    Vec3 right = cross(camera_.sky, forward);
    if (std::abs(right.x) < kEpsilon && std::abs(right.y) < kEpsilon &&
        std::abs(right.z) < kEpsilon) {
      if (parser_.language_version() >= 350) {
        parser_.warning("the camera looks along its sky vector; its old right vector is kept");
      }
      right = camera_.right;
    }
    right = unit_or_zero(right);
    default_focus_ = d;
    camera_.direction = d * forward;
    camera_.right = handedness * w * right;
    camera_.up = h * cross(forward, right);
  }

  void scale_orthographic() {
    const double d = length(camera_.direction);
    const double distance = length(camera_.look_at - camera_.location);
    if (d <= kEpsilon || distance <= kEpsilon) return;
    camera_.right *= distance / d;
    camera_.up *= distance / d;
  }

  void apply(const Transform& t) {
    camera_.location = t.point(camera_.location);
    camera_.direction = t.direction(camera_.direction);
    camera_.up = t.direction(camera_.up);
    camera_.right = t.direction(camera_.right);
  }

  // Version 3.5 and later: fixed order, whatever the order of the text.
  void apply_in_order() {
    apply_angle();
    if (look_at_given_) apply_look_at();
    if (camera_.kind == CameraKind::orthographic &&
        (angle_given_ || (!up_given_ && !right_given_))) {
      scale_orthographic();
    }
    if (focal_point_given_) {
      camera_.focal_distance = length(camera_.focal_point - camera_.location);
    }
    apply(transform_);
  }

  void finish() {
    if (!focal_point_given_) camera_.focal_distance = default_focus_ < 0 ? 1 : default_focus_;
    if (camera_.focal_distance == 0) camera_.focal_distance = 1;
    if (std::abs(dot(camera_.right, camera_.up)) > kEpsilon ||
        std::abs(dot(camera_.right, camera_.direction)) > kEpsilon ||
        std::abs(dot(camera_.up, camera_.direction)) > kEpsilon) {
      parser_.warning("the camera's vectors are not at right angles to each other");
    }
  }

  Parser& parser_;
  CameraNode& camera_;
  bool stepwise_;
  bool angle_given_ = false, up_given_ = false, right_given_ = false, look_at_given_ = false,
       focal_point_given_ = false;
  double default_focus_ = -1;
  Transform transform_;
};

}  // namespace

std::shared_ptr<const CameraNode> parse_camera(Parser& parser,
                                               const std::shared_ptr<const CameraNode>& start) {
  parser.expect_open("camera");
  if (const auto named = parser.accept_identifier<CameraNode>(ValueKind::camera)) {
    auto copy = std::make_shared<CameraNode>(*named);
    if (parser.language_version() < 350) {
      // Before 3.5 a copy may be changed in every way.
      CameraReader(parser, *copy).read();
    } else {
      const Transform t = parse_transformations(parser);
      copy->location = t.point(copy->location);
      copy->direction = t.direction(copy->direction);
      copy->up = t.direction(copy->up);
      copy->right = t.direction(copy->right);
    }
    parser.expect_close("camera");
    return copy;
  }
  // Before language 3.5 only a further #default starts from #default's camera (measured on povray 3.7).
  const bool uses_default = parser.language_version() >= 350 || parser.in_default_block;
  const auto from = start ? start : uses_default ? parser.default_camera : nullptr;
  auto camera = from ? std::make_shared<CameraNode>(*from) : std::make_shared<CameraNode>();
  camera->position = parser.position();
  CameraReader(parser, *camera).read();
  parser.expect_close("camera");
  return camera;
}

}  // namespace durer
