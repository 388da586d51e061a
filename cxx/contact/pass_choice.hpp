#pragma once
// Which of the changes that a pass asks for are made (ALGORITHMS.md 5.3).
#include "contact/contact_model.hpp"
#include <set>

namespace burnish {

/// The flexibility of a bent sheet is no M-matrix: where all changes are made at once, rows of nodes may go to and fro without end.
template <int Dim> class PassChoice {
public:
  /// @param model, window must outlive it; @param window candidates whose states change
  PassChoice(const ContactModel<Dim>& model, const std::vector<int>& window);
  /// Of neighbors that enter only the deepest enters, of those that are released only the one with the largest tension: in the plane
  /// one of each run, in space each that none next to it exceeds. All that begin to stick or to slide do so. Where the states have
  /// been there before, for some passes one change alone.
  /// @param before states that were solved with; @param severity per candidate, see WindowSolver::test
  /// @param trial  states with all changes; in it those that are not made are taken back
  void choose(const ContactState<Dim>& before, const std::vector<double>& severity, ContactState<Dim>& trial);
  /// Whether one of the last passes had states that had been there before.
  bool cycles() const { return m_alone > 0; }

private:
  enum class Kind { NONE, ENTERS, LEAVES, TURNS };
  static Kind kind_of(const ContactNode<Dim>& before, const ContactNode<Dim>& after);
  std::vector<int> worst_of(const std::vector<double>& severity) const;
  bool is_worst_nearby(int candidate, const std::vector<double>& severity) const;
  int worst_of_run(int first, const std::vector<double>& severity, std::vector<char>& done) const;
  bool seen_before(const ContactState<Dim>& state);

  const ContactModel<Dim>& m_model;
  const std::vector<int>& m_window;
  std::vector<Kind> m_kind;           // per candidate, of this pass
  std::set<std::vector<char>> m_seen; // states of the window
  int m_alone = 0;                    // passes to come with one change alone
  unsigned m_draw = 1;
};

} // namespace burnish
