#include "tracer/shading/dispersion.h"

#include <algorithm>

namespace durer {
namespace {

constexpr double kFirstWavelength = 375;
constexpr double kStep = 5;

// Integral of the hue up to 375, 380 ... 740 nm (spec/shading.md 11.6).
constexpr float kHueIntegral[74][3] = {
    {0.0000f, 0.0000f, 0.0000f}, {0.0009f, 0.0000f, 0.0038f},
    {0.0029f, 0.0000f, 0.0113f}, {0.0058f, 0.0000f, 0.0222f},
    {0.0094f, 0.0000f, 0.0363f}, {0.0135f, 0.0000f, 0.0534f},
    {0.0178f, 0.0000f, 0.0734f}, {0.0223f, 0.0000f, 0.0960f},
    {0.0267f, 0.0000f, 0.1210f}, {0.0308f, 0.0000f, 0.1482f},
    {0.0344f, 0.0000f, 0.1775f}, {0.0374f, 0.0000f, 0.2085f},
    {0.0394f, 0.0000f, 0.2412f}, {0.0404f, 0.0000f, 0.2753f},
    {0.0404f, 0.0000f, 0.3106f}, {0.0404f, 0.0000f, 0.3470f},
    {0.0404f, 0.0000f, 0.3841f}, {0.0404f, 0.0000f, 0.4219f},
    {0.0404f, 0.0000f, 0.4600f}, {0.0404f, 0.0000f, 0.4984f},
    {0.0404f, 0.0000f, 0.5368f}, {0.0404f, 0.0000f, 0.5750f},
    {0.0404f, 0.0000f, 0.6128f}, {0.0404f, 0.0000f, 0.6500f},
    {0.0404f, 0.0000f, 0.6864f}, {0.0404f, 0.0045f, 0.7218f},
    {0.0404f, 0.0131f, 0.7560f}, {0.0404f, 0.0256f, 0.7888f},
    {0.0404f, 0.0417f, 0.8200f}, {0.0404f, 0.0612f, 0.8494f},
    {0.0404f, 0.0839f, 0.8768f}, {0.0404f, 0.1095f, 0.9020f},
    {0.0404f, 0.1378f, 0.9248f}, {0.0404f, 0.1684f, 0.9449f},
    {0.0404f, 0.2013f, 0.9623f}, {0.0404f, 0.2360f, 0.9767f},
    {0.0404f, 0.2724f, 0.9878f}, {0.0404f, 0.3102f, 0.9956f},
    {0.0404f, 0.3492f, 0.9997f}, {0.0404f, 0.3891f, 1.0000f},
    {0.0429f, 0.4297f, 1.0000f}, {0.0502f, 0.4707f, 1.0000f},
    {0.0620f, 0.5119f, 1.0000f}, {0.0780f, 0.5530f, 1.0000f},
    {0.0979f, 0.5937f, 1.0000f}, {0.1215f, 0.6340f, 1.0000f},
    {0.1483f, 0.6733f, 1.0000f}, {0.1781f, 0.7117f, 1.0000f},
    {0.2105f, 0.7487f, 1.0000f}, {0.2454f, 0.7841f, 1.0000f},
    {0.2823f, 0.8178f, 1.0000f}, {0.3210f, 0.8494f, 1.0000f},
    {0.3611f, 0.8786f, 1.0000f}, {0.4024f, 0.9054f, 1.0000f},
    {0.4446f, 0.9293f, 1.0000f}, {0.4873f, 0.9501f, 1.0000f},
    {0.5302f, 0.9677f, 1.0000f}, {0.5731f, 0.9817f, 1.0000f},
    {0.6155f, 0.9919f, 1.0000f}, {0.6573f, 0.9981f, 1.0000f},
    {0.6982f, 1.0000f, 1.0000f}, {0.7377f, 1.0000f, 1.0000f},
    {0.7756f, 1.0000f, 1.0000f}, {0.8116f, 1.0000f, 1.0000f},
    {0.8454f, 1.0000f, 1.0000f}, {0.8767f, 1.0000f, 1.0000f},
    {0.9052f, 1.0000f, 1.0000f}, {0.9306f, 1.0000f, 1.0000f},
    {0.9525f, 1.0000f, 1.0000f}, {0.9707f, 1.0000f, 1.0000f},
    {0.9849f, 1.0000f, 1.0000f}, {0.9947f, 1.0000f, 1.0000f},
    {0.9998f, 1.0000f, 1.0000f}, {1.0000f, 1.0000f, 1.0000f},
};

RGB hue_integral(double wavelength) {
  const double place = std::clamp((wavelength - kFirstWavelength) / kStep, 0.0, 73.0);
  const int below = std::min(static_cast<int>(place), 72);
  const float share = static_cast<float>(place - below);
  const float* low = kHueIntegral[below];
  const float* high = kHueIntegral[below + 1];
  return {low[0] + share * (high[0] - low[0]), low[1] + share * (high[1] - low[1]),
          low[2] + share * (high[2] - low[2])};
}

}  // namespace

RGB band_hue(double wavelength, double width, int bands) {
  return (hue_integral(wavelength + width / 2) - hue_integral(wavelength - width / 2)) *
         static_cast<float>(bands);
}

}  // namespace durer
