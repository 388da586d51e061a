#include "cad/occ/closed_support.hpp"

namespace burnish {

namespace {

constexpr double END_SLACK = 1e-9; // of the size of a face
constexpr double WHOLE_TURN = 2 * M_PI - 1e-9;

} // namespace

ClosedSupport::ClosedSupport(const FaceData& data, const Make& make, Parameters uv,
                             const std::optional<Vector<3>>& tip)
    : m_surface(make(false)), m_uv(std::move(uv)), m_tip(tip), m_slack(END_SLACK * data.size) {
  const auto middle = m_surface->foot(data.x, Param<3>::Zero()).place;
  if (m_surface->frame(middle).n.dot(data.n) < 0) m_surface = make(true);
  m_middle = m_surface->foot(data.x, Param<3>::Zero()).place.hint;
  if (data.u1 - data.u0 > WHOLE_TURN) m_middle[1] = 0; // all directions are alike: as the core's own shapes
}

SupportFoot ClosedSupport::foot(const Vector<3>& p, const Param<3>* near, bool& taken) const {
  const SurfaceFoot<3> foot = m_surface->foot(p, Param<3>(near ? (*near)[1] : m_middle[0], m_middle[1]));
  const Vector<3>& y = foot.place.y;
  const double s = foot.place.hint[0];
  SupportFoot found{y, Param<3>(0.5, s), m_uv(y, s), (p - y).norm(), true};
  taken = true;
  if (!foot.on_end) return found;
  found.normal = !(m_tip && (y - *m_tip).norm() <= m_slack);
  taken = !found.normal || (m_surface->frame(foot.place).E.transpose() * (p - y)).norm() <= m_slack;
  return found;
}

bool ClosedSupport::warm(const Vector<3>& p, const Param<3>& near, SupportFoot& found) const {
  bool taken = false;
  found = foot(p, &near, taken);
  return taken;
}

// There is one only: on all of these surfaces every other foot is a saddle or the furthest point, a profile aside.
void ClosedSupport::feet(const Vector<3>& p, const SupportFoot* known, double& reach,
                         const Offer& offer) const {
  if (known) return;
  bool taken = false;
  const SupportFoot found = foot(p, nullptr, taken);
  if (taken && found.distance <= reach) offer(found);
}

SupportFoot ClosedSupport::at(const gp_Pnt2d& uv, const Vector<3>& x) const {
  bool taken = false;
  SupportFoot place = foot(x, nullptr, taken);
  place.uv = uv;
  return place;
}

SurfaceFrame<3> ClosedSupport::frame(const Vector<3>& y, const Param<3>& hint) const {
  return m_surface->frame({y, Param<3>(hint[1], m_middle[1])});
}

} // namespace burnish
