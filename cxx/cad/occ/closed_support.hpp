#pragma once
// Faces that lie on a surface of the core's own.
#include "cad/occ/face_support.hpp"
#include <optional>

namespace burnish {

class ClosedSupport final : public FaceSupport {
public:
  using Make = std::function<std::shared_ptr<const Surface<3>>(bool inside)>;
  using Parameters = std::function<gp_Pnt2d(const Vector<3>& y, double hint)>;
  /// @param make  the surface, with the body outside or inside; which of both: the normal of the data tells
  /// @param uv    OpenCASCADE's parameters of a place with the first number of its hint
  /// @param tip   of a cone
  /// @throws std::invalid_argument what `make` throws
  ClosedSupport(const FaceData& data, const Make& make, Parameters uv,
                const std::optional<Vector<3>>& tip = std::nullopt);

  bool warm(const Vector<3>& p, const Param<3>& near, SupportFoot& found) const override;
  void feet(const Vector<3>& p, const SupportFoot* known, double& reach, const Offer& offer) const override;
  SupportFoot at(const gp_Pnt2d& uv, const Vector<3>& x) const override;
  SurfaceFrame<3> frame(const Vector<3>& y, const Param<3>& hint) const override;
  const Vector<3>* tip() const override { return m_tip ? &*m_tip : nullptr; }

private:
  SupportFoot foot(const Vector<3>& p, const Param<3>* near, bool& taken) const;

  std::shared_ptr<const Surface<3>> m_surface;
  Parameters m_uv;
  std::optional<Vector<3>> m_tip;
  Param<3> m_middle; ///< hint amid the face
  double m_slack;    ///< beyond an end of a profile by so much is on it [length of the file]
};

} // namespace burnish
