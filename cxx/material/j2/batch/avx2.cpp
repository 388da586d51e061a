#include "material/j2/batch/avx2.hpp"
#include "material/j2/batch/packet.hpp"
#include "material/j2/trapezoidal_return.hpp"
#include "material/strain_path.hpp"
#include <algorithm>

#if defined(__x86_64__)
namespace burnish {
namespace avx2 {
namespace {

constexpr int WIDTH = J2_AVX2_WIDTH;

/// What is the same for all points of a range.
struct Batch {
  const HardeningLaw& hardening;
  bool linear;
  YieldStress start; // of linear hardening, at ep = 0
  double K, G;
  double ratio;
  int iteration;
  const UpdateOptions& options;
};

/// step_kinematics and elastic_trial.
struct Trial {
  Tensors strain, s_old, elastic_increment;
  Packet cos_2alpha, sin_2alpha, mean;
};

/// sigma_y and its slope.
struct Yield {
  Packet value, slope;
};

struct Plastic {
  Packet strain_eq, increment; // ep, and what the step has added
};

constexpr int ALL = (1 << WIDTH) - 1; // as lanes() of a mask

/// @param which points it is needed for
BURNISH_AVX2 Yield yield_at(const Batch& batch, Packet plastic_strain_eq, int which) {
  if (batch.linear) {
    const Packet slope = packet(batch.start.slope);
    return {packet(batch.start.value) + slope * plastic_strain_eq, slope};
  }
  alignas(Packet) double ep[WIDTH], value[WIDTH] = {}, slope[WIDTH] = {};
  _mm256_store_pd(ep, plastic_strain_eq);
  for (int k = 0; k < WIDTH; ++k) {
    if (!(which >> k & 1)) continue;
    const YieldStress yield = batch.hardening.at(ep[k]);
    value[k] = yield.value;
    slope[k] = yield.slope;
  }
  return {_mm256_load_pd(value), _mm256_load_pd(slope)};
}

/// @return whether F_mid is one of a body at all four points; else nothing is set
BURNISH_AVX2 bool moved(const Batch& batch, const Gradients& F_old, const Gradients& F, Tensors stress_old,
                        Trial& trial) {
  const Packet half = packet(0.5), one = packet(1), two = packet(2);
  const Gradients M{half * (F_old.xx + F.xx), half * (F_old.xy + F.xy), half * (F_old.yx + F.yx),
                    half * (F_old.yy + F.yy), half * (F_old.zz + F.zz)};
  const Packet area = M.xx * M.yy - M.xy * M.yx, det = area * M.zz, zero = packet(0);
  const Mask sound = both(both(greater(M.zz, zero), greater(det, zero)),
                          not_greater(det, packet(std::numeric_limits<double>::max())));
  if (lanes(sound) != ALL) return false;
  const Gradients inverse{M.yy / area, -M.xy / area, -M.yx / area, M.xx / area, area / M.zz / area};
  const Gradients d{F.xx - F_old.xx, F.xy - F_old.xy, F.yx - F_old.yx, F.yy - F_old.yy, F.zz - F_old.zz};
  const Packet Gxy = d.xx * inverse.xy + d.xy * inverse.yy, Gyx = d.yx * inverse.xx + d.yy * inverse.yx;
  const Packet spin = half * (Gyx - Gxy), t = half * spin, scale = one / (one + t * t);
  const Packet cos = (one - t * t) * scale, sin = two * t * scale;
  trial.cos_2alpha = (cos - sin) * (cos + sin);
  trial.sin_2alpha = two * cos * sin;
  trial.strain = {d.xx * inverse.xx + d.xy * inverse.yx, d.yx * inverse.xy + d.yy * inverse.yy,
                  d.zz * inverse.zz, half * (Gxy + Gyx)};
  if (batch.options.strain_frame == StrainFrame::END) trial.strain = rotated(trial.strain, cos, sin);
  const Tensors turned = rotated(stress_old, trial.cos_2alpha, trial.sin_2alpha);
  const Packet mean_old = mean(turned);
  trial.s_old = {turned.xx - mean_old, turned.yy - mean_old, turned.zz - mean_old, turned.xy};
  trial.mean = mean_old + packet(3 * batch.K) * mean(trial.strain);
  trial.elastic_increment = packet(2 * batch.G) * deviator(trial.strain);
  return true;
}

/// chosen_substeps of every point. @return the largest
BURNISH_AVX2 int choose_substeps(const Batch& batch, const Trial& trial, Packet plastic_strain_eq,
                                 const char* plastic_old, PointTrial* points) {
  const Packet yield = yield_at(batch, plastic_strain_eq, ALL).value;
  const Tensors end = trial.s_old + trial.elastic_increment;
  const int inside = lanes(not_greater(product(end, end), yield * yield));
  alignas(Packet) double wanted[WIDTH];
  const UpdateOptions& options = batch.options;
  const Packet q = root(product(trial.elastic_increment, trial.elastic_increment));
  _mm256_store_pd(wanted, _mm256_ceil_pd(q / (packet(SUBSTEP_STRAIN) * yield)));
  int largest = 0;
  for (int k = 0; k < WIDTH; ++k) {
    points[k].used = 0;
    if ((!plastic_old[k] && (inside >> k & 1)) || std::isnan(wanted[k])) continue;
    const bool may_grow = batch.iteration < FREEZE_ITERATION || points[k].substeps == 0;
    const double needed = std::clamp<double>(wanted[k], options.min_substeps,
                                             std::max(options.min_substeps, options.max_substeps));
    if (may_grow) points[k].substeps = std::max(points[k].substeps, static_cast<int>(needed));
    points[k].used = points[k].substeps;
    largest = std::max(largest, points[k].used);
  }
  return largest;
}

/// Curvature of strain_path.
BURNISH_AVX2 Tensors curvature(const Batch& batch, const Trial& trial, const double* strain_old) {
  if (batch.ratio <= 0) return {packet(0), packet(0), packet(0), packet(0)};
  Tensors before = packet(batch.ratio) * load_tensors(strain_old);
  if (batch.options.strain_frame == StrainFrame::END)
    before = rotated(before, trial.cos_2alpha, trial.sin_2alpha);
  const Tensors change = trial.strain - before;
  const Packet b = packet(2 * batch.ratio / (1 + batch.ratio)), limit = packet(batch.options.path_limit);
  const Packet dd2 = contract(trial.strain, trial.strain), change2 = contract(change, change);
  const Mask limited = greater(change2, limit * limit * dd2);
  const Packet share = select(limited, b * (limit * root(dd2 / change2)), b);
  return packet(2 * batch.G) * deviator(share * change);
}

/// trapezoidal_increment, per point where hardening is no straight line. @param outside points it is for
BURNISH_AVX2 Packet increment_of(const Batch& batch, Yield yield, Packet plastic_strain_eq, Packet q2,
                                 Packet c, int outside) {
  const double g = 1.5 * batch.G;
  if (batch.linear) {
    const Packet Y = yield.value, H = yield.slope, G = packet(g);
    const Packet A = H * (H + packet(2) * G), B = Y * (H + G) + G * c, C = q2 - Y * Y;
    return C / (B + root(B * B + A * C));
  }
  alignas(Packet) double ep[WIDTH], value[WIDTH], slope[WIDTH], square[WIDTH], along[WIDTH], x[WIDTH] = {};
  _mm256_store_pd(ep, plastic_strain_eq);
  _mm256_store_pd(value, yield.value);
  _mm256_store_pd(slope, yield.slope);
  _mm256_store_pd(square, q2);
  _mm256_store_pd(along, c);
  for (int k = 0; k < WIDTH; ++k)
    if (outside >> k & 1)
      x[k] = trapezoidal_increment(batch.hardening, {value[k], slope[k]}, ep[k], square[k], along[k], g);
  return _mm256_load_pd(x);
}

/// (s + f D)/q of exit_of.
BURNISH_AVX2 Tensors exit_normal(const Tensors& s, const Tensors& D, Packet yield) {
  const Packet zero = packet(0), one = packet(1);
  const Packet A = product(D, D), B = product(s, D);
  const Packet C = at_most(zero, product(s, s) - yield * yield), slope = root(B * B - A * C);
  const Packet inward = select(greater(A, zero), at_most(one, (slope - B) / A), zero);
  const Packet f = select(greater(B, zero), at_most(one, -C / (B + slope)), inward);
  const Tensors at = s + f * D;
  return at / root(product(at, at));
}

/// trapezoidal_return of the points in `active`.
BURNISH_AVX2 void returned(const Batch& batch, const Tensors& D, Mask active, Tensors& s, Plastic& plastic) {
  const Yield before = yield_at(batch, plastic.strain_eq, lanes(active));
  const Tensors trial = s + D;
  const Packet q2 = product(trial, trial);
  const Mask outside = first_only(active, not_greater(q2, before.value * before.value));
  const int some = lanes(outside);
  if (some) {
    const Tensors normal = exit_normal(s, D, before.value);
    const Packet c = product(trial, normal);
    const Packet x = increment_of(batch, before, plastic.strain_eq, q2, c, some);
    const Packet gx = packet(1.5 * batch.G) * x;
    const Tensors half = trial - gx * normal;
    plastic.strain_eq = select(outside, plastic.strain_eq + x, plastic.strain_eq);
    plastic.increment = select(outside, plastic.increment + x, plastic.increment);
    const Packet after = yield_at(batch, plastic.strain_eq, some).value;
    s = select(outside, after / (after + gx) * half, select(active, trial, s));
  } else {
    s = select(active, trial, s);
  }
}

/// substepped_return of the points that have substeps; the others take the elastic increment.
BURNISH_AVX2 Tensors substepped(const Batch& batch, const Trial& trial, const PointTrial* points, int largest,
                                const double* strain_old, Plastic& plastic) {
  const Tensors bend = curvature(batch, trial, strain_old);
  const Packet one = packet(1), zero = packet(0);
  const Packet chosen = _mm256_set_pd(points[3].used, points[2].used, points[1].used, points[0].used);
  const Packet n = select(greater(chosen, zero), chosen, one), step = one / n;
  const Tensors part = trial.elastic_increment / n;
  Tensors s = trial.s_old;
  for (int k = 0; k < largest; ++k) {
    const Packet share = packet(0.5) * step * (packet(2 * k + 1) * step - one); // curvature_share
    returned(batch, part + share * bend, greater(chosen, packet(k)), s, plastic);
  }
  return select(greater(chosen, zero), s, trial.s_old + trial.elastic_increment);
}

/// J2Law::update of four points from k on. @return false: one of them fails, nothing is set
BURNISH_AVX2 bool update_packet(const Batch& batch, const RangeStep<2>& step, std::size_t k,
                                const RangeUpdate<2>& now) {
  constexpr std::size_t F = num_gradient<2>, S = num_stress<2>;
  Trial trial;
  const Tensors stress_old = load_tensors(step.stress_old + S * k);
  if (!moved(batch, load_gradients(step.F_old + F * k), load_gradients(step.F + F * k), stress_old, trial))
    return false;
  Plastic plastic{gathered(step.internal_old + step.num_internal * k, step.num_internal), packet(0)};
  PointTrial points[WIDTH];
  std::copy_n(now.trial + k, WIDTH, points);
  const int largest = choose_substeps(batch, trial, plastic.strain_eq, step.plastic_old + k, points);
  const Tensors s =
      largest == 0 ? trial.s_old + trial.elastic_increment
                   : substepped(batch, trial, points, largest, step.strain_increment_old + S * k, plastic);
  alignas(Packet) double ep[WIDTH];
  _mm256_store_pd(ep, plastic.strain_eq);
  for (const double one : ep)
    if (!std::isfinite(one)) return false;
  store(with_mean(s, trial.mean), now.stress + S * k);
  store(trial.strain, now.strain_increment + S * k);
  const int flowed = lanes(greater(plastic.increment, packet(0)));
  for (int lane = 0; lane < WIDTH; ++lane) {
    now.internal[step.num_internal * (k + lane)] = ep[lane];
    now.plastic[k + lane] = flowed >> lane & 1;
    now.trial[k + lane] = points[lane];
  }
  return true;
}

} // namespace
} // namespace avx2

__attribute__((target("avx2"))) int j2_update_avx2(const J2Parameters& material, const RangeStep<2>& step,
                                                   int first, const RangeUpdate<2>& now) {
  const HardeningLaw& hardening = *material.hardening;
  const avx2::Batch batch{hardening,          hardening.is_linear(), hardening.at(0),
                          material.elastic.K, material.elastic.G,    step.ratio,
                          step.iteration,     step.options};
  int k = first;
  while (k + avx2::WIDTH <= step.size && avx2::update_packet(batch, step, k, now)) k += avx2::WIDTH;
  return k;
}

} // namespace burnish
#endif
