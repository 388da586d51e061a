#pragma once
// Four points' numbers in one AVX2 register, and the tensors of a point made of them. Every function here bears the target
// of its own, so that nothing else is compiled for AVX2; none has a fused multiply-add.
#if defined(__x86_64__)
#include <cstddef>
#include <immintrin.h>

#define BURNISH_AVX2 __attribute__((target("avx2"))) inline

namespace burnish::avx2 {

using Packet = __m256d;
using Mask = __m256d; ///< all bits of a lane, or none

BURNISH_AVX2 Packet packet(double x) { return _mm256_set1_pd(x); }
BURNISH_AVX2 Packet root(Packet x) { return _mm256_sqrt_pd(x); }
BURNISH_AVX2 Mask greater(Packet a, Packet b) { return _mm256_cmp_pd(a, b, _CMP_GT_OQ); }
BURNISH_AVX2 Mask not_greater(Packet a, Packet b) {
  return _mm256_cmp_pd(a, b, _CMP_LE_OQ);
} ///< false for NaN
BURNISH_AVX2 Mask both(Mask a, Mask b) { return _mm256_and_pd(a, b); }
BURNISH_AVX2 Mask first_only(Mask a, Mask b) { return _mm256_andnot_pd(b, a); }
BURNISH_AVX2 int lanes(Mask a) { return _mm256_movemask_pd(a); } ///< bit k for lane k
BURNISH_AVX2 Packet select(Mask which, Packet yes, Packet no) { return _mm256_blendv_pd(no, yes, which); }
/// As std::min(limit, x): limit for NaN.
BURNISH_AVX2 Packet at_most(Packet limit, Packet x) { return select(greater(limit, x), x, limit); }
/// One number of each of four points, `stride` numbers apart.
BURNISH_AVX2 Packet gathered(const double* first, std::size_t stride) {
  return _mm256_set_pd(first[3 * stride], first[2 * stride], first[stride], first[0]);
}

/// Stress<2> of four points.
struct Tensors {
  Packet xx, yy, zz, xy;
};
/// Gradient<2> of four points.
struct Gradients {
  Packet xx, xy, yx, yy, zz;
};

BURNISH_AVX2 Tensors operator+(const Tensors& a, const Tensors& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy};
}
BURNISH_AVX2 Tensors operator-(const Tensors& a, const Tensors& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy};
}
BURNISH_AVX2 Tensors operator*(Packet x, const Tensors& a) {
  return {x * a.xx, x * a.yy, x * a.zz, x * a.xy};
}
BURNISH_AVX2 Tensors operator/(const Tensors& a, Packet x) {
  return {a.xx / x, a.yy / x, a.zz / x, a.xy / x};
}
BURNISH_AVX2 Tensors select(Mask which, const Tensors& yes, const Tensors& no) {
  return {select(which, yes.xx, no.xx), select(which, yes.yy, no.yy), select(which, yes.zz, no.zz),
          select(which, yes.xy, no.xy)};
}

// stress_algebra.hpp, operation by operation.
BURNISH_AVX2 Packet mean(const Tensors& t) { return (t.xx + t.yy + t.zz) / packet(3); }
/// t + x I.
BURNISH_AVX2 Tensors with_mean(const Tensors& t, Packet x) { return {t.xx + x, t.yy + x, t.zz + x, t.xy}; }
BURNISH_AVX2 Tensors deviator(const Tensors& t) {
  const Packet m = mean(t);
  return {t.xx - m, t.yy - m, t.zz - m, t.xy};
}
BURNISH_AVX2 Packet contract(const Tensors& a, const Tensors& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + packet(2) * a.xy * b.xy;
}
BURNISH_AVX2 Packet product(const Tensors& a, const Tensors& b) { return packet(1.5) * contract(a, b); }
BURNISH_AVX2 Tensors rotated(const Tensors& t, Packet cos_2alpha, Packet sin_2alpha) {
  const Packet half = packet(0.5), middle = half * (t.xx + t.yy), difference = half * (t.xx - t.yy);
  const Packet turned = cos_2alpha * difference - sin_2alpha * t.xy;
  return {middle + turned, middle - turned, t.zz, sin_2alpha * difference + cos_2alpha * t.xy};
}

/// Rows to columns: out of four numbers of each of four points, or into them.
BURNISH_AVX2 void transpose(Packet& a, Packet& b, Packet& c, Packet& d) {
  const Packet ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b);
  const Packet cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
  a = _mm256_permute2f128_pd(ab0, cd0, 0x20);
  b = _mm256_permute2f128_pd(ab1, cd1, 0x20);
  c = _mm256_permute2f128_pd(ab0, cd0, 0x31);
  d = _mm256_permute2f128_pd(ab1, cd1, 0x31);
}
BURNISH_AVX2 Tensors load_tensors(const double* first) {
  Tensors t{_mm256_loadu_pd(first), _mm256_loadu_pd(first + 4), _mm256_loadu_pd(first + 8),
            _mm256_loadu_pd(first + 12)};
  transpose(t.xx, t.yy, t.zz, t.xy);
  return t;
}
BURNISH_AVX2 void store(Tensors t, double* first) {
  transpose(t.xx, t.yy, t.zz, t.xy);
  _mm256_storeu_pd(first, t.xx);
  _mm256_storeu_pd(first + 4, t.yy);
  _mm256_storeu_pd(first + 8, t.zz);
  _mm256_storeu_pd(first + 12, t.xy);
}
BURNISH_AVX2 Gradients load_gradients(const double* first) {
  Gradients g{_mm256_loadu_pd(first), _mm256_loadu_pd(first + 5), _mm256_loadu_pd(first + 10),
              _mm256_loadu_pd(first + 15), gathered(first + 4, 5)};
  transpose(g.xx, g.xy, g.yx, g.yy);
  return g;
}

} // namespace burnish::avx2
#endif
