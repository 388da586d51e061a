#pragma once
// Edges at which faces of a CAD body meet or end. Lengths in the unit of the file.
#include "cad/occ/space_curve.hpp"
#include "cad/occ/trimmed_face.hpp"

namespace burnish {

/// What is on the other side of an edge.
enum class EdgeKind {
  JOINT,   ///< a face with the same normal
  FREE,    ///< nothing
  CONVEX,  ///< a face that bends away from the body
  CONCAVE, ///< a face that bends towards it
};

struct FaceEdge {
  SpaceCurve curve;
  std::vector<int> faces;        ///< one, or two; twice the same at a seam: indices into the list of faces
  std::vector<TopoDS_Edge> seen; ///< the edge as each of them has it
  EdgeKind kind = EdgeKind::FREE;
  double angle = 0;            ///< largest between the normals [rad]
  bool smooth = false;         ///< curvatures are the same on both sides
  double slack = 0;            ///< how far the faces may be apart here [length of the file]
  Vector<3> sharpest{0, 0, 0}; ///< where that angle is
};

/// Every edge of the faces, but those without length.
/// @throws std::invalid_argument "CadSurface: ...", with the faces and the place (in the tool's unit): more than two faces at an
/// edge, an edge without a curve
std::vector<FaceEdge> face_edges(const std::vector<TrimmedFace>& faces, double scale);

/// "(x, y, z)" in the tool's unit, without the rounding of coordinates that should be zero. @param size of the body there
std::string space_place_text(const Vector<3>& x, double scale, double size);

} // namespace burnish
