#include "diagnosis/before/unresisted.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double UNRESISTED = 1e-9; // motion along the normal over the motion: below, nothing resists
constexpr double RANK =
    1e-8; // the same of a combination of coordinates, and its least part of one that counts
constexpr double NO_WORK = 1e-7; // of the forces in a motion over the sum of their amounts: rounding

// Motions of a tool's surface by its coordinates where the body is near: n.X_k in rows, largest |X_k|.
struct NormalMotions {
  Eigen::MatrixXd normal;
  Eigen::VectorXd size;
};

template <int Dim>
NormalMotions motions_of(const std::vector<SurfacePoint<Dim>>& points, Eigen::Index coordinates) {
  NormalMotions motions{Eigen::MatrixXd(points.size(), coordinates), Eigen::VectorXd::Zero(coordinates)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    motions.normal.row(static_cast<Eigen::Index>(i)) = points[i].n.transpose() * points[i].x_q;
    motions.size = motions.size.cwiseMax(points[i].x_q.colwise().norm().transpose());
  }
  return motions;
}

// In the plane where the nodes are on the tool, those of other tools apart.
NormalMotions normal_motions(const ContactSetup<2>& setup, const ContactState<2>& state,
                             const Eigen::VectorXd&, const Pose<2>& pose, int tool) {
  const Tool<2>& on = *setup.model().tools[tool];
  std::vector<SurfacePoint<2>> points;
  for (const auto& node : state.nodes)
    if (node.tool == tool || node.tool < 0) points.push_back(on.point(pose, node.place));
  return motions_of(points, on.coordinates().size());
}

// Contact nodes of a tool, or the one that is nearest to it, and those next to them.
std::vector<int> near_tool(const ContactSetup<3>& setup, const ContactState<3>& state,
                           const Eigen::VectorXd& u, const Pose<3>& pose, int tool) {
  const auto& model = setup.model();
  std::vector<int> near;
  double least = std::numeric_limits<double>::infinity();
  int nearest = -1;
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
    if (in_contact(state.nodes[i].state) && state.nodes[i].tool == tool) near.push_back(i);
    if (!near.empty() || !model.may_touch(i, tool)) continue;
    const double gap = std::abs(
        model.tools[tool]->foot(pose, setup.body().position(u, model.candidates[i]), Param<3>::Zero()).gap);
    if (gap < least) {
      least = gap;
      nearest = i;
    }
  }
  if (near.empty() && nearest >= 0) near.push_back(nearest);
  for (std::size_t k = 0, touching = near.size(); k < touching; ++k)
    for (const int next : model.neighbors[near[k]])
      if (model.may_touch(next, tool)) near.push_back(next);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

NormalMotions normal_motions(const ContactSetup<3>& setup, const ContactState<3>& state,
                             const Eigen::VectorXd& u, const Pose<3>& pose, int tool) {
  const Tool<3>& on = *setup.model().tools[tool];
  std::vector<SurfacePoint<3>> points;
  for (const int i : near_tool(setup, state, u, pose, tool)) {
    const Vector<3> x = setup.body().position(u, setup.model().candidates[i]);
    points.push_back(on.point(pose, on.foot(pose, x, state.nodes[i].place.hint).place));
  }
  return motions_of(points, on.coordinates().size());
}

// A motion along the surface, and the coordinate that stands for it.
struct Unresisted {
  int coordinate;
  Eigen::VectorXd motion; // per coordinate
};

// Columns without a normal motion.
std::vector<Unresisted> unresisted(const ContactSetup<2>&, const NormalMotions& motions,
                                   const std::vector<int>& free) {
  std::vector<Unresisted> found;
  for (const int k : free)
    if (motions.normal.col(k).cwiseAbs().maxCoeff() <= UNRESISTED * motions.size[k])
      found.push_back({k, Eigen::VectorXd::Unit(motions.size.size(), k)});
  return found;
}

