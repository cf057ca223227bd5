//! Formulas as programs of a stack machine: a flat list of instructions costs a few nanoseconds each,
//! and evaluation needs no memory beyond a fixed stack.

use super::names::VARIABLES;

/// Values that a formula may hold at a time. A sum or product of any length needs two or three; only
/// nesting costs more.
pub(super) const STACK: usize = 32;

/// One instruction.
#[derive(Clone, Copy, Debug)]
pub(super) enum Code {
    /// Pushes a number.
    Number(f64),
    /// Pushes a coordinate.
    Variable(usize),
    /// Replaces the top.
    Unary(fn(f64) -> f64),
    /// Replaces the top two by one.
    Binary(fn(f64, f64) -> f64),
}

/// A formula in reverse Polish notation.
#[derive(Clone, Debug, Default)]
pub(super) struct Program {
    codes: Vec<Code>,
    /// Values on the stack behind the last instruction.
    height: usize,
}

impl Program {
    /// Appends an instruction; `false` when the stack would overflow.
    #[must_use]
    pub(super) fn push(&mut self, code: Code) -> bool {
        match code {
            Code::Number(_) | Code::Variable(_) => self.height += 1,
            Code::Unary(_) => {}
            Code::Binary(_) => self.height -= 1,
        }
        self.codes.push(code);
        self.height <= STACK
    }

    pub(super) fn uses(&self, axis: usize) -> bool {
        self.codes
            .iter()
            .any(|code| matches!(code, Code::Variable(used) if *used == axis))
    }

    /// The parser leaves exactly one value on the stack and never more than [`STACK`].
    pub(super) fn run(&self, point: [f64; VARIABLES.len()]) -> f64 {
        let mut stack = [0.0; STACK];
        let mut height = 0;
        for code in &self.codes {
            match *code {
                Code::Number(value) => {
                    stack[height] = value;
                    height += 1;
                }
                Code::Variable(axis) => {
                    stack[height] = point[axis];
                    height += 1;
                }
                Code::Unary(function) => stack[height - 1] = function(stack[height - 1]),
                Code::Binary(function) => {
                    height -= 1;
                    stack[height - 1] = function(stack[height - 1], stack[height]);
                }
            }
        }
        stack[0]
    }
}

/// A function that a formula may call.
#[derive(Clone, Copy, Debug)]
pub(super) enum Function {
    /// Of one argument.
    One(fn(f64) -> f64),
    /// Of two arguments.
    Two(fn(f64, f64) -> f64),
}

/// All functions, by name.
pub(super) const FUNCTIONS: [(&str, Function); 23] = [
    ("sin", Function::One(f64::sin)),
    ("cos", Function::One(f64::cos)),
    ("tan", Function::One(f64::tan)),
    ("asin", Function::One(f64::asin)),
    ("acos", Function::One(f64::acos)),
    ("atan", Function::One(f64::atan)),
    ("sinh", Function::One(f64::sinh)),
    ("cosh", Function::One(f64::cosh)),
    ("tanh", Function::One(f64::tanh)),
    ("exp", Function::One(f64::exp)),
    ("ln", Function::One(f64::ln)),
    ("log10", Function::One(f64::log10)),
    ("sqrt", Function::One(f64::sqrt)),
    ("cbrt", Function::One(f64::cbrt)),
    ("abs", Function::One(f64::abs)),
    ("floor", Function::One(f64::floor)),
    ("ceil", Function::One(f64::ceil)),
    ("sign", Function::One(sign)),
    ("heaviside", Function::One(heaviside)),
    ("atan2", Function::Two(f64::atan2)),
    ("hypot", Function::Two(f64::hypot)),
    ("min", Function::Two(min)),
    ("max", Function::Two(max)),
];

/// −1, 0 or 1; `f64::signum` knows no 0.
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// 0 below zero, 1 from zero on: patches of load and bound.
fn heaviside(x: f64) -> f64 {
    if x.is_nan() {
        x
    } else if x < 0.0 {
        0.0
    } else {
        1.0
    }
}

/// `f64::min` would drop a NaN, which must stay visible.
fn min(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.min(b)
    }
}

/// As [`min`].
fn max(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.max(b)
    }
}
