// Wedge with a round tip, mm: tip at the origin, radius r, flanks at b degrees from the vertical, far long.
// The curves run from right to left: the workpiece is on their left, below.
SetFactory("OpenCASCADE");
DefineConstant[ r = 1, b = 60, far = 12 ];
beta = b*Pi/180;
Point(1) = {r*Cos(beta) + far*Sin(beta), r - r*Sin(beta) + far*Cos(beta), 0};
Point(2) = {r*Cos(beta), r - r*Sin(beta), 0};
Point(3) = {-r*Cos(beta), r - r*Sin(beta), 0};
Point(4) = {-r*Cos(beta) - far*Sin(beta), r - r*Sin(beta) + far*Cos(beta), 0};
Point(5) = {0, r, 0};
Line(1) = {1, 2};
Circle(2) = {2, 5, 3};
Line(3) = {3, 4};
