#include "settings.hpp"
#include "script/words.hpp"
#include "script_options.hpp"
#include <cstdlib>

namespace burnish {
namespace {

const std::type_info* type_of(const Setting& setting) {
  const std::type_info* const types[] = {&typeid(double), &typeid(long), &typeid(bool), &typeid(string*)};
  return types[setting.member.index()];
}

void take(const Named& named, const Setting& setting, Settings& all, const char* where) {
  if (std::holds_alternative<Choice>(setting.member))
    return set_choice(all, setting, named.text(setting.name, ""), where);
  const std::type_info* const type = type_of(setting);
  const double value = *type == typeid(double) ? named.real(setting.name, 0)
                       : *type == typeid(long) ? static_cast<double>(named.integer(setting.name, 0))
                                               : named.boolean(setting.name, false);
  set_number(all, setting, value, where, setting.name);
}

void take_option(const Setting& setting, Settings& all) {
  const std::string option = std::string("-") + setting.name;
  if (!script_options().reads_setting(option)) return;
  if (std::holds_alternative<Choice>(setting.member))
    set_choice(all, setting, script_options().text(option, "", setting.unit, setting.meaning), "option");
  else
    set_number(all, setting, script_options().real(option, 0, setting.unit, setting.meaning), "option",
               option);
}

} // namespace

std::vector<basicAC_F0::name_and_type> setting_names(const std::string& owner,
                                                     const std::vector<basicAC_F0::name_and_type>& more) {
  std::vector<basicAC_F0::name_and_type> names;
  for (const Setting& setting : settings())
    if (setting.owner == owner) names.push_back({setting.name, type_of(setting)});
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

Settings settings_of(const Named& named, const std::string& owner, const char* where) {
  Settings all;
  for (const Setting& setting : settings()) {
    if (setting.owner != owner) continue;
    if (named.has(setting.name)) take(named, setting, all, where);
    take_option(setting, all);
  }
  return all;
}

void accept_settings() {
  const char* path = std::getenv("FF_INCLUDEPATH");
  for (const Setting& setting : settings())
    if (script_uses(script_options().script(), setting.owner, path ? path : ""))
      script_options().accept(std::string("-") + setting.name);
}

} // namespace burnish
