//! Automatic pairing.

use tresca_contact::{ContactError, facing_surfaces};
use tresca_fem::mesh::CellKind;

use super::flat::KINDS;
use super::support::{block, boundary_where};

#[test]
fn only_what_faces_each_other_is_found() {
    for kind in KINDS {
        // A slab over a wider one, 0.1 apart.
        let upper = block(kind, [0.5, 0.25, 0.1], [1.5, 0.75, 1.0], [2, 2, 1]);
        let lower = block(CellKind::Hex8, [0.0, 0.0, -1.0], [2.0, 1.0, 0.0], [4, 4, 1]);
        let (a, b) = facing_surfaces(&upper, &lower, 0.11).unwrap();
        assert_eq!(a, boundary_where(&upper, |[_, _, z]| z == 0.1));
        let inner = |[x, y, z]: [f64; 3]| {
            z == 0.0 && (0.5..=1.5).contains(&x) && (0.25..=0.75).contains(&y)
        };
        assert_eq!(b, boundary_where(&lower, inner));
        // The other way round it is the same.
        let (b, a) = facing_surfaces(&lower, &upper, 0.11).unwrap();
        assert_eq!(a, boundary_where(&upper, |[_, _, z]| z == 0.1));
        assert_eq!(b, boundary_where(&lower, inner));
        let (a, b) = facing_surfaces(&upper, &lower, 0.09).unwrap();
        assert!(a.is_empty() && b.is_empty());
    }
    let mesh = block(CellKind::Hex8, [0.0; 3], [1.0; 3], [1; 3]);
    for distance in [0.0, f64::NAN] {
        let error = facing_surfaces(&mesh, &mesh, distance).unwrap_err();
        assert!(matches!(error, ContactError::Search { .. }));
    }
}

/// Two thin sheets, one on the other: the upper side of the upper one does not see the lower side of the
/// lower one. Where they overlap a little they still see each other.
#[test]
fn nothing_is_seen_through_a_thin_body() {
    for overlap in [0.0, 0.01] {
        let upper = block(CellKind::Hex8, [0.0; 3], [1.0, 1.0, 0.05], [3, 3, 1]);
        let (low, high) = ([0.0, 0.0, -0.05], [1.0, 1.0, overlap]);
        let lower = block(CellKind::Hex8, low, high, [4, 4, 1]);
        let (a, b) = facing_surfaces(&upper, &lower, 0.3).unwrap();
        assert_eq!(a, boundary_where(&upper, |[_, _, z]| z == 0.0));
        assert_eq!(b, boundary_where(&lower, |[_, _, z]| z == overlap));
    }
}
