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
void read_function(Reader& archive, const std::pair<Base*, int>& function, const RunMesh& run, int turn) {
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
  if (kind == FunctionKind::EARLIER) read_mesh(archive, earlier, run);
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
template <class Array>
void write_functions(Writer& archive, const std::pair<Array*, int>& functions, const RunMesh& run) {
  archive(static_cast<std::int64_t>(functions.first->N));
  for (int i = 0; i < functions.first->N; ++i) {
    std::ostringstream stream(std::ios::binary);
    Writer one(stream);
    write_function(one, std::make_pair(functions.first->xx[i], functions.second), run);
    archive(stream.str());
  }
}
template <class Array>
void read_functions(Reader& archive, const std::pair<Array*, int>& functions, const RunMesh& run, int turn) {
  std::int64_t size = 0;
  archive(size);
  if (functions.first->N != size) functions.first->resize(static_cast<int>(size));
  for (int i = 0; i < size; ++i) {
    std::string bytes;
    archive(bytes);
    std::istringstream stream(bytes, std::ios::binary);
    Reader one(stream);
    read_function(one, std::make_pair(functions.first->xx[i], functions.second), run, turn);
  }
}

// As FreeFEM's type says it, some without the pointer.
template <class T> std::string name_of() {
  const auto type = map_type.find(typeid(T).name());
  return type == map_type.end() ? typeid(T).name() : type->second->name();
}
template <class T> std::pair<const std::string, ValueWay> pointer_way(const char* name) {
  return {name_of<T*>(),
          {name, [](Writer& archive, AnyType at, const RunMesh&) { write_value(archive, *GetAny<T*>(at)); },
           [](Reader& archive, AnyType at, const RunMesh&, int turn) {
             if (turn == LAST_TURN) read_value(archive, *GetAny<T*>(at));
           }}};
}
template <class Mesh> std::pair<const std::string, ValueWay> mesh_way(const char* name) {
  return {
      name_of<Mesh*>(),
      {name,
       [](Writer& archive, AnyType at, const RunMesh& run) { write_mesh(archive, *GetAny<Mesh*>(at), run); },
       [](Reader& archive, AnyType at, const RunMesh& run, int turn) {
         if (turn == MESH_TURN) read_mesh(archive, *GetAny<Mesh*>(at), run);
       }}};
}
template <class Base> std::pair<const std::string, ValueWay> function_way(const char* name) {
  using Pair = std::pair<Base*, int>;
  return {name_of<Pair>(),
          {name,
           [](Writer& archive, AnyType at, const RunMesh& run) {
             write_function(archive, GetAny<Pair>(at), run);
           },
           [](Reader& archive, AnyType at, const RunMesh& run, int turn) {
             read_function(archive, GetAny<Pair>(at), run, turn);
           }}};
}
template <class Array> std::pair<const std::string, ValueWay> functions_way(const char* name) {
  using Pair = std::pair<Array*, int>;
  return {name_of<Pair>(),
          {name,
           [](Writer& archive, AnyType at, const RunMesh& run) {
             write_functions(archive, GetAny<Pair>(at), run);
           },
           [](Reader& archive, AnyType at, const RunMesh& run, int turn) {
             read_functions(archive, GetAny<Pair>(at), run, turn);
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
      pointer_way<double>("real"),
      pointer_way<long>("int"),
      pointer_way<bool>("bool"),
      pointer_way<string*>("string"),
      pointer_way<Complex>("complex"),
      pointer_way<KN<double>>("real[int]"),
      pointer_way<KN<long>>("int[int]"),
      pointer_way<KN<Complex>>("complex[int]"),
      pointer_way<KN<String>>("string[int]"),
      pointer_way<KNM<double>>("real[int,int]"),
      pointer_way<KNM<long>>("int[int,int]"),
      pointer_way<KNM<Complex>>("complex[int,int]"),
      pointer_way<KN<KN<double>>>("real[int][int]"),
      pointer_way<KN<KN<long>>>("int[int][int]"),
      pointer_way<MyMap<String, double>>("real[string]"),
      pointer_way<MyMap<String, long>>("int[string]"),
      pointer_way<MyMap<String, String>>("string[string]"),
      mesh_way<pmesh>("mesh"),
      mesh_way<pmesh3>("mesh in space"),
      function_way<FEbase<double, v_fes>>("function"),
      function_way<FEbase<Complex, v_fes>>("complex function"),
      function_way<FEbase<double, v_fes3>>("function in space"),
      function_way<FEbase<Complex, v_fes3>>("complex function in space"),
      functions_way<FEbaseArray<double, v_fes>>("functions"),
      functions_way<FEbaseArray<Complex, v_fes>>("complex functions"),
      functions_way<FEbaseArray<double, v_fes3>>("functions in space"),
      functions_way<FEbaseArray<Complex, v_fes3>>("complex functions in space"),
      matrix_way<double>("matrix"),
      matrix_way<Complex>("complex matrix")};
  const auto found = all.find(type->name());
  return found == all.end() ? nullptr : &found->second;
}

} // namespace burnish
