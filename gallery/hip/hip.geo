// The head of a hip implant in its cup: a metal ball with a flat on which the load acts, and a plastic cup
// that is tilted against the load, meshed apart. One half, y >= 0. Units: mm.
//
//     gmsh -3 hip.geo                          the small mesh, hip.msh
//     gmsh -3 hip.geo -setnumber size 3
//
// `size` divides the lengths of all elements.
SetFactory("OpenCASCADE");
DefineConstant[ size = {1, Min 0.5, Max 10, Name "elements per length, relative to the small mesh"} ];

radius = 14;        // of the ball
top = 8;            // height of the flat above the centre of the ball
clearance = 0.1;    // between ball and cup, on the radius
wall = 8;           // of the cup
tilt = 35*Pi/180;   // between the axis of the cup and the load
far = 100;
e = 1e-3;

// The ball touches the cup at the bottom, (0, 0, -radius).
Sphere(11) = {0, 0, 0, radius, -Pi/2, Asin(top/radius), Pi};
inner = radius + clearance;
Sphere(12) = {0, 0, 0, inner, -Pi/2, 0, Pi};
Sphere(13) = {0, 0, 0, inner + wall, -Pi/2, 0, Pi};
BooleanDifference(14) = { Volume{13}; Delete; }{ Volume{12}; Delete; };
Rotate{ {0, 1, 0}, {0, 0, 0}, tilt }{ Volume{14}; }
Translate{0, 0, clearance}{ Volume{14}; }

// Surfaces, found by where they are.
flat() = Surface In BoundingBox{-far, -e, top - e, far, far, top + e};
symmetry() = Surface In BoundingBox{-far, -e, -far, far, e, far};
ball() = Surface In BoundingBox{-radius - e, -e, -radius - e, radius + e, radius + e, top + e};
ball() -= {flat(), symmetry()};
socket() = Surface In BoundingBox{-inner - e, -e, -inner - e + clearance, inner + e, inner + e, far};
socket() -= {flat(), symmetry(), ball()};
outside() = Surface In BoundingBox{-far, -e, -inner - wall - e + clearance, far, far, far};
outside() -= {flat(), symmetry(), ball(), socket()};
// What is left are the outer sphere and the rim; the rim stays free.
rim() = {};
For i In {0 : #outside() - 1}
  box() = BoundingBox Surface{outside(i)};
  If (box(2) > -radius)
    rim() += outside(i);
  EndIf
EndFor
outside() -= rim();

Physical Volume("ball") = {11};
Physical Volume("cup") = {14};
Physical Surface("flat") = {flat()};
Physical Surface("sphere") = {ball()};
Physical Surface("socket") = {socket()};
Physical Surface("outside") = {outside()};
Physical Surface("symmetry") = {symmetry()};

// The plastic is soft and carries the deformation: its elements are the smaller ones.
MeshSize{ PointsOf{ Volume{11}; } } = 5/size;
MeshSize{ PointsOf{ Volume{14}; } } = 4/size;
Mesh.MeshSizeExtendFromBoundary = 1;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MshFileVersion = 2.2;
Mesh.Binary = 1;
