// Closed cam: one periodic B-spline about nine points, mm.
SetFactory("OpenCASCADE");
For i In {0:8}
  a = 2*Pi*i/9;
  r = 10*(1 + 0.25*Cos(a) + 0.1*Sin(2*a));
  Point(i + 1) = {r*Cos(a), r*Sin(a), 0};
EndFor
BSpline(1) = {1:9, 1};
