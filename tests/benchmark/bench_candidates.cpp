// Cost of a step against the number of candidates, 100 to 10 000: a roller on a long strip, the contact a dozen nodes
// wide whatever the length. Reports the fit to c*N and its root mean square; judges nothing.
#include "support/run.hpp"
#include <benchmark/benchmark.h>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double SPACING = 0.05, HEIGHT = 0.4;

/// A strip of n + 1 candidates, P2, four elements high, clamped below, under a roller of radius 3 in its middle.
struct Strip : Scene {
  double x, depth = 0;
  explicit Strip(int n)
      : Scene(block_mesh(n / 2, 4, 2, n * SPACING, HEIGHT), elastic_material()), x(0.5 * n * SPACING) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
    place({x, HEIGHT + 3, 0});
    contact().approach(0, "y", u);
    for (int k = 1; k <= 20; ++k) {
      depth = 5e-4 * k;
      go(0);
    }
  }
  bool go(double way) {
    x += way;
    auto& prescription = tool->prescription();
    prescription.move("x", x);
    prescription.move("y", HEIGHT + 3 - depth);
    prescription.force("angle", 0);
    if (converge(*this, 0, 1, Stepping::IMPLICIT) != StepStatus::CONVERGED) return false;
    accept(*this, {});
    return true;
  }
};

void step(benchmark::State& state) {
  Strip strip(static_cast<int>(state.range(0)));
  double way = 0.2 * SPACING;
  for (auto _ : state) {
    if (!strip.go(way)) state.SkipWithError(strip.why().c_str());
    way = -way; // to and fro
  }
  state.SetComplexityN(state.range(0));
}

void setup(benchmark::State& state) {
  for (auto _ : state) {
    Strip strip(static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(strip.u.data());
  }
  state.SetComplexityN(state.range(0));
}

} // namespace

BENCHMARK(step)
    ->Unit(benchmark::kMillisecond)
    ->RangeMultiplier(10)
    ->Range(100, 10000)
    ->Complexity(benchmark::oN);
BENCHMARK(setup)
    ->Unit(benchmark::kMillisecond)
    ->RangeMultiplier(10)
    ->Range(100, 10000)
    ->Complexity(benchmark::oN);
