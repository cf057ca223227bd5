//! The end of a run on matrices.

use std::path::Path;

use tresca::Status;
use tresca::algebraic::Summary;

use super::format::seconds;

/// Prints the verdict.
pub fn print(summary: &Summary, directory: &Path) {
    println!();
    for note in &summary.notes {
        println!("note: {note}");
    }
    if summary.status == Status::Converged {
        println!(
            "converged: {} in {} iterations, {} multiplications by A ({} of them for σmax)",
            summary.method,
            summary.figures.iterations,
            summary.figures.n_a,
            summary.figures.n_a_setup
        );
    } else {
        println!(
            "NOT CONVERGED ({}): {} after {} iterations, {} multiplications by A; relative reduced \
             gradient {:.2e}, tolerance {:.0e}",
            summary.status,
            summary.method,
            summary.figures.iterations,
            summary.figures.n_a,
            summary.figures.relative_reduced_gradient,
            summary.settings.tolerance
        );
    }
    if summary.status == Status::NoEquilibrium {
        println!(
            "no equilibrium: the load does work on a motion in the kernel of K that nothing resists \
             enough; it is `unresisted_motion` in solution.npz"
        );
    }
    let contact = &summary.contact;
    println!(
        "contact: {} closed, {} open, {} stick, {} slip; Σ normal force {:.6e}, max slip {:.4e}, max gap {:.4e}",
        contact.closed,
        contact.open,
        contact.stick,
        contact.slip,
        contact.normal_force_sum,
        contact.max_slip_component,
        contact.max_gap
    );
    println!("certificate (dimensionless, from u and λ alone):");
    for (name, value) in summary.certificate.items() {
        println!("    {name:<20} {value:>10.2e}");
    }
    let times = &summary.times;
    println!(
        "times: check {}, factorisation {}, solve {} ({} of it in multiplications), recovery {}, total {}",
        seconds(times.check),
        seconds(times.factorization),
        seconds(times.solve),
        seconds(times.multiplications),
        seconds(times.recovery),
        seconds(times.total)
    );
    println!("results in {}", directory.display());
}
