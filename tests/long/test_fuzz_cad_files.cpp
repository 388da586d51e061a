// Damaged CAD files, at random: each is read, or refused with std::invalid_argument; none ends the process or hangs.
#include "long/fuzz.hpp"
#include "unit/cad/cad_samples.hpp"
#include <array>
#include <cctype>
#include <csignal>
#include <iostream>
#include <map>
#include <sys/wait.h>
#include <unistd.h>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr unsigned LIMIT = 30; // seconds that a file may take

std::size_t place(Random& random, const std::string& text) {
  return static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 1));
}

void change_number(std::string& text, Random& random) {
  std::size_t begin = text.find_first_of("0123456789", place(random, text));
  if (begin == std::string::npos) return;
  const std::size_t end = text.find_first_not_of("0123456789.eE", begin);
  const char* others[] = {"nan", "NaN",       "1e300",  "1E400", "-1",  "0",
                          "inf", "123456789", "1e-300", "3",     "7.25"};
  text.replace(begin, end - begin, others[random.whole(0, 10)]);
}

void change_line(std::string& text, Random& random) {
  const std::size_t at = place(random, text), before = text.rfind('\n', at), end = text.find('\n', at);
  if (before == std::string::npos || end == std::string::npos) return;
  const std::string line = text.substr(before, end - before);
  if (random.chance(0.5))
    text.erase(before, end - before);
  else
    text.insert(end, line);
}

/// One to three changes: a byte, a number, a line twice or not at all, a few bytes less, the rest cut off.
std::string mutant(std::string text, Random& random) {
  for (int change = random.whole(1, 3); change > 0 && text.size() > 10; --change)
    switch (random.whole(0, 9)) {
    case 0:
      text[place(random, text)] = static_cast<char>(random.whole(32, 126));
      break;
    case 1:
      text[place(random, text)] = static_cast<char>(random.whole(1, 255));
      break;
    case 2:
    case 3:
    case 4:
      change_number(text, random);
      break;
    case 5:
    case 6:
      change_line(text, random);
      break;
    case 7:
      text.erase(place(random, text), static_cast<std::size_t>(random.whole(1, 5)));
      break;
    case 8:
      std::swap(text[place(random, text)], text[place(random, text)]);
      break;
    case 9:
      if (random.chance(0.3)) text = text.substr(0, place(random, text)) + "\n";
    }
  return text;
}

/// Reads a file here; a word for what came of it.
std::string outcome(const std::string& path) {
  CadSelection selection;
  selection.file = path;
  selection.seconds = 2;
  try {
    const CadCurve curve(selection);
    const auto foot = curve.closest_point({1, 2}, Param<2>(0.));
    return std::isfinite(foot.gap) && std::isfinite(curve.length()) ? "read" : "NOT FINITE";
  } catch (const std::invalid_argument& error) {
    const std::string said = error.what();
    return said.size() > 20 && said.find("\"" + path) != std::string::npos ? "refused"
           : said.rfind("CadCurve: ", 0) == 0                              ? "refused for its shape"
                                                                           : "SAYS " + said;
  } catch (const std::exception& error) {
    return std::string("ANOTHER EXCEPTION: ") + error.what();
  } catch (...) {
    return "ANOTHER EXCEPTION";
  }
}

/// The same in a process of its own, so that the test goes on after a crash. (What is read here again afterwards
/// must be right: see OneAfterTheOther.)
std::string outcome_apart(const std::string& path) {
  int ends[2];
  if (pipe(ends) != 0) return "NO PIPE";
  std::cout << std::flush; // what is left in it a child would say again
  const pid_t child = fork();
  if (child == 0) {
    alarm(LIMIT);
    const std::string said = outcome(path);
    const ssize_t written = write(ends[1], said.data(), said.size());
    _exit(written < 0);
  }
  close(ends[1]);
  std::string said;
  std::array<char, 1000> part;
  for (ssize_t n; (n = read(ends[0], part.data(), part.size())) > 0;)
    said.append(part.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFSIGNALED(status)) return said.empty() ? "ENDED THE PROCESS" : said;
  return WTERMSIG(status) == SIGALRM ? "HANGS" : "SIGNAL " + std::to_string(WTERMSIG(status));
}

void try_mutants(const std::string& path, int n, unsigned seed) {
  const std::string good = file_content(path);
  ASSERT_FALSE(good.empty()) << path;
  Random random(seed);
  std::map<std::string, int> counts;
  for (int i = 0; i < n; ++i) {
    const std::string text = mutant(good, random);
    const TemporaryFile file(text, path.substr(path.rfind('.')));
    const std::string what = outcome_apart(file.path());
    ++counts[what];
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(what[0])) == 0)
        << what << " over mutant " << i << ":\n"
        << text;
  }
  std::cout << path << ": ";
  for (const auto& [what, count] : counts) std::cout << count << " " << what << ", ";
  std::cout << std::endl;
}

} // namespace

TEST(FuzzCadFiles, Step) {
  try_mutants("cases/step-die/die.step", 400, 1);
  try_mutants("tests/support/cad/lobe.step", 300, 2);
}

TEST(FuzzCadFiles, Brep) {
  try_mutants("tests/support/cad/circle.brep", 300, 3);
  try_mutants("tests/support/cad/lobe.brep", 400, 4);
}

TEST(FuzzCadFiles, Geo) {
  try_mutants("cases/step-die/die.geo", 200, 5);
  try_mutants("cases/cam/arcs.geo", 200, 6);
  try_mutants("tests/support/cad/lobe.geo", 200, 7);
}

TEST(FuzzCadFiles, OneAfterTheOther) {
  const std::string step = file_content("cases/step-die/die.step"),
                    brep = file_content("tests/support/cad/lobe.brep");
  const CadCurve die = CadCurve({"cases/step-die/die.step", {}, 1, "", false});
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    const TemporaryFile a(mutant(step, random), ".step"), b(mutant(brep, random), ".brep");
    for (const std::string& path : {a.path(), b.path()})
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(outcome(path)[0])) == 0) << outcome(path);
    if (i % 50 == 0) {
      const CadCurve again({"cases/step-die/die.step", {}, 1, "", false});
      EXPECT_EQ(again.length(), die.length());
      EXPECT_EQ(again.tightest_radius(), die.tightest_radius());
    }
  }
}
