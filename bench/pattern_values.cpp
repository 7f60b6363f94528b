// Whether ScalarField::values wins over eight calls of value, for each pattern.
#include <benchmark/benchmark.h>

#include "tracer/patterns/pattern.h"

namespace durer {
namespace {

// Near each other, as isosurfaces ask for them.
void fill(Vec3 points[8], int round) {
  for (int i = 0; i < 8; ++i) {
    points[i] = {0.37 + 0.0131 * i + 0.0007 * round, 1.21 - 0.0023 * i, -0.53 + 0.0017 * round};
  }
}

Pattern pattern_of(PatternKind kind) {
  PatternNode node;
  node.kind = kind;
  return {node, {}};
}

template <typename Evaluate>
void measure(benchmark::State& state, const Evaluate& evaluate) {
  const auto kind = static_cast<PatternKind>(state.range(0));
  const Pattern pattern = pattern_of(kind);
  Vec3 points[8];
  double out[8];
  int round = 0;
  for (auto _ : state) {
    fill(points, ++round & 1023);
    evaluate(pattern, points, out);
    benchmark::DoNotOptimize(out);
  }
  state.SetLabel(std::string(pattern_name(kind)));
}

void eight_calls(benchmark::State& state) {
  measure(state, [](const Pattern& pattern, const Vec3* points, double* out) {
    for (int i = 0; i < 8; ++i) out[i] = pattern.value(points[i]);
  });
}

void one_batch(benchmark::State& state) {
  measure(state, [](const Pattern& pattern, const Vec3* points, double* out) {
    pattern.values(points, out);
  });
}

void kinds(benchmark::internal::Benchmark* benchmark) {
  for (const PatternKind kind :
       {PatternKind::bozo, PatternKind::granite, PatternKind::wrinkles, PatternKind::marble,
        PatternKind::wood, PatternKind::agate, PatternKind::crackle, PatternKind::gradient,
        PatternKind::checker, PatternKind::spherical, PatternKind::waves}) {
    benchmark->Arg(static_cast<int64_t>(kind));
  }
}

BENCHMARK(eight_calls)->Apply(kinds);
BENCHMARK(one_batch)->Apply(kinds);

}  // namespace
}  // namespace durer
