#include "cad/occ/cad_search.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include <algorithm>
#include <array>

namespace burnish {

namespace {

constexpr double TURN = 0.1; // rad in a cell
constexpr int PARTS = 8;     // samples of a cell
constexpr int SCANNED = 16;  // parts of a cell that may hold several foot points
constexpr int MOST_CELL_HALVINGS = 16;
constexpr std::size_t GROUP = 16;

double distance_to_chord(const CadCell& cell, const Vector<2>& x) {
  const Vector<2> chord = cell.x[1] - cell.x[0], from = x - cell.x[0];
  const double length2 = chord.squaredNorm();
  const double part = length2 > 0 ? std::clamp(from.dot(chord) / length2, 0., 1.) : 0.;
  return (from - part * chord).norm();
}

/// A place on a piece seen from x: f = x_s.(x(s) - x) is zero at foot points.
struct View {
  double s, f, slope, distance;
};

View view_of(const CadPiece& piece, double s, const Vector<2>& x) {
  const CadValue at = piece.at(s);
  const Vector<2> d = at.x - x;
  return {s, at.first.dot(d), at.first.squaredNorm() + at.second.dot(d), d.norm()};
}

// Foot point between low and high: the zero of f by Newton within a bracket, or the nearer end.
CadFoot foot_between(const CadCell& cell, const CadPiece& piece, const Vector<2>& x, const View& low_end,
                     const View& high_end) {
  if (low_end.f >= 0 || high_end.f <= 0) {
    const bool first = low_end.f >= 0 && (high_end.f > 0 || low_end.distance <= high_end.distance);
    const View& end = first ? low_end : high_end;
    return {cell.piece, end.s, end.f == 0};
  }
  double low = low_end.s, high = high_end.s, s = low + (high - low) * low_end.f / (low_end.f - high_end.f);
  for (int round = 0; round < 60; ++round) {
    const View at = view_of(piece, s, x);
    const double newton = at.slope > 0 ? s - at.f / at.slope : high + 1;
    if (std::abs(newton - s) <= 1e-9 * (cell.end - cell.begin)) { // the next step would be below rounding
      s = std::clamp(newton, low_end.s, high_end.s);
      break;
    }
    (at.f < 0 ? low : high) = s;
    s = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return {cell.piece, s, true};
}

CadFoot foot_in(const CadCell& cell, const CadPiece& piece, const Vector<2>& x) {
  const auto end = [&](int k, double s) {
    const Vector<2> d = cell.x[k] - x;
    return View{s, cell.t[k].dot(d), 0, d.norm()};
  };
  const View first = end(0, cell.begin), last = end(1, cell.end);
  const double length = (cell.x[1] - cell.x[0]).norm();
  const bool near = (std::min(first.distance, last.distance) + length) * cell.curvature_bound < 1;
  if (near || (cell.hollow[0].dot(cell.x[0] - x) > 0 && cell.hollow[1].dot(cell.x[1] - x) > 0))
    return foot_between(cell, piece, x, first, last);
  // on the hollow side, about as far as the center of curvature, there may be several
  CadFoot best;
  double least = std::numeric_limits<double>::infinity();
  View before = first;
  for (int k = 1; k <= SCANNED; ++k) {
    const View after =
        k == SCANNED ? last : view_of(piece, cell.begin + (cell.end - cell.begin) * k / SCANNED, x);
    const CadFoot foot = foot_between(cell, piece, x, before, after);
    const double distance = (piece.at(foot.s).x - x).norm();
    if (distance < least || (distance == least && foot.normal)) {
      least = distance;
      best = foot;
    }
    before = after;
  }
  return best;
}

// What samples of a cell, its ends included, tell of the rest: a little more.
void bound(CadCell& cell, const std::array<CadValue, PARTS + 1>& samples) {
  bool left = true, right = true;
  double slowest = samples[0].first.squaredNorm();
  for (const CadValue& value : samples) {
    cell.sag = std::max(cell.sag, 1.3 * distance_to_chord(cell, value.x));
    cell.curvature_bound = std::max(cell.curvature_bound, 1.3 * value.second.norm());
    slowest = std::min(slowest, value.first.squaredNorm());
    const double side = left_of(value.first).dot(value.second);
    left = left && side > 0;
    right = right && side < 0;
  }
  cell.curvature_bound /= slowest;
  if (!left && !right) return;
  cell.hollow[0] = samples.front().second;
  cell.hollow[1] = samples.back().second;
}

} // namespace

CadSearch::CadSearch(const std::vector<CadPiece>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto knots = pieces[i].knots();
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) add(pieces[i], i, knots[k], knots[k + 1], 0);
  }
  make_groups();
}

