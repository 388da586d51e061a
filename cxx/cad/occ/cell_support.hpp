#pragma once
// Closest points of any parametric surface: cells with bounds, in which Newton's method finds the local feet.
#include "cad/occ/face_support.hpp"
#include "geometry/box_tree.hpp"
#include <Geom_Surface.hxx>

namespace burnish {

class CellSupport final : public FaceSupport {
public:
  explicit CellSupport(const FaceData& data);

  bool warm(const Vector<3>& p, const Param<3>& near, SupportFoot& found) const override;
  void feet(const Vector<3>& p, const SupportFoot* known, double& reach, const Offer& offer) const override;
  SupportFoot at(const gp_Pnt2d& uv, const Vector<3>& x) const override;
  SurfaceFrame<3> frame(const Vector<3>& y, const Param<3>& hint) const override;

private:
  /// A place with its derivatives.
  struct Value {
    Vector<3> x, u, v, uu, uv, vv;
  };
  /// A place on the way to a foot.
  struct Trial {
    double u, v, distance; ///< from the point
    Vector<3> x;
  };
  /// A part of the parameters whose normals differ by little.
  struct Cell {
    double u0, u1, v0, v1;
    Vector<3> center, half; ///< of a box that holds it, along the axes [length of the file]
    Tensor<3> axes;         ///< two tangents and the normal amid the cell
    double turn;            ///< bound of the angle between that normal and others [rad]
    double bend;            ///< bound of its normal curvatures [1/length of the file]
  };
  Value value(double u, double v) const;
  std::vector<double> knots(bool along_u) const;
  void add(double u0, double u1, double v0, double v1, int depth);
  void bound(Cell cell, const std::vector<Value>& values);
  bool has_one_foot(const Cell& cell, const Vector<3>& local) const;
  bool newton(const Vector<3>& p, const Cell* within, Trial& trial) const;
  bool improved(const Vector<3>& p, const Value& at, double& u, double& v, double& step, bool& certain) const;
  SupportFoot foot_at(const Trial& trial) const;
  SurfaceFrame<3> frame_of(const Value& at) const;
  bool keep_close(const Cell* within, double& u, double& v) const;
  double parameter_u(const Param<3>& hint) const;

  Handle(Geom_Surface) m_surface;
  FaceData m_data;
  double m_side; ///< +1: S_u x S_v points into the body
  std::vector<Cell> m_cells;
  BoxTree m_tree;
};

} // namespace burnish
