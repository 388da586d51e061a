// What is said of a step that ran out of iterations: one sentence for each residue, and what to do.
#include "diagnosis/words.hpp"
#include <gtest/gtest.h>

using namespace burnish;

TEST(Words, OfEveryResidue) {
  const ContactModel<2> model;
  const std::vector<std::pair<Residue, std::string>> said{
      {Residue::UNKNOWN, "0 inconsistent contact states"},
      {Residue::NO_LOAD, "the load of 5 is next to nothing: look at its size and units; where nothing "
                         "presses the workpiece yet, "
                         "C.hold(stiffness, until) holds it until something does"},
      {Residue::TOO_LARGE, "the mesh is too large or too slender for this load"},
      {Residue::FALLS, "the residual still falls, allow more iterations (maxiterations=)"},
      {Residue::FRICTION, "all friction is used up, nothing is left for a coordinate under force"}};
  for (const auto& [residue, end] : said) {
    Failure failure(Cause::NO_BALANCE);
    failure.last = {7, 0, 0.5, 0.25, 2, 5, residue};
    const std::string text = words(failure, model);
    EXPECT_EQ(text.find("no convergence in 7 iterations: residual 0.5, allowed 0.25, "), 0u) << text;
    EXPECT_EQ(text.substr(text.size() - end.size()), end);
  }
}
