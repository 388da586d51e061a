// The same for the tests, see cxx/base/precompiled.hpp.
#include "base/precompiled.hpp"
#include <gtest/gtest.h>
