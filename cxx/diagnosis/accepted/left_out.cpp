// What costs nothing, since it is left out of itself (ALGORITHMS.md 17.3).
#include "base/sentence.hpp"
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

template <int Dim> class LeftOut final : public ObserverOf<LeftOut<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_window)
  void look(const AcceptedStep<Dim>& step, FindingList&) override {
    m_window = std::max(m_window, step.window);
  }
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    const AcceptedStep<Dim>& step = run.step;
    const Eigen::Index all = step.contact.q.size();
    Eigen::Index given = 0;
    for (Eigen::Index k = 0; k < all; ++k)
      given +=
          step.model().coupling_of(static_cast<int>(k)) || (step.prescribed && step.prescribed->is_motion[k]);
    std::string text =
        sentence(given, " of ", all, " coordinates are prescribed at the end and carry no equation");
    if (m_window > 0)
      text += sentence("; at most ", m_window, " of ", step.model().candidates.size(),
                       " contact nodes took part in the contact iteration");
    if (known_law(step.workpiece)) {
      const auto strains = plastic_strains(*step.workpiece);
      text += sentence("; ", (strains.array() > 0).count(), " of ", strains.size(), " points ever flowed");
    }
    if (step.model().symmetric()) text += "; without friction the matrix is symmetric";
    list.push_back({StatementKind::LEAN, "lean", static_cast<double>(given), 0, text});
  }

private:
  std::size_t m_window = 0; // largest number of candidates on the dense block
};

} // namespace

BURNISH_OBSERVER(left_out, LeftOut)

} // namespace burnish
