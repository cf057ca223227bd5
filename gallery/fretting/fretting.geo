// A fretting test in the plane: a pad with a cylindrical face that touches a flat specimen at the origin, meshed
// apart. Units: mm.
//
//     gmsh -2 fretting.geo                     the small mesh, fretting.msh
//     gmsh -2 fretting.geo -setnumber size 8
//
// `size` divides the lengths of all elements. The pad is made of triangles, the specimen of quadrilaterals.
DefineConstant[ size = {1, Min 0.5, Max 50, Name "elements per length, relative to the small mesh"} ];

radius = 50;    // of the face of the pad
half = 6;       // of the width of the pad
height = 10;    // of the pad in its middle
length = 12;    // half of the length of the specimen
depth = 10;     // of the specimen
rise = radius - Sqrt(radius^2 - half^2);

// The pad. Its face is two arcs that meet where it touches.
Point(1) = {0, 0, 0};
Point(2) = {half, rise, 0};
Point(3) = {half, height, 0};
Point(4) = {-half, height, 0};
Point(5) = {-half, rise, 0};
Point(6) = {0, radius, 0};
Circle(1) = {5, 6, 1};
Circle(2) = {1, 6, 2};
Line(3) = {2, 3};
Line(4) = {3, 4};
Line(5) = {4, 5};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};

// The specimen.
Point(11) = {-length, -depth, 0};
Point(12) = {length, -depth, 0};
Point(13) = {length, 0, 0};
Point(14) = {-length, 0, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(2) = {2};
Recombine Surface{2};

Physical Surface("pad") = {1};
Physical Surface("specimen") = {2};
Physical Curve("face") = {1, 2};
Physical Curve("top") = {4};
Physical Curve("flat") = {13};
Physical Curve("bottom") = {11};

// Fine around the contact.
Field[1] = Ball;
Field[1].Radius = 1.4;
Field[1].Thickness = 6;
Field[1].VIn = 0.17/size;
Field[1].VOut = 2.2/size;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.RecombinationAlgorithm = 1;
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
