// Memory that runs out is std::bad_alloc in this library. FreeFem++ puts an operator new of its own in the place of the standard one, for
// all libraries, which returns null where there is none left: a crash. The library is linked with -Bsymbolic-functions, so that its code,
// templates of the standard library among it, calls this one; what it returns is freed by any operator delete.
#include <cstdlib>
#include <new>

void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* operator new[](std::size_t size) { return operator new(size); }
