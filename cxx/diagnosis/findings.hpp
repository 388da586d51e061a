#pragma once
// What a run reports of itself: one finding per check and subject, the worst, with number, place and time.
#include "base/archive.hpp"
#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace burnish {

enum class Severity {
  NOTE,      ///< worth knowing
  WARNING,   ///< the scene asks for more than it can give; the run is trusted
  UNTRUSTED, ///< a self-check is violated: the results of the run are not to be trusted
  STOP,      ///< the same, and going on makes no sense: the run ends in this state
};
/// "note", "warning", "untrusted", "stop".
const char* name_of(Severity severity);

struct Finding {
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
  std::string check, subject; ///< who found it; of what: one finding for each pair
  Severity severity = Severity::WARNING;
  double excess = 0;             ///< how bad, to compare findings of one pair [-]
  double value = 0, bound = 0;   ///< the number that it rests on, and what is allowed; both 0: none
  std::vector<double> place;     ///< empty: none [length]
  double t = NONE, first = NONE; ///< of this one, and of the first of the pair; NaN: before the run [time]
  long count = 0;                ///< accepted steps in which the pair was found
  std::string text;              ///< a sentence, with number, place and time
  BURNISH_FIELDS(check, subject, severity, excess, value, bound, place, t, first, count, text)
};

/// A number that grows as things get worse: a warning above the one, untrusted above the other.
struct Bounds {
  double noted, far = std::numeric_limits<double>::infinity();
};

/// Plain data, in the order in which the pairs were found first.
class FindingList {
public:
  /// Counts a finding. @returns it to be filled in, if it is the first of its pair or worse than what is known; else null
  Finding* report(const std::string& check, const std::string& subject, Severity severity, double excess,
                  double t = Finding::NONE);
  /// The same of a number against its bounds, which are filled in; null within them.
  Finding* beyond(const std::string& check, const std::string& subject, double value, const Bounds& bounds,
                  double t);
  /// Takes it back: what is judged anew as the run goes on.
  void withdraw(const std::string& check, const std::string& subject);
  bool holds(const std::string& check, const std::string& subject) const;
  /// The worst number of every check so far, by name, within its bounds or not: the present one, the largest, the smallest.
  void measure(const std::string& name, double value) { m_measured[name] = value; }
  void largest(const std::string& name, double value);
  void smallest(const std::string& name, double value);
  const std::map<std::string, double>& measured() const { return m_measured; }
  void forget_measured() { m_measured.clear(); }
  const std::vector<Finding>& list() const { return m_list; }
  std::size_t size() const { return m_list.size(); }
  const Finding& operator[](std::size_t i) const { return m_list[i]; }
  /// The most severe one, of these the first; null if there is none.
  const Finding* worst() const;
  /// No check is violated: nothing but notes and warnings.
  bool trusted() const;
  BURNISH_FIELDS(m_list, m_measured)

private:
  std::vector<Finding> m_list;
  std::map<std::string, double> m_measured;
};

} // namespace burnish
