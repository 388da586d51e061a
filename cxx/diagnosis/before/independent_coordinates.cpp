// Coordinates of a tool that move it alike: nothing tells their forces apart.
#include "base/decompositions.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "diagnosis/before/program_checks.hpp"

namespace burnish {
namespace {

// Smallest singular value of the motions, each of length 1: in the plane only rounding; in space angles about axes that are
// this near to being parallel have no forces that mean anything.
template <int Dim> constexpr double DEPENDENT = Dim == 2 ? 1e-9 : 1e-3;
constexpr double TAKES_PART = 0.1; // of a coordinate in the combination that moves nothing

/// A combination of coordinates under force that moves the tool less than each of them.
struct Combination {
  std::vector<int> coordinates;
  Eigen::VectorXd part; ///< of each; length 1, per unit of motion
  double motion = 1;    ///< of the tool
  int turns = 0;        ///< coordinates that turn the tool about its origin only
  bool moves = true;    ///< each of them moves the tool at this pose
};

template <int Dim> Eigen::VectorXd motion_of(const Vector<Dim>& origin, const Tensor<Dim>& R, double lever) {
  Eigen::VectorXd motion(Dim + Dim * Dim);
  motion << origin, lever * Eigen::Map<const Eigen::VectorXd>(R.data(), Dim * Dim);
  return motion;
}

// How coordinate k moves the tool; where it does not, how it will once another free one has moved: a quaternion of no turn.
template <int Dim>
Eigen::VectorXd motion_of(const Pose<Dim>& pose, const std::vector<int>& free, int k, double lever) {
  Eigen::VectorXd motion = motion_of<Dim>(pose.origin_q[k], turn_and_growth(pose, k), lever);
  for (const int m : free)
    if (motion.isZero(0)) motion = motion_of<Dim>(pose.origin_qq[k][m], pose.R_qq[k][m], lever);
  return motion;
}

template <int Dim> Combination weakest(const Pose<Dim>& pose, const std::vector<int>& free, double lever) {
  Combination result;
  std::vector<Eigen::VectorXd> motions;
  for (const int k : free) {
    motions.push_back(motion_of(pose, free, k, lever));
    if (motions.back().isZero(0)) {
      motions.pop_back();
      continue;
    }
    result.coordinates.push_back(k);
    result.turns += pose.origin_q[k].isZero(0);
    result.moves = result.moves && !(pose.origin_q[k].isZero(0) && turn_and_growth(pose, k).isZero(0));
  }
  if (motions.size() < 2) return result;
  Eigen::MatrixXd columns(Dim + Dim * Dim, motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) = motions[i].normalized();
  const RightSingular singular = right_singular(columns);
  const auto last = columns.cols() - 1;
  result.motion = last < singular.values.size() ? singular.values[last] : 0;
  result.part = singular.vectors.col(last);
  for (std::size_t i = 0; i < motions.size(); ++i) // per unit of the coordinate
    result.part[static_cast<Eigen::Index>(i)] /= motions[i].norm();
  return result;
}

// The coordinate whose value decides that the combination moves nothing: its change changes the motion most.
template <int Dim> int deciding(const Pose<Dim>& pose, const Combination& weak, double lever) {
  int best = 0;
  double largest = -1;
  for (std::size_t m = 0; m < pose.R_q.size(); ++m) {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(Dim + Dim * Dim);
    for (std::size_t i = 0; i < weak.coordinates.size(); ++i) {
      const int k = weak.coordinates[i];
      change += weak.part[static_cast<Eigen::Index>(i)] *
                motion_of<Dim>(pose.origin_qq[k][m], pose.R_qq[k][m], lever);
    }
    if (change.norm() <= largest * (1 + 1e-9)) continue;
    largest = change.norm();
    best = static_cast<int>(m);
  }
  return best;
}

} // namespace

template <int Dim>
void check_independent(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                       const PrescribedValues& prescribed) {
  const auto poses = setup.model().poses(state.q);
  const double lever = setup.body().spacing;
  for (std::size_t t = 0; t < setup.tools().size(); ++t) {
    const int first = setup.model().first[t];
    std::vector<int> free;
    for (int k = 0; k < setup.tools()[t]->q().size(); ++k)
      if (!prescribed.is_motion[first + k] && !prescribed.is_held(first + k) &&
          !setup.model().coupling_of(first + k))
        free.push_back(k);
    const Combination weak = weakest(poses[t], free, lever);
    if (!(weak.motion <= DEPENDENT<Dim>)) continue;
    const auto& names = setup.tools()[t]->tool().coordinates().names();
    std::string list;
    for (std::size_t i = 0; i < weak.coordinates.size(); ++i)
      if (Dim == 2 ||
          std::abs(weak.part[static_cast<Eigen::Index>(i)]) > TAKES_PART * weak.part.cwiseAbs().maxCoeff())
        list += (list.empty() ? "\"" : ", \"") + names[static_cast<std::size_t>(weak.coordinates[i])] + "\"";
    std::string cure;
    if (Dim == 3 && weak.moves && weak.turns >= 2 && weak.turns <= 3) {
      const int m = deciding(poses[t], weak, lever);
      cure = sentence(", or, as axes of turns are parallel near \"", names[static_cast<std::size_t>(m)],
                      "\" = ", state.q[first + m],
                      ", take another sequence of axes, or \"cartesian\" without rotation=, whose spins "
                      "have no singular pose");
    }
    fail("contact.begin", "coordinates " + list + " of tool \"" + setup.tools()[t]->name() +
                              "\" are under force, but one of them moves the tool as the others do; give one "
                              "of them a motion" +
                              cure);
  }
}

template void check_independent<2>(const ContactSetup<2>&, const ContactState<2>&, const PrescribedValues&);
template void check_independent<3>(const ContactSetup<3>&, const ContactState<3>&, const PrescribedValues&);

} // namespace burnish
