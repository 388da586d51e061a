#include "tables.hpp"
#include "callables.hpp"

namespace burnish {
namespace {

struct Opened : OneOperator { // never made: opens what OneOperator protects
  static std::vector<aType> of(const OneOperator& op) {
    aType* const first = op.*(&Opened::t);
    return {first, first + op.*(&Opened::n)};
  }
  static std::vector<aType> of(const ArrayOfaType& given) {
    aType* const first = given.*(&Opened::t);
    return {first, first + given.*(&Opened::n)};
  }
};

std::string listed(const std::vector<aType>& types, std::size_t hidden) {
  std::string text = "(";
  for (std::size_t i = hidden; i < types.size(); ++i)
    text += (i == hidden ? "" : ", ") + type_name(types[i]->name());
  return text + ")";
}

/// Stands in a table for other operators: takes all arguments, and gives them to the one that FreeFEM would have found.
class ArgumentCheck : public OneOperator {
public:
  ArgumentCheck(std::string name, std::vector<const OneOperator*> list, const ArrayOfaType& first,
                std::size_t hidden)
      : OneOperator(*list.front(), first), m_name(std::move(name)), m_list(std::move(list)),
        m_hidden(hidden) {
    pref = 1; // before those that stay in the table
  }
  E_F0* code(const basicAC_F0& args) const override { return found(args).code(args); }
  C_F0 code2(const basicAC_F0& args) const override { return found(args).code2(args); }
  const std::vector<const OneOperator*>& list() const { return m_list; }

private:
  /// As OneOperator::Find: as few conversions as possible, then as large a preference.
  const OneOperator& found(const basicAC_F0& args) const {
    const ArrayOfaType given(args);
    for (int casts = 0; casts <= args.size(); ++casts) {
      const OneOperator* best = nullptr;
      int number = 0;
      for (const OneOperator* one : m_list) {
        if (!one->WithCast(given, casts) || (best && one->pref < best->pref)) continue;
        number = best && one->pref == best->pref ? number + 1 : 1;
        best = one;
      }
      if (number == 1) return *best;
      if (number > 1) break;
    }
    std::string allowed;
    for (const OneOperator* one : m_list)
      allowed += (allowed.empty() ? "" : " or ") + listed(argument_types(*one), m_hidden);
    throw PluginError(m_name + ": arguments " + listed(Opened::of(given), m_hidden) + ", expected " +
                      allowed);
  }

  std::string m_name;
  std::vector<const OneOperator*> m_list;
  std::size_t m_hidden;
};

} // namespace

std::vector<aType> argument_types(const OneOperator& op) { return Opened::of(op); }

std::vector<const OneOperator*> overloads(const Polymorphic& table, const char* op) {
  std::vector<const OneOperator*> list;
  const auto& map = table.*reveal(Operators{});
  const auto found = map.find(op);
  for (const OneOperator* one = found == map.end() ? nullptr : found->second; one;
       one = one->*reveal(Next{})) {
    const auto* check = dynamic_cast<const ArgumentCheck*>(one);
    if (!check)
      list.push_back(one);
    else if (one == found->second) // of a constructor it stands beside them
      list.insert(list.end(), check->list().begin(), check->list().end());
  }
  return list;
}

void check_arguments(const std::string& name, const Polymorphic& table, const char* op, std::size_t hidden) {
  const auto list = overloads(table, op);
  if (!list.empty())
    (const_cast<Polymorphic&>(table).*reveal(Operators{}))[op] =
        new ArgumentCheck(name, list, ArrayOfaType(true), hidden);
}

void check_constructor(const std::string& name, aType type) {
  std::vector<const OneOperator*> list;
  for (const OneOperator* one : overloads(*TheOperators, "<-"))
    if (argument_types(*one)[0] == type) list.push_back(one);
  if (!list.empty()) TheOperators->Add("<-", new ArgumentCheck(name, list, ArrayOfaType(type, true), 1));
}

} // namespace burnish
