//! The cases in `cases/` against closed forms, statics and limits: nothing here compares with an earlier
//! output of this project.

mod cattaneo_mindlin;
mod coulomb;
mod every_case;
mod floating;
mod hertz;
mod hysteresis;
mod load_steps;
mod mindlin_sphere;
mod orthotropic;
mod patch;
mod plane;
mod press_fit;
mod sliding;
mod support;
mod tied;
