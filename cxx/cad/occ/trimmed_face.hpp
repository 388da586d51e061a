#pragma once
// A face of a CAD body: the surface on which it lies and what of it belongs to the face. Lengths in the unit of the file.
#include "cad/occ/face_support.hpp"
#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopoDS_Edge.hxx>

namespace burnish {

class TrimmedFace {
public:
  /// @param tag    its number in the file
  /// @param face   oriented as in its solid
  /// @param turned the body is on the side opposite to the face's normal
  /// @throws std::invalid_argument "CadSurface: face 3 ...": it has no surface, or one that is not finite
  TrimmedFace(int tag, const TopoDS_Face& face, bool turned);

  int tag() const { return m_tag; }
  const FaceData& data() const { return m_data; }
  const FaceSupport& support() const { return *m_support; }
  /// Whether the parameters are within its borders or on one.
  bool holds(const gp_Pnt2d& uv) const;
  const Eigen::AlignedBox3d& box() const { return m_box; }
  /// OpenCASCADE's parameters of a place on one of its edges. @param edge oriented as in the face
  gp_Pnt2d on_edge(const TopoDS_Edge& edge, double u) const;
  /// A place of the face, the i-th of a sequence that is spread over its parameters; false if that is not within its borders.
  bool sample(int i, SupportFoot& place) const;

private:
  int m_tag;
  FaceData m_data;
  Eigen::AlignedBox3d m_box;
  std::unique_ptr<FaceSupport> m_support;
  std::unique_ptr<BRepTopAdaptor_FClass2d> m_borders;
};

} // namespace burnish
