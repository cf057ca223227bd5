//! The end of a run: verdict, contact in figures, independent checks, times.

use std::path::Path;

use tresca::report::{RunReport, Source, StepReport};
use tresca::{Certificate, Status};

use super::format::{bytes, seconds};

/// Prints the verdict.
pub fn print(report: &RunReport, directory: &Path) {
    println!();
    for note in &report.notes {
        println!("note: {note}");
    }
    conclusion(report);
    if report.steps.len() > 1 {
        steps(report);
    }
    let step = report.last();
    contact(step);
    certificate(&step.certificate);
    distances(step);
    times(report);
    println!("results in {}", directory.display());
}

/// How the run ended, and with a failure why.
fn conclusion(report: &RunReport) {
    let step = report.last();
    let figures = &step.figures;
    let settings = &report.settings;
    let operator = match report.door {
        Source::Fclib => "W",
        _ => "A",
    };
    if report.converged() {
        println!(
            "converged: {} in {} iterations, {} multiplications by {operator} ({} of them for σmax)",
            report.method, report.iterations, report.n_a, report.n_a_setup
        );
    } else {
        let place = match report.planned_steps {
            1 => String::new(),
            count => format!(" in load step {} of {count}", step.step),
        };
        println!(
            "NOT CONVERGED ({}){place}: {} after {} iterations, {} multiplications by {operator}; relative \
             reduced gradient {:.2e}, tolerance {:.0e}",
            report.status,
            report.method,
            report.iterations,
            report.n_a,
            figures.relative_reduced_gradient,
            settings.tolerance
        );
    }
    if figures.outer_iterations > 0 && figures.outer_residual > 0.0 {
        println!(
            "Coulomb friction: {} updates of the slip bounds, the last changed them by {:.1e} \
             (tolerance {:.0e})",
            figures.outer_iterations, figures.outer_residual, settings.coulomb_tolerance
        );
    }
    let floating = report.system.as_ref().map_or(0, |own| own.rigid_motions);
    if floating > 0 {
        println!(
            "floating bodies: {floating} rigid motions held by contact; residual of their equilibrium {:.1e}",
            figures.equality_residual
        );
    }
    if let Some(failure) = &step.failure {
        println!(
            "inaccurate: {} is {:.1e}, and may be {:.0e}; rounding leaves the answer undetermined beyond that",
            failure.item, failure.value, failure.limit
        );
    }
    no_equilibrium(step);
    contradiction(step);
}

fn no_equilibrium(step: &StepReport) {
    if let Some(motion) = &step.unresisted_motion {
        println!("no equilibrium: the loads do work on a motion that nothing resists enough:");
        for body in &motion.bodies {
            println!("    body `{}`: {}", body.body, body.motion);
        }
        for contact in &motion.contacts {
            println!("    contact {} {}", contact.contact, contact.does);
        }
    } else if step.status == Status::NoEquilibrium {
        println!(
            "no equilibrium: the load does work on a motion in the kernel of K that nothing resists \
             enough; it is `unresisted_motion` in solution.npz"
        );
    }
}

/// Pairs that are named one by one.
const NAMED: usize = 8;

fn contradiction(step: &StepReport) {
    let Some(contradiction) = &step.contradiction else {
        return;
    };
    println!(
        "infeasible: these pairs contradict each other by {:.4e}; no displacement satisfies them all:",
        contradiction.by
    );
    for own in contradiction.pairs.iter().take(NAMED) {
        let place = match (&own.contact, own.point) {
            (Some(contact), Some([x, y, z])) => {
                format!(" of {contact} at ({x:.6}, {y:.6}, {z:.6})")
            }
            _ => String::new(),
        };
        let [first, second] = own.tangential;
        println!(
            "    pair {}{place}: share {:.3} (normal), {first:.3}, {second:.3} (tangential)",
            own.pair, own.normal
        );
    }
    if contradiction.pairs.len() > NAMED {
        println!("    and {} more", contradiction.pairs.len() - NAMED);
    }
}

/// One line per load step.
fn steps(report: &RunReport) {
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
    for step in &report.steps {
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
            contact.dissipation.unwrap_or(0.0),
            step.name.as_deref().unwrap_or("")
        );
    }
}

fn contact(step: &StepReport) {
    let contact = &step.contact;
    print!(
        "contact: {} closed ({} stick, {} slip), {} open",
        contact.closed, contact.stick, contact.slip, contact.open
    );
    if contact.open_with_friction > 0 {
        print!(" ({} with friction)", contact.open_with_friction);
    }
    print!("; Σ normal force {:.6e}", contact.normal_force_sum);
    for (name, value) in [
        ("max pressure", contact.max_pressure),
        ("max slip", contact.max_slip_component),
        ("max gap", contact.max_gap),
        ("dissipation", contact.dissipation),
    ] {
        if let Some(value) = value {
            print!(", {name} {value:.4e}");
        }
    }
    println!("; dual objective {:.9e}", step.figures.objective);
}

fn certificate(certificate: &Certificate) {
    println!("certificate (dimensionless, from u and λ alone):");
    for (name, value) in certificate.items() {
        println!("    {name:<20} {value:>10.2e}");
    }
    for body in &certificate.bodies {
        println!(
            "    {:<20} force {:.2e}, moment {:.2e}",
            format!("balance of {}", body.name),
            body.force,
            body.moment
        );
    }
}

/// What problems of FCLIB have beside the certificate.
fn distances(step: &StepReport) {
    if let Some(residuals) = &step.residuals {
        println!("residual of the natural map, from r and u alone:");
        for (name, value) in [
            ("scaled", residuals.scaled),
            ("with symmetric W", residuals.symmetrised),
            ("as Siconos measures", residuals.siconos),
        ] {
            println!("    {name:<20} {value:>10.2e}");
        }
    }
    if let Some(reference) = &step.reference {
        println!(
            "difference to the file's own solution: forces {:.1e}, velocities {:.1e}",
            reference.forces, reference.velocities
        );
    }
}

fn times(report: &RunReport) {
    let times = &report.times;
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
    match report.peak_memory_bytes {
        Some(peak) => println!("; peak memory {}", bytes(peak)),
        None => println!(),
    }
}
