// A bolted lap joint: two plates with a clearance hole each and a bolt with head and nut, meshed apart.
// One half, y >= 0. Units: mm.
//
//     gmsh -3 lap-joint.geo                    the small mesh, lap-joint.msh
//     gmsh -3 lap-joint.geo -setnumber size 3
//
// `size` divides the lengths of all elements.
SetFactory("OpenCASCADE");
DefineConstant[ size = {1, Min 0.5, Max 10, Name "elements per length, relative to the small mesh"} ];

thickness = 6;     // of a plate
width = 20;        // of half a plate
lap = 20;          // half of the length that the plates share
length = 60;       // from the bolt to the far end of a plate
stem = 5;          // radius
clearance = 0.05;  // between shank and hole, on the radius
head = 9;          // radius of head and nut
height = 5;        // of head and nut
far = 1e4;

// Bodies. What lies at y < 0 is cut off.
bore = stem + clearance;
Box(1) = {-length, 0, -thickness, length + lap, width, thickness};
Cylinder(10) = {0, 0, -2*thickness, 0, 0, 4*thickness, bore};
BooleanDifference{ Volume{1}; Delete; }{ Volume{10}; }
Box(2) = {-lap, 0, 0, length + lap, width, thickness};
BooleanDifference{ Volume{2}; Delete; }{ Volume{10}; Delete; }
Cylinder(20) = {0, 0, thickness, 0, 0, height, head};
Cylinder(21) = {0, 0, -thickness, 0, 0, 2*thickness, stem};
Cylinder(22) = {0, 0, -thickness - height, 0, 0, height, head};
BooleanUnion(23) = { Volume{20}; Delete; }{ Volume{21, 22}; Delete; };
Box(24) = {-far, 0, -far, 2*far, far, 2*far};
BooleanIntersection(3) = { Volume{23}; Delete; }{ Volume{24}; Delete; };


// Only the part of each plate that the other one covers may touch it: an edge is drawn at its end.
For k In {1 : 2}
  x = (2*k - 3)*lap;
  a = newp; Point(a) = {x, 0, 0};
  b = newp; Point(b) = {x, width, 0};
  cut = newc; Line(cut) = {a, b};
  BooleanFragments{ Volume{k}; Delete; }{ Curve{cut}; Delete; }
EndFor

// Surfaces, found by where they are. A group may have faces on several bodies: the case file says upper.faying.
e = 1e-3;
end() = Surface In BoundingBox{-length - e, -e, -far, -length + e, far, far};
end() += Surface In BoundingBox{length - e, -e, -far, length + e, far, far};
faying() = Surface In BoundingBox{-lap - e, -e, -e, lap + e, far, e};
outside() = Surface In BoundingBox{-far, -e, -thickness - e, lap + e, far, -thickness + e};
outside() += Surface In BoundingBox{-lap - e, -e, thickness - e, far, far, thickness + e};
seat_head() = Surface In BoundingBox{-head - e, -e, thickness - e, head + e, head + e, thickness + e};
seat_nut() = Surface In BoundingBox{-head - e, -e, -thickness - e, head + e, head + e, -thickness + e};
outside() -= {seat_head(), seat_nut()};
hole() = Surface In BoundingBox{-bore - e, -e, -thickness - e, bore + e, bore + e, e};
hole() += Surface In BoundingBox{-bore - e, -e, -e, bore + e, bore + e, thickness + e};
shank() = Surface In BoundingBox{-stem - e, -e, -thickness - e, stem + e, stem + e, thickness + e};
symmetry() = Surface In BoundingBox{-far, -e, -far, far, e, far};

Physical Volume("lower") = {1};
Physical Volume("upper") = {2};
Physical Volume("bolt") = {3};
Physical Surface("end") = {end()};
Physical Surface("faying") = {faying()};
Physical Surface("outside") = {outside()};
Physical Surface("hole") = {hole()};
Physical Surface("head") = {seat_head()};
Physical Surface("nut") = {seat_nut()};
Physical Surface("shank") = {shank()};
Physical Surface("symmetry") = {symmetry()};

// Fine around the bolt, coarse towards the ends.
Field[1] = Cylinder;
Field[1].Radius = 1.2*head;
Field[1].ZAxis = 4*thickness;
Field[1].VIn = 3.7/size;
Field[1].VOut = 9/size;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MshFileVersion = 2.2;
Mesh.Binary = 1;
