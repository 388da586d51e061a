#include "diagnosis/observers.hpp"

namespace burnish {

#define BURNISH_MAKE(NAME) list.push_back(NAME<Dim>());

template <int Dim> ObserverList<Dim> causes() {
  ObserverList<Dim> list;
  BURNISH_CAUSES(BURNISH_MAKE)
  return list;
}

template <int Dim> ObserverList<Dim> checks() {
  ObserverList<Dim> list;
  BURNISH_CHECKS(BURNISH_MAKE)
  BURNISH_STATEMENTS(BURNISH_MAKE)
  return list;
}

template ObserverList<2> causes<2>();
template ObserverList<3> causes<3>();
template ObserverList<2> checks<2>();
template ObserverList<3> checks<3>();

} // namespace burnish
