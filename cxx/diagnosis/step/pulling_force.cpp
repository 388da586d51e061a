// Forces on a tool that no pressure of the workpiece balances: they draw it away, or tip it over.
#include "base/nonnegative.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr double ALONG = 0.5; // part of a node's motion by the coordinate that is normal to the tool
constexpr double REACH = 1;   // gap of a candidate that may come to touch, over the spacing
constexpr double LEFT = 1e-3; // part of the forces that pressure leaves: beyond, there is no balance

template <int Dim> class PullingForce final : public ObserverOf<PullingForce<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    if (step.prescribed.value.size() == 0) return; // no step was begun
    const auto poses = step.setup.model().poses(step.state.q);
    for (int tool = 0; tool < static_cast<int>(poses.size()); ++tool) {
      const std::vector<int> forced = forced_coordinates(step, tool);
      if (forced.empty()) continue;
      Failure found = drawn_away(step, poses, forced, tool);
      if (!found && tips_over(step, poses, forced, tool)) {
        found = Cause::TIPS_OVER;
        found.tool = tool;
      }
      if (!found) continue;
      causes.push_back(found);
      return;
    }
  }

private:
  static std::vector<int> forced_coordinates(const FailedStep<Dim>& step, int tool) {
    const ContactModel<Dim>& model = step.setup.model();
    std::vector<int> forced;
    for (int k = model.first[tool]; k < model.first[tool + 1]; ++k)
      if (!step.prescribed.is_motion[k] && !model.coupling_of(k) && !step.prescribed.is_held(k))
        forced.push_back(k);
    return forced;
  }

  // One coordinate whose force moves the tool away from all nodes that it touches.
  static Failure drawn_away(const FailedStep<Dim>& step, const std::vector<Pose<Dim>>& poses,
                            const std::vector<int>& forced, int tool) {
    const ContactModel<Dim>& model = step.setup.model();
    for (const int k : forced) {
      const double force = step.prescribed.value[k];
      bool any = false, all = force != 0;
      for (const auto& node : step.state.nodes) {
        if (!in_contact(node.state) || node.tool != tool) continue;
        const auto p = model.tools[tool]->point(poses[tool], node.place);
        const Vector<Dim> motion = p.x_q.col(k - model.first[tool]);
        any = true;
        all = all && motion.dot(p.n) * (force > 0 ? 1 : -1) < -ALONG * motion.norm();
      }
      if (!any || !all) continue;
      Failure failure(Cause::PULLING);
      failure.coordinate = k;
      failure.value = force;
      return failure;
    }
    return Cause::NONE;
  }

  // sum_i N_i n_i.X_k = Q_k, METHOD.md (2.8), has no solution N >= 0 over the nodes that it touches or soon may, with any friction.
  static bool tips_over(const FailedStep<Dim>& step, const std::vector<Pose<Dim>>& poses,
                        const std::vector<int>& forced, int tool) {
    const ContactModel<Dim>& model = step.setup.model();
    const auto rows = static_cast<Eigen::Index>(forced.size());
    for (const int k : forced) // nor a force by a formula nor those of what follows it are known here
      if (!model.followers(k).empty() || (!step.prescribed.formula.empty() && step.prescribed.formula[k]))
        return false;
    std::vector<Eigen::VectorXd> columns;
    for (int i = 0; i < static_cast<int>(step.state.nodes.size()); ++i) {
      if (!model.may_touch(i, tool)) continue;
      const ContactNode<Dim>& node = step.state.nodes[i];
      const auto foot = model.tools[tool]->foot(
          poses[tool], step.setup.body().position(step.u, model.candidates[i]), node.place.hint);
      if (!(foot.gap < REACH * step.setup.body().spacing)) continue;
      const auto p = model.tools[tool]->point(poses[tool], foot.place);
      Eigen::MatrixXd moved(Dim, rows);
      for (Eigen::Index k = 0; k < rows; ++k) moved.col(k) = p.x_q.col(forced[k] - model.first[tool]);
      columns.push_back(moved.transpose() * p.n);
      if (model.laws[tool].frictionless()) continue; // a weightless vertex may come to have it
      const Eigen::MatrixXd along = moved - p.n * (p.n.transpose() * moved);
      for (int c = 0; c < Dim; ++c)
        for (const double sign : {1., -1.}) columns.push_back(sign * along.row(c).transpose());
    }
    if (columns.empty()) return false;
    Eigen::MatrixXd A(rows, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j) A.col(static_cast<Eigen::Index>(j)) = columns[j];
    Eigen::VectorXd Q = step.prescribed.value(forced);
    for (Eigen::Index k = 0; k < rows; ++k) { // forces of one dimension
      const double arm = A.row(k).cwiseAbs().maxCoeff();
      if (arm == 0) return false;
      A.row(k) /= arm;
      Q[k] /= arm;
    }
    return (A * nonnegative_least_squares(A, Q) - Q).norm() > LEFT * Q.norm();
  }
};

} // namespace

BURNISH_OBSERVER(pulling_force, PullingForce)

} // namespace burnish
