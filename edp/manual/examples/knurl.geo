// Toothed wheel as one closed smooth spline: r = R + h/2 cos(z a). Lengths in mm.
SetFactory("OpenCASCADE");
DefineConstant[ R = 10, z = 24, h = 0.6 ];
n = 12*z;
For i In {0:n-1}
  a = 2*Pi*i/n;
  r = R + h/2*Cos(z*a);
  Point(i+1) = {r*Cos(a), r*Sin(a), 0};
EndFor
Spline(1) = {1:n, 1};
