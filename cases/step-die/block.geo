// Half of a block, fine under its top. Lengths as given by the script.
DefineConstant[ W = 12, H = 8, fine = 0.35, coarse = 1.4 ];
Point(1) = {0, -H, 0, coarse};
Point(2) = {W, -H, 0, coarse};
Point(3) = {W, 0, 0, fine};
Point(4) = {0, 0, 0, fine};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Physical Curve(1) = {1}; // bottom
Physical Curve(2) = {2}; // right side
Physical Curve(3) = {3}; // top
Physical Curve(4) = {4}; // symmetry
Physical Surface(1) = {1};
