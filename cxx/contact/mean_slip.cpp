#include "contact/mean_slip.hpp"
#include <cmath>

namespace burnish {

template <int Dim> MeanSlip<Dim> mean_slip(const Param<Dim>& slip, const Param<Dim>& memory) {
  MeanSlip<Dim> mean{slip, Curvature<Dim>::Identity()};
  const double size = slip.norm();
  if (!(size > 0) || memory.isZero()) return mean;
  const Param<Dim> d = slip / size;
  const double along = d.dot(memory);
  const double root = std::sqrt(std::max(1 - memory.squaredNorm() + along * along, 0.));
  if (!(root > 0)) return mean;
  const double length = along + root;
  mean.way = length * slip - size * memory;
  const Param<Dim> along_slip = memory - along * d; // times size
  mean.by_slip = length * Curvature<Dim>::Identity() + (1 + along / root) * d * along_slip.transpose() -
                 memory * d.transpose();
  return mean;
}

template <int Dim>
MeanSlip<Dim> mean_slip_of(const ContactModel<Dim>& model, const ContactNode<Dim>& node, double tool_size,
                           bool fixed) {
  constexpr double far = 0.5; // cosine
  const Param<Dim> slip = slip_of(model, node, tool_size);
  if (Dim == 2 || node.slip_memory.isZero()) return {slip, Curvature<Dim>::Identity()};
  const SurfaceFrame<Dim> frame = model.tools[node.tool]->surface().frame(node.place);
  const Param<Dim> memory = frame.E.transpose() * node.slip_memory;
  if (fixed && slip.dot(memory) < far * slip.norm() * memory.norm())
    return {slip, Curvature<Dim>::Identity()};
  return mean_slip<Dim>(slip, memory.normalized() * node.slip_memory.norm());
}

template MeanSlip<2> mean_slip<2>(const Param<2>&, const Param<2>&);
template MeanSlip<3> mean_slip<3>(const Param<3>&, const Param<3>&);
template MeanSlip<2> mean_slip_of<2>(const ContactModel<2>&, const ContactNode<2>&, double, bool);
template MeanSlip<3> mean_slip_of<3>(const ContactModel<3>&, const ContactNode<3>&, double, bool);

} // namespace burnish
