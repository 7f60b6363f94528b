// Colours as POV-Ray keeps them: single precision, linear working space, any sign and size.
#pragma once

namespace durer {

struct RGB {
  float red = 0, green = 0, blue = 0;

  RGB() = default;
  constexpr RGB(float r, float g, float b) : red(r), green(g), blue(b) {}
  explicit constexpr RGB(float grey) : red(grey), green(grey), blue(grey) {}

  RGB& operator+=(const RGB& o) {
    red += o.red, green += o.green, blue += o.blue;
    return *this;
  }
  RGB& operator-=(const RGB& o) {
    red -= o.red, green -= o.green, blue -= o.blue;
    return *this;
  }
  RGB& operator*=(const RGB& o) {
    red *= o.red, green *= o.green, blue *= o.blue;
    return *this;
  }
  RGB& operator*=(float s) {
    red *= s, green *= s, blue *= s;
    return *this;
  }
  // Rounded once, after the product.
  RGB times(double s) const {
    return {static_cast<float>(static_cast<double>(red) * s),
            static_cast<float>(static_cast<double>(green) * s),
            static_cast<float>(static_cast<double>(blue) * s)};
  }
  friend RGB operator+(RGB a, const RGB& b) { return a += b; }
  friend RGB operator-(RGB a, const RGB& b) { return a -= b; }
  friend RGB operator*(RGB a, const RGB& b) { return a *= b; }
  friend RGB operator*(RGB a, float s) { return a *= s; }
  friend RGB operator*(float s, RGB a) { return a *= s; }
  bool operator==(const RGB&) const = default;

  bool is_black() const { return red == 0 && green == 0 && blue == 0; }
  // POV-Ray's luma weights (spec/language.md 5.3).
  float grey() const { return 0.297f * red + 0.589f * green + 0.114f * blue; }
  float max_component() const {
    const float rg = red > green ? red : green;
    return rg > blue ? rg : blue;
  }
};

struct ColorRGBFT {
  float red = 0, green = 0, blue = 0, filter = 0, transmit = 0;

  RGB rgb() const { return {red, green, blue}; }
  void set_rgb(const RGB& c) { red = c.red, green = c.green, blue = c.blue; }
  bool is_opaque() const { return filter == 0 && transmit == 0; }
  bool operator==(const ColorRGBFT&) const = default;
  friend ColorRGBFT operator+(const ColorRGBFT& a, const ColorRGBFT& b) {
    return {a.red + b.red, a.green + b.green, a.blue + b.blue, a.filter + b.filter,
            a.transmit + b.transmit};
  }
  friend ColorRGBFT operator*(const ColorRGBFT& a, float s) {
    return {a.red * s, a.green * s, a.blue * s, a.filter * s, a.transmit * s};
  }
};

}  // namespace durer
