#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

template <int Dim, class... Makers> ObserverList<Dim> made_by(Makers... makers) {
  ObserverList<Dim> list;
  (list.push_back(makers()), ...);
  return list;
}

} // namespace

template <int Dim> ObserverList<Dim> causes() {
  return made_by<Dim>(program_jump<Dim>, pulling_force<Dim>, unheld_workpiece<Dim>,
                      incompressible_workpiece<Dim>, force_over_way<Dim>, last_equilibrium<Dim>,
                      end_of_tool<Dim>, few_nodes_hold<Dim>, tight_radius<Dim>, tools_compete<Dim>,
                      hold_carries<Dim>);
}

template <int Dim> ObserverList<Dim> checks() {
  return made_by<Dim>(balance_check<Dim>, contact_forces_check<Dim>, contact_width_check<Dim>,
                      pressure_check<Dim>, overlap_check<Dim>, tool_overlap_check<Dim>, folding_check<Dim>,
                      strain_check<Dim>, distortion_check<Dim>, yield_check<Dim>, volume_check<Dim>,
                      locking_check<Dim>, energy_check<Dim>, surface_end<Dim>, coarse_mesh<Dim>,
                      largest_values<Dim>, unused_yield<Dim>, unused_friction<Dim>, unmoved_coordinates<Dim>,
                      idle_mesh<Dim>, short_steps<Dim>, symmetric_scene<Dim>, small_strains<Dim>,
                      left_out<Dim>);
}

template ObserverList<2> causes<2>();
template ObserverList<3> causes<3>();
template ObserverList<2> checks<2>();
template ObserverList<3> checks<3>();

} // namespace burnish
