#pragma once
// All that looks at a run: what is found of its accepted steps, what is behind its failed ones, what is said of its scene.
#include "diagnosis/observer.hpp"

namespace burnish {

/// A value: a copy goes on to the same bits.
template <int Dim> class Diagnosis {
public:
  Diagnosis() { restart(); }
  Diagnosis(const Diagnosis& other);
  Diagnosis& operator=(const Diagnosis& other);
  Diagnosis(Diagnosis&&) = default;
  Diagnosis& operator=(Diagnosis&&) = default;

  /// false: nothing but what explains a failed step is looked at, and there is no report (S.checks).
  void set_checks(bool on) { m_checks = on; }
  /// A new run: the observers forget, what was found stays.
  void restart();
  /// Before every step; the first one counts: energies are those of the run.
  void begin(AcceptedStep<Dim> step);
  bool begun() const { return m_begun; }
  /// Looks at an accepted step. @returns why the run cannot go on with it, "": it can
  std::string look(AcceptedStep<Dim> step);
  /// What may be behind a failed step, the first cause first.
  std::vector<Failure> explain(const FailedStep<Dim>& step) const;
  /// The report: the most important statements first; none before the first step, or without checks.
  std::vector<Statement> report(const AcceptedStep<Dim>& step, const StepAccuracy& accuracy) const;

  FindingList& findings() { return m_findings; }
  const FindingList& findings() const { return m_findings; }
  double seconds() const { return m_seconds; } ///< CPU of all looks, with checks [s]

  /// All of it, into a file and from one.
  void save(Writer& archive) const;
  void load(Reader& archive);

private:
  template <class Archive> void remember(Archive& archive);
  ObserverList<Dim> m_observers;
  std::size_t m_always = 0; // so many of them look without checks, too
  FindingList m_findings;
  bool m_checks = true, m_begun = false;
  long m_steps = 0; // looked at
  double m_seconds = 0;
};

} // namespace burnish
