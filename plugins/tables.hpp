#pragma once
// FreeFEM's tables of operators. They have no public way in: explicit instantiations may name private members.
#include "plugin.hpp"

#include <map>
#include <vector>

namespace burnish {

template <class Tag, typename Tag::Type member> struct Reveal {
  friend typename Tag::Type reveal(Tag) { return member; }
};
struct Operators {
  using Type = std::map<const char*, OneOperator*, Keyless> Polymorphic::*;
  friend Type reveal(Operators);
};
struct Members {
  using Type = TableOfIdentifier basicForEachType::*;
  friend Type reveal(Members);
};
struct Next {
  using Type = OneOperator* OneOperator::*;
  friend Type reveal(Next);
};
struct Keywords {
  using Type = mylex::MapMotClef mylex::*;
  friend Type reveal(Keywords);
};
template struct Reveal<Operators, &Polymorphic::m>;
template struct Reveal<Members, &basicForEachType::ti>;
template struct Reveal<Next, &OneOperator::next>;
template struct Reveal<Keywords, &mylex::MotClef>;

/// Types of an operator's positional arguments.
std::vector<aType> argument_types(const OneOperator& op);

/// All overloads of an operator such as "(" in a table, those that `check_arguments` has set aside among them.
std::vector<const OneOperator*> overloads(const Polymorphic& table, const char* op);

/// From now on a call with positional arguments that no overload takes is an error of ours, with both lists of types, in
/// place of FreeFEM's, whose types are those of C++.
/// @param name  as the script calls it  @param hidden  first arguments that are not written
void check_arguments(const std::string& name, const Polymorphic& table, const char* op, std::size_t hidden);

/// The same for the constructors of one of our types: they stand in a table with all others.
void check_constructor(const std::string& name, aType type);

} // namespace burnish
