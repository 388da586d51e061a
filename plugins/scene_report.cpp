// What a run says of its scene (ALGORITHMS.md 17): needed and not modelled, modelled and not needed, lean.
//   S.report    the statements, one line each, the most important first; "" without self-checks (S.checks)
//   S.statements   their number, a table i = 0 .. S.statements-1 | -
//   S.statementkind(i)   "needed and not modelled", "modelled and not needed" or "lean"
//     i         line of the table | - | | 0 to statements-1
//   S.statementname(i)   such as "friction roller": what is said, and of what
//     i         line of the table | - | | 0 to statements-1
//   S.statementvalue(i)   the number that it rests on | its own
//     i         line of the table | - | | 0 to statements-1
//   S.statementtext(i)   a sentence with the option that changes it
//     i         line of the table | - | | 0 to statements-1
#include "base/cpu_time.hpp"
#include "named.hpp"
#include "step_control.hpp"

namespace burnish {

const std::vector<Statement>& statements_of(StepControlHandle* h) {
  ControlObject& object = h->get();
  if (!object.stepper) return object.statements;
  const long steps = object.stepper->counts().steps;
  if (object.statements_at == steps) return object.statements;
  object.statements = object.stepper->report();
  object.statements_at = steps;
  return object.statements;
}

namespace {

const Statement& statement(StepControlHandle* h, long i) {
  const auto& list = statements_of(h);
  require(i >= 0 && i < static_cast<long>(list.size()), "stepcontrol.statement", "index", i,
          "less than statements");
  return list[static_cast<std::size_t>(i)];
}

long number(StepControlHandle* const& h) {
  return guarded([&] { return static_cast<long>(statements_of(h).size()); });
}
string* report(Stack stack, StepControlHandle* const& h) {
  return guarded([&] {
    std::string text;
    for (const Statement& s : statements_of(h)) text += std::string(name_of(s.kind)) + ": " + s.text + "\n";
    return new_string(stack, text);
  });
}

struct ValueTag {};
double value(const Method<StepControlHandle, ValueTag>& m, const long& i) {
  return guarded([&] { return statement(m.object, i).value; });
}
// One column of texts; Column: struct with `get`.
template <class Column>
string* text_at(Stack stack, const Method<StepControlHandle, Column>& m, const long& i) {
  return guarded([&] { return new_string(stack, Column::get(statement(m.object, i))); });
}
struct Kind {
  static std::string get(const Statement& s) { return name_of(s.kind); }
};
struct Name {
  static std::string get(const Statement& s) { return s.name; }
};
struct Text {
  static std::string get(const Statement& s) { return s.text; }
};
template <class Column> void add_text(const char* name) {
  add_method<StepControlHandle, Column>(name, [] {
    return new OneOperator2s_<string*, Method<StepControlHandle, Column>, long>(text_at<Column>);
  });
}

} // namespace

void register_scene_report() {
  Add<StepControlHandle*>("statements", ".", new OneOperator1_<long, StepControlHandle*>(number));
  Add<StepControlHandle*>("report", ".", new OneOperator1s_<string*, StepControlHandle*>(report));
  add_text<Kind>("statementkind");
  add_text<Name>("statementname");
  add_text<Text>("statementtext");
  add_method<StepControlHandle, ValueTag>("statementvalue", [] {
    return new OneOperator2_<double, Method<StepControlHandle, ValueTag>, long>(value);
  });
}

} // namespace burnish
