// A block with a ring of layers about the edge of the punch, thin toward r = a.
// The ring is 2 w wide and w deep, in k parts a quarter. Lengths elsewhere are the script's (rcGradedMeshAlong3).
// Labels: 1 sides and bottom, 2 top, 3 top near the punch.
DefineConstant[ side = 200, a = 1, w = 0.2, k = 6 ];
Point(1) = {a - w, 0, 0}; Point(2) = {a, 0, 0}; Point(3) = {a + w, 0, 0};
Point(4) = {a - w, 0, -w}; Point(5) = {a, 0, -w}; Point(6) = {a + w, 0, -w};
Line(1) = {2, 1}; Line(2) = {2, 3}; Line(3) = {2, 5}; Line(4) = {1, 4};
Line(5) = {3, 6}; Line(6) = {5, 4}; Line(7) = {5, 6};
Transfinite Curve{1:7} = 4 Using Progression 2;
Curve Loop(1) = {1, 4, -6, -3}; Curve Loop(2) = {3, 7, -5, -2};
Plane Surface(1) = {1}; Plane Surface(2) = {2};
Transfinite Surface{1, 2};
inner() = {1}; outer() = {2}; ring() = {}; near() = {}; walls() = {};
For q In {0:3}
  e() = Extrude{{0, 0, 1}, {0, 0, 0}, Pi/2}{ Surface{inner(q)}; Layers{k}; };
  f() = Extrude{{0, 0, 1}, {0, 0, 0}, Pi/2}{ Surface{outer(q)}; Layers{k}; };
  inner() += e(0); outer() += f(0); ring() += {e(1), f(1)};
  near() += {e(2), f(5)}; walls() += {e(3), e(4), f(3), f(4)};
EndFor
r = a - 0.9*w; eps = 1e-3*a;
circle() = Curve In BoundingBox{-r, -r, -eps, r, r, eps};
hole() = CombinedBoundary{ Surface{near()}; }; hole() -= circle();
Curve Loop(100) = {circle()}; Plane Surface(100) = {100};
Point(101) = {-side, -side, 0}; Point(102) = {side, -side, 0};
Point(103) = {side, side, 0}; Point(104) = {-side, side, 0};
l = newc; Line(l) = {101, 102}; Line(l + 1) = {102, 103}; Line(l + 2) = {103, 104}; Line(l + 3) = {104, 101};
Curve Loop(101) = {l:l + 3}; Curve Loop(102) = {hole()};
Plane Surface(101) = {101, 102};
below() = Extrude{0, 0, -2*side}{ Line{l:l + 3}; };
Curve Loop(103) = {below(0), below(4), below(8), below(12)}; Plane Surface(103) = {103};
others() = {103, below(1), below(5), below(9), below(13)};
Surface Loop(100) = {100, 101, others(), walls()}; Volume(100) = {100};
Physical Surface(3) = {near(), 100}; Physical Surface(2) = {101}; Physical Surface(1) = {others()};
Physical Volume(1) = {100, ring()};
