#pragma once
// A plane that slides in space and a small elastic body below it: the leaves that space still lacks, made by hand.
#include "geometry/surface.hpp"
#include "kinematics/driven_tool.hpp"
#include "run/contact_run.hpp"
#include "run/run_body.hpp"
#include "support/kirchhoff_law.hpp"
#include "support/tetrahedra.hpp"

namespace burnish::test {

/// The plane z = 0 of the tool's frame; the body is below it.
class FlatSurface final : public Surface<3> {
public:
  SurfaceFoot<3> foot(const Vector<3>& p, const Param<3>&) const override {
    return {at(Vector<3>(p[0], p[1], 0)), -p[2], false};
  }
  SurfaceFrame<3> frame(const SurfacePlace<3>&) const override {
    SurfaceFrame<3> frame;
    frame.n = -Vector<3>::UnitZ();
    frame.E.setZero();
    frame.E(1, 0) = frame.E(0, 1) = 1; // n = E_0 x E_1
    frame.B.setZero();
    return frame;
  }
  bool closed() const override { return false; }
  std::vector<SurfacePlace<3>> ends() const override { return {}; }
  double distance_to_end(const SurfacePlace<3>&) const override {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<SurfacePlace<3>> samples(int n) const override { return outline(n); }
  std::vector<SurfacePlace<3>> outline(int n) const override {
    std::vector<SurfacePlace<3>> places;
    for (int k = 0; k < n; ++k) places.push_back(at(Vector<3>(k, 0, 0)));
    return places;
  }
  double length_scale() const override { return 1; }
  double tightest_radius() const override { return std::numeric_limits<double>::infinity(); }

private:
  static SurfacePlace<3> at(const Vector<3>& y) { return {y, y.head<2>()}; }
};

/// Three translations.
class Translations final : public Coordinates<3> {
public:
  const std::vector<std::string>& names() const override { return m_names; }
  Pose<3> pose(const Eigen::VectorXd& q) const override {
    require_coordinates("Translations::pose", m_names, q);
    Pose<3> pose = blank_pose<3>(3);
    pose.origin = q;
    for (int k = 0; k < 3; ++k) pose.origin_q[k] = Vector<3>::Unit(k);
    return pose;
  }

private:
  std::vector<std::string> m_names{"x", "y", "z"};
};

/// Flat triangles of three nodes.
class TriangleMeasure final : public FacetMeasure<3> {
public:
  Eigen::MatrixXd masses(const std::vector<Vector<3>>& x) const override {
    const double area = 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm();
    return area / 12 * (Eigen::Matrix3d::Ones() + Eigen::Matrix3d::Identity());
  }
};

/// A prism of three tetrahedra, clamped below, its top triangle under the plane.
inline Discretization<3> prism() {
  Discretization<3> mesh;
  mesh.X = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  mesh.connectivity = {0, 1, 2, 3, 1, 2, 3, 4, 2, 3, 4, 5};
  mesh.num_nodes = 6;
  mesh.nodes_per_element = 4;
  mesh.num_elements = 3;
  mesh.points_per_element = 1;
  mesh.facets = {{{3, 4, 5}, {-1, -1, -1}, 2, 1}};
  for (int e = 0; e < 3; ++e) {
    auto t = detail::tetrahedron(mesh, e);
    if (t.volume < 0) std::swap(mesh.connectivity[4 * e], mesh.connectivity[4 * e + 1]);
    detail::add_point(mesh, detail::tetrahedron(mesh, e), Barycentric<3>::Constant(0.25));
  }
  return mesh;
}

struct PressedPrism {
  Discretization<3> mesh = prism();
  std::vector<char> fixed = std::vector<char>(18, 0);
  std::shared_ptr<DrivenTool<3>> tool =
      std::make_shared<DrivenTool<3>>("plane", std::make_shared<FlatSurface>());
  std::shared_ptr<ContactSetup<3>> setup;
  std::unique_ptr<ContactRun<3>> contact;
  RunBody<3> body{std::make_unique<Workpiece<3>>(mesh, std::make_shared<KirchhoffLaw>(3, 2))};
  NodeBlockMatrix<3> K = body.workpiece().pattern();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(18), R = u;

  explicit PressedPrism(double mu) {
    std::fill(fixed.begin(), fixed.begin() + 9, 1);
    IterationOptions options;
    options.tolerance = 1e-11;
    options.offset_tolerance = 1e-10;
    options.gap_tolerance = 1e-9;
    options.max_iterations = 60;
    setup = std::make_shared<ContactSetup<3>>(mesh, mesh.facets, fixed, std::make_shared<TriangleMeasure>());
    tool->set_coordinates(std::make_shared<Translations>());
    tool->place("z", 1.1);
    setup->add_tool(tool, make_coulomb(mu));
    contact = std::make_unique<ContactRun<3>>(setup, options);
  }
};

} // namespace burnish::test
