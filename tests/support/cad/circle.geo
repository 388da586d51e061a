// Roller of radius 15 mm.
SetFactory("OpenCASCADE");
Circle(1) = {0, 0, 0, 15};
