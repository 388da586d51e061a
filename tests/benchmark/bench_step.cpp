// A coarse rolling (METHOD.md 6.1, P2, 75 x 10 divisions) half way: stress, nodal forces, tangent, factor, one whole step.
#include "support/rolling.hpp"
#include <benchmark/benchmark.h>
#include <cstdlib>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double MIDDLE = 0.5, DT = 0.01;

/// The iterate of the step after the middle of the program, once solved; `u` of its end.
struct UnderWay {
  Rolling rolling{75, 10};
  Scene& scene = rolling.scene;
  ProgramAt program = rolling.program();
  UnderWay() {
    Stepper<2> stepper(scene.contact(), scene.body, scene.diagnosis, Rolling::control(MIDDLE, DT), {});
    scene.diagnosis.set_checks(false);
    if (run(scene, stepper, program) != Task::FINISHED || !solve()) std::abort();
  }
  bool solve() {
    program(MIDDLE + DT);
    return converge(scene, MIDDLE, DT, Stepping::IMPLICIT) == StepStatus::CONVERGED;
  }
  static UnderWay& once() {
    static UnderWay way;
    return way;
  }
};

void stress_update(benchmark::State& state) {
  UnderWay& way = UnderWay::once();
  for (auto _ : state) benchmark::DoNotOptimize(way.scene.workpiece().update(way.scene.u, DT, 1).status);
}

void internal_force(benchmark::State& state) {
  UnderWay& way = UnderWay::once();
  for (auto _ : state) benchmark::DoNotOptimize(way.scene.workpiece().internal_force().sum());
}

void tangent(benchmark::State& state) {
  UnderWay& way = UnderWay::once();
  for (auto _ : state) {
    way.scene.workpiece().tangent(way.scene.tangent, TangentKind::CONSISTENT);
    benchmark::DoNotOptimize(way.scene.tangent.value.data());
  }
}

void factorization(benchmark::State& state) {
  UnderWay& way = UnderWay::once();
  way.scene.workpiece().tangent(way.scene.tangent, TangentKind::CONSISTENT);
  for (auto _ : state)
    if (way.scene.contact().factorize(way.scene.tangent, way.scene.u) != FactorStatus::OK)
      state.SkipWithError("not factorized");
}

// From the accepted state to equilibrium and back.
void whole_step(benchmark::State& state) {
  UnderWay& way = UnderWay::once();
  for (auto _ : state) {
    revert(way.scene);
    if (!way.solve()) state.SkipWithError(way.scene.why().c_str());
  }
}

} // namespace

BENCHMARK(stress_update)->Unit(benchmark::kMillisecond);
BENCHMARK(internal_force)->Unit(benchmark::kMillisecond);
BENCHMARK(tangent)->Unit(benchmark::kMillisecond);
BENCHMARK(factorization)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_step)->Unit(benchmark::kMillisecond);
