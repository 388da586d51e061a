#include "number_list.hpp"

namespace burnish {
namespace {

class InlineArray : public E_F0mps {
public:
  explicit InlineArray(const E_Array& array) {
    for (int i = 0; i < array.size(); ++i) m_values.push_back(CastTo<double>(array[i]));
  }
  AnyType operator()(Stack stack) const override {
    auto* list = Add2StackOfPtr2Free(stack, new NumberList);
    for (const Expression value : m_values) list->values.push_back(GetAny<double>((*value)(stack)));
    return SetAny<NumberList*>(list);
  }

private:
  std::vector<Expression> m_values;
};

class FromInline : public OneOperator {
public:
  FromInline() : OneOperator(atype<NumberList*>(), atype<E_Array>()) {}
  E_F0* code(const basicAC_F0& args) const override {
    return new InlineArray(*dynamic_cast<const E_Array*>(args[0].LeftValue()));
  }
};

template <class T> NumberList* from_array(Stack stack, const KN_<T>& array) {
  auto* list = Add2StackOfPtr2Free(stack, new NumberList);
  for (long i = 0; i < array.N(); ++i) list->values.push_back(static_cast<double>(array[i]));
  return list;
}

} // namespace

void register_number_list() {
  Dcl_Type<NumberList*>();
  // variables, real[int], are cast to KN_ by FreeFEM
  map_type[typeid(NumberList*).name()]->AddCast(
      new FromInline, new OneOperator1s_<NumberList*, KN_<double>>(from_array<double>),
      new OneOperator1s_<NumberList*, KN_<long>>(from_array<long>));
}

} // namespace burnish
