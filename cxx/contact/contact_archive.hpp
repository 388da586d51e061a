#pragma once
// State and events of a contact, and what the program prescribes, into a file and from one (base/archive.hpp).
#include "base/archive.hpp"
#include "contact/contact_state.hpp"
#include "contact/events.hpp"
#include "kinematics/prescription.hpp"

namespace burnish {

/// A formula goes by its text and names, and is made of them again; null is none.
template <class Archive>
void write_formula(Archive& archive, const std::shared_ptr<const CoordinateFormula>& formula) {
  archive(formula != nullptr);
  if (!formula) return;
  const FormulaSource& source = formula->source();
  archive(source.what, source.text, source.names.variables, source.names.parameters, source.second);
}
template <class Archive>
void read_formula(Archive& archive, std::shared_ptr<const CoordinateFormula>& formula) {
  bool given = false;
  archive(given);
  formula = nullptr;
  if (!given) return;
  FormulaSource source;
  archive(source.what, source.text, source.names.variables, source.names.parameters, source.second);
  formula = std::make_shared<CoordinateFormula>(source);
}

template <class Archive, int Dim> void serialize(Archive& archive, SurfacePlace<Dim>& value) {
  BURNISH_MEMBERS(value, y, hint);
}
template <class Archive, int Dim> void serialize(Archive& archive, ContactNode<Dim>& value) {
  BURNISH_MEMBERS(value, state, tool, place, slip_origin, slip_direction, slip_memory, tied, bears, has_ties,
                  slip_rate, tributary_area);
}
template <class Archive, int Dim> void serialize(Archive& archive, ContactState<Dim>& value) {
  BURNISH_MEMBERS(value, nodes, q, slip_stiffness, fixed);
}
template <class Archive, int Dim> void serialize(Archive& archive, ContactEvent<Dim>& value) {
  BURNISH_MEMBERS(value, t, fraction, kind, candidate, node, tool, x, slip_direction, name);
}

/// Formulas one by one: cereal has its own way with pointers.
template <class Archive>
void write_formulas(Archive& archive, const std::vector<std::shared_ptr<const CoordinateFormula>>& formulas) {
  archive(static_cast<std::uint64_t>(formulas.size()));
  for (const auto& formula : formulas) write_formula(archive, formula);
}
template <class Archive>
void read_formulas(Archive& archive, std::vector<std::shared_ptr<const CoordinateFormula>>& formulas) {
  std::uint64_t size = 0;
  archive(size);
  formulas.resize(size);
  for (auto& formula : formulas) read_formula(archive, formula);
}
template <class Archive> void save(Archive& archive, const PrescribedValues& prescribed) {
  auto& [is_motion, value, formula, t, held] = prescribed;
  archive(is_motion, value, t, held);
  write_formulas(archive, formula);
}
template <class Archive> void load(Archive& archive, PrescribedValues& prescribed) {
  auto& [is_motion, value, formula, t, held] = prescribed;
  archive(is_motion, value, t, held);
  read_formulas(archive, formula);
}
template <class Archive> void save(Archive& archive, const Prescription::Entry& entry) {
  auto& [kind, value, formula, relation] = entry;
  archive(kind, value, relation);
  write_formula(archive, formula);
}
template <class Archive> void load(Archive& archive, Prescription::Entry& entry) {
  auto& [kind, value, formula, relation] = entry;
  archive(kind, value, relation);
  read_formula(archive, formula);
}

} // namespace burnish
