// From corners and radii to lines and arcs, and everything that can be wrong with them.
#include "base/error.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

namespace {

constexpr const char* ARC_CHAIN = "ArcChain";
constexpr double STRAIGHT = 1e-9; // rad: no corner
constexpr double ROUNDING = 1e-12;

std::string text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}
std::string text(const Vector<2>& x) { return "(" + text(x.x()) + ", " + text(x.y()) + ")"; }

// A number that still fits when it is typed again.
std::string at_most(double value) {
  if (!(value > 0)) return "0";
  const double digit = std::pow(10, std::floor(std::log10(value)) - 5);
  return text(std::floor(value / digit + 1e-9) * digit);
}

class Builder {
public:
  Builder(const std::vector<Vector<2>>& points, const std::vector<double>& radii, bool closed)
      : m_points(points), m_radii(radii), m_closed(closed), m_n(points.size()) {}
  std::vector<ArcPiece> build();

private:
  std::size_t next(std::size_t i) const { return (i + 1) % m_n; }
  std::size_t edges() const { return m_closed ? m_n : m_n - 1; }
  bool has_corner(std::size_t i) const { return m_closed || (i > 0 && i + 1 < m_n); }
  std::string name(std::size_t i) const { return "point " + std::to_string(i) + " at " + text(m_points[i]); }
  void check_input() const;
  void measure();
  void check_corners() const;
  void check_room() const;
  void add(const ArcPiece& piece, const std::string& label);
  void check_arc(std::size_t i) const;
  bool on_the_way(std::size_t i, std::size_t j, const Vector<2>& x) const;
  void check_crossings() const;

  const std::vector<Vector<2>>& m_points;
  const std::vector<double>& m_radii;
  bool m_closed;
  std::size_t m_n;
  double m_size = 0;
  std::vector<Vector<2>> m_tangent;          // of the edge that begins at each point
  std::vector<double> m_edge, m_turn, m_cut; // edge length; turn at each point; length its fillet takes
  std::vector<ArcPiece> m_pieces;
  std::vector<std::string> m_labels;
};

void Builder::check_input() const {
  const std::size_t least = m_closed ? 3 : 2;
  require(m_n >= least, ARC_CHAIN, "number of points", m_n, m_closed ? "at least 3 (closed)" : "at least 2");
  require(m_radii.size() == m_n, ARC_CHAIN, "number of radii", m_radii.size(),
          ("one per point: " + std::to_string(m_n)).c_str());
  for (std::size_t i = 0; i < m_n; ++i) {
    const std::string point = "point " + std::to_string(i), radius = "radius at " + point;
    require(m_points[i].allFinite(), ARC_CHAIN, point.c_str(), text(m_points[i]), "finite components");
    require(std::isfinite(m_radii[i]) && m_radii[i] >= 0, ARC_CHAIN, radius.c_str(), m_radii[i],
            "a finite number >= 0");
    if (!has_corner(i))
      require(m_radii[i] == 0, ARC_CHAIN, radius.c_str(), m_radii[i], "0 at the end of an open chain");
  }
}

void Builder::measure() {
  for (const Vector<2>& p : m_points) m_size = std::max(m_size, (p - m_points[0]).norm());
  m_tangent.resize(m_n);
  m_edge.resize(m_n);
  for (std::size_t i = 0; i < edges(); ++i) {
    const Vector<2> edge = m_points[next(i)] - m_points[i];
    m_edge[i] = edge.norm();
    if (m_edge[i] <= ROUNDING * m_size)
      fail(ARC_CHAIN,
           "points " + std::to_string(i) + " and " + std::to_string(next(i)) + " are the same, " +
               text(m_points[i]) +
               (m_closed && next(i) == 0 ? ": a closed chain returns to its first point by itself" : ""));
    m_tangent[i] = edge / m_edge[i];
  }
  m_turn.assign(m_n, 0);
  m_cut.assign(m_n, 0);
  for (std::size_t i = 0; i < m_n; ++i) {
    if (!has_corner(i)) continue;
    const Vector<2>&in = m_tangent[(i + m_n - 1) % m_n], &out = m_tangent[i];
    m_turn[i] = std::atan2(left_of(in).dot(out), in.dot(out));
    if (std::abs(m_turn[i]) > STRAIGHT) m_cut[i] = m_radii[i] * std::tan(std::abs(m_turn[i]) / 2);
  }
}

