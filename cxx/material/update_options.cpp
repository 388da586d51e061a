#include "material/update_options.hpp"
#include "base/error.hpp"

namespace burnish {

void require_valid(const UpdateOptions& options, const char* where) {
  require(options.path_limit >= 0, where, "path_limit", options.path_limit, ">= 0");
  require(options.min_substeps >= 1, where, "min_substeps", options.min_substeps, ">= 1");
  require(options.max_substeps >= options.min_substeps, where, "max_substeps", options.max_substeps,
          ">= min_substeps");
}

} // namespace burnish
