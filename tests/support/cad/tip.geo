// A cone with a tip and a sharp edge: radius 4 at z = 0, height 6.
SetFactory("OpenCASCADE");
Cone(1) = {0, 0, 0, 0, 0, 6, 4, 0};
