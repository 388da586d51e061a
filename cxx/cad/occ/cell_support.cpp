#include "cad/occ/cell_support.hpp"
#include "base/error.hpp"
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>

namespace burnish {

namespace {

constexpr double CELL_TURN = 0.25;  // rad between normals of a cell and the one amid it
constexpr int CELL_SAMPLES = 5;     // along each side
constexpr int MOST_CELL_DEPTH = 14; // of halving
constexpr double CELL_MARGIN = 1.5,
                 SIDE_MARGIN = 1.05; // what samples tell of the rest: of the sag, of the sides
constexpr double BEYOND = 0.02;      // of the range of a parameter that Newton may leave the face's box by
constexpr double BESIDE = 0.3;       // of a cell's sides that it may leave the cell by
constexpr double HINT_ROOM = 0.25;   // of the hint on both sides of the box
constexpr int MOST_KEPT = 3;         // steps that end where a search may not go on: the foot is elsewhere
constexpr int MOST_NEWTON = 50, MOST_BACKTRACKS = 6;
constexpr double LAST_STEP = 1e-8, NO_STEP = 1e-14; // of the size; the first where Newton's method is certain
constexpr double SLOW = 1e-6;                       // steps that do for a foot where it is not

bool within_range(double x, double begin, double end, double room) {
  const double more = room * (end - begin);
  return x >= begin - more && x <= end + more;
}

} // namespace

CellSupport::Value CellSupport::value(double u, double v) const {
  gp_Pnt x;
  gp_Vec first_u, first_v, second_u, second_v, mixed;
  try {
    m_surface->D2(u, v, x, first_u, first_v, second_u, second_v, mixed);
  } catch (const Standard_Failure&) {
    const Vector<3> none = Vector<3>::Constant(std::numeric_limits<double>::quiet_NaN());
    return {none, none, none, none, none, none};
  }
  return {from_occ(x.XYZ()),        from_occ(first_u.XYZ()), from_occ(first_v.XYZ()),
          from_occ(second_u.XYZ()), from_occ(mixed.XYZ()),   from_occ(second_v.XYZ())};
}

CellSupport::CellSupport(const FaceData& data) : m_surface(BRep_Tool::Surface(data.face)), m_data(data) {
  const Value amid = value(data.u, data.v);
  m_side = amid.u.cross(amid.v).dot(data.n) < 0 ? -1 : 1;
  const auto u = knots(true), v = knots(false);
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    for (std::size_t j = 0; j + 1 < v.size(); ++j) add(u[i], u[i + 1], v[j], v[j + 1], 0);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Cell& cell : m_cells) {
    const Vector<3> half = cell.axes.cwiseAbs() * cell.half;
    boxes.emplace_back(cell.center - half, cell.center + half);
  }
  m_tree = BoxTree(boxes);
}

// Where derivatives jump, within the face's box.
std::vector<double> CellSupport::knots(bool along_u) const {
  GeomAdaptor_Surface surface(m_surface, m_data.u0, m_data.u1, m_data.v0, m_data.v1);
  const int count = along_u ? surface.NbUIntervals(GeomAbs_C2) : surface.NbVIntervals(GeomAbs_C2);
  TColStd_Array1OfReal places(1, count + 1);
  along_u ? surface.UIntervals(places, GeomAbs_C2) : surface.VIntervals(places, GeomAbs_C2);
  const double begin = along_u ? m_data.u0 : m_data.v0, end = along_u ? m_data.u1 : m_data.v1;
  std::vector<double> knots{begin};
  for (const double place : places)
    if (place > knots.back() + 1e-9 * (end - begin) && place < end - 1e-9 * (end - begin))
      knots.push_back(place);
  knots.push_back(end);
  return knots;
}

void CellSupport::add(double u0, double u1, double v0, double v1, int depth) {
  constexpr int n = CELL_SAMPLES - 1;
  std::vector<Value> values;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) values.push_back(value(u0 + (u1 - u0) * i / n, v0 + (v1 - v0) * j / n));
  for (const Value& at : values)
    if (!(at.x.allFinite() && at.uu.allFinite() && at.vv.allFinite()))
      fail("CadSurface", m_data.name + " has points or derivatives that are not finite");
  const auto normal = [&](int i, int j) -> Vector<3> {
    const Value& at = values[static_cast<std::size_t>(i * CELL_SAMPLES + j)];
    return at.u.cross(at.v).normalized();
  };
  double along_u = 0, along_v = 0; // (at a pole a normal is not defined: comparisons are false)
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double of_u = (normal(i, j) - normal(n / 2, j)).norm(),
                   of_v = (normal(i, j) - normal(i, n / 2)).norm();
      if (of_u > along_u) along_u = of_u;
      if (of_v > along_v) along_v = of_v;
    }
  if (std::max(along_u, along_v) > CELL_TURN && depth < MOST_CELL_DEPTH) {
    const double u = (u0 + u1) / 2, v = (v0 + v1) / 2;
    const bool halve_u = along_u > along_v;
    add(u0, halve_u ? u : u1, v0, halve_u ? v1 : v, depth + 1);
    return add(halve_u ? u : u0, u1, halve_u ? v0 : v, v1, depth + 1);
  }
  bound({u0, u1, v0, v1, {}, {}, {}, CELL_MARGIN * std::max(along_u, along_v), 0}, values);
}

