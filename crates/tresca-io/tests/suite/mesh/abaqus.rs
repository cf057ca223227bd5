//! Decks: sets, surfaces, parts and instances.

use miette::Diagnostic;
use tresca_fem::mesh::{CellKind, Space};
use tresca_io::mesh::{MeshFile, parse};

use crate::mesh::support::{area, body, refused, solid};

/// Two cubes on one another, of which the upper one starts its numbers at 101.
const TOWER: &str = "*HEADING
A tower
** a comment
*NODE, NSET=ALL
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1., 0
4, 0, 1, 0.0D0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
9, 0, 0, 2
10, 1, 0, 2
11, 1, 1, 2
12, 0, 1, 2
13, 5, 5, 5
*ELEMENT, TYPE=C3D8R, ELSET=Lower
1, 1, 2, 3, 4, 5,
   6, 7, 8
*Element, type=C3D8R, elset=Upper
101, 5, 6, 7, 8, 9, 10, 11, 12
*ELSET, ELSET=Both
LOWER, upper
*ELSET, ELSET=Range, GENERATE
1, 200, 100
*NSET, NSET=Base, GENERATE
1, 4
*NSET, NSET=Odd
1, 3,
5
*NSET, NSET=Of elements, ELSET=Upper
*SURFACE, NAME=Bottom
Lower, S1
*SURFACE, NAME=Top, TYPE=ELEMENT
101, S2
*SURFACE, NAME=Side
Both, S3
*SURFACE, NAME=Skin
Upper,
*SURFACE, NAME=Points, TYPE=NODE
Base, 1.0
13,
*MATERIAL, NAME=Steel
*ELASTIC
210000., 0.3
*STEP
*STATIC
*END STEP
";

