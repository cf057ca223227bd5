//! Kinds of cells by their names. Apart from the kinds, which errors name.

use super::kind::CellKind;
use crate::error::FemError;
use std::str::FromStr;

/// By [`CellKind::name`].
impl FromStr for CellKind {
    type Err = FemError;

    fn from_str(name: &str) -> Result<Self, FemError> {
        let found = CellKind::ALL.into_iter().find(|kind| kind.name() == name);
        found.ok_or_else(|| FemError::UnknownCellKind {
            name: name.to_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        for kind in CellKind::ALL {
            assert_eq!(kind.to_string().parse(), Ok(kind));
            let digits = kind.name().trim_start_matches(|c: char| c.is_alphabetic());
            assert_eq!(digits.parse(), Ok(kind.node_count()));
        }
        let error = "hex9".parse::<CellKind>().unwrap_err().to_string();
        assert!(
            error.contains("hex9") && error.contains("hex8, hex20"),
            "{error}"
        );
    }
}
