// Die with a groove, mm: flat face y = 0, groove 2w wide, d deep, draft angle b, fillets r1 at its mouth, r2 below.
// The curves run from right to left: the workpiece is on their left, below.       gmsh -0 die.geo -o die.step
SetFactory("OpenCASCADE");
DefineConstant[ w = 3, d = 1.5, b = 15, r1 = 0.8, r2 = 0.6, far = 20 ];
beta = b*Pi/180;
q = Tan((Pi/2 - beta)/2);                       // length of a tangent over its fillet's radius
v = w - d*Tan(beta);                            // half-width of the bottom, between the tips of its corners
// Left half: mouth and bottom of the fillets, with their centers; then the right half
For side In {0:1}
  k = 10*side; m = 2*side - 1;
  Point(k + 1) = {m*far, 0, 0};
  Point(k + 2) = {m*(w + r1*q), 0, 0};
  Point(k + 3) = {m*(w - r1*q*Sin(beta)), r1*q*Cos(beta), 0};
  Point(k + 4) = {m*(v + r2*q*Sin(beta)), d - r2*q*Cos(beta), 0};
  Point(k + 5) = {m*(v - r2*q), d, 0};
  Point(k + 6) = {m*(w + r1*q), r1, 0};
  Point(k + 7) = {m*(v - r2*q), d - r2, 0};
EndFor
Line(1) = {11, 12};   Circle(2) = {12, 16, 13};  Line(3) = {13, 14};  Circle(4) = {14, 17, 15};
Line(5) = {15, 5};
Circle(6) = {5, 7, 4};  Line(7) = {4, 3};  Circle(8) = {3, 6, 2};  Line(9) = {2, 1};
