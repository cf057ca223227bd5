//! `tresca check`: a case file in, what was understood out.

use std::path::Path;

use miette::{IntoDiagnostic, Report};
use tresca::case::Case;
use tresca::output::Destination;
use tresca::{Check, check};

use crate::args::{CheckArguments, run_name};

pub fn run(arguments: &CheckArguments) -> miette::Result<u8> {
    let case = Case::load(&arguments.case)?;
    let name = run_name(&arguments.case)?;
    let mut checked =
        check(&case.model).map_err(|error| Report::new(tresca::case::locate(&case, &error)))?;
    checked.warnings.splice(0..0, case.notes());
    print(&checked);
    if !arguments.dry {
        let directory = match &arguments.out {
            Some(directory) => directory.clone(),
            None => Path::new("out").join(format!("{name}-check")),
        };
        Destination::new(&directory)
            .and_then(|destination| destination.write_check(&name, &case.model, &checked))
            .into_diagnostic()?;
        println!("grids in {}", directory.display());
    }
    Ok(crate::SUCCESS)
}

fn print(check: &Check) {
    println!("tresca {} · {}", check.version, check.title);
    for body in &check.bodies {
        let cells: Vec<String> = body
            .cells
            .iter()
            .map(|(kind, count)| format!("{count} {kind}"))
            .collect();
        println!("\nbody {}", body.name);
        println!("    {} nodes, {}", body.nodes, cells.join(", "));
        let mass = match body.mass {
            Some(mass) => format!("{mass:.6e}"),
            None => "no density given".to_owned(),
        };
        println!("    volume {:.6e}, mass {mass}", body.volume);
        let [least, largest] = body.extent;
        println!("    from {} to {}", vector(least), vector(largest));
        for (name, faces, area) in &body.surfaces {
            println!("    surface {name:<20} {faces:>7} faces, area {area:.6e}");
        }
        for (name, nodes) in &body.node_sets {
            println!("    nodes   {name:<20} {nodes:>7}");
        }
        match body.motions.as_slice() {
            [] => println!("    held by its supports"),
            motions => println!("    supports leave free: {}", motions.join(", ")),
        }
    }
    println!("\nsupports");
    for support in &check.supports {
        let held = support.components.iter();
        let held: Vec<String> = held
            .map(|(axis, value)| format!("{axis} = {value}"))
            .collect();
        println!(
            "    {}{}: {} ({} nodes)",
            label(support.name.as_deref()),
            support.on.join(", "),
            held.join(", "),
            support.nodes
        );
    }
    println!("\nloads (resultant force; moment about the origin)");
    for load in &check.loads {
        println!(
            "    {}{} on {}: {}; {}",
            label(load.name.as_deref()),
            load.kind,
            load.on.join(", "),
            vector(load.force),
            vector(load.moment)
        );
    }
    println!("\ncontacts");
    for contact in &check.contacts {
        println!(
            "    {} – {}: {}, {}, {} pairs, area {:.6e}{}",
            contact.slave,
            contact.master,
            contact.friction,
            contact.coupling,
            contact.pairs,
            contact.area,
            contact.gap.map_or_else(String::new, |[least, largest]| {
                format!(", gap {least:.4e} to {largest:.4e}")
            })
        );
    }
    if check.steps > 1 {
        println!(
            "\n{} load steps; figures above are those of the model itself",
            check.steps
        );
    }
    if !check.warnings.is_empty() {
        println!("\nwarnings");
        for warning in &check.warnings {
            println!("    {warning}");
        }
    }
}

fn label(name: Option<&str>) -> String {
    name.map_or_else(String::new, |name| format!("{name}: "))
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!("({x:.5e}, {y:.5e}, {z:.5e})")
}
