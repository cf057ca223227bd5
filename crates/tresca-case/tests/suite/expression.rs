//! Formulas: their values against Rust's own arithmetic, and the places of their faults.

use std::f64::consts::{E, PI};
use std::fmt::Write;

use insta::assert_snapshot;
use proptest::prelude::*;
use tresca_case::expression::Expression;

const POINT: [f64; 3] = [2.0, 3.0, 0.5];

fn value(text: &str) -> f64 {
    Expression::parse(text)
        .unwrap_or_else(|e| panic!("{text}: {e:?}"))
        .at(POINT)
}

#[test]
fn ranks_are_those_of_mathematics() {
    for (text, expected) in [
        ("-x^2", -4.0),
        ("(-x)^2", 4.0),
        ("2^3^2", 512.0),
        ("2^-x", 0.25),
        ("-2^-x", -0.25),
        ("--x", 2.0),
        ("+x - -y", 5.0),
        ("10 - 4 - 3", 3.0),
        ("12/x/y", 2.0),
        ("12/x*y", 18.0),
        ("1 + x*y", 7.0),
        ("(1 + x)*y", 9.0),
        ("x*-y", -6.0),
        ("2*x^y*z", 8.0),
        ("1e-3", 1e-3),
        ("1.5E+2*x", 300.0),
        (".5 + 5.", 5.5),
        ("2*e", 2.0 * E),
        ("2e", f64::NAN),
    ] {
        if expected.is_nan() {
            assert!(Expression::parse(text).is_err(), "{text}");
        } else {
            assert_eq!(value(text), expected, "{text}");
        }
    }
}

