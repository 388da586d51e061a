#pragma once
// Files that are whole or not there: written under another name and moved; lines added to the end, whole ones only.
#include <string>

namespace burnish {

/// What the name of a file begins with while it is written.
constexpr const char* NEW_MARK = ".new.";
/// Where the new content of a file is written: "folder/.new.name".
std::string new_name(const std::string& path);
/// Makes text the content of a file. @throws FileError
void write_whole(const std::string& path, const std::string& text);
/// Moves new_name(path) onto path. @param ok false: writing it failed; it is removed, and path stays as it is
/// @throws FileError naming path and reason
void replace_file(const std::string& path, bool ok);
/// After a line was added to path. @param ok false: that failed; what follows the last whole line is cut off
/// @throws FileError then
void keep_whole_lines(const std::string& path, bool ok);
/// Whether a file ends with this text, blanks after it.
bool ends_with(const std::string& path, const std::string& text);

} // namespace burnish
