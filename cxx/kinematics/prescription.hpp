#pragma once
// What the program prescribes for the coordinates of one tool: motion or conjugate force
// (METHOD.md 2.4, 3.1).
#include "kinematics/coordinate_formula.hpp"
#include <string>
#include <vector>

namespace burnish {

/// One prescription per generalized coordinate, set by name; plain value data. A later call for the same
/// coordinate wins, so control may change from motion to force during a program.
class Prescription {
public:
  enum class Kind { NONE, MOTION, FORCE, FOLLOWS };
  /// Of one coordinate.
  struct Entry {
    Kind kind = Kind::NONE;
    double value = 0;
    std::shared_ptr<const CoordinateFormula> formula = nullptr;
    std::string relation = {}; ///< of one that follows others
  };

  /// @param tool   name of the tool, for messages
  /// @param names  names of its coordinates, in the order of q
  /// @throws std::invalid_argument if names is empty or has an empty or repeated name
  Prescription(std::string tool, std::vector<std::string> names);

  const std::string& tool() const { return m_tool; }
  const std::vector<std::string>& names() const { return m_names; }
  int size() const { return static_cast<int>(m_names.size()); }

  /// Prescribes motion: q^k = value at the end of the step [length or rad].
  /// @throws std::invalid_argument if the name is unknown (lists the names) or the value is not finite
  void move(const std::string& name, double value);
  /// Prescribes motion by a formula of t, see motion_formula: its value at the end of every step and piece of a step.
  /// @throws std::invalid_argument if the name is unknown (lists the names)
  void move(const std::string& name, std::shared_ptr<const CoordinateFormula> formula);
  /// Prescribes the conjugate force Q_k ON the tool at the end of the step, positive along growing q^k
  /// [force, or force length for an angle]; equilibrium is sum_n X_k . F_n = Q_k.
  /// @throws std::invalid_argument if the name is unknown (lists the names) or the value is not finite
  void force(const std::string& name, double value);
  /// Prescribes Q_k as a formula of the coordinates of this tool, see force_formula: a spring, a brake.
  /// @throws std::invalid_argument if the name is unknown (lists the names)
  void force(const std::string& name, std::shared_ptr<const CoordinateFormula> formula);
  /// The coordinate follows others from now on: it takes neither motion nor force any more.
  /// @param relation for messages, such as "-upper.y"
  /// @throws std::invalid_argument if the name is unknown, or if it has a motion or a force already
  void follow(const std::string& name, const std::string& relation);

  /// True if coordinate k (0 <= k < size()) has a motion or a force, or follows others.
  /// @throws std::invalid_argument if k is out of range
  bool is_set(int k) const;
  /// True if coordinate k follows others. @throws std::invalid_argument if k is out of range
  bool follows(int k) const;
  /// True if coordinate k has a motion, false if it has a force or follows others.
  /// @throws std::invalid_argument if k is out of range or has neither
  bool is_motion(int k) const;
  /// The prescribed q^k or Q_k of coordinate k; 0 if it has a formula or follows others.
  /// @throws std::invalid_argument if k is out of range or has neither
  double value(int k) const;
  /// The formula of the motion or the force of coordinate k; null if it has none.
  /// @throws std::invalid_argument if k is out of range or has neither
  std::shared_ptr<const CoordinateFormula> formula(int k) const;
  /// To be called when a step begins.
  /// @throws std::invalid_argument naming every coordinate that has neither motion nor force
  void check_complete() const;

  /// All of them, in the order of q; set_entries puts others in their place.
  /// @throws std::invalid_argument for another number of them
  const std::vector<Entry>& entries() const { return m_entries; }
  void set_entries(const std::vector<Entry>& entries);

private:
  Entry& entry(const char* where, const std::string& name);
  void set(const char* where, const std::string& name, Entry given);
  const Entry& at(const char* where, int k) const;
  const Entry& prescribed(const char* where, int k) const;
  std::string missing(std::size_t k) const;

  std::string m_tool;
  std::vector<std::string> m_names;
  std::vector<Entry> m_entries;
};

} // namespace burnish
