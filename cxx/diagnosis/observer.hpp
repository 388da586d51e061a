#pragma once
// Whoever looks at a run and moves nothing: a check, a warning, a cause of failed steps, a statement of the report. Each is
// one file and one line in the list of observers.hpp.
#include "base/archive.hpp"
#include "diagnosis/accepted_step.hpp"
#include "diagnosis/failed_step.hpp"
#include "diagnosis/findings.hpp"
#include "diagnosis/statements.hpp"
#include <memory>

namespace burnish {

/// What it has to remember is in its members: a copy goes on to the same bits.
template <int Dim> class Observer {
public:
  virtual ~Observer() = default;
  virtual std::unique_ptr<Observer> clone() const = 0;
  /// What it has to remember, for a file.
  virtual void save(Writer& archive) const = 0;
  virtual void load(Reader& archive) = 0;
  /// The state at the start of the run. @param step prepared
  virtual void begin(const AcceptedStep<Dim>&, FindingList&) {}
  /// @param step prepared; @param findings what it adds to
  virtual void look(const AcceptedStep<Dim>&, FindingList&) {}
  /// A step has failed: what may be behind it, if this is.
  virtual void explain(const FailedStep<Dim>&, std::vector<Failure>&) const {}
  /// What is said of the scene at the end.
  virtual void end(const EndedRun<Dim>&, std::vector<Statement>&) const {}
};

template <int Dim> using ObserverList = std::vector<std::unique_ptr<Observer<Dim>>>;

/// Copy and memory of a class of observers. One with members says which of them are its memory: BURNISH_REMEMBERS.
template <class Own, int Dim> class ObserverOf : public Observer<Dim> {
public:
  std::unique_ptr<Observer<Dim>> clone() const override {
    return std::make_unique<Own>(static_cast<const Own&>(*this));
  }
  void save(Writer& archive) const override { remember_all(archive); }
  void load(Reader& archive) override { remember_all(archive); }
  static constexpr bool REMEMBERS = false;

private:
  template <class Archive> void remember_all(Archive& archive) const {
    static_assert(Own::REMEMBERS || sizeof(Own) == sizeof(Observer<Dim>), "BURNISH_REMEMBERS is missing");
    if constexpr (Own::REMEMBERS) const_cast<Own&>(static_cast<const Own&>(*this)).remember(archive);
  }
};

/// Within a class of observers, public: all its members, which are its memory.
#define BURNISH_REMEMBERS(...)                                                                               \
  static constexpr bool REMEMBERS = true;                                                                    \
  template <class Archive> void remember(Archive& archive) { BURNISH_MEMBERS(*this, __VA_ARGS__); }

/// Defines the maker NAME<Dim>() that observers.hpp declares, of the class TYPE<Dim>.
#define BURNISH_OBSERVER(NAME, TYPE)                                                                         \
  template <int Dim> std::unique_ptr<Observer<Dim>> NAME() { return std::make_unique<TYPE<Dim>>(); }         \
  template std::unique_ptr<Observer<2>> NAME<2>();                                                           \
  template std::unique_ptr<Observer<3>> NAME<3>();

} // namespace burnish
