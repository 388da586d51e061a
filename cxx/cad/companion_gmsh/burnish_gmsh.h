#pragma once
/* All that Burnish asks of gmsh, in a shared library of its own (burnish_gmsh.so): only this one is linked with
   gmsh, and it is opened when a script first needs it. Each function is called once in a process made for it
   (run_in_child): gmsh ends the process on some damaged files, runs for ever on others, and keeps the names of
   the last file. */

#ifdef __cplusplus
extern "C" {
#endif

/* A number for a DefineConstant of a .geo file. */
typedef struct {
  const char* name;
  double value;
} burnish_gmsh_number;

/* Reads a .geo file and writes into an existing folder
     entities             a line each: dimension and tag; of a curve also 1 if it belongs to OpenCASCADE, else 0,
                          its points at burnish_gmsh_place[] of its range, 3 coordinates each, and its kind
                          (to the end of the line)
     opencascade.brep     curves of OpenCASCADE, in the order of their tags, if there are any
     builtin.geo_unrolled points and curves of gmsh's own kernel, if there are any
   seconds: of computing that reading may take; beyond, the process is ended by SIGXCPU, and by SIGALRM if it
   only waits; it may take 2 GB of memory.
   Returns NULL, or the first error that gmsh tells. */
const char* burnish_gmsh_curves(const char* file, const burnish_gmsh_number* numbers, int count,
                                const char* folder, double seconds);
typedef const char* (*burnish_gmsh_curves_call)(const char*, const burnish_gmsh_number*, int, const char*,
                                                double);

/* Where a curve is sampled, parts of its range. */
#define BURNISH_GMSH_PLACES 5
static const double burnish_gmsh_place[BURNISH_GMSH_PLACES] = {0, 0.23, 0.5, 0.81, 1};

/* Meshes the surfaces of a .geo file with triangles (dimension 2) or its volumes with tetrahedra (3) and writes a
   file of format MSH 2.2, text. folder: for temporary files. sizes: statements of .geo that are read last, or "".
   gmsh prints what it does on the standard output.
   Returns NULL, or the last lines of what gmsh says, errors and warnings if there are any. */
const char* burnish_gmsh_mesh(const char* file, const burnish_gmsh_number* numbers, int count,
                              const char* folder, const char* result, int dimension, const char* sizes);
typedef const char* (*burnish_gmsh_mesh_call)(const char*, const burnish_gmsh_number*, int, const char*,
                                              const char*, int, const char*);

/* A body whose surface is a set of patches, each to be meshed anew between the lines where it meets others. */
typedef struct {
  const double* x; /* nodes of the surface, 3 coordinates each */
  int nodes;
  const int* triangle; /* 3 nodes each, from 0 */
  const int* patch;    /* of each triangle, from 0, without a gap */
  int triangles;
  const int* line;         /* nodes of the lines where patches meet, one line after another; closed ones end where they begin */
  const int* line_start;   /* of each, and the end */
  const int* line_patches; /* 2 each */
  int lines;
  const double* size; /* tetrahedra of the body, 16 numbers each: x, y, z of the corners, lengths of edges there */
  int tetrahedra;
} burnish_gmsh_body;

/* Meshes it and writes a text file: numbers of nodes, tetrahedra, triangles; places of the nodes; nodes of the
   tetrahedra, from 0; nodes and patch of the triangles of the surface. Prints and returns as burnish_gmsh_mesh. */
const char* burnish_gmsh_fill(const burnish_gmsh_body* body, const char* result);
typedef const char* (*burnish_gmsh_fill_call)(const burnish_gmsh_body*, const char*);

#ifdef __cplusplus
}
#endif
