//! `tresca bench campaign`: random problems, each answer judged by an independent oracle.

use std::time::{Instant, SystemTime, UNIX_EPOCH};

use miette::{IntoDiagnostic, WrapErr, miette};
use tresca_bench::campaign::kept::Kept;
use tresca_bench::campaign::kinds::KINDS;
use tresca_bench::campaign::problem::{Drawn, Form};
use tresca_bench::campaign::table::Table;
use tresca_bench::campaign::{Judged, Ticket, kind, run as judge, tickets};

use crate::args::{CampaignArguments, use_threads};
use crate::terminal::format::{grouped, seconds};
use crate::terminal::monitor::row_of;

pub fn run(arguments: &CampaignArguments) -> miette::Result<bool> {
    use_threads(arguments.threads)?;
    if arguments.kinds {
        for kind in KINDS {
            println!("{:<22} {}", kind.name, kind.about);
        }
        return Ok(true);
    }
    let kinds = arguments
        .kind
        .iter()
        .map(|name| {
            kind(name).ok_or_else(|| miette!("there is no kind `{name}`; `--kinds` lists them"))
        })
        .collect::<miette::Result<Vec<_>>>()?;
    if let Some(seed) = arguments.only {
        let [kind] = kinds[..] else {
            return Err(miette!("`--only` needs one kind"));
        };
        return Ok(alone(&Ticket {
            kind,
            number: 0,
            seed,
        }));
    }
    let kinds = if kinds.is_empty() {
        KINDS.iter().collect()
    } else {
        kinds
    };
    let seed = if arguments.fresh {
        let now = SystemTime::now().duration_since(UNIX_EPOCH);
        now.into_diagnostic()?.as_nanos() as u64
    } else {
        arguments.seed
    };
    let list = tickets(arguments.problems, seed, &kinds);
    println!("{} problems with seed {seed}", grouped(list.len()));
    let begin = Instant::now();
    let judged = judge(&list, |judged| {
        if judged.judgement.verdict.is_reported() && !arguments.quiet {
            println!("{}", line(judged));
        }
    });
    let time = begin.elapsed().as_secs_f64();
    if std::env::var_os("TRESCA_WRITE_COUNTS").is_some() {
        let text = toml::to_string(&Kept::of(seed, &judged)).into_diagnostic()?;
        let path = "crates/tresca-bench/campaign.toml";
        let head = "# Written by `TRESCA_WRITE_COUNTS=1 tresca bench campaign` at the root.";
        std::fs::write(path, format!("{head}\n\n{text}"))
            .into_diagnostic()
            .wrap_err("cannot write campaign.toml")?;
    }
    let kept = Kept::stored().into_diagnostic()?;
    let table = Table::new(&judged, (kept.seed == seed).then_some(&kept));
    println!();
    print!(
        "{}",
        if arguments.markdown {
            table.markdown()
        } else {
            table.text()
        }
    );
    println!(
        "\nWRONG: the oracle disagrees; unseen: and the certificate is clean. alarm: the oracle agrees, the"
    );
    println!(
        "certificate is above 1e-4. gave up: a method without a guarantee says so. neither: no solution known."
    );
    println!(
        "worst: of right answers, the difference of energies (Coulomb: of the conditions), relative. n_A: of"
    );
    println!(
        "right answers that converged. kept → now: medians over the problems that were right then and now."
    );
    let faults = table.faults();
    for fault in &faults {
        println!("FAULT: {fault}");
    }
    println!("{}", seconds(time));
    Ok(faults.is_empty())
}

fn line(judged: &Judged) -> String {
    let ticket = &judged.ticket;
    format!(
        "{}: {}, {} (certificate {:.0e}); oracle: {} | tresca bench campaign --kind {} --only {}",
        judged.judgement.verdict.name(),
        ticket.kind.name,
        judged.end.name(),
        judged.certificate,
        judged.judgement.oracle,
        ticket.kind.name,
        ticket.seed
    )
}

/// One problem, with its iterations.
fn alone(ticket: &Ticket) -> bool {
    let (drawn, answer, judged) = ticket.run();
    describe(&drawn);
    println!("\n{}", row_of(None));
    for record in &answer.records {
        println!("{}", row_of(Some(record)));
    }
    println!("\nforces {:?}", answer.forces);
    println!("displacements {:?}", answer.displacement);
    println!("\n{}, ended {:?}", line(&judged), judged.end);
    !judged.judgement.verdict.is_wrong()
}

fn describe(drawn: &Drawn) {
    let Drawn {
        truth,
        form,
        units,
        settings,
        ..
    } = drawn;
    println!(
        "{} dofs in {} bodies, {} pairs with {} tangents, {} form, {}",
        truth.dofs(),
        truth.stiffness.len(),
        truth.pairs(),
        truth.tangents,
        match form {
            Form::Primal => "primal",
            Form::Dual => "dual",
        },
        settings.method
    );
    println!(
        "units, as powers of two: K {}, length {}, rows {:?}",
        units.stiffness, units.length, units.rows
    );
    println!("laws {:?}\ngaps {:?}", truth.laws, truth.gap);
    if truth.dofs() <= 6 {
        println!(
            "K {:?}\nN {:?}\nT {:?}\nf {:?}",
            truth.stiffness, truth.normal, truth.tangential, truth.load
        );
    }
}
