#pragma once
// Rotations that depend on some numbers - angles about axes, a rotation vector, a quaternion - with their
// derivatives.
#include "base/cross_matrix.hpp"
#include <string>
#include <vector>

namespace burnish {

/// A rotation with its first and second derivatives by its numbers.
template <int Dim> struct RotationValue {
  Tensor<Dim> R;
  std::vector<Tensor<Dim>> first;               ///< [i]
  std::vector<std::vector<Tensor<Dim>>> second; ///< [i][j], symmetric
};

template <int Dim> class Rotation {
public:
  virtual ~Rotation() = default;
  virtual int size() const = 0; ///< how many numbers
  /// @param a  size() numbers
  virtual RotationValue<Dim> at(const Eigen::VectorXd& a) const = 0;
};

/// By one angle [rad, counter-clockwise]; METHOD.md (2.3).
class AngleRotation final : public Rotation<2> {
public:
  int size() const override { return 1; }
  RotationValue<2> at(const Eigen::VectorXd& a) const override;
};

/// By angles about axes one after the other, each in the frame that the earlier ones have turned (Euler's angles);
/// METHOD.md (2.11). Without axes: none.
class AxisRotations final : public Rotation<3> {
public:
  /// @param axes  of any length > 0
  explicit AxisRotations(const std::vector<Vector<3>>& axes);
  int size() const override { return static_cast<int>(m_spins.size()); }
  RotationValue<3> at(const Eigen::VectorXd& a) const override;

private:
  std::vector<Tensor<3>> m_spins; ///< cross products with the unit axes
};

/// By the length of a vector [rad] about its direction; METHOD.md (2.12). Where the length is a multiple of 2 pi
/// other than 0, vectors of other directions lead to the same rotation: derivatives across the vector vanish.
class VectorRotation final : public Rotation<3> {
public:
  int size() const override { return 3; }
  RotationValue<3> at(const Eigen::VectorXd& a) const override;
};

/// By a quaternion (w, x, y, z) of any length > 0, which does not count: derivatives along it vanish; METHOD.md
/// (2.13).
class QuaternionRotation final : public Rotation<3> {
public:
  /// @param where  for messages
  explicit QuaternionRotation(std::string where) : m_where(std::move(where)) {}
  int size() const override { return 4; }
  /// @throws FormulaDomainError for a quaternion of length 0
  RotationValue<3> at(const Eigen::VectorXd& a) const override;

private:
  std::string m_where;
};

} // namespace burnish
