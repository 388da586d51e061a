#include "arguments.hpp"
#include "callables.hpp"

namespace burnish {
namespace {

const std::type_info* type_of(ArgumentKind kind) {
  switch (kind) {
  case ArgumentKind::NUMBER:
    return &typeid(double);
  case ArgumentKind::NUMBERS:
    return &typeid(NumberList*);
  case ArgumentKind::TEXT:
    return &typeid(string*);
  case ArgumentKind::FLAG:
    return &typeid(bool);
  }
  return nullptr;
}

void take(const Named& named, const Parameter& parameter, Arguments& arguments) {
  const std::string& name = parameter.name;
  switch (parameter.kind) {
  case ArgumentKind::NUMBER:
    arguments.numbers[name] = named.real(name.c_str(), 0);
    break;
  case ArgumentKind::NUMBERS:
    arguments.lists[name] = named.numbers(name.c_str());
    break;
  case ArgumentKind::TEXT:
    arguments.texts[name] = named.text(name.c_str(), "");
    break;
  case ArgumentKind::FLAG:
    arguments.flags[name] = named.boolean(name.c_str(), false);
    break;
  }
}

[[noreturn]] void refuse_unknown(const std::string& name, const basicAC_F0::name_and_type* names, int n) {
  std::string list;
  for (int i = 0; i < n; ++i) list += std::string(i ? ", " : "") + names[i].name;
  throw PluginError("unknown named parameter " + name + "=, expected " +
                    (n > 0 ? "one of " + list : std::string("none")));
}

} // namespace

void refuse_unfit(const basicAC_F0& args, const basicAC_F0::name_and_type* names, int n) {
  if (!args.named_parameter) return;
  for (const auto& given : *args.named_parameter) {
    const std::string name = given.first;
    const auto* const known =
        std::find_if(names, names + n, [&](const auto& one) { return name == one.name; });
    if (known == names + n) refuse_unknown(name, names, n);
    const aType type = map_type[known->type->name()], value = given.second.left();
    if (!type || !value || type->CastingFrom(value)) continue;
    const std::string is = type_name(value->name()), wanted = type_name(type->name());
    const bool literal =
        is == "[...]" && wanted.find('[') != std::string::npos; // FreeFEM makes no array of it here
    throw PluginError("named parameter " + name + "= is of type " + is + ", expected " + wanted +
                      (literal ? ": " + wanted + " list = [...]; before, and " + name + "=list" : ""));
  }
}

std::vector<basicAC_F0::name_and_type> names_of(const std::vector<Parameter>& list,
                                                const std::vector<basicAC_F0::name_and_type>& more) {
  std::vector<basicAC_F0::name_and_type> names;
  for (const Parameter& parameter : list) names.push_back({parameter.name.c_str(), type_of(parameter.kind)});
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

Arguments arguments_of(const Named& named, const std::vector<Parameter>& list) {
  Arguments arguments;
  for (const Parameter& parameter : list)
    if (named.has(parameter.name.c_str())) take(named, parameter, arguments);
  return arguments;
}

} // namespace burnish
