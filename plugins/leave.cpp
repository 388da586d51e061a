#include "leave.hpp"
#include "parallel/ranks.hpp"
#include "plugin.hpp"
#include "script_options.hpp"
#include "types.hpp"

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
  for (const std::string& name : tools_of_no_contact())
    if (status == 0 && owed == 0)
      cout << "burnish: warning: tool \"" << name
           << "\" is moved or loaded, but belongs to no contact, expected C.add" << endl;
  if (status == 0 && owed == 0 && ignores_option()) owed = 20;
  const bool pays = status == 0 && owed != 0;
  if (!pays && ranks().size() == 1) return;
  cout.flush();
  std::fflush(nullptr);
  _exit(ranks().leave(pays ? owed : status));
}

} // namespace

void leave(int status) {
  cout.flush();
  auto silence = std::make_shared<Silence>();
  throw Leave(status, std::move(silence));
}

void owe(int status) { owed = status; }

void register_end() {
  script_options(); // made before, gone after
  on_exit(pay, nullptr);
}

} // namespace burnish
