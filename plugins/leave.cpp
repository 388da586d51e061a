#include "leave.hpp"
#include "plugin.hpp"

#include <cstdlib>
#include <unistd.h>

namespace burnish {
namespace {

/// While one lives nothing is printed: FreeFEM reports every exit with a line number and a call chain.
class Silence {
public:
  Silence() : m_buffer(cout.rdbuf(nullptr)) {}
  ~Silence() {
    cout.rdbuf(m_buffer);
    cout.clear();
  }

private:
  std::streambuf* m_buffer;
};

/// The silence lasts as long as the exception: to the end of the program, or of a script's catch block.
struct Leave : Error {
  explicit Leave(int status, std::shared_ptr<Silence> silence)
      : Error(NONE, "exit ", ""), m_status(status), m_silence(std::move(silence)) {}
  int errcode() const override { return m_status; }
  int m_status;
  std::shared_ptr<Silence> m_silence;
};

int owed = 0;
void pay(int status, void*) {
  if (status != 0 || owed == 0) return;
  cout.flush();
  std::fflush(nullptr);
  _exit(owed);
}

} // namespace

void leave(int status) {
  cout.flush();
  auto silence = std::make_shared<Silence>();
  throw Leave(status, std::move(silence));
}

void owe(int status) {
  static const bool registered = on_exit(pay, nullptr) == 0;
  (void)registered;
  owed = status;
}

} // namespace burnish
