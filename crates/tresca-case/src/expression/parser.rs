//! From text to program, by recursive descent:
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = signed { ("*" | "/") signed }
//! signed  = ("+" | "-") signed | power
//! power   = atom [ "^" signed ]                     right to left, and stronger than a sign before it
//! atom    = number | variable | constant | function "(" sum { "," sum } ")" | "(" sum ")"
//! ```

use std::ops::Range;

use super::code::{Code, FUNCTIONS, Function, Program};
use super::error::ExpressionError;
use super::names::{CONSTANTS, VARIABLES};
use tresca_io::names::{listed, nearest};

/// Levels of nesting that are followed: enough for any formula, and little enough for any stack.
const MAX_NESTING: usize = 64;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Token<'t> {
    Number(f64),
    Name(&'t str),
    /// One of `+ - * / ^ ( ) ,`.
    Sign(u8),
    End,
}

pub(super) fn parse(text: &str) -> Result<Program, ExpressionError> {
    let mut parser = Parser {
        text,
        token: Token::End,
        span: 0..0,
        nesting: 0,
        program: Program::default(),
    };
    parser.advance()?;
    if parser.token == Token::End {
        return Err(parser.fault(
            "the expression is empty",
            "expected a formula in x, y, z",
            "write a number for a constant",
        ));
    }
    parser.sum()?;
    match parser.token {
        Token::End => Ok(parser.program),
        Token::Sign(b')') => Err(parser.fault(
            "a parenthesis is closed that was never opened",
            "no `(` belongs to it",
            "remove it, or open it before",
        )),
        Token::Sign(b',') => Err(parser.fault(
            "a comma outside the parentheses of a function",
            "expected an operator or the end",
            "decimals are written with a point, as in 0.277",
        )),
        _ => Err(parser.fault(
            "an operator is missing",
            "expected `+`, `-`, `*`, `/` or `^` before this",
            "nothing is multiplied without a sign: 2*x, x*y, 3*(1 + x)",
        )),
    }
}

struct Parser<'t> {
    text: &'t str,
    /// The token to be read next, and its place.
    token: Token<'t>,
    span: Range<usize>,
    nesting: usize,
    program: Program,
}

impl<'t> Parser<'t> {
    fn fault(
        &self,
        message: impl Into<String>,
        expected: impl Into<String>,
        help: impl Into<String>,
    ) -> ExpressionError {
        ExpressionError {
            message: message.into(),
            span: self.span.clone(),
            expected: expected.into(),
            help: help.into(),
        }
    }

    fn push(&mut self, code: Code) -> Result<(), ExpressionError> {
        if self.program.push(code) {
            Ok(())
        } else {
            Err(self.too_deep())
        }
    }

    fn too_deep(&self) -> ExpressionError {
        self.fault(
            "the expression is nested too deeply",
            "beyond this, too many intermediate values wait",
            "expand some of the parentheses",
        )
    }

    /// Reads the next token.
    fn advance(&mut self) -> Result<(), ExpressionError> {
        let rest = &self.text[self.span.end..];
        let start = self.text.len() - rest.trim_start().len();
        let rest = &self.text[start..];
        let length;
        (self.token, length) = match rest.as_bytes().first() {
            None => (Token::End, 0),
            Some(sign @ (b'+' | b'-' | b'*' | b'/' | b'^' | b'(' | b')' | b',')) => {
                (Token::Sign(*sign), 1)
            }
            Some(b'0'..=b'9' | b'.') => {
                let length = number_length(rest);
                self.span = start..start + length;
                match rest[..length].parse::<f64>() {
                    Ok(value) if value.is_finite() => (Token::Number(value), length),
                    _ => {
                        return Err(self.fault(
                            format!("`{}` is not a number", &rest[..length]),
                            "expected a number in the range of double precision",
                            "numbers are written as in 0.3, 16 or 5.0e4",
                        ));
                    }
                }
            }
            Some(_) if rest.starts_with(|c: char| c.is_alphabetic() || c == '_') => {
                let length = rest
                    .find(|c: char| !(c.is_alphanumeric() || c == '_'))
                    .unwrap_or(rest.len());
                (Token::Name(&rest[..length]), length)
            }
            Some(_) => {
                let character = rest.chars().next().map_or(0, char::len_utf8);
                self.span = start..start + character;
                return Err(self.fault(
                    format!("`{}` has no meaning in an expression", &rest[..character]),
                    "expected a number, a name, an operator or a parenthesis",
                    "formulas are written as in 0.09*(1 + x^2)",
                ));
            }
        };
        self.span = start..start + length;
        Ok(())
    }

    /// Keeps recursion within the stack of any thread.
    fn nested(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<(), ExpressionError>,
    ) -> Result<(), ExpressionError> {
        if self.nesting == MAX_NESTING {
            return Err(self.too_deep());
        }
        self.nesting += 1;
        let result = read(self);
        self.nesting -= 1;
        result
    }

    fn sum(&mut self) -> Result<(), ExpressionError> {
        self.product()?;
        while let Token::Sign(sign @ (b'+' | b'-')) = self.token {
            self.advance()?;
            self.product()?;
            self.push(Code::Binary(match sign {
                b'+' => |a, b| a + b,
                _ => |a, b| a - b,
            }))?;
        }
        Ok(())
    }

