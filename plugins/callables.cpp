// What the plugin has registered, read from FreeFEM's own tables.
//   rcCallables(dummy)   a line for each type, constant, function, constructor, method, member and named parameter with its
//                        types; tests/shell/test_reference.sh holds it against edp/manual/reference/callables.txt
//     dummy   not read
#include "callables.hpp"
#include "named.hpp"
#include "tables.hpp"
#include "types.hpp"

#include <cxxabi.h>
#include <set>

namespace burnish {
namespace {

std::set<std::string> known_before, known_after; // global names

std::set<std::string> global_names() {
  std::set<std::string> names;
  for (const auto& entry : Global.m) names.insert(entry.first);
  return names;
}

// "KIND NAME(types) -> type", without the first `hidden` arguments, and its named parameters.
void add_call(std::set<std::string>& lines, const std::string& kind, const std::string& name,
              const OneOperator& op, std::size_t hidden) {
  std::string line = kind + " " + name + "(";
  const std::vector<aType> arguments = argument_types(op);
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

// A member's type is either its value's, or a proxy of a method, which the parenthesis acts on: its table then.
const Polymorphic* calls_of(aType member) {
  const bool ours = std::string(member->name()).find("burnish") != std::string::npos;
  return ours ? table_of(member, "(") : nullptr;
}

void add_member(std::set<std::string>& lines, const std::string& name, const Polymorphic& table) {
  for (const OneOperator* dot : overloads(table, ".")) {
    const aType result = *dot;
    const Polymorphic* calls = calls_of(result);
    if (!calls) lines.insert("member " + name + " -> " + type_name(result->name()));
    if (calls)
      for (const OneOperator* op : overloads(*calls, "")) add_call(lines, "method", name, *op, 1);
  }
}

/// Calls f(word, type) for each of our types.
template <class F> void each_type(F&& f) {
  for (const auto& [word, entry] : zzzfff->*reveal(Keywords{}))
    if (entry.second && std::string(entry.second->name()).find("burnish") != std::string::npos)
      f(std::string(word), entry.second);
}

void add_types(std::set<std::string>& lines) {
  each_type([&](const std::string& word, aType type) {
    lines.insert("type " + word);
    for (const OneOperator* op : overloads(*TheOperators, "<-"))
      if (argument_types(*op)[0] == type) add_call(lines, "constructor", word, *op, 1);
    for (const auto& [name, value] : (type->*reveal(Members{})).m)
      if (const auto* table = dynamic_cast<const Polymorphic*>(value.second))
        add_member(lines, word + "." + name, *table);
  });
}

void check_methods(const std::string& word, aType type) {
  for (const auto& [name, value] : (type->*reveal(Members{})).m) {
    const auto* table = dynamic_cast<const Polymorphic*>(value.second);
    if (!table) continue;
    for (const OneOperator* dot : overloads(*table, "."))
      if (const Polymorphic* calls = calls_of(*dot)) check_arguments(word + "." + name, *calls, "", 1);
  }
}

void check_all() {
  for (const auto& [name, value] : Global.m) {
    const auto* table = dynamic_cast<const Polymorphic*>(value.second);
    if (table && known_after.count(name) && !known_before.count(name)) check_arguments(name, *table, "(", 0);
  }
  each_type([](const std::string& word, aType type) {
    check_constructor(word, type);
    check_methods(word, type);
  });
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
  static const std::map<std::string, std::string> words{
      {typeid(double).name(), "real"},
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
      {typeid(pfesS*).name(), "fespace on a surface"},
      {typeid(pmesh*).name(), "mesh"},
      {typeid(pmesh3*).name(), "mesh3"},
      {typeid(std::pair<FEbase<double, v_fes>*, int>).name(), "finite element function"},
      {typeid(std::pair<FEbase<double, v_fes3>*, int>).name(), "finite element function in space"},
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
  check_all();
}

} // namespace burnish