void CellSupport::bound(Cell cell, const std::vector<Value>& values) {
  const Value& amid = values[values.size() / 2];
  cell.axes.col(0) = amid.u.normalized();
  cell.axes.col(2) = amid.u.cross(amid.v).normalized();
  if (!cell.axes.allFinite() || cell.axes.col(2).norm() < 0.5 || cell.axes.col(0).norm() < 0.5)
    cell.axes.setIdentity();
  cell.axes.col(1) = cell.axes.col(2).cross(cell.axes.col(0));
  Eigen::AlignedBox3d box;
  cell.bend = 0;
  for (const Value& at : values) {
    box.extend(Vector<3>(cell.axes.transpose() * at.x));
    const double bend = CELL_MARGIN * frame_of(at).B.norm();
    if (!(bend <= cell.bend))
      cell.bend = std::isfinite(bend) ? bend : std::numeric_limits<double>::infinity();
  }
  cell.center = cell.axes * box.center();
  cell.half = box.sizes() / 2;
  const double sag = CELL_MARGIN * cell.half[2];
  cell.half = Vector<3>(SIDE_MARGIN * cell.half[0] + sag, SIDE_MARGIN * cell.half[1] + sag, sag) +
              Vector<3>::Constant(1e-13 * (m_data.size + cell.center.norm()));
  m_cells.push_back(cell);
}

// The distance is convex along the cell while 1 + k (x - p).n > 0. @param local p in the axes of the cell
bool CellSupport::has_one_foot(const Cell& cell, const Vector<3>& local) const {
  const double along = local.head<2>().norm() + cell.half.head<2>().norm();
  return (std::abs(local[2]) + cell.half[2] + cell.turn * along) * cell.bend < 1;
}

// One step of Newton's method for the least distance; where that is no minimum, of Gauss'. False where there is none.
bool CellSupport::improved(const Vector<3>& p, const Value& at, double& u, double& v, double& step,
                           bool& certain) const {
  const Vector<3> d = at.x - p;
  Eigen::Matrix2d first, full;
  first << at.u.dot(at.u), at.u.dot(at.v), at.u.dot(at.v), at.v.dot(at.v);
  full << d.dot(at.uu), d.dot(at.uv), d.dot(at.uv), d.dot(at.vv);
  full += first;
  const Vector<2> slope(d.dot(at.u), d.dot(at.v));
  constexpr double singular = 1e-6;
  certain = full.trace() > 0 && full.determinant() > singular * first.determinant();
  const Eigen::Matrix2d& matrix = certain ? full : first;
  const double determinant = matrix.determinant();
  if (!(determinant > 1e-24 * matrix.trace() * matrix.trace())) return false;
  const Vector<2> way = -(matrix.inverse() * slope);
  step = std::sqrt(std::max(0., way.dot(first * way)));
  u = way[0];
  v = way[1];
  return std::isfinite(step);
}

// Into where a search may go: close to the face, and to its cell. True if that changes the place.
bool CellSupport::keep_close(const Cell* within, double& u, double& v) const {
  const FaceData& all = m_data;
  const auto room = [](double begin, double end, double part) {
    return std::make_pair(begin - part * (end - begin), end + part * (end - begin));
  };
  auto [u0, u1] = room(all.u0, all.u1, BEYOND);
  auto [v0, v1] = room(all.v0, all.v1, BEYOND);
  if (within) {
    const auto [a0, a1] = room(within->u0, within->u1, BESIDE);
    const auto [b0, b1] = room(within->v0, within->v1, BESIDE);
    u0 = std::max(u0, a0), u1 = std::min(u1, a1), v0 = std::max(v0, b0), v1 = std::min(v1, b1);
  }
  const double kept_u = std::clamp(u, u0, u1), kept_v = std::clamp(v, v0, v1);
  const bool changed = kept_u != u || kept_v != v;
  u = kept_u;
  v = kept_v;
  return changed;
}

