// What --stats writes: one JSON object with the run's figures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tracer/sampling/render.h"

namespace durer {

struct FrameStatistics {
  int frame = 0;
  std::string method;  // of compare-methods; empty: one picture by the method of the options
  std::string output;  // empty: none written
  int warnings = 0;
  size_t objects = 0, lights = 0;
  double parse_seconds = 0, build_seconds = 0, render_seconds = 0, write_seconds = 0;  // wall
  RenderStatistics render;
};

struct RunStatistics {
  std::string scene;
  int width = 0, height = 0, threads = 0;
  std::vector<FrameStatistics> frames;
};

// Times and memory of the process are read when it is called.
std::string statistics_json(const RunStatistics& run);
// For people: some lines about one frame.
std::string statistics_text(const FrameStatistics& frame);
// 1234567 as 1 234 567.
std::string grouped(uint64_t n);
double process_cpu_seconds();
long process_peak_kilobytes();

}  // namespace durer
