// From the working space to a file's numbers (spec/shading.md 6).
#pragma once

namespace durer {

// A transfer curve: nothing, a power law, or sRGB's.
struct TransferCurve {
  enum class Kind { neutral, power, srgb };
  Kind kind = Kind::neutral;
  float gamma = 1;

  static TransferCurve neutral() { return {}; }
  static TransferCurve srgb() { return {Kind::srgb, 2.2f}; }
  // |1 - 1/gamma| <= 0.01 counts as neutral.
  static TransferCurve power(double gamma);

  float encode(float linear) const;
  float decode(float encoded) const;
  bool operator==(const TransferCurve&) const = default;
};

// fileEncode(workDecode(x)) as one step: equal curves cancel, two power laws merge.
class OutputTransfer {
 public:
  OutputTransfer(const TransferCurve& working, const TransferCurve& file);
  float operator()(float value) const;

 private:
  TransferCurve decode_, encode_;
};

}  // namespace durer
