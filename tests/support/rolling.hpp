#pragma once
// Example 1 of the article on a coarse structured mesh: a roller on a ring sector (METHOD.md 6.1).
#include "support/run.hpp"

namespace burnish::test {

struct Rolling {
  double force = 7.5e5, moment = 2e3; ///< F0 [N/m], M0 [N]
  Scene scene;

  explicit Rolling(int along, int across, const IterationOptions& options = {})
      : scene(ring_mesh(along, across, 2, 25e-3, 30e-3, M_PI / 8, 3),
              J2Parameters::from_shear(2.7e10, 0.32, 1.93e8, 9.62e8), options) {
    scene.add_tool(std::make_shared<Circle>(15e-3), std::make_shared<Polar>(), 0.2);
    scene.place({46e-3, M_PI / 2 + M_PI / 32, 0});
    scene.contact().approach(0, "r", scene.u);
  }
  ProgramAt program() {
    return [this](double t) {
      scene.tool->prescription().move("phi", M_PI / 2 + M_PI / 32 - t * M_PI / 16);
      scene.tool->prescription().force("r", -force * t);
      scene.tool->prescription().force("theta", moment * t);
    };
  }
  /// @param t_end end of the run, 1: the whole program
  static StepControl control(double t_end, double dt_max, double steps_per_width = 14) {
    StepControlOptions options;
    options.t_end = t_end;
    options.dt_max = dt_max;
    options.steps_per_width = steps_per_width;
    return StepControl(0, options);
  }
};

} // namespace burnish::test
