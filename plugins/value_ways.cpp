#include "value_ways.hpp"
#include <map>
#include <sstream>
#include <zlib.h>

namespace burnish {
namespace {

constexpr int EARLIER_TURN = 0, MESH_TURN = 1, LAST_TURN = VALUE_TURNS - 1;

template <class T> void write_value(Writer& archive, T& value) { archive(value); }
template <class T> void read_value(Reader& archive, T& value) { archive(value); }
std::string& text_of(String& value) { return *static_cast<string*&>(value); }
void write_value(Writer& archive, String& value) { archive(text_of(value)); }
void read_value(Reader& archive, String& value) { archive(text_of(value)); }
void write_value(Writer& archive, Complex& value);
void read_value(Reader& archive, Complex& value);
template <class T> void write_value(Writer& archive, KN<T>& array);
template <class T> void read_value(Reader& archive, KN<T>& array);
template <class T> void write_value(Writer& archive, KNM<T>& matrix);
template <class T> void read_value(Reader& archive, KNM<T>& matrix);

void write_value(Writer& archive, string*& value) { archive(value ? *value : std::string()); }
void read_value(Reader& archive, string*& value) {
  if (!value) value = newstring();
  archive(static_cast<std::string&>(*value));
}
void write_value(Writer& archive, Complex& value) { archive(value.real(), value.imag()); }
void read_value(Reader& archive, Complex& value) {
  double re = 0, im = 0;
  archive(re, im);
  value = {re, im};
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
template <class T> void write_value(Writer& archive, KNM<T>& matrix) {
  archive(static_cast<std::int64_t>(matrix.N()), static_cast<std::int64_t>(matrix.M()));
  for (long i = 0; i < matrix.N(); ++i)
    for (long j = 0; j < matrix.M(); ++j) write_value(archive, matrix(i, j));
}
template <class T> void read_value(Reader& archive, KNM<T>& matrix) {
  std::int64_t rows = 0, columns = 0;
  archive(rows, columns);
  if (matrix.N() != rows || matrix.M() != columns) matrix.resize(rows, columns);
  for (long i = 0; i < matrix.N(); ++i)
    for (long j = 0; j < matrix.M(); ++j) read_value(archive, matrix(i, j));
}
template <class T> void write_value(Writer& archive, MyMap<String, T>& map) {
  archive(static_cast<std::int64_t>(map.m->size()));
  for (auto& [key, value] : *map.m) {
    archive(static_cast<const std::string&>(key));
    write_value(archive, value);
  }
}
template <class T> void read_value(Reader& archive, MyMap<String, T>& map) {
  std::int64_t size = 0;
  archive(size);
  map.m->clear();
  for (; size > 0; --size) {
    std::string key;
    archive(key);
    read_value(archive, map[String(key)]);
  }
}
// A mesh: none, that of the run, or another one with its bytes.
enum class MeshKind : char { NONE, OF_THE_RUN, OTHER };
template <class Mesh> void put(Writer& archive, const Mesh** at, const RunMesh& run) {
  const MeshKind kind = !*at ? MeshKind::NONE : *at == run.of(*at) ? MeshKind::OF_THE_RUN : MeshKind::OTHER;
  archive(kind);
  if (kind == MeshKind::OTHER) archive(mesh_bytes(**at));
}
template <class Mesh> void take(Reader& archive, const Mesh** at, const RunMesh& run, int turn) {
  if (turn != MESH_TURN) return;
  MeshKind kind = MeshKind::NONE;
  archive(kind);
  const Mesh* read = nullptr;
  if (kind == MeshKind::OF_THE_RUN && (read = run.of(*at))) read->increment();
  if (kind == MeshKind::OTHER) {
    std::string bytes;
    archive(bytes);
    read = mesh_of_bytes<Mesh>(bytes);
  }
  if (*at) (*at)->destroy();
  *at = read;
}
template <class Mesh> void put(Writer& archive, KN<const Mesh*>* meshes, const RunMesh& run) {
  archive(static_cast<std::int64_t>(meshes->N()));
  for (long i = 0; i < meshes->N(); ++i) put(archive, &(*meshes)[i], run);
}
template <class Mesh> void take(Reader& archive, KN<const Mesh*>* meshes, const RunMesh& run, int turn) {
  if (turn != MESH_TURN) return;
  std::int64_t size = 0;
  archive(size);
  const long present = meshes->N();
  for (long i = size; i < present; ++i)
    if ((*meshes)[i]) (*meshes)[i]->destroy();
  meshes->resize(size);
  for (long i = present; i < size; ++i) (*meshes)[i] = nullptr;
  for (long i = 0; i < size; ++i) take(archive, &(*meshes)[i], run, turn);
}

template <class Base> using ScalarOf = std::decay_t<decltype((*std::declval<Base&>().x())[0])>;
// A function of a space: nothing yet; its array; or that on a mesh from which its space has gone on, with that mesh. A function of
// several components goes with the first of them.
enum class FunctionKind : char { NONE, PRESENT, EARLIER };
double measure_of(const ::Mesh& mesh) { return mesh.mesure(); }
double measure_of(const ::Mesh3& mesh) { return const_cast<::Mesh3&>(mesh).mesure(); }
template <class Base> const auto& mesh_of_space(const Base& function) { return (**function.pVh).ppTh; }
template <class Base> bool is_present(const Base& function) {
  return function.Vh && &function.Vh->Th == *mesh_of_space(function);
}
template <class Base> void put(Writer& archive, std::pair<Base*, int> function, const RunMesh& run) {
  Base& base = *function.first;
  const bool given = function.second == 0 && base.x() && base.Vh;
  const FunctionKind kind = !given             ? FunctionKind::NONE
                            : is_present(base) ? FunctionKind::PRESENT
                                               : FunctionKind::EARLIER;
  archive(kind);
  if (!given) return;
  archive(base.Vh->Th.nt, base.Vh->Th.nv, measure_of(base.Vh->Th)); // another mesh, another function
  const auto* mesh = &base.Vh->Th;
  if (kind == FunctionKind::EARLIER) put(archive, &mesh, run);
  write_value(archive, *base.x());
}
template <class Base>
void take(Reader& archive, std::pair<Base*, int> function, const RunMesh& run, int turn) {
  Base& base = *function.first;
  FunctionKind kind = FunctionKind::NONE;
  archive(kind);
  if (turn != (kind == FunctionKind::EARLIER ? EARLIER_TURN : LAST_TURN) || kind == FunctionKind::NONE)
    return;
  int triangles = 0, vertices = 0;
  double measure = 0;
  archive(triangles, vertices, measure);
  using Mesh = std::decay_t<decltype(base.Vh->Th)>;
  const Mesh* earlier = nullptr;
  if (kind == FunctionKind::EARLIER) take(archive, &earlier, run, MESH_TURN);
  auto array = std::make_unique<KN<ScalarOf<Base>>>(0);
  read_value(archive, *array);
  KN<ScalarOf<Base>>* const present = base.x();
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

// An array of them, each as by itself.
template <class K, class Space>
void put(Writer& archive, std::pair<FEbaseArray<K, Space>*, int> functions, const RunMesh& run) {
  archive(static_cast<std::int64_t>(functions.first->N));
  for (int i = 0; i < functions.first->N; ++i) {
    std::ostringstream stream(std::ios::binary);
    Writer one(stream);
    put(one, std::make_pair(functions.first->xx[i], functions.second), run);
    archive(stream.str());
  }
}
template <class K, class Space>
void take(Reader& archive, std::pair<FEbaseArray<K, Space>*, int> functions, const RunMesh& run, int turn) {
  std::int64_t size = 0;
  archive(size);
  if (functions.first->N != size) functions.first->resize(static_cast<int>(size));
  for (int i = 0; i < size; ++i) {
    std::string bytes;
    archive(bytes);
    std::istringstream stream(bytes, std::ios::binary);
    Reader one(stream);
    take(one, std::make_pair(functions.first->xx[i], functions.second), run, turn);
  }
}

// All else.
template <class T> void put(Writer& archive, T* at, const RunMesh&) { write_value(archive, *at); }
template <class T> void take(Reader& archive, T* at, const RunMesh&, int turn) {
  if (turn == LAST_TURN) read_value(archive, *at);
}

// As FreeFEM's type says it, some without the pointer.
template <class T> std::string name_of() {
  const auto type = map_type.find(typeid(T).name());
  return type == map_type.end() ? typeid(T).name() : type->second->name();
}
template <class T> std::pair<const std::string, ValueWay> way(const char* name) {
  return {name_of<T>(),
          {name, [](Writer& archive, AnyType at, const RunMesh& run) { put(archive, GetAny<T>(at), run); },
           [](Reader& archive, AnyType at, const RunMesh& run, int turn) {
             take(archive, GetAny<T>(at), run, turn);
           }}};
}
// Only whether it has changed: its factor and its order are FreeFEM's own.
template <class T> std::pair<const std::string, ValueWay> matrix_way(const char* name) {
  return {name_of<Matrice_Creuse<T>*>(),
          {name,
           [](Writer& archive, AnyType at, const RunMesh&) {
             auto* const entries = GetAny<Matrice_Creuse<T>*>(at)->pHM();
             const std::size_t size = entries ? entries->nnz : 0;
             archive(static_cast<std::int64_t>(size));
             if (size > 0)
               archive(crc32_z(0, reinterpret_cast<const Bytef*>(entries->aij), size * sizeof(T)));
           },
           nullptr}};
}

} // namespace

const ValueWay* way_of(aType type) {
  static const std::map<std::string, ValueWay> all{
      way<double*>("real"),
      way<long*>("int"),
      way<bool*>("bool"),
      way<string**>("string"),
      way<Complex*>("complex"),
      way<KN<double>*>("real[int]"),
      way<KN<long>*>("int[int]"),
      way<KN<Complex>*>("complex[int]"),
      way<KN<String>*>("string[int]"),
      way<KNM<double>*>("real[int,int]"),
      way<KNM<long>*>("int[int,int]"),
      way<KNM<Complex>*>("complex[int,int]"),
      way<KN<KN<double>>*>("real[int][int]"),
      way<KN<KN<long>>*>("int[int][int]"),
      way<MyMap<String, double>*>("real[string]"),
      way<MyMap<String, long>*>("int[string]"),
      way<MyMap<String, String>*>("string[string]"),
      way<pmesh*>("mesh"),
      way<pmesh3*>("mesh in space"),
      way<KN<pmesh>*>("mesh[int]"),
      way<KN<pmesh3>*>("mesh[int] in space"),
      way<std::pair<FEbase<double, v_fes>*, int>>("function"),
      way<std::pair<FEbase<Complex, v_fes>*, int>>("complex function"),
      way<std::pair<FEbase<double, v_fes3>*, int>>("function in space"),
      way<std::pair<FEbase<Complex, v_fes3>*, int>>("complex function in space"),
      way<std::pair<FEbaseArray<double, v_fes>*, int>>("functions"),
      way<std::pair<FEbaseArray<Complex, v_fes>*, int>>("complex functions"),
      way<std::pair<FEbaseArray<double, v_fes3>*, int>>("functions in space"),
      way<std::pair<FEbaseArray<Complex, v_fes3>*, int>>("complex functions in space"),
      matrix_way<double>("matrix"),
      matrix_way<Complex>("complex matrix")};
  const auto found = all.find(type->name());
  return found == all.end() ? nullptr : &found->second;
}

} // namespace burnish
