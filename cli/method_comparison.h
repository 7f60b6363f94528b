// One scene by every method, side by side in one labelled picture (durer compare-methods).
#pragma once

#include <string>
#include <vector>

#include "tracer/image/framebuffer.h"
#include "tracer/sampling/render.h"

namespace durer {

struct Method {
  std::string name;
  std::string explanation;
  IntegratorKind integrator;
  Supersampling supersampling;
};
// `grid`: samples per axis of the methods that take a fixed number.
std::vector<Method> compared_methods(int grid);

// What rendering the whole picture by one method gave and cost.
struct MethodResult {
  Method method;
  Framebuffer picture;
  RenderStatistics statistics;
  double cpu_seconds;

  uint64_t rays() const;
};

// The pictures in rows of three with their names and costs below them, black on white.
// Throws std::runtime_error if no font is found.
Framebuffer method_sheet(const std::vector<MethodResult>& results);
// For people: one line for each method.
std::vector<std::string> method_table(const std::vector<MethodResult>& results);

}  // namespace durer
