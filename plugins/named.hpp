#pragma once
// Operators with named parameters in few lines: positional arguments by type, named ones through an accessor.
#include "base/error.hpp"
#include "number_list.hpp"

namespace burnish {

/// Values of the named parameters of one call.
class Named {
public:
  Named(Stack stack, const Expression* args, const basicAC_F0::name_and_type* names, int n)
      : m_stack(stack), m_args(args), m_names(names), m_n(n) {}
  bool has(const char* name) const { return find(name) != nullptr; }
  double real(const char* name, double otherwise) const {
    const Expression e = find(name);
    return e ? GetAny<double>((*e)(m_stack)) : otherwise;
  }
  long integer(const char* name, long otherwise) const {
    const Expression e = find(name);
    return e ? GetAny<long>((*e)(m_stack)) : otherwise;
  }
  bool boolean(const char* name, bool otherwise) const {
    const Expression e = find(name);
    return e ? GetAny<bool>((*e)(m_stack)) : otherwise;
  }
  std::string text(const char* name, const std::string& otherwise) const {
    const Expression e = find(name);
    return e ? *GetAny<string*>((*e)(m_stack)) : otherwise;
  }
  template <class T> T value(const char* name) const { return GetAny<T>((*find(name))(m_stack)); }
  KN_<double> array(const char* name) const { return GetAny<KN_<double>>((*find(name))(m_stack)); }
  /// The number if it is among least to most. @throws std::invalid_argument "where: ..." otherwise
  long integer(const char* name, long otherwise, long least, long most, const char* where) const {
    const long value = integer(name, otherwise);
    require(value >= least && value <= most, where, name, value,
            (std::to_string(least) + " to " + std::to_string(most)).c_str());
    return value;
  }
  KN_<long> integers(const char* name) const { return GetAny<KN_<long>>((*find(name))(m_stack)); }
  /// Numbers of an inline array, real[int] or int[int]; declared as NumberList*.
  std::vector<double> numbers(const char* name) const {
    return GetAny<NumberList*>((*find(name))(m_stack))->values;
  }
  /// Elements of an inline array [a, b, ...].
  std::vector<double> list(const char* name) const {
    const E_Array* a = dynamic_cast<const E_Array*>(find(name));
    std::vector<double> values;
    for (int i = 0; a && i < a->size(); ++i)
      values.push_back(GetAny<double>((*CastTo<double>((*a)[i]))(m_stack)));
    return values;
  }
  Stack stack() const { return m_stack; }

private:
  Expression find(const char* name) const {
    for (int i = 0; i < m_n; ++i)
      if (std::string(m_names[i].name) == name) return m_args[i];
    throw PluginError(std::string("internal: unknown named parameter ") + name);
  }
  Stack m_stack;
  const Expression* m_args;
  const basicAC_F0::name_and_type* m_names;
  int m_n;
};

/// @throws PluginError naming a named parameter that is none of these or of a wrong type; FreeFEM's own message does not
void refuse_unfit(const basicAC_F0& args, const basicAC_F0::name_and_type* names, int n);

/// What a list of all callables asks an operator (callables.cpp).
struct NamedParameters {
  virtual ~NamedParameters() = default;
  virtual std::vector<basicAC_F0::name_and_type> named() const = 0;
};

/// OneOperator with positional argument types Args... and the named parameters of Spec:
///   struct Spec { static const int n; static basicAC_F0::name_and_type names[];  (or a pointer to n of them)
///                 static Result call(const Named&, Args...); };
template <class Spec, class Result, class... Args>
class NamedOperator : public OneOperator, public NamedParameters {
public:
  class Op : public E_F0mps {
  public:
    std::vector<Expression> nargs;
    Expression positional[sizeof...(Args)];
    Op(const basicAC_F0& args, aType* types) : nargs(static_cast<std::size_t>(Spec::n), nullptr) {
      refuse_unfit(args, Spec::names, Spec::n);
      args.SetNameParam(Spec::n, Spec::names, nargs.data());
      for (std::size_t i = 0; i < sizeof...(Args); ++i)
        positional[i] = types[i]->CastTo(args[static_cast<int>(i)]);
    }
    AnyType operator()(Stack stack) const override { return run(stack, std::index_sequence_for<Args...>()); }

  private:
    template <std::size_t... I> AnyType run(Stack stack, std::index_sequence<I...>) const {
      const Named named(stack, nargs.data(), Spec::names, Spec::n);
      return SetAny<Result>(
          guarded([&] { return Spec::call(named, GetAny<Args>((*positional[I])(stack))...); }));
    }
  };
  NamedOperator() : OneOperator(atype<Result>(), atype<Args>()...) {}
  E_F0* code(const basicAC_F0& args) const override { return new Op(args, this->t); }
  std::vector<basicAC_F0::name_and_type> named() const override {
    return {Spec::names, Spec::names + Spec::n};
  }
};

} // namespace burnish
