#pragma once
// What a material is to the workpiece: a law with named internal variables that answers for one quadrature point at a
// time. All answers are functions of the arguments alone. Knows no mesh.
#include "material/hardening.hpp"
#include "material/internal_variables.hpp"
#include "material/piola.hpp"
#include "material/point_range.hpp"
#include "material/step_increments.hpp"
#include <limits>
#include <map>

namespace burnish {

/// Fraction of what does not happen in a step.
inline constexpr double NEVER = std::numeric_limits<double>::infinity();

enum class TangentKind {
  CONSISTENT, ///< linearization of the chosen finite-step update
  DAMPED, ///< the same, with a part of elastic moduli where updates of the step go to and fro between elastic and
          ///< plastic (ALGORITHMS.md 5.2): of a workpiece
  RATE,    ///< rate tangent, METHOD.md (1.8), at the end of the step; the point loads if `plastic`
  ELASTIC, ///< elastic moduli with the geometric terms
};

/// How the stress drives a point through its yield surface: powers s:dd of the deviator on strain increments
/// [stress].
struct PointLoading {
  double old = 0; ///< in the step that ended at the start
  double now = 0; ///< in this step, R s_old R':dd; > 0 loads, < 0 unloads, 0: neutral but for rounding
  double elastic_distance = -1; ///< yield_distance at the end of the step, had it been elastic
};

template <int Dim> class MaterialLaw {
public:
  virtual ~MaterialLaw() = default;
  const std::string& name() const { return m_name; }
  const InternalVariables<Dim>& internal_variables() const { return m_internal; }
  /// Place of a component of an internal variable among the numbers of a point.
  /// @throws std::invalid_argument "where: ..." if there is no such variable (lists those there are), or component
  int internal_place(const std::string& variable, int component, const char* where) const;

  /// Stress and internal variables at the end of a step. Never throws: what cannot be computed is a status,
  /// and `now` is then of no use. @param trial of the same step's last iteration in, of this one out
  virtual PointResult update(const PointStep<Dim>& step, PointTrial& trial, PointUpdate<Dim>& now) const = 0;
  /// The same for points one after another, to the same bits: the first that fails ends it, `now` of it and of those
  /// behind it is of no use then. One by one, unless a law knows better.
  virtual RangeResult update_range(const RangeStep<Dim>& step, const RangeUpdate<Dim>& now) const;
  /// A_iJkL = dP_iJ/dF_kL at the end of a step, not symmetrized [stress].
  /// @param trial as update left it; @param now end of the step as update found it, F included
  virtual PiolaTangent<Dim> tangent(TangentKind kind, const PointStep<Dim>& step, const PointTrial& trial,
                                    const PointState<Dim>& now) const = 0;

  /// Increments of a step for a user-defined law that takes them; det F_mid > 0. Zero for a law in total strains.
  virtual StepIncrements<Dim> increments(const PointStep<Dim>& step) const;

  /// Its P is its stress, and its strains are sym grad u, METHOD.md 1.15.
  virtual bool small_strain() const { return false; }

  /// False: moduli and stress come from elsewhere (UserLaw), tangent() has none.
  virtual bool has_moduli() const { return true; }

  /// Its moduli by name, K and G of isotropic elasticity [stress], C [stress] and gamma [-] of a back stress; none where it
  /// has others.
  virtual std::map<std::string, double> moduli() const { return {}; }
  /// One of them. @throws std::invalid_argument for an unknown name (lists those there are)
  double modulus(const std::string& name) const;

  // A law without a yield surface leaves the rest as it is.

  /// sigma_y and its slope at plastic_strain_eq; NaN.
  virtual YieldStress yield_stress(double plastic_strain_eq) const;
  /// q/sigma_y - 1: negative inside, positive outside the yield surface [-].
  virtual double yield_distance(const Stress<Dim>& stress, const double* internal) const;
  /// Whether a strain rate d makes the point flow: on the surface (or put there, at.plastic), and s:d > 0.
  virtual bool loads(const PointState<Dim>& at, const Stress<Dim>& strain_rate) const;
  /// Fraction of the step at which its elastic path, linear in F, leaves the yield surface to the outside: 0
  /// if the point is on it, or outside, and loads; NEVER if not before `last` (the elastic path goes on
  /// beyond the end of the step).
  /// @param noise [fraction of sigma_y] on the surface within this; NEVER if the step does not leave it by more
  virtual double yield_fraction(const PointStep<Dim>& step, double last, double noise) const;
  virtual PointLoading loading(const PointStep<Dim>& step) const;

protected:
  /// update() of point k of a range, what it finds written to `now`.
  PointResult update_one(const RangeStep<Dim>& step, int k, const RangeUpdate<Dim>& now) const;
  MaterialLaw(std::string name, std::vector<InternalVariable> internal)
      : m_name(std::move(name)), m_internal(std::move(internal)) {}

private:
  std::string m_name;
  InternalVariables<Dim> m_internal;
};

} // namespace burnish
