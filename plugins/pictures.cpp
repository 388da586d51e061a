// Programs beside the scripts, started without a shell by $PYTHON or python3. Failing is a warning.
//   rcPicture(folder)   draws final.png of a run's results: workpiece, field and tools at its end; 0: drawn
//     folder    of the results
//   rcPictureSoon(dimension)   starts the program of the next rcPicture while the run still computes: it reads its libraries, which takes as long
//              as to draw, and waits for the folder. It ends with the script; without it rcPicture draws the same, later. 0
//     dimension   2 or 3: what is to be drawn
//   rcPictures(folder)   draws all pictures of a run's results, by a plot.py beside the script, else those of any scene; 0: drawn
//     folder    of the results
//   rcMovie(folder)   movie.html and movie.gif of a run's series of fields, by the same programs; 0: made
//     folder    of the results
//   rcLeaner(folder)   runs the script again with leaner models and compares the results, cases/sweep/leaner.py; 0: done
//     folder    of the results
#include "parallel/ranks.hpp"
#include "plugin.hpp"
#include "script_options.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace burnish {
namespace {

std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value && *value ? value : otherwise;
}

/// The folder of cases/: $BURNISH_TOP; set here, for the programs started too, where share/burnish lies beside an installed plugin's
/// lib/burnish.
std::string top() {
  Dl_info self;
  if (!std::getenv("BURNISH_TOP") && dladdr(reinterpret_cast<const void*>(&register_pictures), &self)) {
    std::error_code none;
    const auto plugin = std::filesystem::canonical(self.dli_fname, none);
    const auto share = plugin.parent_path() / "../../share/burnish";
    if (std::filesystem::exists(share / "cases/plotting", none))
      setenv("BURNISH_TOP", share.lexically_normal().c_str(), 1);
  }
  return environment("BURNISH_TOP", ".");
}

std::string scene_program() { return top() + "/cases/plotting/scene.py"; }
std::string plot_program() {
  const std::string beside = script_options().folder() + "plot.py";
  return std::filesystem::exists(beside) ? beside : scene_program();
}

/// Its process, 0 if it cannot be started. input: what it reads as its standard input, -1: as we do
pid_t start(std::vector<std::string> words, int input = -1) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (input >= 0) posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  pid_t process = 0;
  const int code = posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  return code == 0 ? process : 0;
}

/// Exit status, -1 if a signal ended it or there is none.
int end_of(pid_t process) {
  int status = 0;
  if (process == 0) return -1;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Exit status of a program, -1 if it cannot be started; of rank 0, which alone starts it.
int run(std::vector<std::string> words) {
  int status = ranks().rank() == 0 ? end_of(start(words)) : 0;
  ranks().broadcast(&status, sizeof status, 0);
  return status;
}

/// The program of rcPictureSoon, which waits at the other end of the line.
struct Waiting {
  pid_t process = 0;
  int line = -1;
};
Waiting& waiting() {
  static Waiting program;
  return program;
}

long picture_soon(const long& dimension) {
  if (ranks().rank() != 0 || waiting().process != 0) return 0;
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return 0;
  const std::string libraries = dimension == 3 ? "space" : "plane";
  waiting() = {start({environment("PYTHON", "python3"), scene_program(), "-", "final", libraries}, ends[1]),
               ends[0]};
  close(ends[1]);
  if (waiting().process == 0) close(ends[0]);
  return 0;
}

/// Exit status of the program that waits, once it has drawn; -1 without one, or where a signal ended it (Ctrl-C).
int drawn_by_waiting(const std::string& folder) {
  int status = -1;
  if (const Waiting program = std::exchange(waiting(), {}); program.process != 0) {
    const std::string line = folder + "\n";
    send(program.line, line.data(), line.size(), MSG_NOSIGNAL);
    close(program.line);
    status = end_of(program.process);
  }
  ranks().broadcast(&status, sizeof status, 0);
  return status;
}

int said(int code) {
  if (code != 0)
    cout << "burnish: warning: the pictures could not be drawn (exit status " << code << ")" << endl;
  return code;
}
long picture(string* const& folder) {
  cout.flush();
  const int code = drawn_by_waiting(*folder);
  return said(code >= 0 ? code : run({environment("PYTHON", "python3"), scene_program(), *folder, "final"}));
}
long pictures(string* const& folder) {
  cout.flush();
  return said(run({environment("PYTHON", "python3"), plot_program(), *folder}));
}

long movie(string* const& folder) {
  cout.flush();
  const std::string page = *folder + "/movie.html", python = environment("PYTHON", "python3");
  std::error_code code;
  if (ranks().rank() == 0) std::filesystem::remove(page, code); // of an earlier run
  int status = run({python, plot_program(), *folder, "movie"});
  if (!first_rank_says(std::filesystem::exists(page)) && plot_program() != scene_program())
    status = run({python, scene_program(), *folder, "movie"});
  if (status != 0) cout << "burnish: warning: no movie could be made (exit status " << status << ")" << endl;
  return status;
}

long leaner(string* const& folder) {
  cout.flush();
  const std::string program = top() + "/cases/sweep/leaner.py";
  const int code = run({environment("PYTHON", "python3"), program, *folder, script_options().script()});
  if (code != 0)
    cout << "burnish: warning: leaner models could not be compared (exit status " << code << ")" << endl;
  return code;
}

} // namespace

void register_pictures() {
  Global.Add("rcPicture", "(", new OneOperator1_<long, string*>(picture));
  Global.Add("rcPictureSoon", "(", new OneOperator1_<long, long>(picture_soon));
  Global.Add("rcPictures", "(", new OneOperator1_<long, string*>(pictures));
  Global.Add("rcMovie", "(", new OneOperator1_<long, string*>(movie));
  Global.Add("rcLeaner", "(", new OneOperator1_<long, string*>(leaner));
}

} // namespace burnish
