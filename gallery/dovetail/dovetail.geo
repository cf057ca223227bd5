// The root of a turbine blade in its slot in the disc, meshed apart. A quarter: x >= 0 and z >= 0; y is the
// direction of the blade. Units: mm.
//
//     gmsh -3 dovetail.geo                     the small mesh, dovetail.msh
//     gmsh -3 dovetail.geo -setnumber size 3
//
// `size` divides the lengths of all elements. Triangles pulled along z: wedges.
DefineConstant[ size = {1, Min 0.5, Max 10, Name "elements per length, relative to the small mesh"} ];

thickness = 6;  // half of it

// The surface inside of a polygon with rounded corners: x(), y(), r() are corners and radii, counted against
// the clock. Gives `face` and, corner by corner, the curve that starts there, side().
Macro Rounded
  n = #x();
  side() = {};
  curves() = {};
  first() = {};
  last() = {};
  arc() = {};
  For i In {0 : n - 1}
    before = (i + n - 1) % n;
    after = (i + 1) % n;
    ax = x(before) - x(i);
    ay = y(before) - y(i);
    bx = x(after) - x(i);
    by = y(after) - y(i);
    a = Sqrt(ax^2 + ay^2);
    b = Sqrt(bx^2 + by^2);
    ax /= a; ay /= a; bx /= b; by /= b;
    If (r(i) > 0)
      half = Acos(ax*bx + ay*by)/2;
      cut = r(i)/Tan(half);
      far = r(i)/Sin(half)/Sqrt((ax + bx)^2 + (ay + by)^2);
      p1 = newp; Point(p1) = {x(i) + cut*ax, y(i) + cut*ay, 0};
      p2 = newp; Point(p2) = {x(i) + cut*bx, y(i) + cut*by, 0};
      centre = newp; Point(centre) = {x(i) + far*(ax + bx), y(i) + far*(ay + by), 0};
      c = newc; Circle(c) = {p1, centre, p2};
      arc() += c;
    Else
      p1 = newp; Point(p1) = {x(i), y(i), 0};
      p2 = p1;
      arc() += 0;
    EndIf
    first() += p1;
    last() += p2;
  EndFor
  For i In {0 : n - 1}
    c = newc; Line(c) = {last(i), first((i + 1) % n)};
    side() += c;
    If (arc(i) > 0)
      curves() += arc(i);
    EndIf
    curves() += c;
  EndFor
  loop = newcl; Curve Loop(loop) = {curves()};
  face = news; Plane Surface(face) = {loop};
Return

// The blade: foot, flank on the line x + y = 15, neck.
x() = {0, 12, 12, 6, 6, 0};
y() = {0, 0, 3, 9, 22, 22};
r() = {0, 1, 1, 2, 0, 0};
Call Rounded;
blade = face;
blade_side() = side();
blade_arc() = arc();

// The disc: its flank is on the same line.
x() = {0, 26, 26, 7.2, 7.2, 13.5, 13.5, 0};
y() = {-14, -14, 11, 11, 7.8, 1.5, -2, -2};
r() = {0, 0, 0, 0, 1.5, 1.5, 2.5, 0};
Call Rounded;
disc = face;
disc_side() = side();
disc_arc() = arc();

// Fine along the flanks.
Field[1] = Distance;
Field[1].CurvesList = {blade_side(2), disc_side(4), blade_arc(2), blade_arc(3), disc_arc(4), disc_arc(5)};
Field[1].Sampling = 40;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].DistMin = 0.5;
Field[2].DistMax = 12;
Field[2].SizeMin = 0.7/size;
Field[2].SizeMax = 4.5/size;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;

// An extrusion gives the far face, the volume, and the faces of the sides in the order of the curve loop:
// the arc of a corner, if it is rounded, then the side that starts there.
front() = {blade, disc};
blade_out() = Extrude{0, 0, thickness}{ Surface{blade}; Layers{Round(3*size)}; Recombine; };
disc_out() = Extrude{0, 0, thickness}{ Surface{disc}; Layers{Round(3*size)}; Recombine; };

Physical Volume("blade") = {blade_out(1)};
Physical Volume("disc") = {disc_out(1)};
Physical Surface("z0") = {front()};
// Blade: sides 0..5 are the out() entries 2, 4, 6, 8, 9, 10; arcs before 1, 2, 3 are 3, 5, 7.
Physical Surface("x0") = {blade_out(10), disc_out(12)};
Physical Surface("flank") = {blade_out(5), blade_out(6), disc_out(6), disc_out(7), disc_out(8)};
Physical Surface("tip") = {blade_out(9)};
Physical Surface("hub") = {disc_out(2)};
Physical Surface("outside") = {disc_out(3)};
