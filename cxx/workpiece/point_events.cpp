#include "workpiece/point_events.hpp"
#include "base/error.hpp"
#include "workpiece/point_place.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace burnish {
namespace {

constexpr int VARIABLES = 11, PARTS = 8;
constexpr double NO_STRESS = 1e-300;
constexpr const char* WHERE = "PointEvents";
using Values = std::array<double, VARIABLES>;

// What is linear inside a step.
struct PointState {
  Stress<2> stress;
  double ep;
  Vector<2> x;
};

PointState point_state(const Discretization<2>& mesh, const WorkpieceState<2>& state, int point) {
  const std::size_t p = point;
  return {Eigen::Map<const Stress<2>>(state.stress.data() + num_stress<2> * p), state.plastic_strain_eq[p],
          point_place(mesh, point, state)};
}

// In the order of point_event_variables().
Values values_of(const PointState& a) {
  const Stress<2>& t = a.stress;
  const double middle = 0.5 * (t[0] + t[1]), radius = std::hypot(0.5 * (t[0] - t[1]), t[3]);
  return {a.ep,
          std::max(equivalent<2>(deviator<2>(t)), NO_STRESS),
          mean<2>(t),
          t[0],
          t[1],
          t[2],
          t[3],
          std::max(middle + radius, t[2]),
          std::min(middle - radius, t[2]),
          a.x[0],
          a.x[1]};
}

// A formula along one point's path through the step.
struct PointPath {
  const Formula& formula;
  PointState start, end;
  double operator()(double f) const {
    const PointState now{(1 - f) * start.stress + f * end.stress, (1 - f) * start.ep + f * end.ep,
                         (1 - f) * start.x + f * end.x};
    return formula(values_of(now).data());
  }
};

// Where the value passes through zero between a (value va < 0) and b (vb >= 0): regula falsi, the weights
// halved as in the Illinois rule, every third time the middle; ends on the side that is not below zero.
double rising_root(const PointPath& value, double a, double va, double b, double vb) {
  for (int it = 0; it < 200 && b - a > 1e-14 && vb != 0; ++it) {
    const double f = it % 3 == 2 ? 0.5 * (a + b) : a + (b - a) * va / (va - vb);
    const double inside = std::clamp(f, a + 0.01 * (b - a), b - 0.01 * (b - a)), v = value(inside);
    if (v < 0) {
      a = inside;
      va = v;
      vb *= 0.5;
    } else {
      b = inside;
      vb = v;
      va *= 0.5;
    }
  }
  return b;
}

// Calls happened(fraction) for every event of the path; `above` at its start in, at its end out.
template <class Happened>
void follow(const PointPath& value, double overshoot, char& above, const Happened& happened) {
  double a = 0, va = above ? 0 : value(0);
  for (int k = 1; k <= PARTS + (overshoot > 0); ++k) {
    const double b = k <= PARTS ? static_cast<double>(k) / PARTS : 1 + overshoot, vb = value(b);
    if (!above && vb >= 0) happened(std::min(rising_root(value, a, va, b, vb), 1.));
    if (k <= PARTS || vb >= 0) above = vb >= 0;
    a = b;
    va = vb;
  }
}

void check_name(const std::string& name) {
  if (name.empty() || name.find_first_of(",\"\n\r") != std::string::npos)
    fail(WHERE, "name \"" + name + "\", expected a text without comma, quote and line break");
}

} // namespace

const std::vector<std::string>& point_event_variables() {
  static const std::vector<std::string> names = {"ep",  "seq", "sm", "sxx", "syy", "szz",
                                                 "sxy", "s1",  "s3", "x",   "y"};
  return names;
}

template <int Dim>
void PointEvents<Dim>::add(const Workpiece<Dim>& body, const std::string& name, const std::string& formula,
                           const std::map<std::string, double>& parameters) {
  static_assert(Dim == 2, "names and principal stresses are those of the plane");
  check_name(name);
  for (const Event& known : m_events)
    if (known.name == name) fail(WHERE, "name \"" + name + "\" is taken");
  Event event{
      name, Formula("event \"" + name + "\"", formula, {point_event_variables(), parameters}), {}, {}};
  const int points = body.discretization().num_points();
  for (int p = 0; p < points; ++p)
    event.above.push_back(
        event.formula(values_of(point_state(body.discretization(), body.state_old(), p)).data()) >= 0);
  event.count.assign(points, 0);
  m_events.push_back(std::move(event));
}

template <int Dim> std::vector<ElementEvent<Dim>> PointEvents<Dim>::find(const Workpiece<Dim>& body) const {
  std::vector<ElementEvent<Dim>> found;
  const Discretization<Dim>& mesh = body.discretization();
  for (int p = 0; p < mesh.num_points() && !empty(); ++p) {
    const PointState start = point_state(mesh, body.state_old(), p), end = point_state(mesh, body.state(), p);
    for (const Event& event : m_events) {
      char above = event.above[p];
      follow({event.formula, start, end}, m_overshoot, above, [&](double f) {
        found.push_back({f, PointChange::SCRIPT, p, (1 - f) * start.x + f * end.x, event.name});
      });
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.fraction < b.fraction; });
  return found;
}

template <int Dim>
double PointEvents<Dim>::earliest(const Workpiece<Dim>& body, double overshoot, double least) {
  require(overshoot >= 0, WHERE, "overshoot", overshoot, ">= 0");
  m_overshoot = overshoot;
  for (const auto& event : find(body))
    if (event.fraction > least) return event.fraction;
  return 2;
}

template <int Dim> void PointEvents<Dim>::accept(const Workpiece<Dim>& body) {
  const Discretization<Dim>& mesh = body.discretization();
  for (int p = 0; p < mesh.num_points() && !empty(); ++p) {
    const PointState start = point_state(mesh, body.state_old(), p), end = point_state(mesh, body.state(), p);
    for (Event& event : m_events)
      follow({event.formula, start, end}, m_overshoot, event.above[p], [&](double) { ++event.count[p]; });
  }
  m_overshoot = 0;
}

template <int Dim>
const typename PointEvents<Dim>::Event& PointEvents<Dim>::event(const std::string& name) const {
  std::string known;
  for (const Event& event : m_events) {
    if (event.name == name) return event;
    known += (known.empty() ? "" : ", ") + event.name;
  }
  fail(WHERE, "no event \"" + name + "\", expected one of " + (known.empty() ? "none" : known));
}

template <int Dim> const std::vector<int>& PointEvents<Dim>::counts(const std::string& name) const {
  return event(name).count;
}

template <int Dim> long PointEvents<Dim>::number(const std::string& name) const {
  long sum = 0;
  for (const int n : event(name).count) sum += n;
  return sum;
}

template class PointEvents<2>;

} // namespace burnish
