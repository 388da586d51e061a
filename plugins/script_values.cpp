#include "script_values.hpp"
#include "base/error.hpp"
#include "value_ways.hpp"
#include <algorithm>
#include <map>
#include <sstream>
#include <zlib.h>

namespace burnish {
namespace {

uLong mark_of_value(const std::string& bytes) {
  return crc32_z(bytes.size() & 0xFFFF, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}
std::map<Expression, uLong>& noted_values() {
  static std::map<Expression, uLong> all;
  return all;
}
// Of the process, not of the run.
bool passes_by(const std::string& name) {
  for (const char* one : {"rcStarted", "rcPrinted", "rcLine"})
    if (name == one) return true;
  return false;
}

} // namespace

ScriptValues::ScriptValues() {
  std::map<std::string, int> seen;
  for (const TableOfIdentifier* table : tables_of_identifier) {
    if (table == &Global) continue;
    for (const auto& [name, value] : table->m) {
      if (!way_of(value.first) || passes_by(name)) continue;
      const std::string inner(static_cast<std::size_t>(seen[name]++), '\'');
      m_variables.push_back({name + inner, value.first, value.second});
    }
  }
}

namespace {

std::string value_bytes(aType type, Expression place, Stack stack, const RunMesh& mesh = {}) {
  std::ostringstream stream(std::ios::binary);
  {
    Writer archive(stream);
    way_of(type)->write(archive, (*place)(stack), mesh);
  }
  return stream.str();
}

} // namespace

void ScriptValues::note(Stack stack) const {
  for (const Variable& one : m_variables)
    if (!noted_values().count(one.place))
      noted_values()[one.place] = mark_of_value(value_bytes(one.type, one.place, stack));
}

std::vector<KeptValue> ScriptValues::changed(Stack stack, const RunMesh& mesh) const {
  std::vector<KeptValue> values;
  for (const Variable& one : m_variables) {
    const uLong mark = mark_of_value(value_bytes(one.type, one.place, stack));
    const auto before = noted_values().find(one.place);
    if (before == noted_values().end() || before->second != mark)
      values.push_back({one.name, way_of(one.type)->name, value_bytes(one.type, one.place, stack, mesh)});
  }
  return values;
}

void ScriptValues::restore(Stack stack, const std::vector<KeptValue>& values, const RunMesh& mesh) const {
  const auto find = [&](const KeptValue& value) {
    return std::find_if(m_variables.begin(), m_variables.end(), [&](const Variable& one) {
      return one.name == value.name && way_of(one.type)->name == value.type;
    });
  };
  for (const KeptValue& value : values)
    if (find(value) == m_variables.end())
      fail("stepcontrol.resume", "the checkpoint holds " + value.type + " " + value.name +
                                     " of the script, expected a variable of that name and type here");
  for (int turn = 0; turn < VALUE_TURNS; ++turn)
    for (const KeptValue& value : values) {
      const auto one = find(value);
      const ValueWay* const way = way_of(one->type);
      if (!way->read) {
        if (turn == 0)
          cout << "burnish: warning: the run had changed " << value.type << " " << value.name
               << " of the script, which no checkpoint holds: it is as at the start" << endl;
        continue;
      }
      std::istringstream stream(value.bytes, std::ios::binary);
      Reader archive(stream);
      way->read(archive, (*one->place)(stack), mesh, turn);
    }
}

} // namespace burnish
