// Half of a punch, open, mm: side, fillet, flat (drawn the other way round), and a crown that is a Bezier curve.
// Its direction is that of curve 1, down: the punch is on its left, so it needs inside=true.
SetFactory("OpenCASCADE");
DefineConstant[ R = {2, Name "Fillet radius"}, H = 8 ];
Point(1) = {-10, H, 0};
Point(2) = {-10, R, 0};
Point(3) = {-10 + R, R, 0};
Point(4) = {-10 + R, 0, 0};
Point(5) = {0, 0, 0};
Point(6) = {3, 0, 0};
Point(7) = {6, -0.5, 0};
Line(1) = {1, 2};
Circle(2) = {2, 3, 4};
Line(3) = {5, 4};
Bezier(4) = {5, 6, 7};
