//! Whatever stands in a file: it is read or refused, never a panic, and every report can be shown.

use proptest::prelude::*;

use crate::support::{GOOD, OBSTACLES, PLANE, RICH, parse, render};

fn survives(text: &str) {
    if let Err(error) = parse(text) {
        assert!(!render(&error).is_empty());
        let (line, column) = error.line_column().unwrap();
        assert!(line >= 1 && line <= text.lines().count() + 1 && column >= 1);
    }
}

/// Bits of text that mean something in a case file.
fn scrap() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::sample::select(vec![
            "[",
            "]",
            "{",
            "}",
            "\"",
            "'",
            "\"\"\"",
            "=",
            ",",
            ".",
            "\n",
            "#",
            "\\",
            "-",
            "nan",
            "inf",
            "-inf",
            "1e400",
            "-0",
            "0x10",
            "9223372036854775807",
            "9223372036854775808",
            "[[body]]",
            "[solver]",
            "[[contact]]",
            "body",
            "brick",
            "x+",
            "upper.x-",
            "ü",
            "\u{feff}",
            "\r",
            "\0",
            "true",
            "1979-05-27",
            "[[",
            "]]",
            "{}",
            "[]",
            "`, expected `",
            "analysis = \"axisymmetric\"",
            "[[support]]",
            "[[step]]",
            "{ file = \"none.csv\" }",
            "\"2*x\"",
            "\"-(z^\"",
            "law = \"coulomb\"",
            "coefficients = [1, 2]",
            "increments = 3",
            "push",
        ])
        .prop_map(str::to_owned),
        any::<char>().prop_map(String::from),
        "[a-z+.-]{1,6}",
    ]
}

fn at(text: &str, place: usize) -> usize {
    let mut place = place % (text.len() + 1);
    while !text.is_char_boundary(place) {
        place -= 1;
    }
    place
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutations_of_a_good_case(
        good in prop::sample::select(vec![GOOD, RICH, PLANE, OBSTACLES]),
        edits in prop::collection::vec((any::<usize>(), 0_usize..12, scrap()), 1..4),
    ) {
        let mut text = good.to_owned();
        for (place, length, scrap) in edits {
            let start = at(&text, place);
            let end = at(&text, start + length.min(text.len() - start)).max(start);
            text.replace_range(start..end, &scrap);
        }
        survives(&text);
    }

    #[test]
    fn exchanged_values(
        good in prop::sample::select(vec![GOOD, RICH, PLANE, OBSTACLES]),
        from in any::<usize>(),
        to in any::<usize>(),
    ) {
        let values: Vec<&str> = good
            .split(['\n', ' ', ',', '[', ']', '{', '}', '='])
            .filter(|word| !word.is_empty())
            .collect();
        let (from, to) = (values[from % values.len()], values[to % values.len()]);
        survives(&good.replacen(from, to, 1));
        survives(&good.replace(from, to));
    }

    #[test]
    fn any_text(text in any::<String>()) {
        survives(&text);
    }
}

#[test]
fn deep_nesting_is_refused() {
    survives(&format!(
        "title = {}{}",
        "[".repeat(100_000),
        "]".repeat(100_000)
    ));
    survives(&"a.".repeat(100_000));
}
