// A box of 8 x 6 x 4 about the origin, all edges rounded by 1: 6 planes, 12 cylinders, 8 balls.
SetFactory("OpenCASCADE");
Box(1) = {-4, -3, -2, 8, 6, 4};
Fillet{1}{1:12}{1}
