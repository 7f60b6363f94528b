// What an identifier, a macro argument or an array element can hold.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "tracer/math/transform.h"
#include "tracer/math/vector.h"
#include "tracer/scene/color.h"

namespace durer {

enum class ValueKind : uint8_t {
  unset,  // declared without value, or an element that was never stored
  number, uv, vector, vector4, color,
  string,    // std::u16string
  array,     // Array (parser/array.h)
  spline,    // Spline (tracer/math/spline.h)
  function,  // FunctionNode (tracer/scene/function.h)
  macro,     // Macro (parser/macro.h)
  file,      // UserFile (parser/user_file.h)
  // Scene handles; the type behind each is that of the right-hand column.
  object,        // ObjectNode, light sources and light groups too
  texture,       // TextureNode: the top layer
  pigment,       // PigmentNode
  normal,        // NormalNode
  finish,        // FinishNode
  material,      // MaterialNode
  interior,      // InteriorNode
  media,         // MediaNode
  density,       // PigmentNode
  color_map,     // ColorMap
  pigment_map,   // PigmentMap
  normal_map,    // NormalMap
  slope_map,     // SlopeMap
  texture_map,   // TextureMap
  density_map,   // PigmentMap
  transform,     // Transform
  camera,        // CameraNode
  fog,           // FogNode
  rainbow,       // RainbowNode
  sky_sphere,    // SkySphereNode
};

// "float", "vector", "texture" ...: for messages.
const char* kind_name(ValueKind kind);

// One to five numbers with their count, or a shared handle. Copies are O(1): nodes are immutable,
// and an array is copied when one of its sharers writes to it.
class Value {
 public:
  Value() = default;
  Value(double number) : kind_(ValueKind::number) { numbers_[0] = number; }
  Value(const Vec2& v) : kind_(ValueKind::uv), numbers_{v.x, v.y} {}
  Value(const Vec3& v) : kind_(ValueKind::vector), numbers_{v.x, v.y, v.z} {}
  Value(const Vec4& v) : kind_(ValueKind::vector4), numbers_{v.x, v.y, v.z, v.w} {}
  Value(const ColorRGBFT& c)
      : kind_(ValueKind::color), numbers_{c.red, c.green, c.blue, c.filter, c.transmit} {}
  Value(std::u16string text)
      : kind_(ValueKind::string), handle_(std::make_shared<std::u16string>(std::move(text))) {}
  // A handle of the given kind; T must be the type that ValueKind names.
  template <typename T>
  Value(ValueKind kind, std::shared_ptr<T> handle) : kind_(kind), handle_(std::move(handle)) {}

  ValueKind kind() const { return kind_; }
  bool is_set() const { return kind_ != ValueKind::unset; }
  bool is_numeric() const { return kind_ >= ValueKind::number && kind_ <= ValueKind::color; }
  // 1..5; only of numeric values.
  int terms() const { return static_cast<int>(kind_); }
  double number() const { return numbers_[0]; }
  void set_number(double number) { numbers_[0] = number; }
  const std::array<double, 5>& numbers() const { return numbers_; }
  Vec3 vector() const { return {numbers_[0], numbers_[1], numbers_[2]}; }
  ColorRGBFT color() const {
    return {static_cast<float>(numbers_[0]), static_cast<float>(numbers_[1]),
            static_cast<float>(numbers_[2]), static_cast<float>(numbers_[3]),
            static_cast<float>(numbers_[4])};
  }
  const std::u16string& string() const {
    return *static_cast<const std::u16string*>(handle_.get());
  }
  // The handle as the type that the kind names; the caller has looked at kind().
  template <typename T>
  std::shared_ptr<const T> handle() const {
    return std::static_pointer_cast<const T>(handle_);
  }
  template <typename T>
  const T& as() const {
    return *static_cast<const T*>(handle_.get());
  }
  // Arrays and files are the only handles whose content changes.
  template <typename T>
  T& mutable_as() {
    return *static_cast<T*>(const_cast<void*>(handle_.get()));
  }
  bool is_shared() const { return handle_.use_count() > 1; }

 private:
  ValueKind kind_ = ValueKind::unset;
  std::array<double, 5> numbers_{};
  std::shared_ptr<const void> handle_;
};

}  // namespace durer
