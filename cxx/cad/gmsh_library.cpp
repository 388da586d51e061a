#include "cad/gmsh_library.hpp"
#include "base/child_process.hpp"
#include "base/companion_library.hpp"
#include "base/error.hpp"
#include "base/temporary.hpp"
#include "cad/cad_text.hpp"
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstring>
#include <regex>
#include <vector>

namespace burnish {

namespace {

constexpr const char* NAME = "burnish_gmsh.so";

template <class Call> Call function(const char* name) {
  static void* const library = open_companion(NAME, "gmsh", "libgmsh-dev");
  return reinterpret_cast<Call>(companion_function(library, NAME, name));
}

std::vector<burnish_gmsh_number> pointers_to(const GeoNumbers& numbers) {
  std::vector<burnish_gmsh_number> list;
  for (const auto& [name, value] : numbers) list.push_back({name.c_str(), value});
  return list;
}

std::string last_line(const std::string& text) {
  const std::string whole = trimmed(text);
  return whole.substr(whole.find_last_of('\n') + 1);
}

std::string told(const ChildEnd& end, const std::string& log) {
  if (end.returned) return end.result;
  if (end.exit) return "it ends gmsh itself: take Exit out of it";
  if (end.signal == SIGXCPU || end.signal == SIGALRM)
    return "gmsh takes too long over it: does it call itself, or repeat something without end?";
  const std::string last = last_line(file_content(log));
  return "gmsh breaks down over it" +
         (end.signal ? std::string(" (") + strsignal(end.signal) + ")" : std::string()) +
         (end.signal == SIGABRT ? "; is a number in it not finite?" : "") +
         (last.empty() ? "" : " Its last words: " + last.substr(0, 200));
}

} // namespace

GeoNumbers parse_numbers(const std::string& where, const std::string& text) {
  GeoNumbers numbers;
  std::istringstream parts(std::regex_replace(text, std::regex(","), ";"));
  for (std::string part; std::getline(parts, part, ';');) {
    part = trimmed(part);
    if (part.empty()) continue;
    const std::size_t equal = part.find('=');
    const std::string name = trimmed(part.substr(0, equal));
    const std::string value = equal == std::string::npos ? "" : trimmed(part.substr(equal + 1));
    double number = 0;
    const auto [end, code] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (!std::regex_match(name, std::regex("[A-Za-z_][A-Za-z_0-9]*")) || code != std::errc() ||
        end != value.data() + value.size() || !std::isfinite(number))
      fail(where, "\"" + part + "\" is no number for the geometry, expected name=value; name=value");
    if (!numbers.emplace(name, number).second) fail(where, "number \"" + name + "\" is given twice");
  }
  return numbers;
}

std::string gmsh_curves(const std::string& file, const GeoNumbers& numbers, const std::string& folder,
                        double seconds) {
  const auto call = function<burnish_gmsh_curves_call>("burnish_gmsh_curves");
  const auto list = pointers_to(numbers);
  const std::string log = folder + "/log";
  const auto read = [&]() -> std::string {
    const char* error =
        call(file.c_str(), list.data(), static_cast<int>(list.size()), folder.c_str(), seconds);
    return error ? error : "";
  };
  return told(run_in_child(read, log), log);
}

std::string gmsh_mesh(const std::string& file, const GeoNumbers& numbers, const std::string& result,
                      const std::string& log, const GeoMeshing& meshing) {
  const auto call = function<burnish_gmsh_mesh_call>("burnish_gmsh_mesh");
  const auto list = pointers_to(numbers);
  const TemporaryFolder folder;
  const auto make = [&]() -> std::string {
    const char* error = call(file.c_str(), list.data(), static_cast<int>(list.size()), folder.path().c_str(),
                             result.c_str(), meshing.dimension, meshing.sizes.c_str());
    return error ? error : "";
  };
  return told(run_in_child(make, log), log);
}

std::string gmsh_fill(const burnish_gmsh_body& body, const std::string& result, const std::string& log) {
  const auto call = function<burnish_gmsh_fill_call>("burnish_gmsh_fill");
  const auto fill = [&]() -> std::string {
    const char* error = call(&body, result.c_str());
    return error ? error : "";
  };
  return told(run_in_child(fill, log), log);
}

} // namespace burnish
