#include "script_values.hpp"
#include "base/archive.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <map>
#include <sstream>
#include <zlib.h>

namespace burnish {
namespace {

using Base2 = FEbase<double, v_fes>;
using Base3 = FEbase<double, v_fes3>;

template <class T> void write_value(Writer& archive, T& value) { archive(value); }
template <class T> void read_value(Reader& archive, T& value) { archive(value); }
void write_value(Writer& archive, string*& value) { archive(value ? *value : std::string()); }
void read_value(Reader& archive, string*& value) {
  if (!value) value = newstring();
  archive(static_cast<std::string&>(*value));
}
template <class T> void write_value(Writer& archive, KN<T>& array) {
  archive(static_cast<std::int64_t>(array.N()));
  for (long i = 0; i < array.N(); ++i) write_value(archive, array[i]);
}
template <class T> void read_value(Reader& archive, KN<T>& array) {
  std::int64_t size = 0;
  archive(size);
  if (array.N() != size) array.resize(size);
  for (long i = 0; i < array.N(); ++i) read_value(archive, array[i]);
}
template <> void write_value<String>(Writer& archive, KN<String>& array) {
  archive(static_cast<std::int64_t>(array.N()));
  for (long i = 0; i < array.N(); ++i)
    archive(static_cast<const std::string&>(*static_cast<string*>(array[i])));
}
template <> void read_value<String>(Reader& archive, KN<String>& array) {
  std::int64_t size = 0;
  archive(size);
  if (array.N() != size) array.resize(size);
  for (long i = 0; i < array.N(); ++i) archive(static_cast<std::string&>(*static_cast<string*>(array[i])));
}
template <class T> void write_value(Writer& archive, KNM<T>& matrix) {
  archive(static_cast<std::int64_t>(matrix.N()), static_cast<std::int64_t>(matrix.M()));
  for (long i = 0; i < matrix.N(); ++i)
    for (long j = 0; j < matrix.M(); ++j) archive(matrix(i, j));
}
template <class T> void read_value(Reader& archive, KNM<T>& matrix) {
  std::int64_t rows = 0, columns = 0;
  archive(rows, columns);
  if (matrix.N() != rows || matrix.M() != columns) matrix.resize(rows, columns);
  for (long i = 0; i < matrix.N(); ++i)
    for (long j = 0; j < matrix.M(); ++j) archive(matrix(i, j));
}
// A mesh: none, that of the run, or another one with its bytes.
enum class MeshKind : char { NONE, OF_THE_RUN, OTHER };
template <class Mesh> void write_mesh(Writer& archive, const Mesh* mesh, const RunMesh& run) {
  const MeshKind kind = !mesh                  ? MeshKind::NONE
                        : mesh == run.of(mesh) ? MeshKind::OF_THE_RUN
                                               : MeshKind::OTHER;
  archive(kind);
  if (kind == MeshKind::OTHER) archive(mesh_bytes(*mesh));
}
template <class Mesh> void read_mesh(Reader& archive, const Mesh*& mesh, const RunMesh& run) {
  MeshKind kind = MeshKind::NONE;
  archive(kind);
  const Mesh* read = nullptr;
  if (kind == MeshKind::OF_THE_RUN && (read = run.of(mesh))) read->increment();
  if (kind == MeshKind::OTHER) {
    std::string bytes;
    archive(bytes);
    read = mesh_of_bytes<Mesh>(bytes);
  }
  if (mesh) mesh->destroy();
  mesh = read;
}

// A function of a space: nothing yet; its array; or that on a mesh from which its space has gone on, with that mesh. A function of
// several components goes with the first of them.
enum class FunctionKind : char { NONE, PRESENT, EARLIER };
double measure_of(const ::Mesh& mesh) { return mesh.mesure(); }
double measure_of(const ::Mesh3& mesh) { return const_cast<::Mesh3&>(mesh).mesure(); }
template <class Base> const auto& mesh_of_space(const Base& function) { return (**function.pVh).ppTh; }
template <class Base> bool is_present(const Base& function) {
  return function.Vh && &function.Vh->Th == *mesh_of_space(function);
}
template <class Base>
void write_function(Writer& archive, const std::pair<Base*, int>& function, const RunMesh& run) {
  Base& base = *function.first;
  const bool given = function.second == 0 && base.x() && base.Vh;
  const FunctionKind kind = !given             ? FunctionKind::NONE
                            : is_present(base) ? FunctionKind::PRESENT
                                               : FunctionKind::EARLIER;
  archive(kind);
  if (!given) return;
  archive(base.Vh->Th.nt, base.Vh->Th.nv, measure_of(base.Vh->Th)); // another mesh, another function
  if (kind == FunctionKind::EARLIER) write_mesh(archive, &base.Vh->Th, run);
  write_value(archive, *base.x());
}
template <class Base>
void read_function(Reader& archive, const std::pair<Base*, int>& function, const RunMesh& run) {
  Base& base = *function.first;
  FunctionKind kind = FunctionKind::NONE;
  archive(kind);
  if (kind == FunctionKind::NONE) return;
  int triangles = 0, vertices = 0;
  double measure = 0;
  archive(triangles, vertices, measure);
  using Mesh = std::decay_t<decltype(base.Vh->Th)>;
  const Mesh* earlier = nullptr;
  if (kind == FunctionKind::EARLIER) read_mesh(archive, earlier, run);
  auto array = std::make_unique<KN<double>>(0);
  read_value(archive, *array);
  KN<double>* const present = base.x();
  if (!earlier && present && present->N() == array->N() && is_present(base)) {
    *present = *array; // in its place, where others look at it
    return;
  }
  auto& place = const_cast<const Mesh*&>(*mesh_of_space(base));
  const Mesh* const later = place;
  if (earlier) place = earlier;
  base = array.release();
  place = later;
  if (earlier) earlier->destroy();
}

/// How the values of a type go: the expression of a variable gives a pointer to it.
struct Way {
  const char* name;
  void (*write)(Writer&, AnyType, const RunMesh&);
  void (*read)(Reader&, AnyType, const RunMesh&);
};
template <class T> Way way_of_pointer(const char* name) {
  return {name, [](Writer& archive, AnyType at, const RunMesh&) { write_value(archive, *GetAny<T*>(at)); },
          [](Reader& archive, AnyType at, const RunMesh&) { read_value(archive, *GetAny<T*>(at)); }};
}
template <class Mesh> Way way_of_mesh(const char* name) {
  return {
      name,
      [](Writer& archive, AnyType at, const RunMesh& run) { write_mesh(archive, *GetAny<Mesh*>(at), run); },
      [](Reader& archive, AnyType at, const RunMesh& run) { read_mesh(archive, *GetAny<Mesh*>(at), run); }};
}
template <class Base> Way way_of_function(const char* name) {
  using Pair = std::pair<Base*, int>;
  return {
      name,
      [](Writer& archive, AnyType at, const RunMesh& run) { write_function(archive, GetAny<Pair>(at), run); },
      [](Reader& archive, AnyType at, const RunMesh& run) { read_function(archive, GetAny<Pair>(at), run); }};
}
constexpr const char *MESH = "mesh", *MESH_IN_SPACE = "mesh in space", *FUNCTION = "function",
                     *FUNCTION_IN_SPACE = "function in space";

const std::map<std::string, Way>& ways() {
  static const std::map<std::string, Way> all{
      {typeid(double*).name(), way_of_pointer<double>("real")},
      {typeid(long*).name(), way_of_pointer<long>("int")},
      {typeid(bool*).name(), way_of_pointer<bool>("bool")},
      {typeid(string**).name(), way_of_pointer<string*>("string")},
      {typeid(KN<double>*).name(), way_of_pointer<KN<double>>("real[int]")},
      {typeid(KN<long>*).name(), way_of_pointer<KN<long>>("int[int]")},
      {typeid(KN<String>*).name(), way_of_pointer<KN<String>>("string[int]")},
      {typeid(KNM<double>*).name(), way_of_pointer<KNM<double>>("real[int,int]")},
      {typeid(KNM<long>*).name(), way_of_pointer<KNM<long>>("int[int,int]")},
      {typeid(pmesh*).name(), way_of_mesh<pmesh>(MESH)},
      {typeid(pmesh3*).name(), way_of_mesh<pmesh3>(MESH_IN_SPACE)},
      {typeid(std::pair<Base2*, int>).name(), way_of_function<Base2>(FUNCTION)},
      {typeid(std::pair<Base3*, int>).name(), way_of_function<Base3>(FUNCTION_IN_SPACE)}};
  return all;
}
const Way* way_of(aType type) {
  const auto found = ways().find(type->name());
  return found == ways().end() ? nullptr : &found->second;
}

// Functions of earlier meshes, then meshes, then functions on these and all others.
constexpr int TURNS = 3;
int turn_of(const KeptValue& value) {
  if (value.type == MESH || value.type == MESH_IN_SPACE) return 1;
  const bool function = value.type == FUNCTION || value.type == FUNCTION_IN_SPACE;
  return function && static_cast<FunctionKind>(value.bytes[0]) == FunctionKind::EARLIER ? 0 : 2;
}

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
  for (int turn = 0; turn < TURNS; ++turn)
    for (const KeptValue& value : values) {
      if (turn_of(value) != turn) continue;
      std::istringstream stream(value.bytes, std::ios::binary);
      Reader archive(stream);
      const auto one = find(value);
      way_of(one->type)->read(archive, (*one->place)(stack), mesh);
    }
}

} // namespace burnish
