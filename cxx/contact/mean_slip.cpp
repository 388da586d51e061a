#include "contact/mean_slip.hpp"
#include <cmath>

namespace burnish {

template <int Dim> MeanSlip<Dim> mean_slip(const Param<Dim>& slip, const Param<Dim>& before, double reach) {
  MeanSlip<Dim> mean{slip, Curvature<Dim>::Identity()};
  const double size = slip.norm();
  if (!(size > 0) || before.isZero() || !(reach > 0)) return mean;
  const double ratio = size / reach, w = 1 / (1 + ratio * ratio);
  const double w_size = -2 * w * w * ratio / reach; // dw/d|D|
  const Param<Dim> d = slip / size;
  const double along = d.dot(before), square = 1 - along * along;
  const double root = std::sqrt(std::max(1 - w * w * square, 0.));
  if (!(root > 0)) return mean;
  const double length = w * along + root;
  mean.way = length * slip - w * size * before;
  const Param<Dim> along_slip = (before - along * d) / size;
  const Param<Dim> w_slip = w_size * d;
  const Param<Dim> length_slip =
      along * w_slip + w * along_slip + (w * w * along * along_slip - w * square * w_slip) / root;
  mean.by_slip = length * Curvature<Dim>::Identity() + slip * length_slip.transpose() -
                 before * (w * d + size * w_slip).transpose();
  return mean;
}

template <int Dim>
MeanSlip<Dim> mean_slip_of(const ContactModel<Dim>& model, int candidate, const ContactNode<Dim>& node,
                           const DecidingForce<Dim>& deciding, double c) {
  const Param<Dim> slip = slip_of(model, node);
  if (Dim == 2 || node.slip_before.isZero() || !(c > 0)) return {slip, Curvature<Dim>::Identity()};
  const SurfaceFrame<Dim> frame = model.tools[node.tool]->surface().frame(node.place);
  const Param<Dim> before = frame.E.transpose() * node.slip_before;
  const double reach = model.law(candidate, node).capacity(deciding) * SLIP_STIFFNESS / c;
  return mean_slip<Dim>(slip, before.normalized(), reach);
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template MeanSlip<Dim> mean_slip<Dim>(const Param<Dim>&, const Param<Dim>&, double);                       \
  template MeanSlip<Dim> mean_slip_of<Dim>(const ContactModel<Dim>&, int, const ContactNode<Dim>&,           \
                                           const DecidingForce<Dim>&, double);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)
#undef BURNISH_INSTANTIATE

} // namespace burnish
