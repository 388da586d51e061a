#include "workpiece/point_events.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include <algorithm>
#include <cmath>
#include <iomanip>

namespace burnish {
namespace {

constexpr const char* POINT_EVENTS = "PointEvents";
/// A formula is evaluated at this many equal parts of a step.
constexpr int PARTS = 8;
/// Of a root: passes, its error as a fraction of the step, and the least share of the bracket that a pass takes off.
constexpr int MAX_PASSES = 200;
constexpr double ROOT_ERROR = 1e-14, LEAST_SHARE = 0.01;

// A formula along one point's path through the step.
template <int Dim> struct PointPath {
  using Sample = typename PointVariables<Dim>::Sample;
  const Formula& formula;
  const PointVariables<Dim>& variables;
  const Sample &start, &end;
  std::vector<double>& values; // room for them
  double operator()(double f) const {
    variables.values(start, end, f, values.data());
    return formula(values.data());
  }
};

// Where the value passes through zero between a (value va < 0) and b (vb >= 0): regula falsi, the weights
// halved [DowellJarratt1971], every third time the middle; ends on the side that is not below zero.
template <class Value> double rising_root(const Value& value, double a, double va, double b, double vb) {
  for (int it = 0; it < MAX_PASSES && b - a > ROOT_ERROR && vb != 0; ++it) {
    const double f = it % 3 == 2 ? 0.5 * (a + b) : a + (b - a) * va / (va - vb);
    const double inside = std::clamp(f, a + LEAST_SHARE * (b - a), b - LEAST_SHARE * (b - a));
    const double v = value(inside);
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
template <class Value, class Happened>
void follow(const Value& value, double overshoot, char& above, const Happened& happened) {
  double a = 0, va = above ? 0 : value(0);
  for (int k = 1; k <= PARTS + (overshoot > 0); ++k) {
    const double b = k <= PARTS ? static_cast<double>(k) / PARTS : 1 + overshoot, vb = value(b);
    if (!above && vb >= 0) happened(std::min(rising_root(value, a, va, b, vb), 1.));
    if (k <= PARTS || vb >= 0) above = vb >= 0;
    a = b;
    va = vb;
  }
}

// Calls visit(point, start, end, k, path) for all points and formulas of the step.
template <int Dim, class Visit>
void for_each_path(const Workpiece<Dim>& body, const std::vector<Formula>& formulas, const Visit& visit) {
  if (formulas.empty()) return;
  const PointVariables<Dim> variables(body.law());
  std::vector<double> values(variables.names().size());
  for (int p = 0; p < body.discretization().num_points(); ++p) {
    const auto start = variables.sample(body, body.state_old(), p),
               end = variables.sample(body, body.state(), p);
    for (std::size_t k = 0; k < formulas.size(); ++k)
      visit(p, start, end, k, PointPath<Dim>{formulas[k], variables, start, end, values});
  }
}

void check_name(const std::string& name) {
  if (name.empty() || name.find_first_of(",\"\n\r") != std::string::npos)
    fail(POINT_EVENTS, "name \"" + name + "\", expected a text without comma, quote and line break");
}

const PointEventState& event_named(const PointEventsState& state, const std::string& name) {
  std::string known;
  for (const PointEventState& event : state) {
    if (event.name == name) return event;
    known += (known.empty() ? "" : ", ") + event.name;
  }
  fail(POINT_EVENTS, "no event \"" + name + "\", expected one of " + (known.empty() ? "none" : known));
}

} // namespace

template <int Dim>
int PointEvents<Dim>::add(const Workpiece<Dim>& body, const std::string& name, const std::string& formula,
                          const std::map<std::string, double>& parameters) {
  check_name(name);
  for (const PointEventState& known : m_state)
    if (known.name == name) fail(POINT_EVENTS, "name \"" + name + "\" is taken");
  const PointVariables<Dim> variables(body.law());
  const Formula parsed("event \"" + name + "\"", formula, {variables.names(), parameters});
  const int points = body.discretization().num_points();
  PointEventState event{name, {}, std::vector<int>(points, 0)};
  std::vector<double> values(variables.names().size());
  for (int p = 0; p < points; ++p) {
    const auto at = variables.sample(body, body.state_old(), p);
    variables.values(at, at, 0, values.data());
    event.above.push_back(parsed(values.data()) >= 0);
  }
  const auto above = std::count(event.above.begin(), event.above.end(), 1);
  m_formulas.push_back(parsed);
  std::string& words = m_words[name] = "\"" + formula + "\"";
  for (const auto& [parameter, value] : parameters)
    words += sentence(std::setprecision(17), " ", parameter, " ", value);
  m_state.push_back(std::move(event));
  return static_cast<int>(above);
}

template <int Dim> std::vector<ElementEvent<Dim>> PointEvents<Dim>::find(const Workpiece<Dim>& body) const {
  std::vector<ElementEvent<Dim>> found;
  for_each_path(
      body, m_formulas, [&](int p, const auto& start, const auto& end, std::size_t k, const auto& path) {
        char above = m_state[k].above[p];
        follow(path, m_overshoot, above, [&](double f) {
          found.push_back({f, PointChange::USER, p, (1 - f) * start.x + f * end.x, m_state[k].name});
        });
      });
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.fraction < b.fraction; });
  return found;
}

template <int Dim> double PointEvents<Dim>::earliest(const Workpiece<Dim>& body, double least) const {
  for (const auto& event : find(body))
    if (event.fraction > least) return event.fraction;
  return 2;
}

template <int Dim> void PointEvents<Dim>::set_overshoot(double overshoot) {
  require(overshoot >= 0, POINT_EVENTS, "overshoot", overshoot, ">= 0");
  m_overshoot = overshoot;
}

template <int Dim> void PointEvents<Dim>::accept(const Workpiece<Dim>& body) {
  PointEventsState next = m_state;
  for_each_path(body, m_formulas, [&](int p, const auto&, const auto&, std::size_t k, const auto& path) {
    follow(path, m_overshoot, next[k].above[p], [&](double) { ++next[k].count[p]; });
  });
  m_state = std::move(next);
  m_overshoot = 0;
}

template <int Dim> void PointEvents<Dim>::set_state(const PointEventsState& state) {
  const char* where = "PointEvents::set_state";
  require(state.size() == m_state.size(), where, "number of events", state.size(),
          std::to_string(m_state.size()).c_str());
  for (std::size_t k = 0; k < state.size(); ++k) {
    const std::size_t points = m_state[k].count.size();
    require(state[k].name == m_state[k].name, where, "name", state[k].name, m_state[k].name.c_str());
    require(state[k].above.size() == points && state[k].count.size() == points, where,
            "number of points of above and count", std::min(state[k].above.size(), state[k].count.size()),
            std::to_string(points).c_str());
  }
  m_state = state;
  m_overshoot = 0;
}

template <int Dim> void PointEvents<Dim>::take_points(const std::vector<int>& origin) {
  for (PointEventState& event : m_state) {
    const PointEventState before = event;
    event.above.clear();
    event.count.clear();
    for (const int p : origin) {
      event.above.push_back(before.above.at(static_cast<std::size_t>(p)));
      event.count.push_back(before.count.at(static_cast<std::size_t>(p)));
    }
  }
  m_overshoot = 0;
}

template <int Dim> const std::vector<int>& PointEvents<Dim>::counts(const std::string& name) const {
  return event_named(m_state, name).count;
}

template <int Dim> long PointEvents<Dim>::number(const std::string& name) const {
  long sum = 0;
  for (const int n : counts(name)) sum += n;
  return sum;
}

template class PointEvents<2>;
template class PointEvents<3>;

} // namespace burnish
