// Block [X0, W] x [Y0, W] x [-W, 0] under a ball; X0 = 0, Y0 = 0 are planes of symmetry.
// Labels: 1 bottom and far sides, 3 top, 4 plane y = 0, 5 plane x = 0.
SetFactory("OpenCASCADE");
DefineConstant[ W = 2.5, X0 = 0, Y0 = 0 ];
Box(1) = {X0, Y0, -W, W - X0, W - Y0, W};
e = 1e-6*W;
top() = Surface In BoundingBox{X0 - e, Y0 - e, -e, W + e, W + e, e};
left() = Surface In BoundingBox{X0 - e, Y0 - e, -W - e, X0 + e, W + e, e};
front() = Surface In BoundingBox{X0 - e, Y0 - e, -W - e, W + e, Y0 + e, e};
outer() = Surface In BoundingBox{X0 - e, Y0 - e, -W - e, W + e, W + e, -W + e};
outer() += Surface In BoundingBox{W - e, Y0 - e, -W - e, W + e, W + e, e};
outer() += Surface In BoundingBox{X0 - e, W - e, -W - e, W + e, W + e, e};
If (X0 < 0)
  outer() += left();
Else
  Physical Surface(5) = {left()};
EndIf
If (Y0 < 0)
  outer() += front();
Else
  Physical Surface(4) = {front()};
EndIf
Physical Surface(1) = {outer()};
Physical Surface(3) = {top()};
Physical Volume(1) = {1};
