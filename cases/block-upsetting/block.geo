// A quarter of a block on the planes of symmetry x = 0 and y = 0; tetrahedra of gmsh, so that no direction is favored.
DefineConstant[ W = 5, D = 5, height = 12, size = 2.5 ];
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, W, D, height};
Mesh.MeshSizeMax = size; Mesh.MeshSizeMin = size;
Physical Surface(1) = {1}; Physical Surface(2) = {3};          // x = 0, y = 0
Physical Surface(3) = {5, 6}; Physical Surface(4) = {2, 4};     // bottom and top, sides
Physical Volume(1) = {1};
