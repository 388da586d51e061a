#include "geometry/cad_search.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

namespace {

constexpr double TURN = 0.1; // rad in a cell
constexpr int MOST_HALVINGS = 16;
constexpr std::size_t GROUP = 16;

double distance_to_chord(const CadCell& cell, const Vector<2>& x) {
  const Vector<2> chord = cell.x[1] - cell.x[0], from = x - cell.x[0];
  const double length2 = chord.squaredNorm();
  const double part = length2 > 0 ? std::clamp(from.dot(chord) / length2, 0., 1.) : 0.;
  return (from - part * chord).norm();
}

// Foot point within a cell: the zero of f = x_s.(x(s) - x) between the ends, by Newton within a bracket.
CadFoot foot_in(const CadCell& cell, const CadPiece& piece, const Vector<2>& x) {
  const double f0 = cell.t[0].dot(cell.x[0] - x), f1 = cell.t[1].dot(cell.x[1] - x);
  if (f0 >= 0 || f1 <= 0) {
    const bool nearer = (cell.x[0] - x).norm() <= (cell.x[1] - x).norm();
    const bool first = f0 >= 0 && (f1 > 0 || nearer);
    return {cell.piece, first ? cell.begin : cell.end, (first ? f0 : f1) == 0};
  }
  double low = cell.begin, high = cell.end, s = low + (high - low) * f0 / (f0 - f1);
  for (int round = 0; round < 60; ++round) {
    const CadValue at = piece.at(s);
    const Vector<2> d = at.x - x;
    const double f = at.first.dot(d), slope = at.first.squaredNorm() + at.second.dot(d);
    const double newton = slope > 0 ? s - f / slope : high + 1;
    if (std::abs(newton - s) <= 1e-9 * (cell.end - cell.begin)) { // the next step would be below rounding
      s = std::clamp(newton, cell.begin, cell.end);
      break;
    }
    (f < 0 ? low : high) = s;
    s = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return {cell.piece, s, true};
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
  constexpr int PARTS = 8;
  CadValue value[PARTS + 1];
  double turn = 0;
  for (int k = 0; k <= PARTS; ++k) {
    value[k] = piece.at(begin + (end - begin) * k / PARTS);
    const Vector<2>& t = value[k].first;
    if (!(t.norm() > 1e-6)) { // 1 on average
      std::ostringstream place;
      place << value[k].x.x() << ", " << value[k].x.y();
      fail("CadCurve", "curve " + std::to_string(piece.tag()) + " has no tangent at (" + place.str() + ")");
    }
    if (k == 0) continue;
    const Vector<2>& before = value[k - 1].first;
    turn += std::abs(std::atan2(left_of(before).dot(t), before.dot(t)));
  }
  if (turn > TURN && depth < MOST_HALVINGS) {
    add(piece, index, begin, (begin + end) / 2, depth + 1);
    return add(piece, index, (begin + end) / 2, end, depth + 1);
  }
  CadCell cell{index, begin, end, {value[0].x, value[PARTS].x}, {value[0].first, value[PARTS].first}, 0};
  for (const CadValue& v : value) cell.sag = std::max(cell.sag, distance_to_chord(cell, v.x));
  cell.sag = 1.3 * cell.sag + 1e-14 * piece.length(); // of samples: a little more
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
