// Block [-W, W] x [-W, W] x [-W, 0] with a core [-L, L] x [-B, B] x [-D, 0] of nx x ny x nz cells, six tetrahedra
// each, smallest about its middle and at the top; twice as many lie in one another. Labels: 1 bottom and sides, 3 top.
// Lengths outside the core are the script's, rcGradedMeshAlong3.
DefineConstant[ W = 1.3, L = 0.4, B = 0.3, D = 0.2, nx = 12, ny = 12, nz = 4 ];
c = 0.85;      // the middle cell is 1/(1 + c) of the mean one in x and y
q = 1.3;       // layers end at D (k/nz)^q
px() = {}; py() = {}; pz() = {}; ox() = {}; oy() = {}; oz() = {};
For k In {1:nx}
  s = 2*k/nx - 1; px() += {0.5 + 0.5*(s + c*s^3)/(1 + c)}; ox() += {1};
EndFor
For k In {1:ny}
  s = 2*k/ny - 1; py() += {0.5 + 0.5*(s + c*s^3)/(1 + c)}; oy() += {1};
EndFor
For k In {1:nz}
  pz() += {(k/nz)^q}; oz() += {1};
EndFor
Point(1) = {-L, -B, 0};
line() = Extrude{2*L, 0, 0}{ Point{1}; Layers{ {ox()}, {px()} }; };
top() = Extrude{0, 2*B, 0}{ Line{line(1)}; Layers{ {oy()}, {py()} }; };
core() = Extrude{0, 0, -D}{ Surface{top(1)}; Layers{ {oz()}, {pz()} }; };
rim() = Boundary{ Surface{top(1)}; };
Curve Loop(1) = {rim()};
Point(101) = {-W, -W, 0}; Point(102) = {W, -W, 0}; Point(103) = {W, W, 0}; Point(104) = {-W, W, 0};
Line(101) = {101, 102}; Line(102) = {102, 103}; Line(103) = {103, 104}; Line(104) = {104, 101};
Curve Loop(101) = {101:104}; Plane Surface(101) = {101, 1};
sides() = Extrude{0, 0, -W}{ Line{101:104}; };
floor() = {sides(0), sides(4), sides(8), sides(12)};
walls() = {sides(1), sides(5), sides(9), sides(13)};
Curve Loop(102) = {floor()}; Plane Surface(102) = {102};
Surface Loop(101) = {101, 102, walls(), core(0), core({2:5})}; Volume(101) = {101};
Physical Surface(1) = {102, walls()}; Physical Surface(3) = {top(1), 101};
Physical Volume(1) = {101, core(1)};
