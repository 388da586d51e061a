// Egg-shaped cam, mm: one closed spline through points of r(a) = R (1 + e cos a), a from the cam's center.
SetFactory("OpenCASCADE");
DefineConstant[ R = 12, e = 0.15, n = 24 ];
For i In {0:n-1}
  a = 2*Pi*i/n;
  Point(i + 1) = {R*(1 + e*Cos(a))*Cos(a), R*(1 + e*Cos(a))*Sin(a), 0};
EndFor
Spline(1) = {1:n, 1};