void Builder::check_corners() const {
  for (std::size_t i = 0; i < m_n; ++i) {
    const double turn = std::abs(m_turn[i]);
    if (turn <= STRAIGHT) continue;
    if (turn >= M_PI - STRAIGHT) fail(ARC_CHAIN, "the chain turns back on itself at " + name(i));
    if (m_radii[i] > 0) continue;
    const std::size_t before = (i + m_n - 1) % m_n;
    const double room = std::min(m_edge[before] - m_cut[before], m_edge[i] - m_cut[next(i)]);
    const std::string advice = room > ROUNDING * m_size
                                   ? ", up to " + at_most(room / std::tan(turn / 2)) + " fits there"
                                   : " and its neighbors smaller ones, which leave no room";
    fail(ARC_CHAIN, name(i) + " is a corner of " + text(turn * 180 / M_PI) +
                        " degrees without fillet; give it a radius > 0" + advice);
  }
}

void Builder::check_room() const {
  for (std::size_t i = 0; i < edges(); ++i) {
    const std::size_t j = next(i);
    const double need = m_cut[i] + m_cut[j];
    if (need <= m_edge[i] + ROUNDING * m_size) continue;
    const auto fillet = [&](std::size_t k) {
      return "radius " + text(m_radii[k]) + " at point " + std::to_string(k) + " takes " + text(m_cut[k]);
    };
    std::string what = m_cut[j] == 0 ? fillet(i) : m_cut[i] == 0 ? fillet(j) : fillet(i) + ", " + fillet(j);
    fail(ARC_CHAIN, "no room for the fillets between " + name(i) + " and " + name(j) +
                        ": their distance is " + text(m_edge[i]) + ", " + what + "; " +
                        at_most(m_edge[i] / need) + " times the radii would fit");
  }
}

void Builder::add(const ArcPiece& piece, const std::string& label) {
  if (piece.length <= ROUNDING * m_size) return;
  m_pieces.push_back(piece);
  m_labels.push_back(label);
}

void Builder::check_arc(std::size_t i) const {
  const double turn = std::abs(m_turn[i]), least = ROUNDING * m_size;
  if (m_radii[i] * turn > least) return;
  fail(ARC_CHAIN, "radius " + text(m_radii[i]) + " at " + name(i) + " is too small for a corner of " +
                      text(turn * 180 / M_PI) + " degrees in a chain of size " + text(m_size) +
                      "; give it more than " + text(least / turn));
}

// A chain that turns by less than 180 degrees on the way from one point to the other does not come back: the
// two are close because little lies between them.
bool Builder::on_the_way(std::size_t i, std::size_t j, const Vector<2>& x) const {
  double turn = 0, between = 0;
  for (std::size_t k = 0; k < m_pieces.size(); ++k) {
    const ArcPiece& piece = m_pieces[k];
    const double sharpness = std::abs(piece.curvature), from = k == i ? piece.closest(x, 0).s : 0;
    const double to = k == j ? piece.closest(x, 0).s : piece.length;
    turn += sharpness * piece.length;
    if (k >= i && k <= j) between += sharpness * (to - from);
  }
  return between < M_PI || (m_closed && turn - between < M_PI);
}

void Builder::check_crossings() const {
  const std::size_t n = m_pieces.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (m_closed && i == 0 && j == n - 1) continue; // neighbors
      for (const Vector<2>& x : common_points(m_pieces[i], m_pieces[j], STRAIGHT * m_size)) {
        if (on_the_way(i, j, x)) continue;
        const bool ends =
            i == 0 && j == n - 1 && (m_points.front() - m_points.back()).norm() <= STRAIGHT * m_size;
        fail(ARC_CHAIN, "the chain crosses or touches itself at " + text(x) + ": " + m_labels[i] + " and " +
                            m_labels[j] +
                            (ends ? " (if it is meant to be closed: closed, without the last point)" : ""));
      }
    }
}

std::vector<ArcPiece> Builder::build() {
  check_input();
  measure();
  check_corners();
  check_room();
  for (std::size_t i = 0; i < edges(); ++i) {
    const std::size_t j = next(i);
    const Vector<2>& t = m_tangent[i];
    add({m_points[i] + m_cut[i] * t, t, 0, m_edge[i] - m_cut[i] - m_cut[j]},
        "the line from point " + std::to_string(i) + " to point " + std::to_string(j));
    if (m_cut[j] == 0) continue;
    check_arc(j);
    const double turn = m_turn[j], R = m_radii[j];
    add({m_points[j] - m_cut[j] * t, t, std::copysign(1 / R, turn), R * std::abs(turn)},
        "the fillet at point " + std::to_string(j));
  }
  check_crossings();
  return std::move(m_pieces);
}

} // namespace

std::vector<ArcPiece> filleted(const std::vector<Vector<2>>& points, const std::vector<double>& radii,
                               bool closed) {
  return Builder(points, radii, closed).build();
}

} // namespace burnish
