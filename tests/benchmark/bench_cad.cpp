// Cost of the closest point on a CAD curve of a STEP file, from places on a circle about it, without a hint. Judges nothing.
#include "unit/cad/cad_samples.hpp"
#include <benchmark/benchmark.h>

using namespace burnish;
using namespace burnish::test;

namespace {

void closest_point(benchmark::State& state) {
  const CadCurve lobe = stored("lobe.step");
  int i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(lobe.closest_point({9 * std::cos(i), 9 * std::sin(i)}, Param<2>(0.0)).gap);
    ++i;
  }
}

} // namespace

BENCHMARK(closest_point);
