// What the plugin has registered, read from FreeFEM's own tables.
//   rcCallables(dummy)   a line for each type, constant, function, constructor, method, member and named parameter with its
//                        types; tests/shell/test_reference.sh holds it against edp/manual/reference/callables.txt
//     dummy   not read
#include "callables.hpp"
#include "named.hpp"
#include "types.hpp"

#include <cxxabi.h>
#include <set>

namespace burnish {
namespace {

// Access to FreeFEM's tables, which have no public way in: explicit instantiations may name private members.
template <class Tag, typename Tag::Type member> struct Reveal {
  friend typename Tag::Type reveal(Tag) { return member; }
};
struct Operators {
  using Type = std::map<const char*, OneOperator*, Keyless> Polymorphic::*;
  friend Type reveal(Operators);
};
struct Members {
  using Type = TableOfIdentifier basicForEachType::*;
  friend Type reveal(Members);
};
struct Next {
  using Type = OneOperator* OneOperator::*;
  friend Type reveal(Next);
};
struct Keywords {
  using Type = mylex::MapMotClef mylex::*;
  friend Type reveal(Keywords);
};
template struct Reveal<Operators, &Polymorphic::m>;
template struct Reveal<Members, &basicForEachType::ti>;
template struct Reveal<Next, &OneOperator::next>;
template struct Reveal<Keywords, &mylex::MotClef>;

std::set<std::string> known_before, known_after; // global names

std::set<std::string> global_names() {
  std::set<std::string> names;
  for (const auto& entry : Global.m) names.insert(entry.first);
  return names;
}

struct OperatorArguments : OneOperator { // never made: opens what OneOperator protects
  static std::vector<aType> of(const OneOperator& op) {
    aType* const first = op.*(&OperatorArguments::t);
    return {first, first + op.*(&OperatorArguments::n)};
  }
};

// All overloads of an operator such as "(" in a table.
std::vector<const OneOperator*> overloads(const Polymorphic& table, const char* op) {
  std::vector<const OneOperator*> list;
  const auto& map = table.*reveal(Operators{});
  const auto found = map.find(op);
  for (const OneOperator* one = found == map.end() ? nullptr : found->second; one; one = one->*reveal(Next{}))
    list.push_back(one);
  return list;
}

// "KIND NAME(types) -> type", without the first `hidden` arguments, and its named parameters.
void add_call(std::set<std::string>& lines, const std::string& kind, const std::string& name,
              const OneOperator& op, std::size_t hidden) {
  std::string line = kind + " " + name + "(";
  const std::vector<aType> arguments = OperatorArguments::of(op);
  for (std::size_t i = hidden; i < arguments.size(); ++i)
    line += (i == hidden ? "" : ", ") + type_name(arguments[i]->name());
  lines.insert(line + ") -> " + type_name(static_cast<aType>(op)->name()));
  if (const auto* takes = dynamic_cast<const NamedParameters*>(&op))
    for (const auto& parameter : takes->named())
      lines.insert("parameter " + name + " " + parameter.name + "= " + type_name(parameter.type->name()));
}

void add_globals(std::set<std::string>& lines) {
  for (const auto& [name, value] : Global.m) {
    if (!known_after.count(name) || known_before.count(name)) continue;
    const auto* table = dynamic_cast<const Polymorphic*>(value.second);
    if (!table) {
      lines.insert(std::string("constant ") + name + " " + type_name(value.first->name()));
      continue;
    }
    for (const OneOperator* op : overloads(*table, "(")) add_call(lines, "function", name, *op, 0);
  }
}

// What the table of a type says of a name; nullptr if it is not there.
const Polymorphic* table_of(aType type, const char* name) {
  const auto& members = (type->*reveal(Members{})).m;
  const auto found = members.find(name);
  return found == members.end() ? nullptr : dynamic_cast<const Polymorphic*>(found->second.second);
}

// A member's type is either its value's, or a proxy of a method, which the parenthesis acts on.
void add_member(std::set<std::string>& lines, const std::string& name, const Polymorphic& table) {
  for (const OneOperator* dot : overloads(table, ".")) {
    const aType result = *dot;
    const bool ours = std::string(result->name()).find("burnish") != std::string::npos;
    const Polymorphic* calls = ours ? table_of(result, "(") : nullptr;
    if (!calls) lines.insert("member " + name + " -> " + type_name(result->name()));
    if (calls)
      for (const OneOperator* op : overloads(*calls, "")) add_call(lines, "method", name, *op, 1);
  }
}

void add_types(std::set<std::string>& lines) {
  for (const auto& [word, entry] : zzzfff->*reveal(Keywords{})) {
    const aType type = entry.second;
    if (!type || std::string(type->name()).find("burnish") == std::string::npos) continue;
    lines.insert(std::string("type ") + word);
    for (const OneOperator* op : overloads(*TheOperators, "<-"))
      if (OperatorArguments::of(*op)[0] == type) add_call(lines, "constructor", word, *op, 1);
    for (const auto& [name, value] : (type->*reveal(Members{})).m)
      if (const auto* table = dynamic_cast<const Polymorphic*>(value.second))
        add_member(lines, std::string(word) + "." + name, *table);
  }
}

string* callables(Stack stack, const long&) {
  return guarded([&] {
    std::set<std::string> lines;
    add_types(lines);
    add_globals(lines);
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return new_string(stack, text);
  });
}

} // namespace

std::string type_name(const char* name) {
  static const std::map<std::string, std::string> words{{typeid(double).name(), "real"},
                                                        {typeid(long).name(), "int"},
                                                        {typeid(bool).name(), "bool"},
                                                        {typeid(string*).name(), "string"},
                                                        {typeid(string).name(), "string"},
                                                        {typeid(char).name(), "string"}, // one in quotes
                                                        {typeid(KN_<double>).name(), "real[int]"},
                                                        {typeid(KN_<long>).name(), "int[int]"},
                                                        {typeid(KN<double>*).name(), "real[int]"},
                                                        {typeid(KN<long>*).name(), "int[int]"},
                                                        {typeid(NumberList*).name(), "numbers"},
                                                        {typeid(E_Array).name(), "[...]"},
                                                        {typeid(pfes*).name(), "fespace"},
                                                        {typeid(pfes3*).name(), "fespace in space"},
                                                        {typeid(::Mesh).name(), "mesh"},
                                                        {typeid(::Mesh3).name(), "mesh3"},
                                                        {typeid(Fem2D::MeshS).name(), "meshS"},
                                                        {typeid(KNM<double>*).name(), "real[int,int]"},
                                                        {typeid(Matrice_Creuse<double>*).name(), "matrix"},
                                                        {typeid(newpMatrice_Creuse<double>).name(), "matrix"},
                                                        {typeid(std::ostream**).name(), "ofstream"},
                                                        {typeid(Made<ContactObject>).name(), "contact"},
                                                        {typeid(Made<MaterialObject>).name(), "material"}};
  for (const auto& [word, entry] : zzzfff->*reveal(Keywords{}))
    if (entry.second && std::string(entry.second->name()) == name) return word;
  const auto found = words.find(name);
  if (found != words.end()) return found->second;
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> plain(abi::__cxa_demangle(name, nullptr, nullptr, &status),
                                                     std::free);
  return status == 0 ? plain.get() : name;
}

void note_names_before() { known_before = global_names(); }
void register_callables() {
  Global.Add("rcCallables", "(", new OneOperator1s_<string*, long>(callables));
  known_after = global_names();
}

} // namespace burnish
