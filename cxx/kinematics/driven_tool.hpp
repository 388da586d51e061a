#pragma once
// A tool together with what the program prescribes for it and where it is: the object a script holds.
#include "kinematics/prescription.hpp"
#include "kinematics/tool.hpp"
#include <optional>

namespace burnish {

/// Built in two stages: a surface first, coordinates later. q is the accepted position; a run keeps it up to date.
template <int Dim> class DrivenTool {
public:
  /// @throws std::invalid_argument for a null surface and for a name that is empty or holds a comma, quote or
  /// line break (it goes into tables)
  DrivenTool(std::string name, std::shared_ptr<const Surface<Dim>> surface);
  /// Chooses the generalized coordinates; forgets earlier motions and forces. q starts at zero.
  void set_coordinates(std::shared_ptr<const Coordinates<Dim>> coordinates);
  /// @throws std::invalid_argument if no coordinates were chosen yet
  const Tool<Dim>& tool() const;
  std::shared_ptr<const Tool<Dim>> shared_tool() const { return m_tool; }
  Prescription& prescription();
  /// Prescribes the force conjugate to a coordinate by a formula, see force_formula. A formula that was given before
  /// is not read again. @throws std::invalid_argument naming tool and coordinate, see there
  void force(const std::string& coordinate, const std::string& text);
  /// Prescribes the motion of a coordinate by a formula of t, see motion_formula; read once, as those of forces.
  /// @throws std::invalid_argument naming tool and coordinate, see there
  void move(const std::string& coordinate, const std::string& text);
  /// A number that formulas of coordinates and forces call by name. Once the coordinates are chosen, new ones only.
  /// @throws std::invalid_argument for a name that formulas cannot have, a value that is not finite, or one that
  /// formulas have read already
  void set_parameter(const std::string& parameter, double value);
  /// The same that follows a formula of t: a coordinate under this motion, METHOD.md 2.8. Before the coordinates are
  /// chosen, which place it where it is at t = 0.
  /// @throws std::invalid_argument for a name that formulas cannot have, and if the coordinates are chosen
  void set_parameter(const std::string& parameter, const std::string& text);
  const std::map<std::string, double>& parameters() const { return m_parameters; }
  /// Formulas of t by the names of the parameters that follow them.
  const std::map<std::string, std::string>& following() const { return m_following; }
  const std::string& name() const { return m_name; }
  /// Present coordinates, one per name; may be set before the first step.
  Eigen::VectorXd& q();
  /// Generalized forces on the tool at the accepted state [force, force length].
  Eigen::VectorXd& generalized_force();
  /// Sets one coordinate by name. @throws std::invalid_argument for an unknown name or a value that is not
  /// finite
  void place(const std::string& coordinate, double value);
  /// Index of a coordinate. @throws std::invalid_argument for an unknown name (lists the names)
  int index(const std::string& coordinate) const;

private:
  std::string m_name;
  std::shared_ptr<const Surface<Dim>> m_surface;
  std::shared_ptr<const Tool<Dim>> m_tool;
  std::optional<Prescription> m_prescription;
  Eigen::VectorXd m_q, m_force;
  std::map<std::string, double> m_parameters;
  std::map<std::string, std::string> m_following;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const CoordinateFormula>> m_formulas,
      m_motions;
};

} // namespace burnish