fn deck(text: &str) -> MeshFile {
    parse("deck.inp", text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn sets_and_surfaces_of_a_flat_deck() {
    let file = deck(TOWER);
    assert_eq!(
        file.skipped,
        [
            "*HEADING",
            "*MATERIAL",
            "*ELASTIC",
            "*STEP and what follows"
        ]
    );
    assert_eq!(file.group_names(3), ["Both", "Lower", "Range", "Upper"]);
    assert_eq!(file.group_names(2), ["Bottom", "Side", "Skin", "Top"]);
    assert_eq!(file.group("Range", 3).unwrap().cells, [0, 1]);
    assert_eq!(file.group("Odd", 0).unwrap().nodes, [0, 2, 4]);
    assert_eq!(
        file.group("Of elements", 0).unwrap().nodes,
        (4..12).collect::<Vec<_>>()
    );
    assert_eq!(file.group("Points", 0).unwrap().nodes, [0, 1, 2, 3, 12]);
    assert_eq!(file.points[3], [0.0, 1.0, 0.0]);
    let tower = solid(&file, None);
    assert_eq!((tower.node_count(), tower.cell_count()), (12, 2));
    assert_eq!(tower.cells[0].kind, CellKind::Hex8);
    assert_eq!(tower.node_sets["Points"], [0, 1, 2, 3]);
    assert_eq!(area(&tower, "Bottom"), [0.0, 0.0, -1.0]);
    assert_eq!(area(&tower, "Top"), [0.0, 0.0, 1.0]);
    assert_eq!(area(&tower, "Side"), [0.0, -2.0, 0.0]);
    // What a set leaves open is the outside: five of six sides, without the common one.
    assert_eq!(area(&tower, "Skin"), [0.0, 0.0, 1.0]);
    assert_eq!(tower.face_sets["Skin"].len(), 5);
    let lower = solid(&file, Some("Lower"));
    assert_eq!(
        lower.face_sets.keys().collect::<Vec<_>>(),
        ["Bottom", "Side"]
    );
    assert_eq!(lower.face_sets["Side"].len(), 1);
}

#[test]
fn a_set_that_is_given_again_grows_whatever_its_letters() {
    let text = TOWER.replace(
        "*MATERIAL",
        "*NSET, NSET=BASE\n5\n*NSET, NSET=\"Later\"\nbase\n*MATERIAL",
    );
    let file = deck(&text);
    assert_eq!(file.group("Base", 0).unwrap().nodes, [0, 1, 2, 3, 4]);
    assert_eq!(file.group("Later", 0).unwrap().nodes, [0, 1, 2, 3, 4]);
    assert!(file.group("BASE", 0).is_err());
}

#[test]
fn shells_are_surfaces_of_the_body_that_they_lie_on() {
    // A rigid plate of shells under a cube, and a surface of it.
    let text = TOWER.replace(
        "*ELSET, ELSET=Both",
        "*ELEMENT, TYPE=R3D4, ELSET=Plate\n200, 1, 2, 3, 4\n*SURFACE, NAME=Contact\nPlate, SPOS\n*ELSET, ELSET=Both",
    );
    let file = deck(&text);
    assert_eq!(
        file.group("Contact", 2).unwrap().cells,
        file.group("Plate", 2).unwrap().cells
    );
    assert_eq!(
        area(&solid(&file, Some("Lower")), "Plate"),
        [0.0, 0.0, -1.0]
    );
}

#[test]
fn instances_are_placed_and_named() {
    let text = "*Part, name=Cube
*Node
1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0
5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1
*Element, type=C3D8
1, 1, 2, 3, 4, 5, 6, 7, 8
*Elset, elset=Set-1
1
*Nset, nset=Corner
1
*Surface, type=ELEMENT, name=Floor
Set-1, S1
*End Part
*Assembly, name=Assembly
*Instance, name=Cube-1, part=Cube
*End Instance
*Instance, name=Cube-2, part=CUBE
0., 0., 3.
0., 0., 3., 0., 1., 3., 90.
*End Instance
*Node
1, 7, 7, 7
*Nset, nset=Reference
1
*Nset, nset=Tips, instance=Cube-2
7, 8
*Elset, elset=_Roof_S2, internal, instance=Cube-1
1
*Surface, type=ELEMENT, name=Roof
_Roof_S2, S2
Cube-2.Set-1, S2
*Nset, nset=Two
Cube-1.1, Cube-2.Corner
*End Assembly
";
    let file = deck(text);
    assert_eq!(
        file.group_names(3),
        ["Cube-1", "Cube-2", "Set-1", "_Roof_S2"]
    );
    assert_eq!(file.group("Two", 0).unwrap().nodes, [0, 8]);
    assert_eq!(file.points[16], [7.0; 3]);
    let first = solid(&file, Some("Cube-1"));
    let second = solid(&file, Some("Cube-2"));
    assert_eq!(first.points[6], [1.0, 1.0, 1.0]);
    // Moved up by 3, then turned about y through (0, 0, 3): (x, y, 3 + z) → (z, y, 3 − x).
    assert_eq!(second.points[6], [1.0, 1.0, 2.0]);
    assert_eq!(second.points[1], [0.0, 0.0, 2.0]);
    assert_eq!(second.node_sets["Tips"], [6, 7]);
    assert_eq!(area(&first, "Floor"), [0.0, 0.0, -1.0]);
    assert_eq!(area(&second, "Floor"), [-1.0, 0.0, 0.0]);
    assert_eq!(area(&first, "Roof"), [0.0, 0.0, 1.0]);
    assert_eq!(area(&second, "Roof"), [1.0, 0.0, 0.0]);
    // Without an assembly every part is there once.
    let alone = deck(text.split("*Assembly").next().unwrap());
    assert_eq!(alone.group_names(3), ["Cube", "Set-1"]);
}

#[test]
fn plane_decks_have_sides_for_surfaces() {
    let file = deck(
        "*NODE\n1, 0, 0\n2, 2, 0\n3, 2, 1\n4, 0, 1\n5, 3, 0\n*ELEMENT, TYPE=CPE4, ELSET=Plate\n1, 1, 2, 3, 4\n\
         *ELEMENT, TYPE=CPE3, ELSET=Plate\n2, 2, 5, 3\n*SURFACE, NAME=low\nPlate, S1\n*SURFACE, NAME=out\nPlate,\n",
    );
    let plate = body(&file, Space::Plane, None).mesh;
    assert_eq!(area(&plate, "low"), [0.0, -3.0, 0.0]);
    assert_eq!(plate.face_sets["out"].len(), 5);
    assert!((plate.volume() - 2.5).abs() < 1e-15);
}

#[test]
fn what_a_deck_cannot_mean_is_refused_with_its_line() {
    let with = |from: &str, to: &str| {
        assert!(TOWER.contains(from), "{from}");
        refused("deck.inp", &TOWER.replacen(from, to, 1))
    };
    for (error, expected) in [
        (
            with(
                "*ELSET, ELSET=Both",
                "*INCLUDE, INPUT=more.inp\n*ELSET, ELSET=Both",
            ),
            "deck.inp:23: the keyword `*INCLUDE` is not supported",
        ),
        (
            with("*ELSET, ELSET=Both", "*NGEN\n1, 2\n*ELSET, ELSET=Both"),
            "deck.inp:23: the keyword `*NGEN` is not supported",
        ),
        (
            with("*NODE, NSET=ALL", "*NODE, SYSTEM=C"),
            "deck.inp:4: `SYSTEM=C` is not supported",
        ),
        (
            with("TYPE=C3D8R", "TYPE=C3D15"),
            "deck.inp:19: element 1 is of the type C3D15, which is not supported",
        ),
        (
            with("TYPE=C3D8R,", ""),
            "deck.inp:18: expected the parameter `TYPE=…` of `*ELEMENT`, found none",
        ),
        (
            with("   6, 7, 8", "   6, 7"),
            "deck.inp:19: expected 8 nodes of element 1 (C3D8R), found 7",
        ),
        (
            with("   6, 7, 8", "   6, 7, 80"),
            "deck.inp:20: element 1 refers to node 80, which the file does not have",
        ),
        (
            with("3, 1, 1., 0", "3, 1, one, 0"),
            "deck.inp:7: expected a coordinate, found `one`",
        ),
        (
            with("3, 1, 1., 0", "3, 1, NaN, 0"),
            "deck.inp:7: node 3 has a coordinate that is no finite number: [1.0, NaN, 0.0]",
        ),
        (
            with("12, 0, 1, 2", "11, 0, 1, 2"),
            "deck.inp:16: there are two nodes with the number 11",
        ),
        (
            with("101, 5,", "1, 5,"),
            "deck.inp:22: there are two elements with the number 1",
        ),
        (
            with("LOWER, upper", "LOWER, uper"),
            "deck.inp:24: expected a number or the name of a set of elements, found `uper`, which is not the name of such a set",
        ),
        (
            with("1, 3,\n5", "1, 3,\n55"),
            "deck.inp:31: expected the number of a node, found 55, which no node has",
        ),
        (
            with("1, 200, 100", "1, 200, 0"),
            "deck.inp:26: expected first, last and increment (1 or more), found `1, 200, 0`",
        ),
        (
            with("Lower, S1", "Lower, S7"),
            "deck.inp:34: expected a side of a hex8, S1 to S6, found `S7`",
        ),
    ] {
        assert_eq!(error.to_string(), expected);
    }
    let error = with("LOWER, upper", "LOWER, uper");
    let help = error.help().map(|help| help.to_string());
    assert_eq!(help.as_deref(), Some("did you mean `UPPER`?"));
}

/// Single characters changed, single lines left out: an error or another mesh, but no panic.
#[test]
fn damaged_decks_do_no_harm() {
    let mut bytes = TOWER.as_bytes().to_vec();
    for at in 0..bytes.len() {
        let old = bytes[at];
        for new in [b',', b'*', b'=', b'\n', b'9', b'.', 0xff] {
            bytes[at] = new;
            let _ = parse("damaged.inp", &bytes);
        }
        bytes[at] = old;
    }
    let lines: Vec<&str> = TOWER.lines().collect();
    for left_out in 0..lines.len() {
        let rest = lines.iter().enumerate().filter(|(i, _)| *i != left_out);
        let text: Vec<&str> = rest.map(|(_, line)| *line).collect();
        let _ = parse("damaged.inp", text.join("\n").as_bytes());
    }
}
