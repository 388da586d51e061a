#pragma once
// Derivatives by finite differences and the check of thrown messages, for the unit tests.
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace burnish::test {

/// df/dt at t by the central five-point rule (error O(step^4)); f returns a double or an Eigen object by
/// value. step: about 1e-3 of the length or angle over which f changes gives a relative error of about 1e-12.
template <class Function> auto finite_difference(const Function& f, double t, double step) {
  using Value = decltype(f(t));
  const Value near = f(t + step) - f(t - step);
  const Value far = f(t + 2 * step) - f(t - 2 * step);
  return Value((8.0 * near - far) / (12.0 * step));
}

/// Expects |computed - expected| <= tolerance * scale; scale is the natural size of the quantity (> 0), so
/// that derivatives that vanish are tested too.
template <class Computed, class Expected>
void expect_close(const Computed& computed, const Expected& expected, double scale, double tolerance,
                  const std::string& quantity) {
  const double error = (computed - expected).norm() / scale;
  EXPECT_LE(error, tolerance) << quantity << ": computed\n" << computed << "\nexpected\n" << expected;
}

/// Expects std::invalid_argument whose text contains `text`.
template <class Call> void expect_invalid(const Call& call, const std::string& text) {
  try {
    call();
    ADD_FAILURE() << "nothing thrown, expected \"" << text << "\"";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
        << "message \"" << error.what() << "\", expected \"" << text << "\"";
  }
}

} // namespace burnish::test
