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

#ifdef __cplusplus
}
#endif