// Combinations of columns: those that a QR factorization with column pivoting leaves behind, METHOD.md (5.1).
std::vector<Unresisted> unresisted(const ContactSetup<3>&, const NormalMotions& motions,
                                   const std::vector<int>& free) {
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd columns(motions.normal.rows(), n);
  Eigen::VectorXd size(n);
  for (Eigen::Index f = 0; f < n; ++f) {
    size[f] = motions.size[free[f]] > 0 ? motions.size[free[f]] : 1;
    columns.col(f) = motions.normal.col(free[f]) / size[f];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  const Eigen::MatrixXd R = qr.matrixR().topRows(std::min(columns.rows(), n));
  Eigen::Index rank = 0;
  while (rank < R.rows() && std::abs(R(rank, rank)) > RANK * std::max(1e-3, std::abs(R(0, 0)))) ++rank;
  const auto& order = qr.colsPermutation().indices();
  std::vector<Unresisted> found;
  for (Eigen::Index j = rank; j < n; ++j) {
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(motions.size.size());
    motion[free[order[j]]] = 1 / size[order[j]];
    const Eigen::VectorXd others =
        R.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(R.col(j).head(rank));
    for (Eigen::Index i = 0; i < rank; ++i)
      if (std::abs(others[i]) > RANK) motion[free[order[i]]] = -others[i] / size[order[i]];
    found.push_back({free[order[j]], motion});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.coordinate < b.coordinate; });
  return found;
}

// Coordinates of a tool that forces alone decide.
template <int Dim>
std::vector<int> free_coordinates(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                  int tool) {
  std::vector<int> free;
  for (int q = model.first[tool]; q < model.first[tool + 1]; ++q)
    if (!prescribed.is_motion[q] && !prescribed.is_held(q) && !model.coupling_of(q) &&
        model.followers(q).empty())
      free.push_back(q - model.first[tool]);
  return free;
}

template <int Dim>
void check_no_work(const ContactModel<Dim>& model, int tool, const Unresisted& dead,
                   const Eigen::VectorXd& drive) {
  const Eigen::VectorXd work = dead.motion.cwiseProduct(drive.segment(model.first[tool], dead.motion.size()));
  if (std::abs(work.sum()) <= NO_WORK * work.cwiseAbs().sum()) return;
  std::string with;
  for (int k = 0; k < dead.motion.size(); ++k)
    if (k != dead.coordinate && dead.motion[k] != 0)
      with += (with.empty() ? ", moved together with \"" : ", \"") +
              model.tools[tool]->coordinates().names()[static_cast<std::size_t>(k)] + "\"";
  fail("contact.begin",
       model.coordinate(model.first[tool] + dead.coordinate) + with + (with.empty() ? "" : ",") +
           " has a force but without friction nothing resists it; give it a motion or friction");
}

} // namespace

template <int Dim>
std::vector<std::string> leave_out_unresisted(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                                              const Eigen::VectorXd& u, PrescribedValues& prescribed) {
  std::vector<std::string> left_out;
  const auto& model = setup.model();
  const DrivingForce drive = driving_force(model, prescribed, state.q);
  const auto poses = model.poses(state.q);
  for (int t = 0; t < static_cast<int>(model.tools.size()); ++t) {
    if (!model.laws[t].frictionless()) continue;
    const std::vector<int> free = free_coordinates(model, prescribed, t);
    if (free.empty()) continue;
    const NormalMotions motions = normal_motions(setup, state, u, poses[t], t);
    if (motions.normal.rows() == 0) continue;
    for (const Unresisted& dead : unresisted(setup, motions, free)) {
      check_no_work(model, t, dead, drive.value);
      const int q = model.first[t] + dead.coordinate;
      prescribed.is_motion[q] = 1;
      prescribed.value[q] = state.q[q];
      left_out.push_back(model.coordinate(q));
    }
  }
  return left_out;
}

template std::vector<std::string> leave_out_unresisted<2>(const ContactSetup<2>&, const ContactState<2>&,
                                                          const Eigen::VectorXd&, PrescribedValues&);
template std::vector<std::string> leave_out_unresisted<3>(const ContactSetup<3>&, const ContactState<3>&,
                                                          const Eigen::VectorXd&, PrescribedValues&);

} // namespace burnish
