#pragma once
// Which names a script uses.
#include <map>
#include <string>

namespace burnish {

/// Whether one of the words, "a b c", stands in the script, outside of comments, or in a file that it includes. burnish.idp and files
/// that cannot be read have none. @param folders "a;b", where included files are looked for after the
/// folder of the file itself
bool script_uses(const std::string& script, const std::string& words, const std::string& folders);

/// The first of the names, "a b", that the script itself declares as a variable, a function or a parameter, though a type bears it: the name
/// and its line, "tool in line 7"; "" if it declares none after its include of burnish.idp.
std::string declared_name(const std::string& script, const std::string& names);

/// The script and the files that it includes, by name without folder, without comments and empty lines; not burnish.idp.
std::map<std::string, std::string> script_code(const std::string& script, const std::string& folders);

} // namespace burnish
