#pragma once
// How the values of a script's variables go into a checkpoint and come back, type by type.
#include "base/archive.hpp"
#include "plugin.hpp"
#include "script_meshes.hpp"

namespace burnish {

/// All values come back turn by turn: functions of earlier meshes, then meshes, then functions on these and all others.
constexpr int VALUE_TURNS = 3;

/// The expression of a variable gives a pointer to its value.
struct ValueWay {
  const char* name;
  void (*write)(Writer&, AnyType, const RunMesh&);
  void (*read)(Reader&, AnyType, const RunMesh&, int turn); ///< nullptr: only a change of it is seen
};

/// nullptr: values of that type are not seen
const ValueWay* way_of(aType type);

} // namespace burnish
