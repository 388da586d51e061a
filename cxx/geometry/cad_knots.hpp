#pragma once
// Knots of a curve of which only samples can be had: where it passes from one polynomial to the next.
#include "geometry/chebyshev.hpp"
#include <functional>

namespace burnish {

using CadSamples = std::function<Eigen::Matrix2Xd(const std::vector<double>& u)>;

/// Degree at which arcs and rational splines are equal to their Chebyshev polynomials to rounding, on parts
/// that turn by less than about 3 rad.
constexpr int CAD_DEGREE = 18;

/// Interpolates the samples on [begin, end]; returns the largest error at points between, also close to the
/// ends, where a knot just inside would hide.
double cad_misfit(const CadSamples& samples, int degree, double begin, double end, Coefficients& c);

/// Knots of the first derivative x_u: begin, inner knots, end. Intervals are halved until x_u is smooth on
/// each; neighbors that are smooth together are one; then each knot is put where the two neighboring
/// polynomials are equal, to 1e-8 of the range or so. Curves without knots are left in few intervals.
/// @param tolerance  error of x_u that is rounding [length/u]
/// @param jump       set to the parameter where x_u itself jumps, if it does (a break inside the curve); or NaN
/// @return empty if x_u jumps (unless halving hits the place), or is nowhere smooth
std::vector<double> find_knots(const CadSamples& derivative, double begin, double end, double tolerance,
                               double& jump);

/// Equal intervals with a cubic on each, as gmsh's own Line, Spline, BSpline and Bezier have them; empty if
/// there are none.
std::vector<double> equal_cubics(const CadSamples& value, double begin, double end, double tolerance);

} // namespace burnish
