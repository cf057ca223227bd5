//! `tresca options`: the one list of solver options.

use tresca::Settings;

use crate::args::{Format, OptionsArguments};

pub fn run(arguments: &OptionsArguments) -> miette::Result<u8> {
    match arguments.format {
        Format::Text => {
            for option in Settings::options() {
                println!("{} = {}", option.name, option.default);
                println!("    {}", option.doc);
                println!("    allowed: {}\n", option.allowed);
            }
        }
        Format::Markdown => print!("{}", markdown()),
    }
    Ok(crate::SUCCESS)
}

/// The table of `docs/options.md`.
fn markdown() -> String {
    let mut text = String::from("| option | default | allowed | meaning |\n|---|---|---|---|\n");
    for option in Settings::options() {
        let allowed = option.allowed.replace('|', "\\|");
        text += &format!(
            "| `{}` | `{}` | {allowed} | {} |\n",
            option.name, option.default, option.doc
        );
    }
    text
}
