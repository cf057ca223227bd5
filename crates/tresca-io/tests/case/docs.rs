//! The documentation of the keys names those that the reader knows, table by table, and no others.

use std::collections::BTreeSet;

use crate::support::{GOOD, report, with};

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
    for (heading, text) in [
        ("The file", format!("zzz = 1\n{GOOD}")),
        ("`[[body]]`", with("name =", "zzz = 1\nname =")),
        ("`brick`", with("{ min", "{ zzz = 1, min")),
        ("`material`", with("{ young", "{ zzz = 1, young")),
        ("`[[traction]]`", with("value =", "zzz = 1\nvalue =")),
        ("`[[contact]]`", with("pair =", "zzz = 1\npair =")),
        ("`friction`", with("{ law", "{ zzz = 1, law")),
    ] {
        assert_eq!(keys_on_page(heading), keys_in_report(&text), "{heading}");
    }
    // A single key is worded otherwise.
    assert!(report(&with("on = [", "zzz = [")).contains("the only key that belongs here is `on`"));
    assert_eq!(
        keys_on_page("`[[clamp]]`"),
        BTreeSet::from(["on".to_owned()])
    );
}

#[test]
fn the_example_on_the_page_is_the_good_case() {
    let (_, rest) = PAGE.split_once("```toml\n").unwrap();
    let (example, _) = rest.split_once("```").unwrap();
    assert_eq!(example, GOOD);
}