void CadSearch::add(const CadPiece& piece, std::size_t index, double begin, double end, int depth) {
  std::array<CadValue, PARTS + 1> value;
  double turn = 0;
  for (int k = 0; k <= PARTS; ++k) {
    value[k] = piece.at(begin + (end - begin) * k / PARTS);
    const Vector<2>& t = value[k].first;
    if (!(t.norm() > 1e-6)) // 1 on average
      fail("CadCurve", "curve " + std::to_string(piece.tag()) + " has no tangent at " +
                           place_text(value[k].x, piece.length()));
    if (k == 0) continue;
    const Vector<2>& before = value[k - 1].first;
    turn += std::abs(std::atan2(left_of(before).dot(t), before.dot(t)));
  }
  if (turn > TURN && depth < MOST_CELL_HALVINGS) {
    add(piece, index, begin, (begin + end) / 2, depth + 1);
    return add(piece, index, (begin + end) / 2, end, depth + 1);
  }
  CadCell cell{index, begin, end, {value[0].x, value[PARTS].x}, {value[0].first, value[PARTS].first}, turn};
  bound(cell, value);
  cell.sag += 1e-14 * piece.length();
  m_cells.push_back(cell);
}

void CadSearch::make_groups() {
  for (std::size_t begin = 0; begin < m_cells.size(); begin += GROUP) {
    Group group{begin, std::min(begin + GROUP, m_cells.size()), {0, 0}, 0};
    const CadCell &first = m_cells[group.begin], &last = m_cells[group.end - 1];
    group.center = (first.x[0] + last.x[1]) / 2;
    for (std::size_t i = group.begin; i < group.end; ++i)
      for (const Vector<2>& x : m_cells[i].x)
        group.radius = std::max(group.radius, (x - group.center).norm() + m_cells[i].sag);
    m_groups.push_back(group);
  }
}

// Least distance that each cell of a group can have; returns what the chain surely reaches.
double CadSearch::reach_of(const Group& group, const Vector<2>& x, double reach,
                           std::vector<double>& nearest) const {
  for (std::size_t i = group.begin; i < group.end; ++i) {
    const double distance = distance_to_chord(m_cells[i], x);
    nearest[i] = distance - m_cells[i].sag;
    reach = std::min(reach, distance + m_cells[i].sag);
  }
  return reach;
}

CadFoot CadSearch::closest(const std::vector<CadPiece>& pieces, const std::vector<double>& start,
                           const Vector<2>& x, FootChoice& choice) const {
  const double infinity = std::numeric_limits<double>::infinity();
  thread_local std::vector<double> nearest, least;
  nearest.assign(m_cells.size(), infinity);
  least.clear();
  std::size_t first = 0;
  for (const Group& group : m_groups) {
    least.push_back((x - group.center).norm() - group.radius);
    if (least.back() < least[first]) first = least.size() - 1;
  }
  double reach = reach_of(m_groups[first], x, infinity, nearest);
  for (std::size_t g = 0; g < m_groups.size(); ++g)
    if (g != first && least[g] <= reach) reach = reach_of(m_groups[g], x, reach, nearest);
  CadFoot best;
  for (std::size_t i = 0; i < m_cells.size(); ++i) {
    if (nearest[i] > reach || choice.beyond(nearest[i])) continue;
    const CadFoot foot = foot_in(m_cells[i], pieces[m_cells[i].piece], x);
    const double distance = (pieces[foot.piece].at(foot.s).x - x).norm();
    if (choice.offer(start[foot.piece] + foot.s, distance, foot.normal)) best = foot;
  }
  return best;
}

} // namespace burnish
