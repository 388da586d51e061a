#pragma once
// A curve of a CAD file as OpenCASCADE has it; the only types of it that other headers see.
#include <Geom_Curve.hxx>
#include <array>
#include <map>
#include <set>
#include <string>

namespace burnish {

/// A curve and the range of its parameter.
struct CadEdge {
  std::string kind;          ///< Line, Circle, BSpline, ...
  Handle(Geom_Curve) curve;  ///< null: it has none
  double begin = 0, end = 0; ///< of its parameter
  std::string missing;       ///< why it has no curve, for messages
};

/// What a CAD file holds, by tags as gmsh numbers them.
struct CadModel {
  std::map<int, CadEdge> edges;
  std::array<std::set<int>, 4> others; ///< tags of points (0), surfaces (2), volumes (3)
};

} // namespace burnish
