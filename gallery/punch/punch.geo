// A block for a rigid ball that is pressed into it at the origin and then dragged along x. One half, y >= 0.
// Units: mm.
//
//     gmsh -3 punch.geo                        the small mesh, punch.msh
//     gmsh -3 punch.geo -setnumber size 3
//
// `size` divides the lengths of all elements.
SetFactory("OpenCASCADE");
DefineConstant[ size = {1, Min 0.5, Max 10, Name "elements per length, relative to the small mesh"} ];

half = 20;     // of the length and of the width
depth = 20;
contact = 4;   // radius of the part of the top that may touch the ball
far = 1e3;
e = 1e-3;

Box(1) = {-half, 0, -depth, 2*half, half, depth};
Circle(20) = {0, 0, 0, contact, 0, Pi};
Line(21) = {PointsOf{ Curve{20}; }};
Curve Loop(22) = {20, 21};
Plane Surface(10) = {22};
BooleanFragments{ Volume{1}; Delete; }{ Surface{10}; Delete; }

middle() = Surface In BoundingBox{-contact - e, -e, -e, contact + e, contact + e, e};
Physical Volume("block") = {1};
Physical Surface("middle") = {middle()};
Physical Surface("bottom") = {Surface In BoundingBox{-far, -far, -depth - e, far, far, -depth + e}};
Physical Surface("symmetry") = {Surface In BoundingBox{-far, -e, -far, far, e, far}};

Field[1] = Ball;
Field[1].Radius = contact;
Field[1].Thickness = half;
Field[1].VIn = 1.15/size;
Field[1].VOut = 10/size;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MshFileVersion = 2.2;
Mesh.Binary = 1;
