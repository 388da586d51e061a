#include "cad/cad_text.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <vector>

namespace burnish {

namespace {

constexpr const char* CAD_TEXT = "CadFile";

std::string content(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code code;
  const std::string quoted = "\"" + path + "\"", end = file_extension(path);
  if (!fs::exists(path, code))
    fail(CAD_TEXT, quoted + " does not exist, seen from folder " + fs::current_path().string());
  if (fs::is_directory(path, code)) fail(CAD_TEXT, quoted + " is a folder");
  if (!fs::is_regular_file(path, code)) fail(CAD_TEXT, quoted + " is no ordinary file");
  if (end != ".geo" && end != ".step" && end != ".stp" && end != ".brep")
    fail(CAD_TEXT, quoted + " ends in \"" + end + "\", expected .geo, .step, .stp or .brep");
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || trimmed(text.str()).empty())
    fail(CAD_TEXT,
         quoted + (fs::file_size(path, code) > 0 && text.str().empty() ? " cannot be read" : " is empty"));
  return text.str();
}

// gmsh says little of these.
void check_kind(const std::string& quoted, const std::string& end, const std::string& text) {
  const auto begins_with = [&](const char* words) {
    return text.substr(0, 1000).find(words) != std::string::npos;
  };
  if (text.find('\0') != std::string::npos) fail(CAD_TEXT, quoted + " is no text: it has bytes of value 0");
  if (end == ".brep" && !begins_with("CASCADE Topology"))
    fail(CAD_TEXT, quoted + " is no BREP file: it does not begin with \"CASCADE Topology\"");
  if ((end == ".step" || end == ".stp") && !begins_with("ISO-10303-21"))
    fail(CAD_TEXT, quoted + " is no STEP file: it does not begin with \"ISO-10303-21\"");
}

// OpenCASCADE takes them, and is busy with them for ever.
void check_finite(const std::string& quoted, const std::string& text) {
  const char* const blanks = " \t\r\n";
  for (std::size_t begin = 0; (begin = text.find_first_not_of(blanks, begin)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    std::string word = text.substr(begin, std::min<std::size_t>(end - begin, 4));
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const std::string letters = word.substr(word[0] == '-' || word[0] == '+' ? 1 : 0, 3);
    if (letters == "nan" || letters == "inf")
      fail(CAD_TEXT,
           quoted + ", line " +
               std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<long>(begin), '\n')) +
               ": " + text.substr(begin, end - begin) + " is no finite number");
    begin = end;
  }
}

/// A .geo file and what it includes, as far as the names of these files are written there.
struct GeoText {
  std::vector<std::pair<std::string, std::string>> files; ///< paths and contents
  bool whole = true;                                      ///< false: some could not be found this way
};

void gather(const std::string& path, const std::string& text, GeoText& all) {
  all.files.emplace_back(path, text);
  std::istringstream lines(text);
  const std::regex word("\\b(Include|Merge)\\b"), literal("\\b(Include|Merge)\\s*\"([^\"]*)\"");
  for (std::string line; std::getline(lines, line);) {
    line = line.substr(0, line.find("//"));
    std::smatch found;
    if (!std::regex_search(line, word)) continue;
    const auto folder = std::filesystem::path(path).parent_path();
    const bool named = std::regex_search(line, found, literal);
    const std::string name = named ? (folder / found[2].str()).string() : "";
    std::ifstream stream(name, std::ios::binary);
    std::ostringstream content;
    if (named && stream) content << stream.rdbuf();
    if (content.str().empty() || all.files.size() > 20)
      all.whole = false;
    else if (file_extension(name) == ".geo")
      gather(name, content.str(), all);
  }
}

// Printf(...) > "file"; nothing else has a quotation mark after this sign.
bool redirects(const std::string& line) {
  for (std::size_t at = line.find('>'); at != std::string::npos; at = line.find('>', at + 1)) {
    const std::size_t next = line.find_first_not_of(" \t", at + 1);
    if (next != std::string::npos && line[next] == '"') return true;
  }
  return false;
}

void check_geo(const std::string& path, const std::string& text) {
  const std::string last = text.substr(text.find_last_of('\n') + 1), quoted = "\"" + path + "\"";
  if (std::count(last.begin(), last.end(), ';') > 1)
    fail(CAD_TEXT,
         quoted + " does not end with a new line: gmsh would read only one command of its last line");
  std::istringstream lines(text);
  const std::regex runs("(^|[;})/])\\s*((NonBlocking)?SystemCall|System|OnelabRun)\\b(?!\\s*=)");
  const std::regex writes("(^|[;})/])\\s*(Save|Print|CreateDir|CreateFolder)\\b(?!\\s*[=.])");
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = line.substr(0, line.find("//"));
    std::smatch found;
    if (std::regex_search(line, found, runs))
      fail(CAD_TEXT, quoted + ", line " + std::to_string(number) + ": " + found[2].str() +
                         " would run another program; take it out");
    if (std::regex_search(line, found, writes) || redirects(line))
      fail(CAD_TEXT, quoted + ", line " + std::to_string(number) + ": " +
                         (found.empty() ? "Printf" : found[2].str()) + " would write a file; take it out");
  }
}

// The text without comments and without what stands in quotation marks.
std::string code_of(const std::string& text) {
  std::string code;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string two = text.substr(i, 2);
    const std::string end = two == "//" ? "\n" : two == "/*" ? "*/" : text[i] == '"' ? "\"" : "";
    if (end.empty()) {
      code += text[i];
      continue;
    }
    const std::size_t at = text.find(end, i + (text[i] == '"' ? 1 : 2));
    if (at == std::string::npos) break;
    i = at + end.size() - 1;
    code += end == "\n" ? '\n' : ' ';
  }
  return code;
}

// A number that no file knows would change nothing: a typing error.
void check_known(const std::string& quoted, const GeoText& all,
                 const std::map<std::string, double>& numbers) {
  if (!all.whole) return;
  for (const auto& number : numbers) {
    const std::regex name("\\b" + number.first + "\\b");
    const auto holds = [&](const auto& file) { return std::regex_search(code_of(file.second), name); };
    if (std::none_of(all.files.begin(), all.files.end(), holds))
      fail(CAD_TEXT, quoted + " has no number \"" + number.first + "\"");
  }
}

} // namespace

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string file_extension(const std::string& path) {
  std::string end = std::filesystem::path(path).extension().string();
  for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return end;
}

void check_cad_text(const std::string& path, const std::map<std::string, double>& numbers) {
  const std::string text = content(path), quoted = "\"" + path + "\"", end = file_extension(path);
  check_kind(quoted, end, text);
  if (end == ".geo") {
    GeoText all;
    gather(path, text, all);
    for (const auto& [name, content] : all.files) check_geo(name, content);
    check_known(quoted, all, numbers);
    return;
  }
  if (!numbers.empty()) fail(CAD_TEXT, quoted + " takes no numbers, only .geo files do");
  if (end == ".brep") check_finite(quoted, text);
}

} // namespace burnish
