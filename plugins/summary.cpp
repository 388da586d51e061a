// summary.json, see edp/cases/rcSummary.idp: what a script knows of its run, and the file with what the run does.
//   internal: rcSummaryNote rcSummarySave
#include "output/summary.hpp"
#include "file_units.hpp"
#include "named.hpp"
#include "script_options.hpp"
#include "step_control.hpp"

namespace burnish {
namespace {

// Of the script that runs.
Json& told() {
  static Json notes = Json::object();
  return notes;
}

Json options() {
  Json values = Json::object();
  for (const auto& option : script_options().options())
    values[option.name.substr(1)] = option.number ? Json::parse(option.json) : Json(option.value);
  return values;
}

Json value_of(const double& value) { return value; }
Json value_of(const long& value) { return value; }
Json value_of(const KN_<double>& values) {
  Json list = Json::array();
  for (long i = 0; i < values.N(); ++i) list.push_back(values[i]);
  return list;
}
Json value_of(string* const& value) { return static_cast<const std::string&>(*value); }

// section "": a key of its own.
template <class Value> bool note(string* const& section, string* const& name, const Value& value) {
  (section->empty() ? told() : told()[*section])[*name] = value_of(value);
  return true;
}
template <class Value>
bool note_part(string* const& section, string* const& name, string* const& part, const Value& value) {
  told()[*section][*name][*part] = value_of(value);
  return true;
}

// What the run knows of itself, then what the script has told, which comes first where a key is that of both.
void save(Json summary, const std::string& file) {
  summary.merge_patch(told());
  const FileUnits& units = units_of_files();
  if (!units.length.empty()) summary["units"] = {{"length", units.length}, {"stress", units.stress}};
  summary["versions"] = versions();
  summary["options"] = options();
  save_summary(summary, file);
}

// Of a run that begins: its status and no more.
bool save_told(string* const& file) {
  return guarded([&] { return save(Json::object(), *file), true; });
}

struct SaveRun {
  static const int n = 0;
  static constexpr basicAC_F0::name_and_type* names = nullptr;
  static bool call(const Named&, ContactHandle* c, MaterialHandle* m, StepControlHandle* s, KN_<double> about,
                   string* file) {
    visit(c->get(), [&](auto& contact) {
      constexpr int Dim = dim_of<decltype(contact)>;
      auto& material = of_dimension<Dim>(m->get(), "rcSummarySave");
      require(about.N() == Dim, "rcSummarySave", "size of rcMomentPoint", about.N(), Dim == 2 ? "2" : "3");
      save(of_run<Dim>(contact, material, s, values_of(about)), *file);
    });
    return true;
  }

private:
  template <int Dim>
  static Json of_run(ContactOf<Dim>& contact, MaterialOf<Dim>& material, StepControlHandle* s,
                     const Vector<Dim>& about) {
    const ContactRun<Dim>& run = contact.run();
    const IterationCounts counts = run.iteration().counts();
    const ControlObject& control = s->get();
    Json summary{{"status", ""}, {"reason", ""}};
    summary.update(run_summary(
        SummarizedRun<Dim>{run,
                           material.workpiece(),
                           contact.diagnosis,
                           control.now(),
                           control.stepper.get(),
                           statements_of(s),
                           counts.condensations > 0 ? contact.condensed : nullptr,
                           material.warnings,
                           material.body->has_damage(),
                           about,
                           {{"stress update", material.update_seconds},
                            {"assembly", material.assembly_seconds},
                            {"condensation", counts.condensation_seconds + contact.condense_seconds},
                            {"factorization", counts.factorization_seconds},
                            {"solve", counts.solve_seconds},
                            {"events", contact.event_seconds},
                            {"checks", contact.diagnosis.seconds()}}}));
    for (const Remeshing& one : control.remeshings)
      summary["remeshings"].push_back({{"t", one.t},
                                       {"nodes", one.after.nodes},
                                       {"shape", one.before.shape},
                                       {"volume", one.volume()},
                                       {"energy", one.energy()},
                                       {"force", one.force()}});
    return summary;
  }
};

template <class Value> void add_notes() {
  Global.Add("rcSummaryNote", "(", new OneOperator3_<bool, string*, string*, Value>(note<Value>));
  Global.Add("rcSummaryNote", "(",
             new OneOperator4_<bool, string*, string*, string*, Value>(note_part<Value>));
}

} // namespace

void register_summary() {
  add_notes<double>();
  add_notes<long>();
  add_notes<string*>();
  add_notes<KN_<double>>();
  Global.Add("rcSummarySave", "(", new OneOperator1_<bool, string*>(save_told));
  Global.Add("rcSummarySave", "(",
             new NamedOperator<SaveRun, bool, ContactHandle*, MaterialHandle*, StepControlHandle*,
                               KN_<double>, string*>);
}

} // namespace burnish
