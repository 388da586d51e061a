#pragma once
// The whole surface on which a CAD face lies, without the face's borders. Lengths in the unit of the file.
#include "cad/occ/occ_points.hpp"
#include "geometry/surface.hpp"
#include <TopoDS_Face.hxx>
#include <functional>
#include <memory>

namespace burnish {

/// A local foot point.
struct SupportFoot {
  Vector<3> y = Vector<3>::Zero();  ///< the point [length of the file]
  Param<3> hint = Param<3>::Zero(); ///< where the support finds it again; the first number in [0, 1)
  gp_Pnt2d uv;                      ///< OpenCASCADE's parameters of the face, for trimming
  double distance = 0;              ///< [length of the file]
  bool normal = true;               ///< false: the tip of a cone
};

class FaceSupport {
public:
  using Offer = std::function<void(const SupportFoot&)>;
  virtual ~FaceSupport() = default;
  /// The local foot that is found from a place next to p. False if there is none, or the search fails.
  virtual bool warm(const Vector<3>& p, const Param<3>& near, SupportFoot& found) const = 0;
  /// Offers every local foot that may be the closest point of a part of the surface, none further from p than reach. An offer
  /// that is taken makes `reach` smaller. @param known what `warm` has found, or null: may be left out
  virtual void feet(const Vector<3>& p, const SupportFoot* known, double& reach,
                    const Offer& offer) const = 0;
  /// The place with the parameters uv. @param x about where it is
  virtual SupportFoot at(const gp_Pnt2d& uv, const Vector<3>& x) const = 0;
  /// Local geometry there, n into the body.
  virtual SurfaceFrame<3> frame(const Vector<3>& y, const Param<3>& hint) const = 0;
  /// The tip of a cone, where there is no normal, or null.
  virtual const Vector<3>* tip() const { return nullptr; }
};

/// What supports have in common: from the face, as OpenCASCADE has it.
struct FaceData {
  TopoDS_Face face;
  double u0, u1, v0, v1; ///< of the face's parameters
  double size;           ///< of the face [length of the file]
  bool turned;           ///< the body is on the side opposite to the face's normal
  double u, v;           ///< amid them
  Vector<3> x, n;        ///< the place there, and the normal into the body
  std::string name;      ///< "face 3"
};

/// Closed forms: planes, balls, cylinders, cones, rings. Null for all other kinds.
std::unique_ptr<FaceSupport> analytic_support(const FaceData& data);
/// Plane curves turned about an axis of their plane or swept normal to it. Null for all other kinds.
std::unique_ptr<FaceSupport> swept_support(const FaceData& data);
/// Any surface with second derivatives: bounded cells and Newton's method.
/// @throws std::invalid_argument "face 3 ..." where it has none that are finite
std::unique_ptr<FaceSupport> cell_support(const FaceData& data);

} // namespace burnish
