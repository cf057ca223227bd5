// Half a ball on a block, meshed apart: two bodies of tetrahedra of second order with about 340 000 unknowns
// together. For timings; the mesh is not kept. Units: mm.
//
//     gmsh -3 large.geo                        large.msh
//     gmsh -3 large.geo -setnumber size 0.5    about 50 000 unknowns
//
// `size` divides the lengths of all elements.
SetFactory("OpenCASCADE");
DefineConstant[ size = {1, Min 0.1, Max 3, Name "elements per length, relative to 340 000 unknowns"} ];

radius = 50;
half = 50;     // of the length and width of the block
depth = 50;
touch = 20;    // radius around the contact where elements are small
far = 1e3;
e = 1e-3;

// The lower half of the ball touches the block at the origin.
Sphere(1) = {0, 0, radius, radius, -Pi/2, 0, 2*Pi};
Box(2) = {-half, -half, -depth, 2*half, 2*half, depth};

plane() = Surface In BoundingBox{-far, -far, radius - e, far, far, radius + e};
ball() = Boundary{ Volume{1}; };
ball() -= {plane()};
Physical Volume("ball") = {1};
Physical Volume("block") = {2};
Physical Surface("plane") = {plane()};
Physical Surface("sphere") = {ball()};
Physical Surface("top") = {Surface In BoundingBox{-far, -far, -e, far, far, e}};
Physical Surface("bottom") = {Surface In BoundingBox{-far, -far, -depth - e, far, far, -depth + e}};

Field[1] = Ball;
Field[1].Radius = touch;
Field[1].Thickness = 60;
Field[1].VIn = 2.18/size;
Field[1].VOut = 6.4/size;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 1;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
