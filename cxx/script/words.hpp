#pragma once
// Which names a script uses.
#include <map>
#include <string>

namespace burnish {

/// Whether one of the words, "a b c", stands in the script, outside of comments, or in a file that it includes. burnish.idp and files
/// that cannot be read have none. @param folders "a;b", where included files are looked for after the
/// folder of the file itself
bool script_uses(const std::string& script, const std::string& words, const std::string& folders);

/// The script and the files that it includes, by name without folder, without comments and empty lines; not burnish.idp.
std::map<std::string, std::string> script_code(const std::string& script, const std::string& folders);

} // namespace burnish
