#include "material/update_options.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>

using namespace burnish;
using burnish::test::expect_invalid;

TEST(UpdateOptions, DefaultsAndInfiniteLimitAreValid) {
  UpdateOptions options;
  EXPECT_NO_THROW(require_valid(options, "here"));
  options.path_limit = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(require_valid(options, "here"));
}

TEST(UpdateOptions, Errors) {
  const auto with = [](auto change, const std::string& text) {
    UpdateOptions options;
    change(options);
    expect_invalid([&] { require_valid(options, "here"); }, text);
  };
  with([](UpdateOptions& o) { o.path_limit = -1; }, "here: path_limit = -1, expected >= 0");
  with([](UpdateOptions& o) { o.path_limit = std::nan(""); }, "here: path_limit = nan");
  with([](UpdateOptions& o) { o.min_substeps = 0; }, "here: min_substeps = 0, expected >= 1");
  with([](UpdateOptions& o) { o.max_substeps = 2; }, "here: max_substeps = 2, expected >= min_substeps");
}
