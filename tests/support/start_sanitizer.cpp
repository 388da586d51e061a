// Preloaded by make sanitize and initialized before all libraries: the sanitizer of addresses starts with the first
// malloc. Where that malloc is newlocale's, which holds the C library's lock of locales, the start takes the lock a
// second time (dlerror reads translations) and leaves it released once too often: child processes wait forever.
#include <cstdlib>

[[gnu::constructor]] static void start_sanitizer() {
  void* volatile memory = std::malloc(1);
  std::free(memory);
}
