#include "diagnosis/step/drive_curves.hpp"
#include "base/sentence.hpp"
#include "contact/resultant.hpp"
#include "diagnosis/observers.hpp"
#include "diagnosis/step/leaps.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double PART = 0.01;    // of the way of a coordinate, over which the growth of its force is measured
constexpr double STAGNANT = 0.1; // growth of the force there, relative, over that part
constexpr double MECHANISM = 0.2;   // the same of the contact force: above it the workpiece still resists
constexpr double RESTING = 1e-3;    // way of the coordinates under motion, over that of the one under force
constexpr double LEAST_FALL = 1e-3; // of a force, relative: above what the tolerance of the residual leaves

// Whether the script gives the force as a number.
bool is_dead_load(const PrescribedValues& prescribed, Eigen::Index k) {
  const bool formula = !prescribed.formula.empty() && prescribed.formula[static_cast<std::size_t>(k)];
  return !prescribed.is_motion[static_cast<std::size_t>(k)] && !formula;
}

// The last point that lies PART of the way or more behind the last one, on the way: near a limit the coordinate may go back by
// what the tolerance leaves. Null: the curve is too short.
const DrivePoint* part_before(const std::vector<DrivePoint>& curve) {
  if (curve.size() < 3) return nullptr;
  const double way = curve.back().q - curve.front().q;
  for (std::size_t i = curve.size() - 1; i-- > 1;)
    if ((curve.back().q - curve[i].q) * way >= PART * way * way) return &curve[i];
  return nullptr;
}

// Points that part_before does not need any more. They are kept a while: a coordinate may go back.
void thin(std::vector<DrivePoint>& curve) {
  constexpr double kept = 10;
  const double way = std::abs(curve.back().q - curve.front().q);
  std::size_t drop = 1;
  while (drop + 2 < curve.size() && std::abs(curve.back().q - curve[drop + 1].q) > kept * PART * way) ++drop;
  curve.erase(curve.begin() + 1, curve.begin() + static_cast<std::ptrdiff_t>(drop));
}

} // namespace

template <int Dim> void DriveCurves<Dim>::add(const ContactSetup<Dim>& setup, const DrivenStep& step) {
  const Eigen::VectorXd &before = step.before, &after = step.after, &force = step.force;
  const auto& model = setup.model();
  const auto poses = model.poses(before);
  double driven = 0;
  m_lever.resize(after.size());
  for (int k = 0; k < static_cast<int>(after.size()); ++k) {
    m_lever[k] = lever(model, poses, k);
    if (step.prescribed.is_motion[static_cast<std::size_t>(k)])
      driven = std::max(driven, m_lever[k] * std::abs(after[k] - before[k]));
  }
  m_driven += driven;
  follow_branch(setup, step);
  m_curves.resize(static_cast<std::size_t>(after.size()));
  for (Eigen::Index k = 0; k < after.size(); ++k) {
    auto& curve = m_curves[static_cast<std::size_t>(k)];
    const double size = step.contact[model.tool_of(static_cast<int>(k))];
    if (curve.empty() || force[k] == 0 || force[k] * curve.back().force < 0)
      curve.assign(1, {force[k] == 0 ? after[k] : before[k], 0, 0, m_driven});
    curve.push_back({after[k], force[k], size, m_driven});
    thin(curve);
  }
  m_force = force;
  m_t = step.t;
}

// Second-order work of the drives: with all else at rest it is that of the workpiece, > 0 where it is stable under dead loads.
template <int Dim>
void DriveCurves<Dim>::follow_branch(const ContactSetup<Dim>& setup, const DrivenStep& step) {
  const Eigen::VectorXd &force = step.force, dq = step.after - step.before;
  double work = 0, least = 0, driven = 0, moved = 0;
  int most = -1;
  bool dead = m_force.size() == force.size() && step.old.value.size() == force.size();
  for (int k = 0; k < static_cast<int>(dq.size()) && dead; ++k) {
    const double way = m_lever[k] * std::abs(dq[k]);
    if (step.prescribed.is_motion[static_cast<std::size_t>(k)]) {
      driven = std::max(driven, way);
      continue;
    }
    moved = std::max(moved, way);
    dead = is_dead_load(step.prescribed, k) && !setup.model().coupling_of(k);
    const double part = (force[k] - m_force[k]) * dq[k];
    work += part;
    if (part < least && force[k] * dq[k] > 0) {
      least = part;
      most = k;
    }
  }
  if (!dead || !(work < 0) || most < 0 || driven > RESTING * moved)
    m_branch = {};
  else if (m_branch.coordinate != most)
    m_branch = {most, m_t, step.before[most], m_force[most]};
}

