//! The end of a run: verdict, contact in figures, certificate, times.

use std::path::Path;

use tresca::{Status, Summary};

use super::format::{bytes, seconds};

/// Prints the verdict.
pub fn print(summary: &Summary, directory: &Path) {
    println!();
    conclusion(summary);
    if summary.steps.len() > 1 {
        steps(summary);
    }
    let step = summary.last();
    let contact = &step.contact;
    println!(
        "contact: {} closed, {} open, {} stick, {} slip; Σ normal force {:.6e}, max pressure {:.4e}, \
         max slip {:.4e}, max gap {:.4e}, dissipation {:.4e}",
        contact.closed,
        contact.open,
        contact.stick,
        contact.slip,
        contact.normal_force_sum,
        contact.max_pressure,
        contact.max_slip_component,
        contact.max_gap,
        contact.dissipation
    );
    println!("certificate (dimensionless, from u and λ alone):");
    for (name, value) in step.certificate.items() {
        println!("    {name:<20} {value:>10.2e}");
    }
    for body in &step.certificate.bodies {
        println!(
            "    {:<20} force {:.2e}, moment {:.2e}",
            format!("balance of {}", body.name),
            body.force,
            body.moment
        );
    }
    let times = &summary.times;
    print!(
        "times: assembly {}, factorisation {}, solve {} ({} of it in multiplications), recovery {}, output {}, total {}",
        seconds(times.assembly),
        seconds(times.factorization),
        seconds(times.solve),
        seconds(times.multiplications),
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

/// How the run ended, and with a failure why.
fn conclusion(summary: &Summary) {
    let step = summary.last();
    let settings = &summary.settings;
    if summary.status == Status::Converged {
        println!(
            "converged: {} in {} iterations, {} multiplications by A ({} of them for σmax)",
            summary.method, summary.iterations, summary.n_a, summary.n_a_setup
        );
    } else {
        let place = match summary.planned_steps {
            1 => String::new(),
            count => format!(" in load step {} of {count}", step.step),
        };
        println!(
            "NOT CONVERGED ({}){place}: {} after {} iterations, {} multiplications by A; relative \
             reduced gradient {:.2e}, tolerance {:.0e}",
            summary.status,
            summary.method,
            summary.iterations,
            summary.n_a,
            step.figures.relative_reduced_gradient,
            settings.tolerance
        );
    }
    if step.figures.outer_iterations > 0 {
        println!(
            "Coulomb friction: {} updates of the slip bounds, the last changed them by {:.1e} \
             (tolerance {:.0e})",
            step.figures.outer_iterations, step.figures.outer_residual, settings.coulomb_tolerance
        );
    }
    if summary.rigid_motions > 0 {
        println!(
            "floating bodies: {} rigid motions held by contact; residual of their equilibrium {:.1e}",
            summary.rigid_motions, step.figures.equality_residual
        );
    }
    if let Some(motion) = &step.unresisted_motion {
        println!("no equilibrium: the loads do work on a motion that nothing resists enough:");
        for body in &motion.bodies {
            println!("    body `{}`: {}", body.body, body.motion);
        }
        for contact in &motion.contacts {
            println!("    contact {} {}", contact.contact, contact.does);
        }
    }
}

/// One line per load step.
fn steps(summary: &Summary) {
    println!(
        "{:>5} {:>10} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} {:>14} {:>12}  name",
        "step",
        "time",
        "iter",
        "n_A",
        "open",
        "closed",
        "stick",
        "slip",
        "Σ normal force",
        "dissipation"
    );
    for step in &summary.steps {
        let contact = &step.contact;
        println!(
            "{:>5} {:>10.4} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} {:>14.6e} {:>12.4e}  {}",
            step.step,
            step.time,
            step.figures.iterations,
            step.figures.n_a,
            contact.open,
            contact.closed,
            contact.stick,
            contact.slip,
            contact.normal_force_sum,
            contact.dissipation,
            step.name.as_deref().unwrap_or("")
        );
    }
}
