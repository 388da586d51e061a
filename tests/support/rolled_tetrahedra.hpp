#pragma once
// A roller or ball that is pressed into a block of tetrahedra, rolled or dragged over it, and taken off: z under force, x
// under motion, the turn about y under moment. Units: radius and yield stress 1.
#include "geometry/simple_surfaces.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "material/j2/law.hpp"
#include "run/stepper.hpp"
#include "run/workpiece_tangent.hpp"
#include "support/tetrahedra.hpp"
#include <functional>
#include <gtest/gtest.h>

namespace burnish::test {

struct RolledTetrahedra {
  Discretization<3> mesh;
  std::vector<char> fixed;
  std::shared_ptr<DrivenTool<3>> tool;
  std::shared_ptr<ContactSetup<3>> setup;
  std::unique_ptr<ContactRun<3>> contact;
  RunBody<3> body;
  Eigen::VectorXd u, R;
  double load = 0, way = 0;     ///< [force], x at the end [length]
  long steps = 0, rejected = 0; ///< of all parts of the program
  std::function<void()> on_step = [] {};

  /// @param P load [force]
  RolledTetrahedra(Mesh<3> block, std::shared_ptr<const Surface<3>> surface, double mu, double P,
                   const IterationOptions& options = {})
      : mesh(tetrahedra(std::move(block))), fixed(supports(mesh)),
        tool(std::make_shared<DrivenTool<3>>("tool", std::move(surface))),
        setup(std::make_shared<ContactSetup<3>>(mesh, mesh.facets, fixed, std::make_shared<FaceMeasure>())),
        body(std::make_unique<Workpiece<3>>(mesh, j2_law<3>(J2Parameters::from_shear(140, 0.32, 1, 5)))),
        u(Eigen::VectorXd::Zero(mesh.num_dofs())), R(u), load(P) {
    tool->set_coordinates(std::make_shared<FormulaCoordinates<3>>(
        "tool", std::vector<std::string>{"x", "z", "theta"}, SpaceFormulas{"x", "0", "z", "y:theta"}));
    tool->place("z", 1.01);
    setup->add_tool(tool, make_coulomb(mu));
    contact = std::make_unique<ContactRun<3>>(setup, options);
  }
  /// Bottom clamped, ends held along x, sides along y.
  static std::vector<char> supports(const Discretization<3>& mesh) {
    Vector<3> low = mesh.node(0), high = low;
    for (int a = 0; a < mesh.num_nodes; ++a) {
      low = low.cwiseMin(mesh.node(a));
      high = high.cwiseMax(mesh.node(a));
    }
    std::vector<char> fixed(static_cast<std::size_t>(mesh.num_dofs()), 0);
    for (int a = 0; a < mesh.num_nodes; ++a) {
      const Vector<3> x = mesh.node(a);
      const bool bottom = x[2] < low[2] + 1e-9;
      fixed[3 * a] = bottom || x[0] < low[0] + 1e-9 || x[0] > high[0] - 1e-9;
      fixed[3 * a + 1] = bottom || x[1] < low[1] + 1e-9 || x[1] > high[1] - 1e-9;
      fixed[3 * a + 2] = bottom;
    }
    return fixed;
  }
  Workpiece<3>& workpiece() { return body.workpiece(); }
  double depth() const { return 1 - tool->q()[1]; }
  double theta() const { return tool->q()[2]; }
  double plastic_strain() {
    const int place = workpiece().law().internal_place("plastic_strain_eq", 0, "test");
    const int n = workpiece().law().internal_variables().size();
    double most = 0;
    for (int p = 0; p < mesh.num_points(); ++p)
      most = std::max(most, body.workpiece().state().internal[static_cast<std::size_t>(n) * p + place]);
    return most;
  }
  /// One part of the program from t = 0 to 1. @param steps in it
  Task run(int number, const std::function<void(Prescription&, double t)>& program) {
    StepControlOptions control;
    control.dt_max = 1. / number;
    control.dt_first = control.dt_max;
    control.steps_per_width = 0;
    Diagnosis<3> diagnosis;
    Stepper<3> stepper(*contact, body, diagnosis, StepControl(0, control), {});
    for (;;) {
      const Task task = stepper.next(u, R);
      if (task == Task::PROGRAM) program(tool->prescription(), stepper.target());
      if (task == Task::FORCES) {
        if (workpiece().update(u, stepper.dt(), stepper.iteration()).status != UpdateStatus::OK)
          stepper.refuse("the material could not follow");
        R = workpiece().internal_force();
      }
      if (task == Task::TANGENT && !factorize_tangent(*contact, workpiece(), u)) stepper.refuse("");
      if (task == Task::RECORD) {
        if (stepper.counts().rejected > m_rejected) m_reasons += stepper.last_rejection() + "; ";
        m_rejected = stepper.counts().rejected;
        on_step();
      }
      if (task != Task::FINISHED && task != Task::STOPPED) continue;
      steps += stepper.counts().steps;
      rejected += stepper.counts().rejected;
      if (task == Task::STOPPED) ADD_FAILURE() << stepper.reason();
      m_rejected = 0;
      return task;
    }
  }
  Task press(int number) {
    contact->approach(0, "z", u);
    return run(number, [this](Prescription& p, double t) {
      p.move("x", 0);
      p.force("z", -load * std::pow(t, 1.3));
      p.force("theta", 0);
    });
  }
  /// @param moment at the end, full after `ramp` of the way
  Task roll(int number, double distance, double moment, double ramp) {
    way += distance;
    return run(number, [=](Prescription& p, double t) {
      p.move("x", way - distance + t * distance);
      p.force("z", -load);
      p.force("theta", moment * std::min(1., t * distance / ramp));
    });
  }
  Task drag(int number, double distance) {
    const double turn = theta();
    way += distance;
    return run(number, [=](Prescription& p, double t) {
      p.move("x", way - distance + t * distance);
      p.force("z", -load);
      p.move("theta", turn);
    });
  }
  /// Down to a thousandth of the load.
  Task unload(int number, double moment = 0) {
    return run(number, [=](Prescription& p, double t) {
      p.move("x", way);
      p.force("z", -load * (1 - 0.999 * t));
      p.force("theta", moment * (1 - t));
    });
  }
  const std::string& reasons() const { return m_reasons; }

private:
  long m_rejected = 0;
  std::string m_reasons;
};

/// The slab: two cells thick, in plane strain, under a roller about y. @param h size of the cells; @param P per thickness
struct Slab {
  double h, fine_depth, distance, mu = 0.2;
  int nodes_per_element = 10;
  double P = 0.4;
  bool mirrored = true; ///< see block_of_tetrahedra
  std::unique_ptr<RolledTetrahedra> scene(const IterationOptions& options = {}) const {
    const double a = 0.08, from = -1.6 * a, to = from + h * std::ceil((distance + 3.2 * a) / h - 1e-9);
    std::vector<double> z = divisions(0, fine_depth, h, 1.6, NAN, 0.5);
    std::reverse(z.begin(), z.end());
    for (double& c : z) c = -c;
    Mesh<3> mesh = block_of_tetrahedra(divisions(from, to, h, 1.6, from - 0.45, to + 0.45), {0, h, 2 * h}, z,
                                       nodes_per_element, mirrored);
    AxisFrame axis;
    axis.point = Vector<3>(0, -1, 0);
    axis.base << 0, 1, 0, 0, 0, 1, 1, 0, 0; // third direction y
    return std::make_unique<RolledTetrahedra>(std::move(mesh), cylinder(1, 3, axis), mu, 2 * h * P, options);
  }
};
inline std::unique_ptr<RolledTetrahedra> slab(double h, double fine_depth, double distance, double mu = 0.2,
                                              int nodes_per_element = 10, double P = 0.4,
                                              const IterationOptions& options = {}) {
  return Slab{h, fine_depth, distance, mu, nodes_per_element, P}.scene(options);
}

/// A ball on a block, the half y > 0 of both or the whole. @param P load of the whole ball; @param fine size of the part of
/// the surface that has cells of size h, beside the way
struct BallOnBlock {
  double h = 0.04, distance = 0.1, mu = 0.2, P = 0.05, fine = 0.1;
  int nodes_per_element = 10;
  bool whole = false;
  std::unique_ptr<RolledTetrahedra> scene(const IterationOptions& options = {}) const {
    const double from = -1.3 * fine, to = from + h * std::ceil((distance + 2.6 * fine) / h - 1e-9);
    std::vector<double> y = divisions(0, h * std::ceil(fine / h - 1e-9), h, 2, NAN, 0.4),
                        z = divisions(0, 0.05, h, 2, NAN, 0.4);
    std::reverse(z.begin(), z.end());
    for (double& c : z) c = -c;
    if (whole) {
      std::vector<double> both(y.rbegin(), y.rend() - 1);
      for (double& c : both) c = -c;
      both.insert(both.end(), y.begin(), y.end());
      y = both;
    }
    Mesh<3> mesh =
        block_of_tetrahedra(divisions(from, to, h, 2, from - 0.3, to + 0.3), y, z, nodes_per_element);
    AxisFrame axis;
    axis.base << 0, 1, 0, 0, 0, 1, 1, 0, 0; // third direction y
    return std::make_unique<RolledTetrahedra>(std::move(mesh), sphere(1, axis), mu, whole ? P : 0.5 * P,
                                              options);
  }
};

} // namespace burnish::test
