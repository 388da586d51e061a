#pragma once
// The outline of a tool as a picture needs it: finer where it bends, and where the picture looks.
#include "kinematics/tool.hpp"

namespace burnish {

/// What a picture shows [length].
template <int Dim> struct PictureWindow {
  Vector<Dim> low, high;
  /// Largest distance of the outline from its chords within the window; FAR_OUT times as much outside [length].
  double sagitta = 0;
};
inline constexpr double FAR_OUT = 30;

/// The window round these places (num x Dim) [length]: half of its larger side more on every side, and a sagitta that no
/// eye sees in a picture of it.
template <int Dim> PictureWindow<Dim> picture_window(const Eigen::VectorXd& places);

/// Points of the tool's surface from its begin to its end, with the joints of its pieces, in the order of travel.
/// @throws std::invalid_argument if q is refused by the tool, or the sagitta is not > 0
template <int Dim>
std::vector<Vector<Dim>> window_outline(const Tool<Dim>& tool, const Eigen::VectorXd& q,
                                        const PictureWindow<Dim>& window);

} // namespace burnish