#[test]
fn functions_are_those_of_the_standard_library() {
    let (x, y, z) = (POINT[0], POINT[1], POINT[2]);
    for (text, expected) in [
        ("sin(x)", x.sin()),
        ("cos(x)", x.cos()),
        ("tan(x)", x.tan()),
        ("asin(z)", z.asin()),
        ("acos(z)", z.acos()),
        ("atan(y)", y.atan()),
        ("sinh(x)", x.sinh()),
        ("cosh(x)", x.cosh()),
        ("tanh(x)", x.tanh()),
        ("exp(x)", x.exp()),
        ("ln(x)", x.ln()),
        ("log10(x)", x.log10()),
        ("sqrt(x)", x.sqrt()),
        ("cbrt(x)", x.cbrt()),
        ("abs(-x)", x),
        ("floor(-z)", -1.0),
        ("ceil(z)", 1.0),
        ("sign(-x) + sign(0) + sign(y)", 0.0),
        ("sign(-x)", -1.0),
        ("heaviside(-z)", 0.0),
        ("heaviside(0)", 1.0),
        ("heaviside(z)", 1.0),
        ("atan2(x, y)", x.atan2(y)),
        ("hypot(x, y)", x.hypot(y)),
        ("min(x, y)", x),
        ("max(x, y)", y),
        ("max(min(x, y), hypot(3, 4)) - 1", 4.0),
        ("pi", PI),
    ] {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn values_outside_a_domain_stay_visible() {
    for text in [
        "sqrt(-x)",
        "ln(-x)",
        "0/(x - 2)",
        "min(sqrt(-1), x)",
        "max(x, sqrt(-1))",
        "heaviside(sqrt(-1))",
        "sign(sqrt(-1))",
        "asin(x)",
    ] {
        assert!(value(text).is_nan(), "{text}");
    }
    assert_eq!(value("1/(x - 2)"), f64::INFINITY);
}

#[test]
fn it_is_known_which_coordinates_matter() {
    let expression = Expression::parse(" 1 + x*sin(z) ").unwrap();
    assert_eq!(
        [0, 1, 2].map(|axis| expression.uses(axis)),
        [true, false, true]
    );
    assert_eq!(expression.constant(), None);
    assert_eq!(expression.text(), " 1 + x*sin(z) ");
    assert_eq!(expression.to_string(), expression.text());
    assert_eq!(expression, expression.clone());
    assert_eq!(
        Expression::parse("2*pi").unwrap().constant(),
        Some(2.0 * PI)
    );
}

#[test]
fn expressions_go_between_threads() {
    fn anywhere<T: Clone + Send + Sync + std::fmt::Debug + 'static>() {}
    anywhere::<Expression>();
}

/// The fault in one line: the text with the place marked, what is wrong, and what was expected.
fn fault(text: &str) -> String {
    let error = Expression::parse(text).unwrap_err();
    let (start, end) = (error.span.start, error.span.end);
    let marked = format!("{}«{}»{}", &text[..start], &text[start..end], &text[end..]);
    format!("{error}: {marked}; {}; {}", error.expected, error.help)
}

#[test]
fn faults_are_shown_at_their_place() {
    assert_snapshot!(fault(""), @"the expression is empty: «»; expected a formula in x, y, z; write a number for a constant");
    assert_snapshot!(fault("   "), @"the expression is empty:    «»; expected a formula in x, y, z; write a number for a constant");
    assert_snapshot!(fault("2x"), @"an operator is missing: 2«x»; expected `+`, `-`, `*`, `/` or `^` before this; nothing is multiplied without a sign: 2*x, x*y, 3*(1 + x)");
    assert_snapshot!(fault("x y"), @"an operator is missing: x «y»; expected `+`, `-`, `*`, `/` or `^` before this; nothing is multiplied without a sign: 2*x, x*y, 3*(1 + x)");
    assert_snapshot!(fault("(1 + x)(1 - x)"), @"an operator is missing: (1 + x)«(»1 - x); expected `+`, `-`, `*`, `/` or `^` before this; nothing is multiplied without a sign: 2*x, x*y, 3*(1 + x)");
    assert_snapshot!(fault("1 + "), @"the expression stops too early: 1 + «»; expected a number, a name or `(`; an operator has a value on both sides");
    assert_snapshot!(fault("1 + * 2"), @"a value is missing: 1 + «*» 2; expected a number, a name or `(` here; an operator has a value on both sides");
    assert_snapshot!(fault("x**2"), @"`**` is not an operator: x*«*»2; expected a factor; powers are written with `^`: x^2");
    assert_snapshot!(fault("sin x"), @"the function `sin` has no argument: sin «x»; expected `(` before this; functions have parentheses: sin(…)");
    assert_snapshot!(fault("sin"), @"the function `sin` has no argument: sin«»; expected `(` before this; functions have parentheses: sin(…)");
    assert_snapshot!(fault("sin()"), @"a value is missing: sin(«)»; expected a number, a name or `(` here; an operator has a value on both sides");
    assert_snapshot!(fault("sin(x, y)"), @"a comma where no further argument belongs: sin(x«,» y); expected `)`; decimals are written with a point, as in 0.277");
    assert_snapshot!(fault("max(x)"), @"the function `max` has two arguments: max(x«)»; expected a comma and the second argument; write max(…, …)");
    assert_snapshot!(fault("max(1, 2, 3)"), @"a comma where no further argument belongs: max(1, 2«,» 3); expected `)`; decimals are written with a point, as in 0.277");
    assert_snapshot!(fault("2*(x + (y - 1)"), @"a parenthesis is not closed: 2*«(»x + (y - 1); no `)` belongs to it; close it, or remove it");
    assert_snapshot!(fault("x + 1)"), @"a parenthesis is closed that was never opened: x + 1«)»; no `(` belongs to it; remove it, or open it before");
    assert_snapshot!(fault("0,5*x"), @"a comma outside the parentheses of a function: 0«,»5*x; expected an operator or the end; decimals are written with a point, as in 0.277");
    assert_snapshot!(fault("(0,5)*x"), @"a comma where no further argument belongs: (0«,»5)*x; expected `)`; decimals are written with a point, as in 0.277");
    assert_snapshot!(fault("1.2.3"), @"`1.2.3` is not a number: «1.2.3»; expected a number in the range of double precision; numbers are written as in 0.3, 16 or 5.0e4");
    assert_snapshot!(fault("X + 1"), @"`X` has no meaning in an expression: «X» + 1; did you mean `x`?; known are `x`, `y`, `z`, `pi`, `e`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `sinh`, `cosh`, `tanh`, `exp`, `ln`, `log10`, `sqrt`, `cbrt`, `abs`, `floor`, `ceil`, `sign`, `heaviside`, `atan2`, `hypot`, `min` and `max`");
    assert_snapshot!(fault("log(x)"), @"`log` does not say which logarithm: «log»(x); expected `ln` or `log10`; `ln` is the natural one");
    assert_snapshot!(fault("sqr(x)"), @"`sqr` has no meaning in an expression: «sqr»(x); did you mean `sqrt`?; known are `x`, `y`, `z`, `pi`, `e`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `sinh`, `cosh`, `tanh`, `exp`, `ln`, `log10`, `sqrt`, `cbrt`, `abs`, `floor`, `ceil`, `sign`, `heaviside`, `atan2`, `hypot`, `min` and `max`");
    assert_snapshot!(fault("größe"), @"`größe` has no meaning in an expression: «größe»; expected a variable, a constant or a function; known are `x`, `y`, `z`, `pi`, `e`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `sinh`, `cosh`, `tanh`, `exp`, `ln`, `log10`, `sqrt`, `cbrt`, `abs`, `floor`, `ceil`, `sign`, `heaviside`, `atan2`, `hypot`, `min` and `max`");
    assert_snapshot!(fault("2·x"), @"`·` has no meaning in an expression: 2«·»x; expected a number, a name, an operator or a parenthesis; formulas are written as in 0.09*(1 + x^2)");
    assert_snapshot!(fault("x = 1"), @"`=` has no meaning in an expression: x «=» 1; expected a number, a name, an operator or a parenthesis; formulas are written as in 0.09*(1 + x^2)");
    assert_snapshot!(fault("1e400*"), @"`1e400` is not a number: «1e400»*; expected a number in the range of double precision; numbers are written as in 0.3, 16 or 5.0e4");
}

#[test]
fn long_formulas_are_read_and_deep_ones_refused() {
    let long = vec!["x*y"; 100_000].join(" + ");
    assert_eq!(value(&long), 600_000.0);
    for (open, inner, close) in [
        ("(", "x", ")"),
        ("-", "x", ""),
        ("1 + (", "x", ")"),
        ("2^", "x", ""),
        ("sin(", "x", ")"),
    ] {
        let deep = |n: usize| format!("{}{inner}{}", open.repeat(n), close.repeat(n));
        assert!(Expression::parse(&deep(20)).is_ok(), "{open}");
        let error = Expression::parse(&deep(100_000)).unwrap_err();
        assert_eq!(
            error.message, "the expression is nested too deeply",
            "{open}"
        );
    }
}

/// A formula with its value by Rust's arithmetic, and the rank of its outermost operator:
/// 0 sum, 1 product, 2 sign, 3 power, 4 atom.
#[derive(Clone, Debug)]
struct Formula {
    text: String,
    value: f64,
    rank: u8,
}

impl Formula {
    /// In parentheses where the rank asks for them.
    fn within(&self, rank: u8) -> String {
        match self.rank < rank {
            true => format!("({})", self.text),
            false => self.text.clone(),
        }
    }
}

fn formula() -> impl Strategy<Value = Formula> {
    let atom = |text: String, value| Formula {
        text,
        value,
        rank: 4,
    };
    let leaf = prop_oneof![
        (0_u32..1000).prop_map(move |n| {
            let value = f64::from(n) / 64.0;
            atom(format!("{value:?}"), value)
        }),
        (0_usize..3).prop_map(move |axis| atom(["x", "y", "z"][axis].to_owned(), POINT[axis])),
    ];
    leaf.prop_recursive(6, 48, 2, move |inner| {
        (inner.clone(), inner, 0..8).prop_map(move |(a, b, kind)| {
            let mut text = String::new();
            // Left operands of + - * / keep their rank without parentheses, right ones need more;
            // with ^ it is the other way round.
            let (value, rank) = match kind {
                0 => {
                    write!(text, "{} + {}", a.within(0), b.within(1)).unwrap();
                    (a.value + b.value, 0)
                }
                1 => {
                    write!(text, "{}-{}", a.within(0), b.within(1)).unwrap();
                    (a.value - b.value, 0)
                }
                2 => {
                    write!(text, "{}*{}", a.within(1), b.within(2)).unwrap();
                    (a.value * b.value, 1)
                }
                3 => {
                    write!(text, "{} / {}", a.within(1), b.within(2)).unwrap();
                    (a.value / b.value, 1)
                }
                4 => {
                    write!(text, "-{}", a.within(2)).unwrap();
                    (-a.value, 2)
                }
                5 => {
                    write!(text, "{}^{}", a.within(4), b.within(2)).unwrap();
                    (a.value.powf(b.value), 3)
                }
                6 => {
                    write!(text, "atan2({}, {})", a.text, b.text).unwrap();
                    (a.value.atan2(b.value), 4)
                }
                _ => {
                    write!(text, "cos( {} )", a.text).unwrap();
                    (a.value.cos(), 4)
                }
            };
            Formula { text, value, rank }
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_formulas_have_the_values_of_their_trees(formula in formula()) {
        let read = Expression::parse(&formula.text).unwrap().at(POINT);
        prop_assert!(
            read == formula.value || (read.is_nan() && formula.value.is_nan()),
            "{}: {read}, expected {}", formula.text, formula.value
        );
    }

    #[test]
    fn any_text_is_read_or_refused_with_a_place(text in "[-+*/^(),. xyz0-9eEsincoü\"]{0,24}") {
        match Expression::parse(&text) {
            Ok(expression) => {
                expression.at(POINT);
            }
            Err(error) => prop_assert!(text.get(error.span).is_some()),
        }
    }
}
