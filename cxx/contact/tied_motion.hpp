#pragma once
// How a tied mid node moves with the ends of its edge (METHOD.md 3.19).
#include "contact/contact_model.hpp"

namespace burnish {

/// An end of a tied edge as the mid node sees it, in the tangents E of the mid node and E_e of the end. In the plane slips
/// are arcs: the mid node repeats half of them.
template <int Dim> struct TiedEnd {
  Curvature<Dim> follows = Curvature<Dim>::Identity(); ///< E'G E_e: the mid node moves by half of it
  Param<Dim> lift = Param<Dim>::Zero();                ///< E_e'n
  Param<Dim> normal = Param<Dim>::Zero();              ///< E'n_e
  Curvature<Dim> B = Curvature<Dim>::Zero();           ///< of the tool at the end [1/length]
};
/// Ends on a symmetry plane count by what their supports leave them. @param middle, end candidates, in contact with one tool
template <int Dim>
TiedEnd<Dim> tied_end(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                      const std::vector<Pose<Dim>>& poses, int middle, int end);

/// Place of a tied mid node by the slips of the ends that slide: in space the foot of its origin and half of their chords.
template <int Dim>
SurfacePlace<Dim> tied_place(const ContactModel<Dim>& model, const ContactState<Dim>& state, int middle);

/// (I + phi B)^-1 at its place, phi the height of what tied_place takes the foot of: that of G in the tangents.
template <int Dim>
Curvature<Dim> foot_slope(const ContactModel<Dim>& model, const ContactState<Dim>& state, int middle);

// (specialized for each dimension: told before any use)
template <>
TiedEnd<2> tied_end(const ContactModel<2>&, const ContactState<2>&, const std::vector<Pose<2>>&, int, int);
template <>
TiedEnd<3> tied_end(const ContactModel<3>&, const ContactState<3>&, const std::vector<Pose<3>>&, int, int);
template <> SurfacePlace<2> tied_place(const ContactModel<2>&, const ContactState<2>&, int);
template <> SurfacePlace<3> tied_place(const ContactModel<3>&, const ContactState<3>&, int);
template <> Curvature<2> foot_slope(const ContactModel<2>&, const ContactState<2>&, int);
template <> Curvature<3> foot_slope(const ContactModel<3>&, const ContactState<3>&, int);

} // namespace burnish
