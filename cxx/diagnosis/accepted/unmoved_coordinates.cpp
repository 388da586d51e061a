// Coordinates under force that never moved (ALGORITHMS.md 17.1).
#include "contact/coupling.hpp"
#include "diagnosis/accepted/mirror.hpp"
#include "diagnosis/observers.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double UNMOVED = 1e-6; // way of a coordinate's points over the size of the body

// Where a coordinate has been.
struct CoordinateUse {
  bool forced = true; // under force in every step
  double least = 0, most = 0;
  BURNISH_FIELDS(forced, least, most)
};

template <int Dim> class UnmovedCoordinates final : public ObserverOf<UnmovedCoordinates<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_use)
  void look(const AcceptedStep<Dim>& step, FindingList&) override {
    const Eigen::VectorXd& q = step.contact.q;
    if (m_use.empty())
      for (const double value : q) m_use.push_back({true, value, value});
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      CoordinateUse& use = m_use[k];
      use.least = std::min(use.least, q[k]);
      use.most = std::max(use.most, q[k]);
      use.forced = use.forced && step.prescribed && !step.prescribed->is_motion[k] &&
                   !step.model().coupling_of(static_cast<int>(k));
    }
  }
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    const ContactModel<Dim>& model = run.step.model();
    const auto names = dotted_names(model);
    const auto poses = model.poses(run.step.contact.q);
    const double size = size_of(run.step.mesh());
    for (int k = 0; k < static_cast<int>(m_use.size()); ++k) {
      const CoordinateUse& use = m_use[k];
      if (!use.forced) continue;
      const int tool = model.tool_of(k), own = k - model.first[tool];
      const double per_unit = point_rate(poses[tool], static_cast<std::size_t>(own), size);
      const double way = per_unit * (use.most - use.least) / size;
      if (!(way < UNMOVED)) continue;
      const double at = std::abs(use.most) < UNMOVED * size ? 0 : use.most; // no rounding
      const std::string dotted = names[k], coordinate = dotted.substr(dotted.rfind('.') + 1);
      list.push_back({StatementKind::NOT_NEEDED, "coordinate " + dotted, way, 45,
                      "coordinate \"" + coordinate + "\" of tool \"" + run.step.tool_name(tool) +
                          "\" is under force and never moved, by " + short_number(way) +
                          " of the size of the body: move(\"" + coordinate + "\", " + short_number(at) +
                          ") gives the same"});
    }
  }

private:
  std::vector<CoordinateUse> m_use; // per coordinate
};

} // namespace

BURNISH_OBSERVER(unmoved_coordinates, UnmovedCoordinates)

} // namespace burnish
