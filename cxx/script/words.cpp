#include "script/words.hpp"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

namespace burnish {
namespace {

const std::string LIBRARY = "burnish.idp"; // names every word

std::string read_without_comments(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream whole;
  whole << file.rdbuf();
  const std::string text = whole.str();
  std::string code;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!quoted && text.compare(i, 2, "//") == 0) i = text.find('\n', i);
    if (!quoted && i != std::string::npos && text.compare(i, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", i);
      if (end != std::string::npos) code.append(std::count(text.begin() + i, text.begin() + end, '\n'), '\n');
      i = end;
    }
    if (i == std::string::npos) break;
    if (text[i] == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
    code += text[i];
  }
  return code;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

/// Reads a script and what it includes, each file once.
class Search {
public:
  /// @param stop called with path and code of a file; true ends the search
  Search(std::function<bool(const std::string&, const std::string&)> stop, const std::string& folders)
      : m_stop(std::move(stop)), m_folders(split(folders, ';')) {}
  bool finds(const std::string& path) {
    if (!m_read.insert(std::filesystem::weakly_canonical(path)).second) return false;
    const std::string code = read_without_comments(path);
    if (m_stop(path, code)) return true;
    static const std::regex INCLUDE("\\binclude\\s*\"([^\"]+)\"");
    const std::string own = path.substr(0, path.rfind('/') + 1); // "" without a folder
    for (std::sregex_iterator found(code.begin(), code.end(), INCLUDE), last; found != last; ++found) {
      const std::string name = (*found)[1];
      if (name == LIBRARY) continue;
      if (finds(own + name) || finds(name)) return true; // beside it, or in the present folder
      for (const std::string& folder : m_folders)
        if (finds(folder + "/" + name)) return true;
    }
    return false;
  }

private:
  std::function<bool(const std::string&, const std::string&)> m_stop;
  std::vector<std::string> m_folders;
  std::set<std::string> m_read;
};

} // namespace

std::string declared_name(const std::string& script, const std::string& names) {
  std::string either;
  for (const std::string& name : split(names, ' ')) either += (either.empty() ? "" : "|") + name;
  std::string types = "\\b(?:real|int|bool|complex|string|mesh3?|meshS|meshL|matrix|varf|border|fespace|func";
  const std::string name = "[\\s&\\[]\\s*(" + either + ")\\s*[=;,()\\[\\]]",
                    later = "[^;{}()]*,\\s*(" + either + ")\\s*[=;,\\[\\]]";
  static const std::regex QUOTED("\"(?:[^\"\\\\\n]|\\\\.)*\""), SPACE("\\bfespace\\s+(\\w+)");
  std::string code = read_without_comments(script);
  const std::size_t library = code.find(LIBRARY);
  const auto before = code.begin() + (library == std::string::npos ? 0 : library);
  const long first = 1 + std::count(code.begin(), before, '\n');
  code = std::regex_replace("\"" + std::string(before, code.end()), QUOTED, "\"\"");
  for (std::sregex_iterator space(code.begin(), code.end(), SPACE), last; space != last; ++space)
    types += "|" + (*space)[1].str() + "(?=\\s*[\\[\\w<])"; // its functions
  types += ")\\b";
  std::smatch found;
  for (const std::string& rest : {"(?:\\s+\\w+)?\\s*(?:\\[[^\\]]*\\])?" + name, later})
    if (std::regex_search(code, found, std::regex(types + rest)))
      return found[1].str() + " in line " +
             std::to_string(first + std::count(code.begin(), code.begin() + found.position(1), '\n'));
  return "";
}

bool script_uses(const std::string& script, const std::string& words, const std::string& folders) {
  if (words.empty()) return false;
  std::string either;
  for (const std::string& word : split(words, ' ')) either += (either.empty() ? "" : "|") + word;
  const std::regex any("\\b(" + either + ")\\b");
  const auto holds = [&](const std::string&, const std::string& code) {
    return std::regex_search(code, any);
  };
  return Search(holds, folders).finds(script);
}

std::map<std::string, std::string> script_code(const std::string& script, const std::string& folders) {
  std::map<std::string, std::string> codes;
  const auto take = [&](const std::string& path, const std::string& code) {
    std::string lines;
    for (std::string line : split(code, '\n')) {
      line.erase(line.find_last_not_of(" \t\r") + 1);
      line.erase(0, line.find_first_not_of(" \t"));
      if (!line.empty()) lines += line + "\n";
    }
    if (!lines.empty()) codes[std::filesystem::path(path).filename()] += lines;
    return false;
  };
  Search(take, folders).finds(script);
  return codes;
}

} // namespace burnish
