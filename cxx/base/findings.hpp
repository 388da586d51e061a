#pragma once
// What a run reports of itself: one finding per check and subject, the worst, with number, place and time.
#include <array>
#include <limits>
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
};

/// Plain data, in the order in which the pairs were found first.
class FindingList {
public:
  /// Counts a finding. @returns it to be filled in, if it is the first of its pair or worse than what is known; else null
  Finding* report(const std::string& check, const std::string& subject, Severity severity, double excess,
                  double t = Finding::NONE);
  /// Takes it back: what is judged anew as the run goes on.
  void withdraw(const std::string& check, const std::string& subject);
  const std::vector<Finding>& list() const { return m_list; }
  std::size_t size() const { return m_list.size(); }
  const Finding& operator[](std::size_t i) const { return m_list[i]; }
  /// The most severe one, of these the first; null if there is none.
  const Finding* worst() const;
  /// No check is violated: nothing but notes and warnings.
  bool trusted() const;

private:
  std::vector<Finding> m_list;
};

/// "x y" of a place, for the sentence.
std::string place_text(const std::vector<double>& place);

} // namespace burnish
