#pragma once
// Values that a script gives for all nodes: displacement of the supports, external forces.
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "contact/body_view.hpp"
#include <cmath>

namespace burnish {

/// @throws std::invalid_argument "where: ..." for another size than num_dofs, and for the first value that is not finite or for
///         which `wrong(d)` has words: value, component, node, place and those words
template <int Dim, class Wrong>
void require_nodal(const BodyView<Dim>& body, const Eigen::VectorXd& values, const char* where, Wrong wrong) {
  require(values.size() == body.X.size(), where, "size of the values", values.size(),
          (std::to_string(body.X.size()) + ", one per degree of freedom").c_str());
  for (Eigen::Index d = 0; d < values.size(); ++d) {
    const std::string what = std::isfinite(values[d]) ? wrong(d) : "expected a finite number";
    if (what.empty()) continue;
    fail(where, sentence("value ", values[d], " at component ", d % Dim, " of node ", d / Dim, " at ",
                         place_text(body.X.template segment<Dim>(d - d % Dim)), ": ", what));
  }
}

} // namespace burnish
