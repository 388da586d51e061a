// A pin of radius 3 from z = 0 up to 5, its lower edge rounded by 1; the upper one is sharp, out of reach. mm
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 5, 3};
Fillet{1}{3}{1}
