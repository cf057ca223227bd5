// A press fit: a shaft in a hub, meshed apart, a quarter of both. The shaft is larger than the bore of the hub
// by the interference that the case file gives; here both have the same radius. The shaft is drawn in front of the
// hub; the case file pushes it in. Units: mm.
//
//     gmsh -3 press-fit.geo                    the small mesh, press-fit.msh
//     gmsh -3 press-fit.geo -setnumber size 3
//
// `size` divides the lengths of all elements. The shaft is made of tetrahedra, the hub of hexahedra.
SetFactory("OpenCASCADE");
DefineConstant[ size = {1, Min 0.5, Max 10, Name "elements per length, relative to the small mesh"} ];

radius = 20;
outer = 40;
height = 10;
far = 1e3;
e = 1e-3;

Disk(10) = {0, 0, 0, outer};
Disk(11) = {0, 0, 0, radius};
BooleanDifference(12) = { Surface{10}; Delete; }{ Surface{11}; Delete; };
Rectangle(13) = {0, 0, 0, outer, outer};
BooleanIntersection(14) = { Surface{12}; Delete; }{ Surface{13}; Delete; };
hub() = Extrude{0, 0, height}{ Surface{14}; Layers{Round(2*size)}; Recombine; };
Recombine Surface{14};
Cylinder(20) = {0, 0, 2*height, 0, 0, height, radius, Pi/2};

ends() = Surface In BoundingBox{-e, -e, -e, far, far, e};
For k In {1 : 3}
  ends() += Surface In BoundingBox{-e, -e, k*height - e, far, far, k*height + e};
EndFor
cut_x() = Surface In BoundingBox{-e, -far, -far, e, far, far};
cut_y() = Surface In BoundingBox{-far, -e, -far, far, e, far};
bore() = Surface In BoundingBox{-e, -e, -e, radius + e, radius + e, height + e};
bore() -= {ends(), cut_x(), cut_y()};
shaft() = Boundary{ Volume{20}; };
shaft() -= {ends(), cut_x(), cut_y()};

Physical Volume("shaft") = {20};
Physical Volume("hub") = {hub(1)};
Physical Surface("ends") = {ends()};
Physical Surface("x0") = {cut_x()};
Physical Surface("y0") = {cut_y()};
Physical Surface("round") = {shaft()};
Physical Surface("bore") = {bore()};

MeshSize{ PointsOf{ Volume{20}; } } = 5/size;
MeshSize{ PointsOf{ Volume{hub(1)}; } } = 3.5/size;
Mesh.Algorithm = 8;
Mesh.RecombinationAlgorithm = 1;
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Mesh.HighOrderOptimize = 1;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
