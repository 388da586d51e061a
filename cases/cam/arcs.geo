// Cam of lines and arcs, mm: a rectangle 2a x 2b with rounded corners, counterclockwise from the right side's lower end.
// Corners: r1 upper right, r2 upper left, r3 lower left, r4 lower right.
SetFactory("OpenCASCADE");
DefineConstant[ a = 7, b = 6, r1 = 5, r2 = 4, r3 = 5.5, r4 = 5.5 ];
Point(1) = {a, r4 - b, 0};     Point(2) = {a, b - r1, 0};     Point(3) = {a - r1, b - r1, 0};
Point(4) = {a - r1, b, 0};
Point(5) = {r2 - a, b, 0};     Point(6) = {r2 - a, b - r2, 0};  Point(7) = {-a, b - r2, 0};
Point(8) = {-a, r3 - b, 0};    Point(9) = {r3 - a, r3 - b, 0};  Point(10) = {r3 - a, -b, 0};
Point(11) = {a - r4, -b, 0};   Point(12) = {a - r4, r4 - b, 0};
Line(1) = {1, 2};    Circle(2) = {2, 3, 4};    Line(3) = {4, 5};     Circle(4) = {5, 6, 7};
Line(5) = {7, 8};    Circle(6) = {8, 9, 10};   Line(7) = {10, 11};   Circle(8) = {11, 12, 1};
