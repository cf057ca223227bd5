//! Surfaces that do not match, and obstacles, against closed forms.

mod curved;
mod facing;
mod flat;
mod obstacles;
mod plane;
mod support;
mod supported;