bool CellSupport::newton(const Vector<3>& p, const Cell* within, Trial& trial) const {
  const FaceData& all = m_data;
  Value at = value(trial.u, trial.v);
  trial.x = at.x;
  trial.distance = (at.x - p).norm();
  double last = all.size;
  for (int round = 0, kept = 0; round < MOST_NEWTON && kept < MOST_KEPT; ++round) {
    double du = 0, dv = 0, step = 0;
    bool certain = false;
    if (!improved(p, at, du, dv, step, certain)) return false;
    const double most = std::max(std::abs(du) / (all.u1 - all.u0), std::abs(dv) / (all.v1 - all.v0));
    bool whole = most <= HINT_ROOM;
    if (whole && certain && step <= NO_STEP * all.size) return true; // begun at the foot
    double f = whole ? 1 : HINT_ROOM / most;
    for (int k = 0;; ++k, f /= 2) {
      double u = trial.u + f * du, v = trial.v + f * dv;
      if (keep_close(within, u, v)) {
        whole = false;
        kept += k == 0;
      }
      const Value next = value(u, v);
      const double length = (next.x - p).norm();
      if (!(length <= trial.distance * (1 + 1e-14) + 1e-15 * all.size) && k < MOST_BACKTRACKS) continue;
      at = next;
      trial = {u, v, length, next.x};
      break;
    }
    if (step <= NO_STEP * all.size || (whole && certain && step <= LAST_STEP * all.size)) return true;
    last = step;
  }
  return last <= SLOW * all.size; // close to a center of curvature
}

double CellSupport::parameter_u(const Param<3>& hint) const {
  return m_data.u0 + (hint[0] - HINT_ROOM) / (1 - 2 * HINT_ROOM) * (m_data.u1 - m_data.u0);
}

SupportFoot CellSupport::foot_at(const Trial& trial) const {
  const double part = (trial.u - m_data.u0) / (m_data.u1 - m_data.u0);
  return {trial.x, Param<3>(HINT_ROOM + part * (1 - 2 * HINT_ROOM), trial.v), gp_Pnt2d(trial.u, trial.v),
          trial.distance, true};
}

bool CellSupport::warm(const Vector<3>& p, const Param<3>& near, SupportFoot& found) const {
  Trial trial{std::clamp(parameter_u(near), m_data.u0, m_data.u1), std::clamp(near[1], m_data.v0, m_data.v1),
              0, p};
  if (!newton(p, nullptr, trial)) return false;
  found = foot_at(trial);
  return true;
}

void CellSupport::feet(const Vector<3>& p, const SupportFoot* known, double& reach,
                       const Offer& offer) const {
  m_tree.near(p, reach, [&](int i) {
    const Cell& cell = m_cells[static_cast<std::size_t>(i)];
    const Vector<3> local = cell.axes.transpose() * (p - cell.center);
    if ((local.cwiseAbs() - cell.half).cwiseMax(0).norm() > reach) return;
    const bool one = has_one_foot(cell, local);
    if (one && known && within_range(known->uv.X(), cell.u0, cell.u1, 0) &&
        within_range(known->uv.Y(), cell.v0, cell.v1, 0))
      return;
    const int starts = one ? 1 : 3; // along each side
    for (int a = 0; a < starts; ++a)
      for (int b = 0; b < starts; ++b) {
        Trial trial{cell.u0 + (a + 0.5) / starts * (cell.u1 - cell.u0),
                    cell.v0 + (b + 0.5) / starts * (cell.v1 - cell.v0), 0, p};
        if (newton(p, &cell, trial) && trial.distance <= reach) offer(foot_at(trial));
      }
  });
}

SupportFoot CellSupport::at(const gp_Pnt2d& uv, const Vector<3>& x) const {
  const Vector<3> y = value(uv.X(), uv.Y()).x;
  return foot_at({uv.X(), uv.Y(), (y - x).norm(), y});
}

SurfaceFrame<3> CellSupport::frame(const Vector<3>&, const Param<3>& hint) const {
  Value at = value(parameter_u(hint), hint[1]);
  constexpr double aside = 1e-6, pole = 1e-9;
  if (at.u.norm() * (m_data.u1 - m_data.u0) < pole * m_data.size ||
      at.v.norm() * (m_data.v1 - m_data.v0) < pole * m_data.size)
    at = value(parameter_u(hint) + aside * (m_data.u - parameter_u(hint)),
               hint[1] + aside * (m_data.v - hint[1]));
  return frame_of(at);
}

SurfaceFrame<3> CellSupport::frame_of(const Value& at) const {
  SurfaceFrame<3> frame;
  frame.n = m_side * at.u.cross(at.v).normalized();
  frame.E.col(0) = at.u.normalized();
  frame.E.col(1) = frame.n.cross(frame.E.col(0));
  Tangents<3> along;
  along << at.u, at.v;
  Eigen::Matrix2d second;
  second << frame.n.dot(at.uu), frame.n.dot(at.uv), frame.n.dot(at.uv), frame.n.dot(at.vv);
  const Eigen::Matrix2d back = (frame.E.transpose() * along).inverse();
  frame.B = -back.transpose() * second * back;
  frame.B(0, 1) = frame.B(1, 0) = (frame.B(0, 1) + frame.B(1, 0)) / 2;
  return frame;
}

std::unique_ptr<FaceSupport> cell_support(const FaceData& data) {
  return std::make_unique<CellSupport>(data);
}

} // namespace burnish
