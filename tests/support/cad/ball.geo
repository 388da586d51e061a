// A ball of radius 5 about the origin.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 5};
