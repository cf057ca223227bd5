//! Names that a formula may use, beside its functions.

/// The variables, in the order of the coordinates of a point.
pub const VARIABLES: [&str; 3] = ["x", "y", "z"];

/// The constants: π and Euler's number.
pub const CONSTANTS: [(&str, f64); 2] = [("pi", std::f64::consts::PI), ("e", std::f64::consts::E)];
