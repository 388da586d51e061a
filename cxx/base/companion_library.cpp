#include "base/companion_library.hpp"
#include "base/error.hpp"
#include <dlfcn.h>
#include <filesystem>

namespace burnish {

void* open_companion(const char* name, const char* what, const char* needs) {
  Dl_info self;
  if (dladdr(reinterpret_cast<const void*>(&open_companion), &self) == 0)
    fail(what, "where is this program?");
  const auto folder = std::filesystem::path(self.dli_fname).parent_path();
  std::string path = (folder / name).string();
  const std::string other = (folder / ".." / "plugins" / name).string();
  if (!std::filesystem::exists(path) && std::filesystem::exists(other)) path = other;
  if (path == name) path = std::string("./") + name; // not somewhere in the system's folders
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library) return library;
  fail(what, std::string(what) + "'s library cannot be opened: " + dlerror() + "; Debian's package " + needs +
                 " has it, and make builds " + name);
}

void* companion_function(void* library, const char* name, const char* function) {
  void* const address = dlsym(library, function);
  if (!address) fail(name, std::string(name) + " is of another version: it has no " + function);
  return address;
}

} // namespace burnish
