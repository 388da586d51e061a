#include "arguments.hpp"

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

} // namespace

void refuse_unknown(const basicAC_F0& args, const basicAC_F0::name_and_type* names, int n) {
  if (!args.named_parameter) return;
  for (const auto& given : *args.named_parameter) {
    const std::string name = given.first;
    std::string list;
    bool known = false;
    for (int i = 0; i < n; ++i) {
      known = known || name == names[i].name;
      list += std::string(i ? ", " : "") + names[i].name;
    }
    if (known) continue;
    throw PluginError("unknown named parameter " + name + "=, expected " +
                      (n > 0 ? "one of " + list : std::string("none")));
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
