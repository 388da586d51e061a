#pragma once
// How plain data goes into a file and comes back: cereal's binary archive, with Eigen's matrices. The members of a structure are
// named in their order; one that is left out does not compile.
#include <Eigen/Dense>
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/vector.hpp>

/// Passes all members of `value` to `archive`: as many names as it has, in their order.
#define BURNISH_MEMBERS(value, ...)                                                                          \
  auto& [__VA_ARGS__] = value;                                                                               \
  archive(__VA_ARGS__)
/// Within a structure: the same of its own members.
#define BURNISH_FIELDS(...)                                                                                  \
  template <class Archive> void serialize(Archive& archive) { BURNISH_MEMBERS(*this, __VA_ARGS__); }

namespace burnish {

using Writer = cereal::BinaryOutputArchive;
using Reader = cereal::BinaryInputArchive;

} // namespace burnish

namespace cereal {

/// Rows, columns, numbers.
template <class Archive, class Scalar, int Rows, int Columns>
void save(Archive& archive, const Eigen::Matrix<Scalar, Rows, Columns>& matrix) {
  archive(static_cast<std::int64_t>(matrix.rows()), static_cast<std::int64_t>(matrix.cols()));
  archive(binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Scalar)));
}
template <class Archive, class Scalar, int Rows, int Columns>
void load(Archive& archive, Eigen::Matrix<Scalar, Rows, Columns>& matrix) {
  std::int64_t rows = 0, columns = 0;
  archive(rows, columns);
  matrix.resize(rows, columns);
  archive(binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Scalar)));
}

} // namespace cereal
