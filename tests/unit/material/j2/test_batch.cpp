// Points of J2 updated several at a time: the same bits as one by one, and the same first point that fails.
#include "material/formula_hardening.hpp"
#include "material/j2/batch/kernel.hpp"
#include "unit/material/j2/point_walk.hpp"
#include <cstring>
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

/// What an update of a range writes; numbers that nobody wrote are NaN.
struct Found {
  std::vector<double> stress, internal, strain_increment;
  std::vector<char> plastic;
  std::vector<PointTrial> trial;
  Found(std::size_t size, int num_internal, std::vector<PointTrial> before)
      : stress(4 * size, NONE), internal(num_internal * size, NONE), strain_increment(4 * size, NONE),
        plastic(size, 2), trial(std::move(before)) {}
  RangeUpdate<2> view() {
    return {stress.data(), internal.data(), strain_increment.data(), plastic.data(), trial.data()};
  }
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Points with random states and steps.
struct Points {
  int size, num_internal;
  std::vector<double> F_old, stress, internal, strain_increment, F;
  std::vector<char> plastic;
  std::vector<PointTrial> trial;
  UpdateOptions options;
  double ratio = 0.8;
  int iteration = 0;

  /// @param yield of the law at ep = 0; stresses are up to 1.2 of it, steps up to some three of it
  Points(int size, int num_internal, double yield, unsigned seed) : size(size), num_internal(num_internal) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> one(-1, 1);
    const double strain = yield / 2.7e10;
    for (int p = 0; p < size; ++p) {
      const double turn = 0.3 * one(random), step_size = strain * std::pow(10, 1.5 * one(random) - 0.5);
      const Tensor<2> start =
          rotation(turn) * tensor(1 + 0.1 * one(random), 0.1 * one(random), 0.1 * one(random), 1);
      const Tensor<2> step =
          rotation(0.05 * one(random)) * tensor(1 + step_size * one(random), step_size * one(random),
                                                step_size * one(random), 1 + step_size * one(random));
      const double zz = 1 + 0.02 * one(random);
      append(F_old, gradient(start, zz));
      append(F, gradient(step * start, zz * (p % 3 ? 1 + step_size * one(random) : 1)));
      Stress<2> s = Stress<2>::NullaryExpr([&] { return one(random); });
      s *= yield * (1.2 * std::abs(one(random))) / equivalent<2>(deviator<2>(s));
      append(stress, s);
      append(strain_increment, Stress<2>::NullaryExpr([&] { return step_size * one(random); }));
      for (int k = 0; k < num_internal; ++k)
        internal.push_back(k == 0 ? 0.1 * std::abs(one(random)) : 0.1 * yield * one(random));
      plastic.push_back(one(random) > 0.6);
      trial.push_back({});
    }
  }
  template <class Numbers> static void append(std::vector<double>& to, const Numbers& numbers) {
    for (const double x : numbers) to.push_back(x);
  }
  RangeStep<2> step() const {
    return {size,           F_old.data(), stress.data(), internal.data(), strain_increment.data(),
            plastic.data(), num_internal, F.data(),      ratio,           iteration,
            options};
  }
  Found nothing() const { return Found(size, num_internal, trial); }
  void set_F(int p, const Gradient<2>& value) { std::copy(value.begin(), value.end(), F.begin() + 5 * p); }
  /// Of the points after an update, for the next iteration.
  void go_on(const Found& found) {
    trial = found.trial;
    ++iteration;
  }
};

/// How many points were elastic, crossed the yield surface, started on it.
struct Counts {
  int elastic = 0, crossing = 0, plastic = 0;
  void add(const Points& points, const Found& found) {
    for (int p = 0; p < points.size; ++p) {
      if (!found.plastic[p]) ++elastic;
      if (found.plastic[p]) ++(points.plastic[p] ? plastic : crossing);
    }
  }
};

void expect_same(const Found& found, const Found& expected) {
  EXPECT_TRUE(same_bits(found.stress, expected.stress));
  EXPECT_TRUE(same_bits(found.internal, expected.internal));
  EXPECT_TRUE(same_bits(found.strain_increment, expected.strain_increment));
  EXPECT_EQ(found.plastic, expected.plastic);
  for (std::size_t p = 0; p < expected.trial.size(); ++p) {
    EXPECT_EQ(found.trial[p].substeps, expected.trial[p].substeps) << "point " << p;
    EXPECT_EQ(found.trial[p].used, expected.trial[p].used) << "point " << p;
  }
}

/// One by one, as a law does that knows no better.
RangeResult one_by_one(const J2Law<2>& law, const Points& points, Found& found) {
  return law.MaterialLaw<2>::update_range(points.step(), found.view());
}

J2Parameters with_formula(const char* text, bool softening = false) {
  return {example_material().elastic, formula_hardening(text, softening, "test_batch")};
}
std::vector<J2Parameters> covered_materials() {
  return {example_material(), example_material(1.93e8, 0), with_formula("193e6*(1+ep/0.002)^0.2")};
}

} // namespace

