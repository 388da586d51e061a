#pragma once
// Generalized coordinates q place a tool's frame in space: x = origin(q) + size(q) R(q) xhat.
#include "base/types.hpp"
#include <string>
#include <vector>

namespace burnish {

/// Pose of a tool frame with first and second derivatives by the generalized coordinates.
template <int Dim> struct Pose {
  Vector<Dim> origin;                              ///< [length]
  Tensor<Dim> R;                                   ///< rotation of the tool frame
  std::vector<Vector<Dim>> origin_q;               ///< [k]
  std::vector<Tensor<Dim>> R_q;                    ///< [k]
  std::vector<std::vector<Vector<Dim>>> origin_qq; ///< [k][l], symmetric
  std::vector<std::vector<Tensor<Dim>>> R_qq;      ///< [k][l], symmetric
  double size = 1;                                 ///< of the tool over that of its own frame, > 0
  Eigen::VectorXd size_q;                          ///< [k]; empty: the size is 1 for good
  Eigen::MatrixXd size_qq;                         ///< (k, l), symmetric
};

/// Derivative of size times R by coordinate k: how the tool turns and grows with it.
template <int Dim> Tensor<Dim> turn_and_growth(const Pose<Dim>& pose, std::size_t k) {
  if (pose.size_q.size() == 0) return pose.R_q[k];
  return pose.size * pose.R_q[k] + pose.size_q[static_cast<Eigen::Index>(k)] * pose.R;
}

/// Bound of the motion of the tool's points that are up to `length` off its origin, in its own frame, with coordinate k
/// [length per unit].
template <int Dim> double point_rate(const Pose<Dim>& pose, std::size_t k, double length) {
  return pose.origin_q[k].norm() + turn_and_growth(pose, k).norm() * length;
}

/// Bound of the way of such points from one pose to another [length].
template <int Dim> double pose_change(const Pose<Dim>& from, const Pose<Dim>& to, double length) {
  const double turn = (to.size * to.R - from.size * from.R).norm();
  return (to.origin - from.origin).norm() + turn * length;
}

/// Rigid motion x -> R x + d.
template <int Dim> struct RigidMotion {
  Tensor<Dim> R = Tensor<Dim>::Identity();
  Vector<Dim> d = Vector<Dim>::Zero();
  Vector<Dim> operator()(const Vector<Dim>& x) const { return R * x + d; }
  RigidMotion inverse() const { return {R.transpose(), -R.transpose() * d}; }
};

template <int Dim> class Coordinates {
public:
  virtual ~Coordinates() = default;
  virtual const std::vector<std::string>& names() const = 0; ///< e.g. {"r","phi","theta"}
  int size() const { return static_cast<int>(names().size()); }
  /// Pose and its derivatives at q (size()); lengths in the user's length unit, angles in radians.
  virtual Pose<Dim> pose(const Eigen::VectorXd& q) const = 0;
  /// Rigid motion of the carrier of the tool from q_from to q_to: what moves with the tool's path but does
  /// not spin with the tool. Polar: the turn about the pivot; otherwise the translation of the origin.
  /// Used to carry the last step along with the tool as a predictor. Default: the translation.
  virtual RigidMotion<Dim> carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const {
    RigidMotion<Dim> translation;
    translation.d = pose(q_to).origin - pose(q_from).origin;
    return translation;
  }
  /// What the pose depends on besides q, where it is no function of q alone: a part of the accepted state, which a run
  /// renews at the end of a step and puts back with a state. Empty: nothing.
  virtual Eigen::VectorXd reference() const { return {}; }
  /// The reference for what follows on q: the pose at q stays.
  virtual Eigen::VectorXd reference_at(const Eigen::VectorXd&) const { return {}; }
  /// Puts one of these in place. The object is shared, as its pose is; only a run does this.
  virtual void refer_to(const Eigen::VectorXd&) const {}
};

/// Pose with R = I, the origin at zero and all derivatives zero, for `size` coordinates: a start to fill in.
template <int Dim> Pose<Dim> blank_pose(int size) {
  const auto n = static_cast<std::size_t>(size);
  const std::vector<Vector<Dim>> vectors(n, Vector<Dim>::Zero());
  const std::vector<Tensor<Dim>> tensors(n, Tensor<Dim>::Zero());
  Pose<Dim> pose;
  pose.origin.setZero();
  pose.R.setIdentity();
  pose.origin_q = vectors;
  pose.R_q = tensors;
  pose.origin_qq.assign(n, vectors);
  pose.R_qq.assign(n, tensors);
  return pose;
}

/// Checks a vector of generalized coordinates.
/// @throws std::invalid_argument "where: ..." unless q has one finite number per name (says which one is not)
void require_coordinates(const std::string& where, const std::vector<std::string>& names,
                         const Eigen::VectorXd& q);

/// "a, b, c", for messages.
std::string joined(const std::vector<std::string>& names);

} // namespace burnish
