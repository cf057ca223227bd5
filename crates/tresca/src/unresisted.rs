//! A motion of floating bodies that nothing resists, in words.

use tresca_fem::rigid::FreeMotion;
use tresca_fem::vector3::norm;
use tresca_model::Model;

use crate::assemble::Assembled;

/// A motion that nothing resists, in words and as a displacement.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct UnresistedMotion {
    /// The bodies that move, with how they move.
    pub bodies: Vec<(String, String)>,
    /// The contacts that open or slide in it, as `slave – master`, with which of the two they do.
    pub contacts: Vec<(String, &'static str)>,
    /// Displacement of each body over its full dofs, the largest component 1.
    pub displacements: Vec<Vec<f64>>,
}

/// The combination of some motions, one for each part of the body that moves; a rotation counts with the
/// displacement at the distance `radius`.
fn combined(motions: &[FreeMotion], amounts: &[f64], radius: f64) -> Vec<FreeMotion> {
    let mut sums: Vec<FreeMotion> = Vec::new();
    for (motion, amount) in motions.iter().zip(amounts) {
        // All motions of a part have the same centre.
        match sums.iter_mut().find(|sum| sum.part == motion.part) {
            Some(sum) => sum.add(*amount, motion),
            None => sums.push(motion.scaled(*amount)),
        }
    }
    // A translation with rounding in its rotation is a translation, and the other way round.
    for motion in sums.iter_mut().flat_map(FreeMotion::rigid_motions_mut) {
        let turn = radius * norm(motion.rotation);
        let shift = norm(motion.translation);
        if turn < VISIBLE * shift {
            motion.rotation = [0.0; 3];
        } else if shift < VISIBLE * turn {
            motion.translation = [0.0; 3];
        }
    }
    sums
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a: f64, x| a.max(x.abs()))
}

/// Amounts below this, relative to the largest, are rounding in a motion.
const VISIBLE: f64 = 1e-3;

/// Puts the combination `v` of all rigid motions in words; `free` is that motion over the free dofs, the largest
/// component 1.
pub(crate) fn unresisted(
    model: &Model,
    assembled: &Assembled,
    v: &[f64],
    free: &[Vec<f64>],
) -> UnresistedMotion {
    let bodies = assembled.bodies.iter().zip(free);
    let displacements: Vec<Vec<f64>> = bodies.map(|(body, u)| body.dofs.expand(u)).collect();
    let mut moving = Vec::new();
    let mut first = 0;
    for (body, meshed) in model.bodies().iter().zip(&assembled.bodies) {
        let own = &v[first..first + meshed.motions.len()];
        first += own.len();
        let radius = 0.5 * body.mesh.bounding_box().diagonal();
        for motion in combined(&meshed.motions, own, radius) {
            let moves = largest(&motion.displacement(&body.mesh));
            moving.push((moves, body.name.clone(), motion.to_string()));
        }
    }
    let size = moving.iter().fold(0.0, |a: f64, (moves, ..)| a.max(*moves));
    let visible = moving
        .into_iter()
        .filter(|(moves, ..)| *moves > VISIBLE * size);
    let names = visible.map(|(_, body, motion)| (body, motion)).collect();

    let relative = assembled.relative(&displacements);
    let m = assembled.pair_count();
    let mut contacts = Vec::new();
    let mut first = 0;
    for (contact, data) in model.contacts().iter().zip(&assembled.contacts) {
        let pairs = first..first + data.pairs.len();
        first = pairs.end;
        let opens = pairs.clone().any(|i| relative[i] < -VISIBLE);
        let slides = pairs.clone().any(|i| {
            assembled
                .layout
                .tangential(&relative[..], i)
                .into_iter()
                .any(|s| s.abs() > VISIBLE)
        });
        debug_assert!(pairs.end <= m);
        if opens || slides {
            let name = format!(
                "{} – {}",
                model.surface_name(&contact.slave),
                model.partner_name(&contact.master)
            );
            contacts.push((name, if opens { "opens" } else { "slides" }));
        }
    }
    UnresistedMotion {
        bodies: names,
        contacts,
        displacements,
    }
}
