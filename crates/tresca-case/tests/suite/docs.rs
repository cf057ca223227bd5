//! The documentation of the keys names those that the reader knows, table by table, and no others.

use std::collections::BTreeSet;

use tresca_case::Case;
use tresca_case::expression::Expression;
use tresca_contact::FrictionLaw;

use crate::support::{GOOD, OBSTACLES, PLANE, RICH, Solver, changed, render, report, with};

const PAGE: &str = include_str!("../../../../docs/case-file.md");

/// The keys that the reader lists when it meets one it does not know.
fn keys_in_report(text: &str) -> BTreeSet<String> {
    let report = report(text);
    let (_, list) = report.split_once("belong here are").expect(&report);
    list.split('`')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect()
}

/// The first column of the table under a heading.
fn keys_on_page(heading: &str) -> BTreeSet<String> {
    let (_, section) = PAGE.split_once(&format!("## {heading}\n")).expect(heading);
    let section = section.split("\n## ").next().unwrap();
    section
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split_once('`'))
        .map(|(key, _)| key.to_owned())
        .collect()
}

#[test]
fn every_key_is_documented_and_every_documented_key_exists() {
    let rich = |from, to| changed(RICH, from, to);
    let plane = |from, to| changed(PLANE, from, to);
    let touching = |from, to| changed(OBSTACLES, from, to);
    for (heading, text) in [
        ("The file", format!("zzz = 1\n{GOOD}")),
        ("`[[body]]`", with("name =", "zzz = 1\nname =")),
        ("`mesh`", with("{ brick =", "{ zzz = 1, brick =")),
        (
            "`rotate`",
            touching("{ axis = [0, 0, 1], a", "{ zzz = 1, a"),
        ),
        ("`brick`", with("{ min", "{ zzz = 1, min")),
        ("`rectangle`", plane("{ min", "{ zzz = 1, min")),
        ("`material`", with("{ young", "{ zzz = 1, young")),
        ("`[[support]]`", rich("[[support]]", "[[support]]\nzzz = 1")),
        ("`[[traction]]`", with("value =", "zzz = 1\nvalue =")),
        (
            "`[[pressure]]`",
            rich("[[pressure]]", "[[pressure]]\nzzz = 1"),
        ),
        (
            "`[[body_force]]`",
            rich("[[body_force]]", "[[body_force]]\nzzz = 1"),
        ),
        ("`[[gravity]]`", rich("[[gravity]]", "[[gravity]]\nzzz = 1")),
        ("`[[force]]`", rich("[[gravity]]", "[[force]]\nzzz = 1")),
        (
            "`[[obstacle]]`",
            touching("[[obstacle]]", "[[obstacle]]\nzzz = 1"),
        ),
        ("`sphere`", touching("sphere = {", "sphere = { zzz = 1,")),
        (
            "`cylinder`",
            touching("cylinder = {", "cylinder = { zzz = 1,"),
        ),
        ("`circle`", touching("sphere = {", "circle = { zzz = 1,")),
        ("`surface`", touching("surface = {", "surface = { zzz = 1,")),
        ("`[[contact]]`", with("pair =", "zzz = 1\npair =")),
        ("`friction`", with("{ law", "{ zzz = 1, law")),
        ("`plane`", touching("plane = {", "plane = { zzz = 1,")),
        ("`[[step]]`", rich("[[step]]", "[[step]]\nzzz = 1")),
    ] {
        assert_eq!(keys_on_page(heading), keys_in_report(&text), "{heading}");
    }
    // A single key is worded otherwise.
    for (heading, key, text) in [
        ("`[[clamp]]`", "on", with("on = [", "zzz = [")),
        (
            "`{ file = … }`",
            "file",
            with("0.09", "{ zzz = \"bounds.csv\" }"),
        ),
    ] {
        let only = format!("the only key that belongs here is `{key}`");
        assert!(report(&text).contains(&only), "{heading}");
        assert_eq!(keys_on_page(heading), BTreeSet::from([key.to_owned()]));
    }
}

/// In the list of laws, and among the words at the key `law`.
#[test]
fn every_law_is_documented() {
    let (_, section) = PAGE.split_once("## `friction`\n").unwrap();
    let (section, _) = section.split_once("\n## ").unwrap();
    let listed: Vec<&str> = section
        .lines()
        .filter_map(|line| line.strip_prefix("- `")?.split('`').next())
        .collect();
    assert_eq!(listed, FrictionLaw::NAMES);
    let (_, words) = section.split_once("| `law` | text | required | ").unwrap();
    let words = words.lines().next().unwrap();
    assert_eq!(
        words.split('`').skip(1).step_by(2).collect::<Vec<_>>(),
        FrictionLaw::NAMES
    );
}

#[test]
fn every_function_and_constant_is_documented() {
    let (_, section) = PAGE.split_once("## Fields\n").unwrap();
    let (section, _) = section.split_once("\n## ").unwrap();
    let error = Expression::parse("nothing").unwrap_err();
    let (_, known) = error.help.split_once("known are ").unwrap();
    for name in known.split('`').skip(1).step_by(2) {
        let alone = section.contains(&format!("`{name}`"));
        assert!(
            alone || section.contains(&format!("`{name}(")) || ["x", "y", "z"].contains(&name),
            "{name}"
        );
    }
}

#[test]
fn the_example_on_the_page_is_the_good_case() {
    let (_, rest) = PAGE.split_once("```toml\n").unwrap();
    let (example, _) = rest.split_once("```").unwrap();
    assert_eq!(example, GOOD);
}

#[test]
fn every_other_example_is_read() {
    let bodies = RICH.split("[[support]]").next().unwrap();
    let bodies = bodies.replace("poisson = 0.35", "poisson = 0.35, density = 1");
    let examples: Vec<&str> = PAGE
        .split("```toml\n")
        .skip(2)
        .map(|rest| rest.split("```").next().unwrap())
        .collect();
    assert_eq!(examples.len(), 15);
    for example in examples {
        let text = match example.contains("[[body]]") {
            true => example.to_owned(),
            false => format!("{bodies}\n{example}"),
        };
        // Beside the page, where its relative paths start.
        let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/case.toml");
        if let Err(error) = Case::<Solver>::parse_with(page, &text) {
            panic!("{}", render(&error));
        }
    }
}

/// What the TOML parser says is shown, never interpreted: a release of it with other words must not blunt any report.
#[test]
fn no_report_depends_on_the_words_of_the_parser() {
    fn texts(directory: &std::path::Path, found: &mut Vec<String>) {
        for entry in std::fs::read_dir(directory).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => texts(&path, found),
                false => found.push(std::fs::read_to_string(path).unwrap()),
            }
        }
    }
    let mut sources = Vec::new();
    texts(
        &std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        &mut sources,
    );
    let count = |word: &str| {
        sources
            .iter()
            .map(|text| text.matches(word).count())
            .sum::<usize>()
    };
    // Its errors come from two parses, and one message of theirs becomes a label.
    assert_eq!(count("DeTable::parse("), 4);
    assert_eq!(count(".message()"), 1);
    // Its own deserializer, whose errors are sentences, is not used at all.
    for word in [
        "toml::from_str",
        "toml::Deserializer",
        "into_deserializer()).",
        "toml::Table",
    ] {
        assert_eq!(count(word), 0, "{word}");
    }
}
