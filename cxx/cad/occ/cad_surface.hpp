#pragma once
// Faces of a CAD file as the surface of a rigid tool in space.
#include "cad/cad_selection.hpp"
#include "cad/occ/face_edges.hpp"
#include "geometry/box_tree.hpp"

namespace burnish {

/// A face of a file with its side.
struct CadFaceSource {
  int tag;
  TopoDS_Face face;  ///< oriented as in its solid
  TopoDS_Shape body; ///< the solid or shell that has it, or null
  bool turned;       ///< the body is on the side opposite to the face's normal
};

/// Faces of .step, .stp and .brep files, trimmed, from exact surfaces, no facets. Planes, balls, cylinders, cones and rings have
/// closed forms, curves turned or swept the plane's search, all others cells with bounds and Newton's method. Of a solid the
/// body is OUTSIDE; `inside` swaps the side. Faces of no closed shell are sewn first (1e-6 of the file's unit); what is not closed
/// then has no side of its own: it must be given.
/// Neighbors must join smoothly (1e-3 rad), or end at their common edge: then no surface goes on there, and a foot on the edge is
/// an end. STEP files arrive in mm, whatever their unit. The hint of a place: number of the face and the place on it.
class CadSurface final : public Surface<3> {
public:
  /// @throws std::invalid_argument with file, face and place: see CadFile; no faces, an unknown one (tells those that exist), one
  /// given twice, a side that is missing, a named face that meets another one at a sharp edge (with the fillet that fits, FilletRadii)
  /// or has a tip, more than two faces at an edge, a scale that is not positive
  explicit CadSurface(const CadSelection& selection);

  SurfaceFoot<3> foot(const Vector<3>& p, const Param<3>& hint) const override;
  SurfaceFrame<3> frame(const SurfacePlace<3>& place) const override;
  /// Faces that join with the same curvature are one piece.
  int piece(const SurfacePlace<3>& place) const override;
  /// True if there are two faces at every edge.
  bool closed() const override { return m_closed; }
  /// RIM_PLACES places on each edge at which the surface ends, and every tip.
  std::vector<SurfacePlace<3>> ends() const override;
  /// Straight, through space.
  double distance_to_end(const SurfacePlace<3>& place) const override;
  std::vector<SurfacePlace<3>> samples(int n) const override;
  /// Along all edges.
  std::vector<SurfacePlace<3>> outline(int n) const override;
  SurfaceMesh mesh(const Eigen::AlignedBox3d& window) const override;
  /// Half the largest side of the box about all faces [length].
  double length_scale() const override { return m_scale * m_size / 2; }
  /// At places spread over each face.
  double tightest_radius() const override { return m_tightest; }
  /// Numbers of the faces in the file.
  std::vector<int> tags() const;

  static constexpr int RIM_PLACES = 24;

private:
  /// Part of an edge: two indices.
  struct EdgePart {
    int edge, part;
    Vector<3> x; ///< where it begins
  };
  /// The best foot so far. Lengths in the unit of the file.
  struct Best;
  std::size_t face_at(const Param<3>& hint) const;
  void check_edges(const std::vector<CadFaceSource>& named) const;
  std::string fillet_text(const FaceEdge& first, const std::vector<CadFaceSource>& named) const;
  [[noreturn]] void refuse_edge(const FaceEdge& edge, const std::vector<CadFaceSource>& named,
                                double size) const;
  void divide_edges();
  void join_pieces();
  double tightest() const;
  double edge_bound(const Vector<3>& p) const;
  bool holds(std::size_t face, const SupportFoot& foot) const;
  void ask_faces(const Vector<3>& p, const Param<3>& hint, Best& best) const;
  void ask_rims(const Vector<3>& p, Best& best) const;
  SurfacePlace<3> place_of(std::size_t face, const SupportFoot& foot) const;
  SurfacePlace<3> edge_place(const FaceEdge& edge, double u) const;

  double m_scale; ///< tool's unit of length per unit of the file
  std::vector<TrimmedFace> m_faces;
  std::vector<FaceEdge> m_edges;
  std::vector<EdgePart> m_rims, m_joints; ///< where the surface ends, and where it goes on
  BoxTree m_face_tree, m_rim_tree, m_joint_tree;
  std::vector<int> m_piece; ///< of each face
  bool m_closed = true;
  double m_size = 0;  ///< largest side of the box about all faces [length of the file]
  double m_slack = 0; ///< largest of the joints [length of the file]
  double m_tightest;
};

/// The faces of a selection in the order given, of all faces unless there are some named.
std::vector<CadFaceSource> read_faces(const CadSelection& selection);
/// Whether a .step, .stp or .brep file can be read and has a face that is not in the plane z = 0.
bool has_faces_in_space(const std::string& path);

} // namespace burnish
