//! Two dimensions: plane strain against a slice of space, finite termination.

use super::support::{report, settings, solved, solved_with, variant};
use tresca::{InnerSolver, Method};

/// A slice of the two bricks, one element thick and held across, is the plane-strain problem.
#[test]
fn plane_strain_is_a_slice_of_space() {
    let plane = variant(
        "two-rectangles.toml",
        &[
            ("nodes = [65, 33], cells = \"triangle\"", "nodes = [17, 9]"),
            ("nodes = [65, 33]", "nodes = [17, 9]"),
        ],
    );
    let slice = variant(
        "two-bricks.toml",
        &[
            (
                "min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16]",
                "min = [0.0, 0.0, 1.0], max = [2.0, 0.1, 2.0], nodes = [17, 2, 9]",
            ),
            (
                "min = [0.0, 0.0, 0.0], max = [2.0, 1.0, 1.0], nodes = [16, 16, 16]",
                "min = [0.0, 0.0, 0.0], max = [2.0, 0.1, 1.0], nodes = [17, 2, 9]",
            ),
            (
                "[[traction]]",
                "[[support]]\non = [\"upper.y-\", \"upper.y+\", \"lower.y-\", \"lower.y+\"]\ny = 0.0\n\n[[traction]]",
            ),
        ],
    );
    let (plane, slice) = (solved(&plane), solved(&slice));
    let (plane, slice) = (plane.last(), slice.last());
    // Slice forces are those of its thickness 0.1, shared by two rows of pairs.
    for pair in slice.pairs() {
        let x = pair.pair.point[0];
        let same = plane
            .pairs()
            .find(|other| (other.pair.point[0] - x).abs() < 1e-9)
            .unwrap();
        let scale = 0.05;
        assert!((pair.normal_force - scale * same.normal_force).abs() < 1e-7 * scale);
        assert!((pair.friction_force[0] - scale * same.friction_force[0]).abs() < 1e-7 * scale);
        assert!((pair.local_slip[0] - same.local_slip[0]).abs() < 1e-9);
        assert_eq!((pair.closed, pair.stick), (same.closed, same.stick));
    }
}

/// With intervals only there is no curvature: once the active set is right, one step is exact. From then
/// on the residual is rounding, whatever the tolerance.
#[test]
fn the_exact_method_stops_after_finitely_many_steps() {
    let case = variant("two-rectangles.toml", &[]);
    for method in [Method::Grssn, Method::Mssn] {
        let exact = settings(&case, |settings| {
            settings.method = method;
            settings.engine = tresca::Engine::Explicit;
            settings.inner_solver = InnerSolver::Direct;
            settings.tolerance = 1e-12;
        });
        let outcome = solved_with(&case, &exact);
        let records = &outcome.last().solution.records;
        assert!(records.len() < 20, "{method}: {} steps", records.len());
        let [.., before, last] = &records[..] else {
            panic!("{method}: too few steps")
        };
        report(&format!(
            "finite termination, {method}: {} steps, the last from {:.1e} to {:.1e}",
            records.len() - 1,
            before.relative_reduced_gradient,
            last.relative_reduced_gradient
        ));
        assert!(
            last.relative_reduced_gradient < 1e-12 && before.relative_reduced_gradient > 1e-6,
            "{method}: {:e} then {:e}",
            before.relative_reduced_gradient,
            last.relative_reduced_gradient
        );
        assert_eq!(
            last.set_changes, 0,
            "{method}: the set was right before the last step"
        );
    }
}

/// Plane stress is softer than plane strain, by the ratio of the moduli where nothing else matters.
#[test]
fn plane_stress_is_softer() {
    let strain = solved(&variant("two-rectangles.toml", &[]));
    let stress = solved(&variant(
        "two-rectangles.toml",
        &[("plane_strain", "plane_stress")],
    ));
    let energy = |outcome: &tresca::Outcome| -outcome.last().solution.figures.objective;
    assert!(energy(&stress) > 1.02 * energy(&strain));
}
