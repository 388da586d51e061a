// Programs beside the scripts, started without a shell by $PYTHON or python3. Failing is a warning.
//   rcPicture(folder)   draws final.png of a run's results: workpiece, field and tools at its end; 0: drawn
//     folder    of the results
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
#include <sys/wait.h>

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

int run_here(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  if (posix_spawnp(&process, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return -1;
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Exit status of a program, -1 if it cannot be started; of rank 0, which alone starts it.
int run(std::vector<std::string> words) {
  int status = ranks().rank() == 0 ? run_here(words) : 0;
  ranks().broadcast(&status, sizeof status, 0);
  return status;
}

long drawn(const std::vector<std::string>& words) {
  cout.flush();
  const int code = run(words);
  if (code != 0)
    cout << "burnish: warning: the pictures could not be drawn (exit status " << code << ")" << endl;
  return code;
}
long picture(string* const& folder) {
  return drawn({environment("PYTHON", "python3"), scene_program(), *folder, "final"});
}
long pictures(string* const& folder) {
  return drawn({environment("PYTHON", "python3"), plot_program(), *folder});
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
  Global.Add("rcPictures", "(", new OneOperator1_<long, string*>(pictures));
  Global.Add("rcMovie", "(", new OneOperator1_<long, string*>(movie));
  Global.Add("rcLeaner", "(", new OneOperator1_<long, string*>(leaner));
}

} // namespace burnish
