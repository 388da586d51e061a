#include "cad/occ/cad_file.hpp"
#include "base/error.hpp"
#include "cad/cad_text.hpp"
#include "cad/occ/cad_shape.hpp"
#include "cad/occ/geo_model.hpp"

namespace burnish {

CadFile::CadFile(std::string path, const GeoNumbers& numbers, double seconds) : m_path(std::move(path)) {
  check_cad_text(m_path, numbers);
  m_model = file_extension(m_path) == ".geo" ? read_geo(m_path, numbers, seconds) : read_shape(m_path);
  for (const auto& edge : m_model.edges) m_curves.push_back(edge.first);
  if (m_curves.empty()) fail("CadFile", "\"" + m_path + "\": no curves in it");
}

bool CadFile::has(int dimension, int tag) const {
  return m_model.others[static_cast<std::size_t>(dimension)].count(tag) > 0;
}

} // namespace burnish
