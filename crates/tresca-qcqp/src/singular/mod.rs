//! Singular A: rows of B that depend on each other, W of a rigid multibody problem.
//!
//! Then forces are not unique, blocks of A have no factor, and the dual problem may have no solution at all:
//! that is what constraints that contradict each other look like from here. The methods run as ever, with
//! blocks of A factored a little off ([`shifted`]); where one fails, the problem is solved by proximal steps
//! ([`proximal`]), which end at a solution or at a proof that there is none ([`contradiction`]).

pub(crate) mod contradiction;
pub(crate) mod proximal;
pub(crate) mod rank;
pub(crate) mod shifted;
