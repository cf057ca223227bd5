//! Surfaces that do not match, and obstacles, against closed forms.

// Rates are printed for whoever asks (--nocapture).
#![allow(clippy::print_stdout)]

mod curved;
mod facing;
mod flat;
mod obstacles;
mod patches;
mod plane;
mod support;
mod supported;
