// Tools that pass through each other (ALGORITHMS.md 16.3).
#include "base/sentence.hpp"
#include "contact/contact_archive.hpp"
#include "diagnosis/accepted/tool_overlap.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr double TOOLS_OVERLAP = 2e-3; // depth of a tool in another one over the smaller one of them: warning

// Two tools of the plane.
struct ToolPairState {
  Eigen::VectorXd origin; // of the second one in the frame of the first one [length]
  Eigen::MatrixXd R;      // its rotation there, times its size
  double size = 1;        // of the first one
  double at_start = 0;    // depth of their overlap at the start of the run [length]
  double clear = 0;       // they are apart by so much at least [length]
  bool moved = false;     // relative to each other
  BURNISH_FIELDS(origin, R, size, at_start, clear, moved)
};

// Of the plane. In space nothing is checked: a few places on two surfaces do not tell whether these cross.
template <int Dim> class ToolOverlapCheck final : public ObserverOf<ToolOverlapCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_outlines, m_pairs)
  void begin(const AcceptedStep<Dim>& step, FindingList& findings) override;
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  struct Outline {
    std::vector<SurfacePlace<2>> places;
    double spacing = 0; // bound of the way along the surface between neighbors [length]
    double reach = 0;   // largest distance of its points from its origin [length]
    BURNISH_FIELDS(places, spacing, reach)
  };
  void measure(const AcceptedStep<2>& step);
  double motion(const AcceptedStep<2>& step, int a, int b, ToolPairState& pair) const;
  ToolOverlap overlap(const AcceptedStep<2>& step, int a, int b) const;
  void look_at_pair(const AcceptedStep<2>& step, int a, int b, double bound, ToolPairState& pair,
                    FindingList& findings) const;

  std::vector<Outline> m_outlines;
  std::vector<ToolPairState> m_pairs; // (0, 1), (0, 2), (1, 2), (0, 3), ...
};

// Number of the pair (a, b), a < b.
std::size_t pair_of(int a, int b) { return static_cast<std::size_t>(b * (b - 1) / 2 + a); }

// Whether a coordinate of the tool finds its own place.
bool under_force(const AcceptedStep<2>& step, int tool) {
  if (!step.prescribed) return false;
  for (int k = step.model().first[tool]; k < step.model().first[tool + 1]; ++k)
    if (!step.prescribed->is_motion[k] && !step.model().coupling_of(k)) return true;
  return false;
}

template <int Dim> void ToolOverlapCheck<Dim>::measure(const AcceptedStep<2>& step) {
  constexpr int places = 64;
  constexpr double arc = 1.2; // bound of an arc between two places over its chord
  for (const auto& tool : step.model().tools) {
    Outline outline;
    outline.places = tool->surface().outline(places);
    for (std::size_t i = 0; i < outline.places.size(); ++i) {
      outline.reach = std::max(outline.reach, outline.places[i].y.norm());
      if (i > 0)
        outline.spacing =
            std::max(outline.spacing, arc * (outline.places[i].y - outline.places[i - 1].y).norm());
    }
    m_outlines.push_back(std::move(outline));
  }
}

// Bound of the way of any point of one outline as the other one sees it, since the last call.
template <int Dim>
double ToolOverlapCheck<Dim>::motion(const AcceptedStep<2>& step, int a, int b, ToolPairState& pair) const {
  const Pose<2>&pa = step.poses[a], &pb = step.poses[b];
  const Vector<2> origin = pa.R.transpose() * (pb.origin - pa.origin);
  const Tensor<2> R = pb.size * (pa.R.transpose() * pb.R);
  const double way = pair.R.size() == 0
                         ? 0
                         : (origin - pair.origin).norm() + (R - pair.R).norm() * m_outlines[b].reach +
                               std::abs(pa.size - pair.size) * m_outlines[a].reach;
  pair.origin = origin;
  pair.R = R;
  pair.size = pa.size;
  return way;
}

template <int Dim>
ToolOverlap ToolOverlapCheck<Dim>::overlap(const AcceptedStep<2>& step, int a, int b) const {
  const double apart = (step.poses[b].origin - step.poses[a].origin).norm() -
                       step.poses[a].size * m_outlines[a].reach - step.poses[b].size * m_outlines[b].reach;
  if (apart > 0) return {0, apart};
  const auto placed = [&](int t) {
    return PlacedTool{step.model().tools[t].get(), &step.poses[t], &m_outlines[t].places,
                      step.poses[t].size * m_outlines[t].spacing};
  };
  return tool_overlap(placed(a), placed(b));
}

// Pieces of one tool move together, and open tools are often drawn further than they are needed: what overlaps from the
// start on is judged by its motion if it is closed, and not at all if it is open.
template <int Dim>
void ToolOverlapCheck<Dim>::look_at_pair(const AcceptedStep<2>& step, int a, int b, double bound,
                                         ToolPairState& pair, FindingList& findings) const {
  constexpr double rounding = 1e-9; // of the size of the tools
  const auto &first = step.model().tools[a]->surface(), &second = step.model().tools[b]->surface();
  const double size =
      std::min(step.poses[a].size * first.length_scale(), step.poses[b].size * second.length_scale());
  if (pair.at_start > bound * size && !(first.closed() && second.closed())) return;
  const double way = motion(step, a, b, pair);
  pair.moved = pair.moved || way > rounding * (m_outlines[a].reach + m_outlines[b].reach) ||
               (under_force(step, a) && under_force(step, b));
  pair.clear -= way;
  if (!pair.moved || pair.clear > 0) return;
  const ToolOverlap now = overlap(step, a, b);
  pair.clear = now.clear;
  const double value = now.depth / size;
  findings.largest("tools overlap", value);
  if (!(value > bound)) return;
  const std::string names = "\"" + step.tool_name(a) + "\" and \"" + step.tool_name(b) + "\"";
  Finding* finding = findings.report("tools overlap", names, Severity::WARNING, value, step.t);
  if (!finding) return;
  finding->value = value;
  finding->bound = bound;
  finding->place = step.place_of(now.x);
  finding->text = sentence("tools ", names, " overlap by ", now.depth, step.at(now.x),
                           ": rigid tools cannot pass through each other");
}

template <int Dim> void ToolOverlapCheck<Dim>::begin(const AcceptedStep<Dim>& step, FindingList&) {
  if constexpr (Dim == 2) {
    if (m_outlines.empty()) measure(step);
    const int tools = static_cast<int>(step.model().tools.size());
    m_pairs.assign(tools > 1 ? pair_of(0, tools) : 0, {});
    for (int b = 1; b < tools; ++b)
      for (int a = 0; a < b; ++a) {
        ToolPairState& pair = m_pairs[pair_of(a, b)];
        motion(step, a, b, pair);
        const ToolOverlap start = overlap(step, a, b);
        pair.at_start = start.depth;
        pair.clear = start.clear;
      }
  }
}

template <int Dim> void ToolOverlapCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  if constexpr (Dim == 2) {
    if (m_outlines.empty()) measure(step);
    for (int b = 1; b < static_cast<int>(step.model().tools.size()); ++b)
      for (int a = 0; a < b; ++a)
        if (pair_of(a, b) < m_pairs.size())
          look_at_pair(step, a, b, TOOLS_OVERLAP, m_pairs[pair_of(a, b)], findings);
  }
}

} // namespace

BURNISH_OBSERVER(tool_overlap_check, ToolOverlapCheck)

} // namespace burnish
