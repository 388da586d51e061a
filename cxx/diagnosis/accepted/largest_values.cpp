// Largest values that are those of one point: no node confirms them (ALGORITHMS.md 17.2).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/volume_percentile.hpp"

namespace burnish {
namespace {

constexpr double ONE_POINT = 0.05;  // largest plastic strain of a point over the largest nodal one, less 1
constexpr double ONE_STRESS = 0.25; // the same of the von Mises stress
constexpr double FLOWING = 1e-4;    // plastic strain: above, a point counts in the percentile
constexpr double PERCENTILE = 0.99; // of the flowing volume

// The largest value of all points beside the largest nodal one.
struct Largest {
  double point = 0, nodal = 0, part = 0; // part: most of the volume lies below
  std::string place;
  double ratio() const { return nodal > 0 ? point / nodal : 1; }
};

template <int Dim> class LargestValues final : public ObserverOf<LargestValues<Dim>, Dim> {
public:
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    const Workpiece<Dim>& workpiece = *run.step.workpiece;
    if (workpiece.law().internal_variables().find("plastic_strain_eq") >= 0) {
      const Largest strain = largest(run, internal_field(workpiece, "plastic_strain_eq"), FLOWING);
      if (strain.point > FLOWING && strain.ratio() > 1 + ONE_POINT)
        say("plastic strain", "flowing volume", strain, list);
    }
    const Largest stress = largest(run, stress_eq_field(workpiece), 0);
    if (stress.ratio() > 1 + ONE_STRESS) say("von Mises stress", "volume", stress, list);
  }

private:
  static Largest largest(const EndedRun<Dim>& run, const Eigen::VectorXd& values, double least) {
    const Discretization<Dim>& space = run.step.workpiece->discretization();
    Eigen::Index p = 0;
    Largest result;
    result.point = values.maxCoeff(&p);
    result.nodal = nodal_average(space, values).maxCoeff();
    result.part = volume_percentile(space, values, PERCENTILE, least);
    result.place = place_text(run.step.place_of(run.step.point(static_cast<int>(p))));
    return result;
  }
  static void say(const std::string& name, const std::string& volume, const Largest& value,
                  std::vector<Statement>& list) {
    list.push_back({StatementKind::NEEDED, "largest " + name, value.ratio(), 75,
                    "the largest " + name + ", " + short_number(value.point) + ", is that of one point, at " +
                        value.place + ": " + short_number(value.nodal) + " at a node, " +
                        short_number(100 * PERCENTILE) + " % of the " + volume + " below " +
                        short_number(value.part) + ": judge by these, or refine there"});
  }
};

} // namespace

BURNISH_OBSERVER(largest_values, LargestValues)

} // namespace burnish
