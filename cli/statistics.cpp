#include "cli/statistics.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <vector>

namespace durer {
namespace {

// In the order of ShapeNode; the last two are never tested as such.
constexpr const char* kShapeNames[] = {
    "sphere",   "box",      "plane",        "cylinder",      "cone",          "disc",
    "torus",    "superellipsoid", "ovus",   "triangle",      "smooth_triangle", "polygon",
    "quadric",  "poly",     "lathe",        "sor",           "prism",         "sphere_sweep",
    "blob",     "text",     "height_field", "bicubic_patch", "mesh",          "isosurface",
    "parametric", "julia_fractal", "csg",   "light_source"};
static_assert(std::size(kShapeNames) == std::tuple_size_v<ShapeTestCounts>);

// The bytes of the UTF-8 character that begins at `at`; 0 if none does.
size_t utf8_length(const std::string& text, size_t at) {
  const auto byte = [&](size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(at), second = byte(at + 1);
  const size_t length = first < 0x80   ? 1
                        : first < 0xc2 ? 0
                        : first < 0xe0 ? 2
                        : first < 0xf0 ? 3
                        : first < 0xf5 ? 4
                                       : 0;
  for (size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  }
  // Longer than needed, halves of surrogate pairs, beyond the last character.
  const bool is_none = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return is_none ? 0 : length;
}

// File names may hold any bytes. Those that are no UTF-8 become \udc80 to \udcff, which Python's
// os.fsencode turns back.
std::string json_string(const std::string& text) {
  std::string out = "\"";
  const auto escape = [&](unsigned code) {
    char digits[8];
    std::snprintf(digits, sizeof digits, "\\u%04x", code);
    out += digits;
  };
  for (size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const size_t length = utf8_length(text, i);
    if (length == 0) {
      escape(0xdc00u + c);
    } else if (c < 0x20) {
      escape(c);
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out += text.substr(i, length);
    }
    i += std::max<size_t>(length, 1);
  }
  return out + "\"";
}

std::string json_number(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string frame_json(const FrameStatistics& frame) {
  const RayCounts& rays = frame.render.rays;
  std::string out = "    {\"frame\": " + std::to_string(frame.frame);
  if (!frame.method.empty()) out += ", \"method\": " + json_string(frame.method);
  out += ", \"output\": " + json_string(frame.output);
  out += ", \"warnings\": " + std::to_string(frame.warnings);
  out += ", \"objects\": " + std::to_string(frame.objects);
  out += ", \"lights\": " + std::to_string(frame.lights);
  out += ",\n     \"parse_seconds\": " + json_number(frame.parse_seconds);
  out += ", \"build_seconds\": " + json_number(frame.build_seconds);
  out += ", \"render_seconds\": " + json_number(frame.render_seconds);
  out += ", \"write_seconds\": " + json_number(frame.write_seconds);
  out += ",\n     \"samples\": " + std::to_string(frame.render.samples);
  out += ", \"rays\": {\"primary\": " + std::to_string(rays.primary);
  out += ", \"reflected\": " + std::to_string(rays.reflected);
  out += ", \"refracted\": " + std::to_string(rays.refracted);
  out += ", \"shadow\": " + std::to_string(rays.shadow);
  out += ", \"total_internal\": " + std::to_string(rays.total_internal) + "}";
  out += ",\n     \"shape_tests\": {";
  bool first = true;
  for (size_t i = 0; i < frame.render.shapes.size(); ++i) {
    const ShapeTests& shape = frame.render.shapes[i];
    if (shape.tests() == 0) continue;
    out += std::string(first ? "" : ", ") + "\"" + kShapeNames[i] +
           "\": {\"tests\": " + std::to_string(shape.tests()) +
           ", \"hits\": " + std::to_string(shape.hits()) + "}";
    first = false;
  }
  return out + "}}";
}

}  // namespace

std::string grouped(uint64_t n) {
  std::string digits = std::to_string(n);
  for (size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ' ');
  return digits;
}

double process_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1e-6;
}

long process_peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

std::string statistics_json(const RunStatistics& run) {
  std::string out = "{\n  \"program\": \"durer " DURER_VERSION "\",\n";
  out += "  \"scene\": " + json_string(run.scene) + ",\n";
  out += "  \"width\": " + std::to_string(run.width) + ",\n";
  out += "  \"height\": " + std::to_string(run.height) + ",\n";
  out += "  \"threads\": " + std::to_string(run.threads) + ",\n";
  out += "  \"cpu_seconds\": " + json_number(process_cpu_seconds()) + ",\n";
  out += "  \"peak_memory_kilobytes\": " + std::to_string(process_peak_kilobytes()) + ",\n";
  out += "  \"frames\": [\n";
  for (size_t i = 0; i < run.frames.size(); ++i) {
    out += frame_json(run.frames[i]) + (i + 1 < run.frames.size() ? ",\n" : "\n");
  }
  return out + "  ]\n}\n";
}

std::string statistics_text(const FrameStatistics& frame) {
  const RayCounts& rays = frame.render.rays;
  std::string text = grouped(frame.render.samples) + " samples; rays: " + grouped(rays.primary) +
                     " primary, " + grouped(rays.reflected) + " reflected, " +
                     grouped(rays.refracted) + " refracted, " + grouped(rays.shadow) + " shadow";
  // Tests of shapes, the most frequent first.
  std::vector<size_t> kinds;
  for (size_t i = 0; i < frame.render.shapes.size(); ++i) {
    if (frame.render.shapes[i].tests() > 0) kinds.push_back(i);
  }
  std::stable_sort(kinds.begin(), kinds.end(), [&](size_t a, size_t b) {
    return frame.render.shapes[a].tests() > frame.render.shapes[b].tests();
  });
  const char* separator = "\ntests: ";
  for (const size_t kind : kinds) {
    const ShapeTests& shape = frame.render.shapes[kind];
    text += separator + std::string(kShapeNames[kind]) + " " + grouped(shape.tests()) + " (" +
            std::to_string(shape.hits() * 100 / shape.tests()) + " % hit)";
    separator = ", ";
  }
  return text + "\npeak memory " + std::to_string(process_peak_kilobytes() / 1024) + " MB";
}

}  // namespace durer