// All options of the kernel, over the iterations of a step in which numbers of substeps are frozen.
TEST(J2Batch, KernelFindsTheBitsOfTheLaw) {
  const J2Kernel kernel = j2_kernel();
#if defined(__x86_64__)
  EXPECT_EQ(kernel.update != nullptr, __builtin_cpu_supports("avx2") != 0);
#else
  EXPECT_EQ(kernel.update, nullptr);
#endif
  if (!kernel.update) return; // ranges are updated one by one, which the tests below compare
  Counts counts;
  unsigned seed = 1;
  for (const J2Parameters& material : covered_materials())
    for (const StrainFrame frame : {StrainFrame::END, StrainFrame::MIDPOINT})
      for (const double limit : {0., 1.5, std::numeric_limits<double>::infinity()})
        for (const double ratio : {0., 0.7}) {
          const J2Law<2> law(material);
          Points points(203, 1, 1.93e8, ++seed);
          points.options.strain_frame = frame;
          points.options.path_limit = limit;
          points.ratio = ratio;
          ASSERT_TRUE(covered(material, points.options));
          for (int iteration = 0; iteration < 5; ++iteration) {
            Found expected = points.nothing(), found = points.nothing();
            ASSERT_EQ(one_by_one(law, points, expected).point, -1);
            const int end = 203 / kernel.width * kernel.width;
            EXPECT_EQ(kernel.update(material, points.step(), 0, found.view()), end);
            EXPECT_TRUE(std::isnan(found.stress[4 * end])); // not touched
            EXPECT_EQ(law.update_range(points.step(), found.view()).point, -1);
            expect_same(found, expected);
            counts.add(points, found);
            points.go_on(found);
            Points other(203, 1, 1.93e8, ++seed); // other steps; the trials stay
            points.F = other.F;
            points.F_old = other.F_old;
          }
        }
  EXPECT_GT(counts.elastic, 5000);
  EXPECT_GT(counts.crossing, 5000);
  EXPECT_GT(counts.plastic, 2000);
}

// Ranges too short for the kernel, and ends of longer ones.
TEST(J2Batch, AnyNumberOfPoints) {
  for (const J2Parameters& material : covered_materials())
    for (int size = 0; size <= 13; ++size) {
      const J2Law<2> law(material);
      const Points points(size, 1, 1.93e8, 100 + size);
      Found expected = points.nothing(), found = points.nothing();
      EXPECT_EQ(one_by_one(law, points, expected).point, -1);
      EXPECT_EQ(law.update_range(points.step(), found.view()).point, -1);
      expect_same(found, expected);
    }
}

TEST(J2Batch, WhatItDoesNotCoverGoesOneByOne) {
  J2Parameters backstress = example_material(), turning = example_material();
  backstress.kinematic.modulus = 1e9;
  turning.rate = CorotationalRate::LOGARITHMIC;
  UpdateOptions single, euler;
  single.update = StressUpdate::SINGLE;
  euler.update = StressUpdate::FORWARD_EULER;
  const std::pair<J2Parameters, UpdateOptions> cases[] = {
      {backstress, {}}, {turning, {}}, {example_material(), single}, {example_material(), euler}};
  for (const auto& [material, options] : cases) {
    EXPECT_FALSE(covered(material, options));
    const J2Law<2> law(material);
    Points points(21, law.internal_variables().size(), 1.93e8, 7);
    points.options.update = options.update;
    Found expected = points.nothing(), found = points.nothing();
    EXPECT_EQ(one_by_one(law, points, expected).point, -1);
    EXPECT_EQ(law.update_range(points.step(), found.view()).point, -1);
    expect_same(found, expected);
  }
}

// A point inside out at half of its step, one that is not finite there, one without a yield stress: wherever it stands, alone or
// before another one.
TEST(J2Batch, TheFirstPointThatFailsIsReported) {
  const J2Parameters softening = with_formula("193e6*(1-8*ep)", true);
  const J2Law<2> law(softening);
  Points sound(14, 1, 1.93e8, 3);
  std::fill(sound.internal.begin(), sound.internal.end(), 0.01);
  std::fill(sound.plastic.begin(), sound.plastic.end(), 0);
  const std::pair<Tensor<2>, UpdateStatus> wrong[] = {
      {tensor(-3, 0, 0, -0.5), UpdateStatus::INVERTED_ELEMENT},
      {tensor(1e200, 0, 0, 1e200), UpdateStatus::NOT_FINITE},
      {tensor(NONE, 0, 0, 1), UpdateStatus::NOT_FINITE},
      {tensor(1.3, 0, 0, 0.8), UpdateStatus::NO_RETURN}};
  for (const auto& [F, status] : wrong)
    for (int first = 0; first < sound.size; ++first)
      for (int second = first; second < sound.size; ++second) {
        Points points = sound;
        const Gradient<2> undeformed_start = undeformed<2>();
        std::copy(undeformed_start.begin(), undeformed_start.end(), points.F_old.begin() + 5 * first);
        points.set_F(first, gradient(F));
        if (second > first) points.set_F(second, gradient(tensor(NONE, 0, 0, 1)));
        Found expected = points.nothing(), found = points.nothing();
        const RangeResult is = law.update_range(points.step(), found.view());
        const RangeResult should = one_by_one(law, points, expected);
        ASSERT_EQ(should.point, first);
        ASSERT_EQ(should.result.status, status);
        EXPECT_EQ(is.point, should.point);
        EXPECT_EQ(is.result.status, should.result.status);
        EXPECT_EQ(std::memcmp(&is.result.value, &should.result.value, sizeof(double)), 0);
        EXPECT_EQ(std::memcmp(found.stress.data(), expected.stress.data(), 4 * first * sizeof(double)), 0);
        EXPECT_EQ(found.trial[first].substeps, expected.trial[first].substeps);
      }
}
