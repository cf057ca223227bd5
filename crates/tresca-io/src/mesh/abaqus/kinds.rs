//! Element types of Abaqus and CalculiX.

use tresca_fem::mesh::CellKind;

use super::super::order::from_abaqus;

/// Families of types: the letters, then the kinds by number of nodes.
const FAMILIES: [(&str, &[(u32, CellKind)]); 16] = [
    ("C3D", &SOLIDS),
    ("CPE", &SURFACES),
    ("CPS", &SURFACES),
    ("CAX", &SURFACES),
    ("SFM3D", &SURFACES),
    ("M3D", &SURFACES),
    ("R3D", &SURFACES),
    ("STRI", &[(3, CellKind::Tri3), (65, CellKind::Tri6)]),
    ("S", &SURFACES),
    ("T2D", &LINES),
    ("T3D", &LINES),
    ("B2", &BEAMS),
    ("B3", &BEAMS),
    ("R2D", &LINES),
    ("RAX", &LINES),
    ("SAX", &[(1, CellKind::Line2), (2, CellKind::Line3)]),
];

const SOLIDS: [(u32, CellKind); 5] = [
    (4, CellKind::Tet4),
    (6, CellKind::Wedge6),
    (8, CellKind::Hex8),
    (10, CellKind::Tet10),
    (20, CellKind::Hex20),
];

const SURFACES: [(u32, CellKind); 5] = [
    (3, CellKind::Tri3),
    (4, CellKind::Quad4),
    (6, CellKind::Tri6),
    (8, CellKind::Quad8),
    (9, CellKind::Quad9),
];

const LINES: [(u32, CellKind); 2] = [(2, CellKind::Line2), (3, CellKind::Line3)];

/// Of beams the number is the order.
const BEAMS: [(u32, CellKind); 2] = [(1, CellKind::Line2), (2, CellKind::Line3)];

/// Letters behind the number that change the formulation but not the nodes: reduced integration,
/// hybrid, incompatible modes, modified, with five dofs per node, small strain, and so on.
const MODIFIERS: [char; 9] = ['R', 'H', 'I', 'M', 'S', 'W', 'L', 'T', '5'];

/// The kind of an element type, which is given in any case.
pub(super) fn kind(name: &str) -> Option<CellKind> {
    let name = name.to_ascii_uppercase();
    FAMILIES.iter().find_map(|(family, kinds)| {
        let rest = name.strip_prefix(family)?;
        let end = rest
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(rest.len());
        let (digits, modifiers) = rest.split_at(end);
        if !modifiers.chars().all(|c| MODIFIERS.contains(&c)) {
            return None;
        }
        let number: u32 = digits.parse().ok()?;
        let found = kinds.iter().find(|(known, _)| *known == number)?;
        Some(found.1)
    })
}

/// The corners of the faces of an element, by the number of the face from 1 (`S1`, `S2`, …) and of
/// the node from 0. Source: Abaqus Elements Guide, "Node ordering and face numbering on elements".
pub(super) fn faces(kind: CellKind) -> &'static [&'static [usize]] {
    match kind {
        CellKind::Tet4 | CellKind::Tet10 => &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]],
        CellKind::Wedge6 => &[
            &[0, 1, 2],
            &[3, 5, 4],
            &[0, 3, 4, 1],
            &[1, 4, 5, 2],
            &[2, 5, 3, 0],
        ],
        CellKind::Hex8 | CellKind::Hex20 | CellKind::Hex27 => &[
            &[0, 1, 2, 3],
            &[4, 7, 6, 5],
            &[0, 4, 5, 1],
            &[1, 5, 6, 2],
            &[2, 6, 7, 3],
            &[3, 7, 4, 0],
        ],
        CellKind::Tri3 | CellKind::Tri6 => &[&[0, 1], &[1, 2], &[2, 0]],
        CellKind::Quad4 | CellKind::Quad8 | CellKind::Quad9 => {
            &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]]
        }
        CellKind::Line2 | CellKind::Line3 => &[],
    }
}

/// The number of our face with the same corners.
pub(super) fn local_face(kind: CellKind, face: usize) -> Option<usize> {
    // Their nodes of the face in our numbering; only corners matter.
    let place = |theirs: usize| match from_abaqus(kind) {
        Some(order) => order.iter().position(|&from| from == theirs),
        None => Some(theirs),
    };
    let theirs = faces(kind).get(face.checked_sub(1)?)?;
    let ours: Option<Vec<usize>> = theirs.iter().map(|&node| place(node)).collect();
    let wanted = sorted(&ours?);
    kind.faces().iter().position(|own| {
        let corners = own.kind.corner_count();
        sorted(&own.nodes[..corners]) == wanted
    })
}

fn sorted(nodes: &[usize]) -> Vec<usize> {
    let mut nodes = nodes.to_vec();
    nodes.sort_unstable();
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_known_with_their_modifiers() {
        for (name, kind) in [
            ("C3D4", CellKind::Tet4),
            ("c3d8r", CellKind::Hex8),
            ("C3D8I", CellKind::Hex8),
            ("C3D8IH", CellKind::Hex8),
            ("C3D10MH", CellKind::Tet10),
            ("C3D20R", CellKind::Hex20),
            ("C3D6", CellKind::Wedge6),
            ("CPE4R", CellKind::Quad4),
            ("CPS6M", CellKind::Tri6),
            ("CAX8RH", CellKind::Quad8),
            ("S3", CellKind::Tri3),
            ("S4R5", CellKind::Quad4),
            ("S9R5", CellKind::Quad9),
            ("STRI65", CellKind::Tri6),
            ("SFM3D4R", CellKind::Quad4),
            ("R3D3", CellKind::Tri3),
            ("T3D2", CellKind::Line2),
            ("B32", CellKind::Line3),
        ] {
            assert_eq!(super::kind(name), Some(kind), "{name}");
        }
        for name in [
            "C3D15", "C3D5", "C3D8P", "DC3D8", "CPEG4", "SPRINGA", "MASS", "", "S", "U1",
        ] {
            assert_eq!(super::kind(name), None, "{name}");
        }
    }

    #[test]
    fn every_face_of_theirs_is_one_of_ours() {
        for kind in CellKind::ALL {
            let count = faces(kind).len();
            let mut own: Vec<usize> = (1..=count).filter_map(|f| local_face(kind, f)).collect();
            own.sort_unstable();
            assert_eq!(own, (0..count).collect::<Vec<_>>(), "{kind}");
            assert_eq!(local_face(kind, 0), None);
            assert_eq!(local_face(kind, count + 1), None);
        }
    }
}
