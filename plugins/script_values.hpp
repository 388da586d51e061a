#pragma once
// The variables of a script where it calls: what a run has changed of them goes into its checkpoint.
#include "checkpoint/checkpoint.hpp"
#include "plugin.hpp"
#include "script_meshes.hpp"

namespace burnish {

/// Numbers, texts, arrays, maps, meshes and functions of a finite element space, and arrays of them, that are visible where FreeFEM compiles a call. Made
/// then; asked when the call is executed.
class ScriptValues {
public:
  ScriptValues();
  /// Notes what each is, the first time that it is seen.
  void note(Stack stack) const;
  /// Those that are not what was noted of them, or were never noted. @param mesh of the run: a variable that is it goes without
  std::vector<KeptValue> changed(Stack stack, const RunMesh& mesh) const;
  /// Puts these in place of the present ones, meshes before what is on them.
  /// @param mesh of the run now @throws std::invalid_argument naming one that is not visible
  void restore(Stack stack, const std::vector<KeptValue>& values, const RunMesh& mesh) const;

private:
  struct Variable {
    std::string name; // with a ' for each inner one of the same name
    aType type;
    Expression place;
  };
  std::vector<Variable> m_variables;
};

} // namespace burnish
