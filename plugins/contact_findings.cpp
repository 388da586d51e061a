// What a run found of itself: warnings and violated self-checks (ALGORITHMS.md 16), the worst of each check and subject.
//   C.trusted   no self-check is violated
//   C.worstfinding   "check: text" of the most severe finding, or ""
//   C.findings   number of findings, a table i = 0 .. C.findings-1 | -
//   C.findingcheck(i)   name of the check
//     i         line of the table | - | | 0 to findings-1
//   C.findingseverity(i)   "note", "warning", "untrusted", "stop"
//     i         line of the table | - | | 0 to findings-1
//   C.findingvalue(i), C.findingbound(i)   the number that it rests on, and what is allowed; both 0: none | its own
//     i         line of the table | - | | 0 to findings-1
//   C.findingx(i), C.findingy(i), C.findingz(i)   place, nan without one | length
//     i         line of the table | - | | 0 to findings-1
//   C.findingtime(i), C.findingfirst(i)   instant of the worst one, of the first one; nan before the run | time
//     i         line of the table | - | | 0 to findings-1
//   C.findingcount(i)   accepted steps in which it was found | -
//     i         line of the table | - | | 0 to findings-1
//   C.findingtext(i)   a sentence
//     i         line of the table | - | | 0 to findings-1
#include "base/error.hpp"
#include "named.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;

const FindingList& findings_of(H* h) {
  const FindingList* findings = nullptr;
  visit(h->get(), [&](auto& contact) { findings = &contact.diagnosis.findings(); });
  return *findings;
}
const Finding& finding(H* h, long i) {
  const FindingList& findings = findings_of(h);
  require(i >= 0 && i < static_cast<long>(findings.size()), "contact.finding", "index", i,
          "less than findings");
  return findings[static_cast<std::size_t>(i)];
}

long number(H* const& h) {
  return guarded([&] { return static_cast<long>(findings_of(h).size()); });
}
bool trusted(H* const& h) {
  return guarded([&] { return findings_of(h).trusted(); });
}
string* worst(Stack stack, H* const& h) {
  return guarded([&] {
    const Finding* worst = findings_of(h).worst();
    return new_string(stack, worst ? worst->check + ": " + worst->text : "");
  });
}

// One column of the table; Column: struct with `get`.
template <class Column> auto number_at(const Method<H, Column>& m, const long& i) {
  return guarded([&] { return Column::get(finding(m.object, i)); });
}
template <class Column> string* text_at(Stack stack, const Method<H, Column>& m, const long& i) {
  return guarded([&] { return new_string(stack, Column::get(finding(m.object, i))); });
}
template <int axis> struct Place {
  static double get(const Finding& f) { return f.place.size() > axis ? f.place[axis] : Finding::NONE; }
};
struct Value {
  static double get(const Finding& f) { return f.value; }
};
struct Allowed {
  static double get(const Finding& f) { return f.bound; }
};
struct Time {
  static double get(const Finding& f) { return f.t; }
};
struct First {
  static double get(const Finding& f) { return f.first; }
};
struct Count {
  static long get(const Finding& f) { return f.count; }
};
struct Name {
  static std::string get(const Finding& f) { return f.check; }
};
struct Severe {
  static std::string get(const Finding& f) { return name_of(f.severity); }
};
struct Text {
  static std::string get(const Finding& f) { return f.text; }
};

template <class Column> void add_number(const char* name) {
  using Result = decltype(Column::get(Finding()));
  add_method<H, Column>(name,
                        [] { return new OneOperator2_<Result, Method<H, Column>, long>(number_at<Column>); });
}
template <class Column> void add_text(const char* name) {
  add_method<H, Column>(name,
                        [] { return new OneOperator2s_<string*, Method<H, Column>, long>(text_at<Column>); });
}

} // namespace

void register_contact_findings() {
  Add<H*>("findings", ".", new OneOperator1_<long, H*>(number));
  Add<H*>("trusted", ".", new OneOperator1_<bool, H*>(trusted));
  Add<H*>("worstfinding", ".", new OneOperator1s_<string*, H*>(worst));
  add_text<Name>("findingcheck");
  add_text<Severe>("findingseverity");
  add_text<Text>("findingtext");
  add_number<Value>("findingvalue");
  add_number<Allowed>("findingbound");
  add_number<Place<0>>("findingx");
  add_number<Place<1>>("findingy");
  add_number<Place<2>>("findingz");
  add_number<Time>("findingtime");
  add_number<First>("findingfirst");
  add_number<Count>("findingcount");
}

} // namespace burnish
