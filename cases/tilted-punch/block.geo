// A block with a circle on its top, where the edge of the punch will stand. Lengths are the script's (rcGradedMeshAlong3).
DefineConstant[ side = 200, a = 1 ];
SetFactory("OpenCASCADE");
Box(1) = {-side, -side, -2*side, 2*side, 2*side, 2*side};
Disk(7) = {0, 0, 0, a}; Disk(8) = {0, 0, 0, 2*a};
BooleanFragments{ Volume{1}; Delete; }{ Surface{7, 8}; Delete; }
eps = 1e-3*a;
near() = Surface In BoundingBox{-2*a - eps, -2*a - eps, -eps, 2*a + eps, 2*a + eps, eps};
top() = Surface In BoundingBox{-side - eps, -side - eps, -eps, side + eps, side + eps, eps};
others() = Surface{:}; others() -= top(); top() -= near();
Physical Surface(3) = {near()}; Physical Surface(2) = {top()}; Physical Surface(1) = {others()};
Physical Volume(1) = {1};