    fn product(&mut self) -> Result<(), ExpressionError> {
        self.signed()?;
        while let Token::Sign(sign @ (b'*' | b'/')) = self.token {
            self.advance()?;
            if sign == b'*' && self.token == Token::Sign(b'*') {
                return Err(self.fault(
                    "`**` is not an operator",
                    "expected a factor",
                    "powers are written with `^`: x^2",
                ));
            }
            self.signed()?;
            self.push(Code::Binary(match sign {
                b'*' => |a, b| a * b,
                _ => |a, b| a / b,
            }))?;
        }
        Ok(())
    }

    fn signed(&mut self) -> Result<(), ExpressionError> {
        match self.token {
            Token::Sign(b'-') => {
                self.advance()?;
                self.nested(Self::signed)?;
                self.push(Code::Unary(|a| -a))
            }
            Token::Sign(b'+') => {
                self.advance()?;
                self.nested(Self::signed)
            }
            _ => self.power(),
        }
    }

    fn power(&mut self) -> Result<(), ExpressionError> {
        self.atom()?;
        if self.token == Token::Sign(b'^') {
            self.advance()?;
            self.nested(Self::signed)?;
            self.push(Code::Binary(f64::powf))?;
        }
        Ok(())
    }

    fn atom(&mut self) -> Result<(), ExpressionError> {
        match self.token {
            Token::Number(value) => {
                self.advance()?;
                self.push(Code::Number(value))
            }
            Token::Name(name) => self.name(name),
            Token::Sign(b'(') => {
                let open = self.span.clone();
                self.advance()?;
                self.nested(Self::sum)?;
                self.close(open)
            }
            Token::End => Err(self.fault(
                "the expression stops too early",
                "expected a number, a name or `(`",
                "an operator has a value on both sides",
            )),
            Token::Sign(_) => Err(self.fault(
                "a value is missing",
                "expected a number, a name or `(` here",
                "an operator has a value on both sides",
            )),
        }
    }

    fn name(&mut self, name: &'t str) -> Result<(), ExpressionError> {
        if let Some(axis) = VARIABLES.iter().position(|&variable| variable == name) {
            self.advance()?;
            return self.push(Code::Variable(axis));
        }
        if let Some((_, value)) = CONSTANTS.iter().find(|(constant, _)| *constant == name) {
            self.advance()?;
            return self.push(Code::Number(*value));
        }
        let Some((_, function)) = FUNCTIONS.iter().find(|(function, _)| *function == name) else {
            return Err(self.unknown(name));
        };
        self.advance()?;
        if self.token != Token::Sign(b'(') {
            return Err(self.fault(
                format!("the function `{name}` has no argument"),
                "expected `(` before this",
                format!("functions have parentheses: {name}(…)"),
            ));
        }
        let open = self.span.clone();
        self.advance()?;
        self.nested(Self::sum)?;
        match function {
            Function::One(function) => {
                self.close(open)?;
                self.push(Code::Unary(*function))
            }
            Function::Two(function) => {
                if self.token != Token::Sign(b',') {
                    return Err(self.fault(
                        format!("the function `{name}` has two arguments"),
                        "expected a comma and the second argument",
                        format!("write {name}(…, …)"),
                    ));
                }
                self.advance()?;
                self.nested(Self::sum)?;
                self.close(open)?;
                self.push(Code::Binary(*function))
            }
        }
    }

    /// The parenthesis that ends what began at `open`.
    fn close(&mut self, open: Range<usize>) -> Result<(), ExpressionError> {
        match self.token {
            Token::Sign(b')') => self.advance(),
            Token::Sign(b',') => Err(self.fault(
                "a comma where no further argument belongs",
                "expected `)`",
                "decimals are written with a point, as in 0.277",
            )),
            Token::End => {
                self.span = open;
                Err(self.fault(
                    "a parenthesis is not closed",
                    "no `)` belongs to it",
                    "close it, or remove it",
                ))
            }
            _ => Err(self.fault(
                "an operator is missing",
                "expected `+`, `-`, `*`, `/`, `^` or `)` before this",
                "nothing is multiplied without a sign: 2*x, x*y, 3*(1 + x)",
            )),
        }
    }

    fn unknown(&self, name: &str) -> ExpressionError {
        if name == "log" {
            return self.fault(
                "`log` does not say which logarithm",
                "expected `ln` or `log10`",
                "`ln` is the natural one",
            );
        }
        let names = || {
            let functions = FUNCTIONS.iter().map(|(name, _)| *name);
            let constants = CONSTANTS.iter().map(|(name, _)| *name);
            VARIABLES.into_iter().chain(constants).chain(functions)
        };
        let all: Vec<&str> = names().collect();
        self.fault(
            format!("`{name}` has no meaning in an expression"),
            match nearest(name, names()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => "expected a variable, a constant or a function".to_owned(),
            },
            format!("known are {}", listed(&all)),
        )
    }
}

/// Bytes of the number at the start of a text: digits with a point, and an exponent if digits follow.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| {
        let rest = &text.as_bytes()[from..];
        let count = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        from + count
    };
    let mut end = digits(0);
    while text[end..].starts_with('.') {
        end = digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
        let exponent = digits(end + 1 + sign);
        if exponent > end + 1 + sign {
            end = exponent;
        }
    }
    end
}
