#pragma once
// Coordinates of a tool that grows or shrinks: those of its frame, and its size as a formula.
#include "formula/formula.hpp"
#include "kinematics/coordinates.hpp"
#include <memory>

namespace burnish {

/// x = o(q) + s(q) Lambda(q) y, METHOD.md (2.17): all lengths of the tool's shape are s times those of its surface. The
/// force of a coordinate of the size is conjugate to it as all others are. Carrier and reference are those of the frame.
template <int Dim> class SizedCoordinates : public Coordinates<Dim> {
public:
  /// @param tool       its name, for messages
  /// @param names      those of the frame, then those of the size alone
  /// @param size       formula of all names and of the parameters [-]
  /// @throws std::invalid_argument for what Formula refuses, and if the size depends on none of the names
  SizedCoordinates(const std::string& tool, std::shared_ptr<const Coordinates<Dim>> frame,
                   std::vector<std::string> names, const std::string& size,
                   const std::map<std::string, double>& parameters);

  const std::vector<std::string>& names() const override { return m_names; }
  /// @throws std::invalid_argument as the frame does; FormulaDomainError where the size is not finite or <= 0, quoting it
  Pose<Dim> pose(const Eigen::VectorXd& q) const override;
  RigidMotion<Dim> carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const override;
  Eigen::VectorXd reference() const override { return m_frame->reference(); }
  Eigen::VectorXd reference_at(const Eigen::VectorXd& q) const override;
  void refer_to(const Eigen::VectorXd& reference) const override { m_frame->refer_to(reference); }

private:
  std::shared_ptr<const Coordinates<Dim>> m_frame;
  std::vector<std::string> m_names;
  std::string m_what; ///< for messages
  Formula m_size;
  std::vector<Formula> m_first;               ///< [k]
  std::vector<std::vector<Formula>> m_second; ///< [k][l <= k]
};

} // namespace burnish
