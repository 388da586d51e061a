#pragma once
// Checks of the text of a CAD file before OpenCASCADE or gmsh reads it.
#include <map>
#include <string>

namespace burnish {

/// Without blanks and line ends at both ends.
std::string trimmed(const std::string& text);

/// In small letters, with its dot.
std::string file_extension(const std::string& path);

/// Of a .geo file also the files that it includes by their written names.
/// @param numbers  values for names of a .geo file
/// @throws std::invalid_argument with the file: missing, a folder or no file, of another kind than its name
/// tells, empty, a .geo whose last line gmsh would not read or that runs programs (SystemCall), a .brep
/// with numbers that are not finite, numbers for another kind of file or with a name that no file has
void check_cad_text(const std::string& path, const std::map<std::string, double>& numbers);

} // namespace burnish
