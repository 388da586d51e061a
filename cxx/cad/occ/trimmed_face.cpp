#include "cad/occ/trimmed_face.hpp"
#include "base/error.hpp"
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace burnish {

namespace {

constexpr double ON_BORDER = 1e-9; // in parameters: on a border is within it
constexpr double LARGEST_FACE = 1e50;
constexpr double LARGEST_PARAMETER = 1e10; // OpenCASCADE brings parameters into a period turn by turn

Eigen::AlignedBox3d box_of(const TopoDS_Face& face, const std::string& name) {
  Bnd_Box box;
  BRepBndLib::Add(face, box, false);
  if (box.IsVoid() || box.IsOpen()) fail("CadSurface", name + " has no size, or is endless");
  const Eigen::AlignedBox3d found(from_occ(box.CornerMin().XYZ()), from_occ(box.CornerMax().XYZ()));
  if (!(found.min().allFinite() && found.max().allFinite() && found.sizes().maxCoeff() > 0 &&
        found.min().cwiseAbs().maxCoeff() < LARGEST_FACE && found.max().cwiseAbs().maxCoeff() < LARGEST_FACE))
    fail("CadSurface", name + " has points that are not finite or beyond 1e50");
  return found;
}

// A place amid the parameters where the surface has a normal.
void find_middle(FaceData& data) {
  const auto surface = BRep_Tool::Surface(data.face);
  for (const double f : {0.5, 0.41, 0.67, 0.83, 0.12}) {
    data.u = data.u0 + f * (data.u1 - data.u0);
    data.v = data.v0 + f * (data.v1 - data.v0);
    gp_Pnt x;
    gp_Vec u, v;
    surface->D1(data.u, data.v, x, u, v);
    data.x = from_occ(x.XYZ());
    const double side = (data.face.Orientation() == TopAbs_REVERSED) != data.turned ? -1 : 1;
    data.n = side * from_occ(u.Crossed(v).XYZ()).normalized();
    if (data.n.allFinite() && std::abs(data.n.norm() - 1) < 0.5) return;
  }
  fail("CadSurface", data.name + " has no normal: it has no area");
}

// Whether all borders run along the ends of the parameters.
bool fills_its_box(const TrimmedFace& face) {
  const FaceData& data = face.data();
  const double u = 1e-9 * (data.u1 - data.u0), v = 1e-9 * (data.v1 - data.v0);
  for (TopExp_Explorer edge(data.face, TopAbs_EDGE); edge.More(); edge.Next()) {
    double begin = 0, end = 0;
    BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), data.face, begin, end);
    for (int i = 0; i <= 8; ++i) {
      const gp_Pnt2d at = face.on_edge(TopoDS::Edge(edge.Current()), begin + (end - begin) * i / 8);
      const auto close = [](double x, double end, double tolerance) {
        return std::abs(x - end) <= tolerance;
      };
      if (!close(at.X(), data.u0, u) && !close(at.X(), data.u1, u) && !close(at.Y(), data.v0, v) &&
          !close(at.Y(), data.v1, v))
        return false;
    }
  }
  return true;
}

} // namespace

TrimmedFace::TrimmedFace(int tag, const TopoDS_Face& face, bool turned) : m_tag(tag) {
  m_data.face = face;
  m_data.turned = turned;
  m_data.name = "face " + std::to_string(tag);
  if (BRep_Tool::Surface(face).IsNull()) fail("CadSurface", m_data.name + " has no surface, only triangles");
  m_box = box_of(face, m_data.name);
  m_data.size = m_box.diagonal().norm();
  BRepTools::UVBounds(face, m_data.u0, m_data.u1, m_data.v0, m_data.v1);
  const double most = std::max({-m_data.u0, m_data.u1, -m_data.v0, m_data.v1});
  if (!(m_data.u1 > m_data.u0 && m_data.v1 > m_data.v0 && most < LARGEST_PARAMETER))
    fail("CadSurface", m_data.name + " has no range of its parameters, or one beyond 1e10");
  find_middle(m_data);
  m_borders = std::make_unique<BRepTopAdaptor_FClass2d>(face, ON_BORDER);
  m_support = analytic_support(m_data);
  if (!m_support && fills_its_box(*this)) m_support = swept_support(m_data);
  if (!m_support) m_support = cell_support(m_data);
}

bool TrimmedFace::holds(const gp_Pnt2d& uv) const {
  try {
    const TopAbs_State state = m_borders->Perform(uv);
    return state == TopAbs_IN || state == TopAbs_ON;
  } catch (const Standard_Failure& failure) {
    fail("CadSurface", m_data.name + " has borders that cannot be evaluated: " + failure.GetMessageString());
  }
}

gp_Pnt2d TrimmedFace::on_edge(const TopoDS_Edge& edge, double u) const {
  double begin = 0, end = 0;
  const auto curve = BRep_Tool::CurveOnSurface(edge, m_data.face, begin, end);
  if (curve.IsNull()) fail("CadSurface", m_data.name + " has an edge that does not lie on it");
  return curve->Value(u);
}

bool TrimmedFace::sample(int i, SupportFoot& place) const {
  constexpr double plastic = 0.7548776662466927; // with its square: points spread evenly in a square
  const double f = 0.5 + i * plastic, g = 0.5 + i * plastic * plastic;
  const gp_Pnt2d uv(m_data.u0 + (f - std::floor(f)) * (m_data.u1 - m_data.u0),
                    m_data.v0 + (g - std::floor(g)) * (m_data.v1 - m_data.v0));
  if (!holds(uv)) return false;
  place = m_support->at(uv, from_occ(BRep_Tool::Surface(m_data.face)->Value(uv.X(), uv.Y()).XYZ()));
  return true;
}

} // namespace burnish