template <int Dim>
Failure DriveCurves<Dim>::exhausted(const ContactSetup<Dim>& setup, const PrescribedValues& before,
                                    const PrescribedValues& prescribed) const {
  const auto& model = setup.model();
  const auto n = static_cast<Eigen::Index>(m_curves.size());
  if (n != prescribed.value.size() || n != before.value.size()) return {};
  for (int k = 0; k < static_cast<int>(n); ++k) {
    const auto& curve = m_curves[static_cast<std::size_t>(k)];
    const DrivePoint* part = part_before(curve);
    if (!part || !is_dead_load(prescribed, k) || !is_dead_load(before, k) || model.coupling_of(k)) continue;
    const DrivePoint& last = curve.back();
    const double way = last.q - curve.front().q, since = last.q - part->q, along = since / way;
    const double grown = (last.force - part->force) / last.force;
    if (!(way * last.force > 0) || !((prescribed.value[k] - before.value[k]) * last.force > 0)) continue;
    if (last.driven - part->driven > m_lever[k] * std::abs(since)) continue; // another drive's doing
    if (!(grown >= 0) || grown > STAGNANT * along) continue;
    Failure failure(Cause::EXHAUSTED);
    failure.coordinate = k;
    failure.value = last.force;
    failure.allowed = last.q;
    failure.t = m_t;
    failure.along = along;
    failure.grown = grown;
    failure.flag = (last.contact - part->contact) / last.contact > MECHANISM * along;
    return failure;
  }
  return {};
}

template <int Dim> std::string DriveCurves<Dim>::unstable(const ContactSetup<Dim>& setup) const {
  const int k = m_branch.coordinate;
  if (k < 0) return "";
  const DrivePoint& now = m_curves[static_cast<std::size_t>(k)].back();
  if (branch_way() <= JUMP_LENGTH * setup.body().spacing) return "";
  if (!(std::abs(now.force - m_branch.from) > LEAST_FALL * std::abs(m_branch.from))) return "";
  return sentence(setup.model().coordinate(k), " goes on from ", m_branch.q, " to ", now.q,
                  " under a force that falls from ", m_branch.from, " to ", now.force,
                  ", t = ", m_branch.since, " to ", m_t,
                  ": an unstable branch behind the maximum of the force, a jump in reality "
                  "(snap-through), and there may be another equilibrium; take the force off by a motion");
}

template <int Dim> double DriveCurves<Dim>::branch_way() const {
  const int k = m_branch.coordinate;
  return k < 0 ? 0 : m_lever[k] * std::abs(m_curves[static_cast<std::size_t>(k)].back().q - m_branch.q);
}

namespace {

// Follows the forces of a run.
template <int Dim> class ForceOverWay final : public ObserverOf<ForceOverWay<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_curves, m_q, m_prescribed)
  void begin(const AcceptedStep<Dim>& step, FindingList&) override {
    m_q = step.contact.q;
    if (step.prescribed) m_prescribed = *step.prescribed;
  }
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (!step.prescribed) return;
    Eigen::VectorXd contact = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(step.model().tools.size()));
    for (Eigen::Index tool = 0; tool < contact.size(); ++tool) {
      const Eigen::VectorXd f = contact_forces(step.model(), step.contact, step.R, static_cast<int>(tool));
      contact[tool] = f.reshaped(Dim, f.size() / Dim).rowwise().sum().norm();
    }
    m_curves.add(step.setup, {m_q, step.contact.q, m_prescribed, *step.prescribed, step.generalized_force,
                              contact, step.t});
    m_q = step.contact.q;
    m_prescribed = *step.prescribed;
    const std::string branch = step.hold.force.size() > 0 ? "" : m_curves.unstable(step.setup);
    if (branch.empty()) return;
    Finding* finding =
        findings.report("contact", "falling force", Severity::WARNING, m_curves.branch_way(), step.t);
    if (finding) finding->text = branch;
  }
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    const Failure failure = m_curves.exhausted(step.setup, step.before, step.prescribed);
    if (failure) causes.push_back(failure);
  }

private:
  DriveCurves<Dim> m_curves;
  Eigen::VectorXd m_q; // at the end of the last step, and what was prescribed there
  PrescribedValues m_prescribed;
};

} // namespace

template class DriveCurves<2>;
template class DriveCurves<3>;
BURNISH_OBSERVER(force_over_way, ForceOverWay)

} // namespace burnish
