#pragma once
// Points of OpenCASCADE as vectors, and back.
#include "base/types.hpp"
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

namespace burnish {

inline Vector<3> from_occ(const gp_XYZ& x) { return {x.X(), x.Y(), x.Z()}; }
inline gp_Pnt to_occ(const Vector<3>& x) { return {x[0], x[1], x[2]}; }

} // namespace burnish
