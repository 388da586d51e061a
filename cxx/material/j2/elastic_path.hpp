#pragma once
// The elastic path of a step through the yield surface of J2: what the events of points are located by.
#include "material/j2/parameters.hpp"
#include "material/material_law.hpp"

namespace burnish {

/// Fraction at which q(R (s_old - X_old) R' + elastic increment) = sigma_y(ep_old) on the elastic path of the step of
/// that length, X = 0 without a back stress: a step cut there ends on the surface. See MaterialLaw::yield_fraction.
template <int Dim>
double elastic_yield_fraction(const J2Parameters& material, const PointStep<Dim>& step, double last,
                              double noise);

/// See MaterialLaw::loading.
template <int Dim> PointLoading elastic_loading(const J2Parameters& material, const PointStep<Dim>& step);

} // namespace burnish
