// An oval, mm, clockwise: the workpiece is on its left, outside. Two arcs of radius R above and below, two of R/q beside them, all of a
// quarter turn, tangent to each other; each drawn by n arcs.
DefineConstant[ R = 3, q = 1, n = 1 ];
c = (R - R/q)/Sqrt(2);                           // distance of all centers from the middle
For k In {0:3}
  a = Pi/4 - k*Pi/2;                             // where this piece begins; it is beside the middle where k is even
  r = (k % 2 == 0) ? R/q : R;
  s = (k % 2 == 0) ? 1 : -1;
  p = 100000*(k + 1);
  Point(p) = {s*c*Cos(a - Pi/4), s*c*Sin(a - Pi/4), 0};
  For i In {0:n-1}
    Point(k*n + i + 1) = {s*c*Cos(a - Pi/4) + r*Cos(a - i*Pi/2/n), s*c*Sin(a - Pi/4) + r*Sin(a - i*Pi/2/n), 0};
  EndFor
EndFor
For i In {0:4*n-1}
  Circle(i + 1) = {i + 1, 100000*(Floor(i/n) + 1), (i + 1) % (4*n) + 1};
EndFor
