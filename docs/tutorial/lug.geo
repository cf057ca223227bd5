// A pin in the hole of a lug that a rod pulls: a quarter, y >= 0 and z >= 0. Units: mm.
//
//     gmsh -3 lug.geo                              the mesh of the tutorial, lug.msh
//     gmsh -3 lug.geo -setnumber size 2 -o fine.msh
//
// `size` divides the lengths of all elements.
SetFactory("OpenCASCADE");
DefineConstant[ size = {1, Min 0.5, Max 5, Name "elements per length, relative to the small mesh"} ];

pin = 10;           // radius of the pin
clearance = 0.05;   // between pin and hole, on the radius
head = 22;          // radius of the head of the lug
half = 6;           // half the thickness of the lug
reach = 16;         // half the length of the pin
shank = 60;         // where the lug is held
far = 100;
e = 1e-3;

// The pin touches the hole at x = -pin, where it bears.
Cylinder(1) = {0, 0, 0, 0, 0, reach, pin, Pi};
Cylinder(2) = {clearance, 0, 0, 0, 0, half, head, Pi};
Box(3) = {clearance, 0, 0, shank, head, half};
BooleanUnion(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
Cylinder(5) = {clearance, 0, 0, 0, 0, half, pin + clearance, Pi};
BooleanDifference(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };

// Surfaces, found by where they are.
side() = Surface In BoundingBox{-far, -e, -e, far, e, far};
middle() = Surface In BoundingBox{-far, -e, -e, far, far, e};
end() = Surface In BoundingBox{-far, -e, reach - e, far, far, far};
held() = Surface In BoundingBox{shank + clearance - e, -e, -e, far, far, far};
round() = Surface In BoundingBox{-pin - e, -e, -e, pin + e, pin + e, reach + e};
round() -= {side(), middle(), end()};
hole() = Surface In BoundingBox{-pin - e, -e, -e, far, pin + clearance + e, half + e};
hole() -= {side(), middle(), held(), round()};

Physical Volume("pin") = {1};
Physical Volume("lug") = {6};
Physical Surface("side") = {side()};
Physical Surface("middle") = {middle()};
Physical Surface("end") = {end()};
Physical Surface("held") = {held()};
Physical Surface("round") = {round()};
Physical Surface("hole") = {hole()};

MeshSize{ PointsOf{ Volume{1}; } } = 4/size;
MeshSize{ PointsOf{ Volume{6}; } } = 6/size;
MeshSize{ PointsOf{ Surface{hole()}; } } = 3/size;
Mesh.MeshSizeExtendFromBoundary = 1;
Mesh.MeshSizeFromCurvature = 0;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MshFileVersion = 4.1;
