#include "cad/occ/cad_surface.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "cad/occ/edge_fillet.hpp"
#include "cad/occ/occ_guard.hpp"
#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>

namespace burnish {

namespace {

constexpr const char* CAD_SURFACE = "CadSurface";
constexpr double EQUAL_DISTANCE = 1e-12; // of the size
constexpr double INFINITE = std::numeric_limits<double>::infinity();

std::vector<TrimmedFace> trimmed_faces(const std::vector<CadFaceSource>& sources) {
  std::vector<TrimmedFace> faces;
  for (const CadFaceSource& source : sources) faces.emplace_back(source.tag, source.face, source.turned);
  return faces;
}

bool is_sharp(const FaceEdge& edge) {
  return edge.kind == EdgeKind::CONVEX || edge.kind == EdgeKind::CONCAVE;
}

} // namespace

struct CadSurface::Best {
  double tolerance;
  double distance = INFINITE, reach = INFINITE;
  SupportFoot foot{};
  std::size_t face = 0;
  const FaceEdge* edge = nullptr; ///< at which the surface ends, or null
  bool normal = false;

  void offer(const SupportFoot& other, std::size_t of, const FaceEdge* at) {
    const bool is_normal = other.normal && !at;
    const bool clearly = other.distance < distance - tolerance;
    if (!clearly && !(other.distance <= distance + tolerance && is_normal && !normal)) return;
    distance = other.distance;
    reach = std::min(reach, distance + tolerance);
    foot = other;
    face = of;
    edge = at;
    normal = is_normal;
  }
};

CadSurface::CadSurface(const CadSelection& selection) : m_scale(selection.scale), m_tightest(0) {
  require(std::isfinite(m_scale) && m_scale > 0, CAD_SURFACE, "scale", m_scale, "a finite number > 0");
  const auto sources = read_faces(selection);
  const OccGuard guard;
  std::exception_ptr refused;
  const std::string thrown = guard.run([&] {
    try {
      m_faces = trimmed_faces(sources);
      m_edges = face_edges(m_faces, m_scale);
      if (!selection.faces.empty()) check_edges(sources);
      divide_edges();
      join_pieces();
      m_tightest = tightest();
    } catch (const ArgumentError&) {
      refused = std::current_exception();
    }
  });
  if (refused) std::rethrow_exception(refused);
  if (!thrown.empty())
    fail(CAD_SURFACE, "\"" + selection.file + "\" has faces that OpenCASCADE cannot evaluate: " + thrown);
}

// What a fillet at all sharp edges between named faces may be, beginning with ":"; "" if that is not known.
std::string CadSurface::fillet_text(const FaceEdge& first, const std::vector<CadFaceSource>& named) const {
  const auto source = [&](const FaceEdge& edge, int k) {
    return named[static_cast<std::size_t>(edge.faces[static_cast<std::size_t>(k)])];
  };
  const TopoDS_Shape body = source(first, 0).body;
  if (body.IsNull()) return "";
  std::vector<TopoDS_Edge> edges;
  std::vector<TopoDS_Face> beside;
  Eigen::AlignedBox3d box;
  for (const FaceEdge& edge : m_edges) {
    if (!is_sharp(edge) || edge.faces[0] == edge.faces[1] || !source(edge, 0).body.IsSame(body)) continue;
    edges.push_back(edge.seen[0]);
    for (int k = 0; k < 2; ++k) {
      beside.push_back(source(edge, k).face);
      box.extend(m_faces[static_cast<std::size_t>(edge.faces[static_cast<std::size_t>(k)])].box());
    }
  }
  return burnish::fillet_text(radii_that_fit(body, edges, beside, box.diagonal().norm()), m_scale,
                              edges.size() > 1 ? sentence(" at all ", edges.size(), " edges of named faces")
                                               : "");
}

void CadSurface::refuse_edge(const FaceEdge& edge, const std::vector<CadFaceSource>& named,
                             double size) const {
  const auto face_of = [&](int f) { return std::to_string(m_faces[static_cast<std::size_t>(f)].tag()); };
  const bool alone = edge.faces[0] == edge.faces[1];
  fail(CAD_SURFACE, (alone ? "face " + face_of(edge.faces[0]) + " closes with a sharp edge"
                           : "faces " + face_of(edge.faces[0]) + " and " + face_of(edge.faces[1]) +
                                 " meet at a sharp edge") +
                        sentence(" of ", edge.angle * 180 / M_PI, " degrees at ") +
                        space_place_text(edge.sharpest, m_scale, size) +
                        "; round it with a fillet in the CAD system" +
                        (alone ? "" : fillet_text(edge, named) + "; or name only one of them"));
}

void CadSurface::check_edges(const std::vector<CadFaceSource>& named) const {
  Eigen::AlignedBox3d all;
  for (const TrimmedFace& face : m_faces) all.extend(face.box());
  const double size = all.diagonal().norm();
  for (const FaceEdge& edge : m_edges)
    if (is_sharp(edge)) refuse_edge(edge, named, size);
  for (const TrimmedFace& face : m_faces)
    if (face.support().tip())
      fail(CAD_SURFACE, face.data().name + " has a tip without normal at " +
                            space_place_text(*face.support().tip(), m_scale, size) +
                            "; round it in the CAD system");
}

void CadSurface::divide_edges() {
  Eigen::AlignedBox3d all;
  std::vector<Eigen::AlignedBox3d> boxes, rims, joints;
  for (const TrimmedFace& face : m_faces) {
    boxes.push_back(face.box());
    all.extend(face.box());
  }
  m_size = all.sizes().maxCoeff();
  for (int e = 0; e < static_cast<int>(m_edges.size()); ++e) {
    const FaceEdge& edge = m_edges[static_cast<std::size_t>(e)];
    const bool joint = edge.kind == EdgeKind::JOINT;
    m_closed = m_closed && edge.kind != EdgeKind::FREE;
    if (joint) m_slack = std::max(m_slack, edge.slack);
    for (int part = 0; part < edge.curve.parts(); ++part) {
      (joint ? m_joints : m_rims).push_back({e, part, edge.curve.start_of(part)});
      (joint ? joints : rims).push_back(edge.curve.box(part));
    }
  }
  m_face_tree = BoxTree(boxes);
  m_rim_tree = BoxTree(rims);
  m_joint_tree = BoxTree(joints);
}

void CadSurface::join_pieces() {
  m_piece.resize(m_faces.size());
  std::iota(m_piece.begin(), m_piece.end(), 0);
  for (const FaceEdge& edge : m_edges) {
    if (edge.kind != EdgeKind::JOINT || !edge.smooth) continue;
    const int a = m_piece[static_cast<std::size_t>(edge.faces[0])],
              b = m_piece[static_cast<std::size_t>(edge.faces[1])];
    for (int& piece : m_piece)
      if (piece == std::max(a, b)) piece = std::min(a, b);
  }
}

double CadSurface::tightest() const {
  constexpr int places = 100;
  double sharpest = 0;
  for (const TrimmedFace& face : m_faces)
    for (int i = 0; i < places; ++i) {
      SupportFoot place;
      if (!face.sample(i, place)) continue;
      const Curvature<3> B = face.support().frame(place.y, place.hint).B;
      const double mean = (B(0, 0) + B(1, 1)) / 2, apart = std::hypot((B(0, 0) - B(1, 1)) / 2, B(0, 1));
      sharpest = std::max(sharpest, std::abs(mean) + apart);
    }
  constexpr double flat = 1e-9; // over the size
  return sharpest * m_size < flat ? INFINITE : m_scale / sharpest;
}

std::size_t CadSurface::face_at(const Param<3>& hint) const {
  return static_cast<std::size_t>(
      std::clamp(std::floor(hint[0]), 0., static_cast<double>(m_faces.size() - 1)));
}

// What the surface surely reaches: its edges begin there.
double CadSurface::edge_bound(const Vector<3>& p) const {
  double bound = INFINITE;
  for (const auto* parts : {&m_joints, &m_rims})
    (parts == &m_joints ? m_joint_tree : m_rim_tree).near(p, bound, [&](int i) {
      bound = std::min(bound, ((*parts)[static_cast<std::size_t>(i)].x - p).norm());
    });
  return bound;
}

// Within the borders, or so close to a joint that rounding and the file's tolerance decide.
bool CadSurface::holds(std::size_t face, const SupportFoot& foot) const {
  if (m_faces[face].holds(foot.uv)) return true;
  bool joint = false;
  double reach = m_slack;
  m_joint_tree.near(foot.y, reach, [&](int i) {
    const EdgePart& at = m_joints[static_cast<std::size_t>(i)];
    const FaceEdge& edge = m_edges[static_cast<std::size_t>(at.edge)];
    if (joint || (edge.faces[0] != static_cast<int>(face) && edge.faces[1] != static_cast<int>(face))) return;
    joint = edge.curve.nearest(at.part, foot.y).distance <= edge.slack;
  });
  return joint;
}

void CadSurface::ask_faces(const Vector<3>& p, const Param<3>& hint, Best& best) const {
  const std::size_t near = face_at(hint);
  const Param<3> at(std::clamp(hint[0] - static_cast<double>(near), 0., 1.), hint[1]);
  SupportFoot warm;
  const bool known = m_faces[near].support().warm(p, at, warm);
  if (known && (!warm.normal || holds(near, warm))) best.offer(warm, near, nullptr);
  if (best.distance == INFINITE) best.reach = edge_bound(p) * (1 + EQUAL_DISTANCE) + best.tolerance;
  m_face_tree.near(p, best.reach, [&](int i) {
    const auto f = static_cast<std::size_t>(i);
    m_faces[f].support().feet(p, known && f == near ? &warm : nullptr, best.reach,
                              [&](const SupportFoot& foot) {
                                if (!foot.normal || holds(f, foot)) best.offer(foot, f, nullptr);
                              });
  });
}

void CadSurface::ask_rims(const Vector<3>& p, Best& best) const {
  m_rim_tree.near(p, best.reach, [&](int i) {
    const EdgePart& at = m_rims[static_cast<std::size_t>(i)];
    const FaceEdge& edge = m_edges[static_cast<std::size_t>(at.edge)];
    const SpaceCurve::Nearest nearest = edge.curve.nearest(at.part, p);
    SupportFoot foot;
    foot.y = nearest.x;
    foot.uv.SetX(nearest.u);
    foot.distance = nearest.distance;
    foot.normal = false;
    best.offer(foot, 0, &edge);
  });
}

SurfacePlace<3> CadSurface::place_of(std::size_t face, const SupportFoot& foot) const {
  constexpr double last = 1 - 1e-9;
  return {m_scale * foot.y,
          Param<3>(static_cast<double>(face) + std::clamp(foot.hint[0], 0., last), foot.hint[1])};
}

SurfacePlace<3> CadSurface::edge_place(const FaceEdge& edge, double u) const {
  const auto face = static_cast<std::size_t>(edge.faces[0]);
  SupportFoot foot = m_faces[face].support().at(m_faces[face].on_edge(edge.seen[0], u), edge.curve.at(u).x);
  foot.y = edge.curve.at(u).x;
  return place_of(face, foot);
}

SurfaceFoot<3> CadSurface::foot(const Vector<3>& p, const Param<3>& hint) const {
  require(p.allFinite(), "CadSurface::foot", "p", p.transpose(), "finite components");
  require(hint.allFinite(), "CadSurface::foot", "hint", hint.transpose(), "finite parameters");
  Best best{EQUAL_DISTANCE * m_size};
  const Vector<3> local = p / m_scale;
  ask_faces(local, hint, best);
  ask_rims(local, best);
  if (best.distance == INFINITE)
    fail(CAD_SURFACE, sentence("no closest point to (", p[0], ", ", p[1], ", ", p[2], ") on its faces"));
  if (best.normal) {
    const SurfacePlace<3> place = place_of(best.face, best.foot);
    return {place, frame(place).n.dot(p - place.y), false};
  }
  // an edge or a tip: where the tool is hollow only points within it are nearest to these
  const double distance = m_scale * best.distance;
  if (best.edge)
    return {edge_place(*best.edge, best.foot.uv.X()),
            best.edge->kind == EdgeKind::CONCAVE ? -distance : distance, true};
  const FaceData& face = m_faces[best.face].data();
  const SupportFoot beside = m_faces[best.face].support().at(gp_Pnt2d(face.u, face.v), face.x);
  const bool hollow = m_faces[best.face].support().frame(beside.y, beside.hint).B.trace() < 0;
  return {place_of(best.face, best.foot), hollow ? -distance : distance, true};
}

SurfaceFrame<3> CadSurface::frame(const SurfacePlace<3>& place) const {
  const std::size_t face = face_at(place.hint);
  const Param<3> at(place.hint[0] - static_cast<double>(face), place.hint[1]);
  SurfaceFrame<3> frame = m_faces[face].support().frame(place.y / m_scale, at);
  frame.B /= m_scale;
  return frame;
}

int CadSurface::piece(const SurfacePlace<3>& place) const { return m_piece[face_at(place.hint)]; }

std::vector<int> CadSurface::tags() const {
  std::vector<int> tags;
  for (const TrimmedFace& face : m_faces) tags.push_back(face.tag());
  return tags;
}

} // namespace burnish
