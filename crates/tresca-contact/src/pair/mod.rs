//! A contact pair: what it can do beside supports, and its rows of B.

pub(crate) mod contact_pair;
pub(crate) mod mobility;
pub(crate) mod rows;
