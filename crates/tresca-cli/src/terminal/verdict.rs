//! The end of a run: verdict, contact in figures, certificate, times.

use std::path::Path;

use tresca::{Status, Summary};

use super::format::{bytes, seconds};

/// Prints the verdict.
pub fn print(summary: &Summary, directory: &Path) {
    let tolerance = summary.settings.tolerance;
    println!();
    match summary.status {
        Status::Converged => println!(
            "converged: {} in {} iterations, {} multiplications by A ({} of them for σmax)",
            summary.method, summary.iterations, summary.n_a, summary.n_a_setup
        ),
        status => println!(
            "NOT CONVERGED ({status}): {} after {} iterations, {} multiplications by A; relative \
             reduced gradient {:.2e}, tolerance {tolerance:.0e}",
            summary.method, summary.iterations, summary.n_a, summary.relative_reduced_gradient
        ),
    }
    let contact = &summary.contact;
    println!(
        "contact: {} closed, {} open, {} stick, {} slip; Σ normal force {:.6e}, max pressure {:.4e}, \
         max slip {:.4e}, max gap {:.4e}",
        contact.closed,
        contact.open,
        contact.stick,
        contact.slip,
        contact.normal_force_sum,
        contact.max_pressure,
        contact.max_slip_component,
        contact.max_gap
    );
    println!("certificate (dimensionless, from u and λ alone):");
    for (name, value) in summary.certificate.items() {
        println!("    {name:<20} {value:>10.2e}");
    }
    for body in &summary.certificate.bodies {
        println!(
            "    {:<20} force {:.2e}, moment {:.2e}",
            format!("balance of {}", body.name),
            body.force,
            body.moment
        );
    }
    let times = &summary.times;
    print!(
        "times: assembly {}, factorisation {}, solve {}, recovery {}, output {}, total {}",
        seconds(times.assembly),
        seconds(times.factorization),
        seconds(times.solve),
        seconds(times.recovery),
        seconds(times.output),
        seconds(times.total)
    );
    match summary.peak_memory_bytes {
        Some(peak) => println!("; peak memory {}", bytes(peak)),
        None => println!(),
    }
    println!("results in {}", directory.display());
}
