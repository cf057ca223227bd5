//! Pairs whose relative motion is restrained by supports.
//!
//! Where both nodes of a pair are held in the direction of one axis, on a symmetry plane say, no force
//! along that axis can do work between them. Rows of B that see it would be dependent, so the frame of
//! such a pair is laid along what is left: the normal within the free directions if it has a part
//! there, and the tangents such that as many of them as possible see nothing at all.

use tresca_fem::vector3::{cross, dot, unit};

use crate::frame::Frame;

/// A normal with less than this part in the free directions is held.
const HELD_NORMAL: f64 = 0.1;

/// Which directions of a frame a pair can move along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mobility {
    /// Along ν.
    pub normal: bool,
    /// Along τ1 and τ2; of one free tangent it is τ1 that is free.
    pub tangents: [bool; 2],
}

impl Mobility {
    /// In every direction.
    pub const FULL: Mobility = Mobility {
        normal: true,
        tangents: [true; 2],
    };
}

/// The frame and mobility of a pair that can move along some of the axes only. `None` when it can
/// move along all of them, and the frame may be chosen freely.
pub(crate) fn restrained_frame(normal: [f64; 3], free: [bool; 3]) -> Option<(Frame, Mobility)> {
    if free == [true; 3] {
        return None;
    }
    let part = |keep: bool| -> [f64; 3] {
        std::array::from_fn(|k| if free[k] == keep { normal[k] } else { 0.0 })
    };
    let inside = part(true);
    let moves = dot(inside, inside).sqrt() > HELD_NORMAL;
    let normal = unit(if moves { inside } else { part(false) });
    // The free directions orthogonal to the normal.
    let axis = |k: usize| -> [f64; 3] { std::array::from_fn(|l| if l == k { 1.0 } else { 0.0 }) };
    let free_axes = (0..3).filter(|&k| free[k]);
    let tangential: Vec<[f64; 3]> = if moves {
        match free_axes.clone().count() {
            1 => Vec::new(),
            _ => {
                // Two free axes and the normal between them.
                let held = (0..3).find(|&k| !free[k]).unwrap_or(2);
                vec![aligned(cross(normal, axis(held)))]
            }
        }
    } else {
        free_axes.map(axis).collect()
    };
    let frame = match tangential.first() {
        Some(&first) => Frame {
            normal,
            tangents: [first, cross(normal, first)],
        },
        None => Frame::from_normal(normal),
    };
    let mobility = Mobility {
        normal: moves,
        tangents: [!tangential.is_empty(), tangential.len() == 2],
    };
    Some((frame, mobility))
}

/// ±a, such that its largest component is positive: neighbouring pairs get neighbouring tangents.
fn aligned(a: [f64; 3]) -> [f64; 3] {
    let largest = a
        .into_iter()
        .fold(0.0, |l: f64, x| if x.abs() > l.abs() { x } else { l });
    a.map(|x| x * largest.signum())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: [f64; 3], b: [f64; 3]) -> bool {
        (0..3).all(|k| (a[k] - b[k]).abs() < 1e-14)
    }

    #[test]
    fn on_a_symmetry_plane_the_normal_is_turned_into_the_plane() {
        // A tilted normal of a curved surface that ends at y = 0.
        let normal = unit([0.6, 0.1, 0.8]);
        let (frame, mobility) = restrained_frame(normal, [true, false, true]).unwrap();
        assert!(close(frame.normal, [0.6, 0.0, 0.8]));
        assert!(close(frame.tangents[0], [0.8, 0.0, -0.6]));
        assert!(
            close(frame.tangents[1], [0.0, 1.0, 0.0]) || close(frame.tangents[1], [0.0, -1.0, 0.0])
        );
        assert_eq!(
            mobility,
            Mobility {
                normal: true,
                tangents: [true, false]
            }
        );
        // In a corner of two symmetry planes.
        let (frame, mobility) = restrained_frame(normal, [false, false, true]).unwrap();
        assert!(close(frame.normal, [0.0, 0.0, 1.0]));
        assert_eq!(
            mobility,
            Mobility {
                normal: true,
                tangents: [false; 2]
            }
        );
    }

    #[test]
    fn a_held_normal_leaves_the_tangents() {
        let (frame, mobility) = restrained_frame([0.0, 0.0, -1.0], [true, true, false]).unwrap();
        assert!(close(frame.normal, [0.0, 0.0, -1.0]));
        assert_eq!(
            mobility,
            Mobility {
                normal: false,
                tangents: [true; 2]
            }
        );
        let (_, mobility) = restrained_frame([0.0, 0.0, -1.0], [false, true, false]).unwrap();
        assert_eq!(
            mobility,
            Mobility {
                normal: false,
                tangents: [true, false]
            }
        );
        assert!(restrained_frame([0.0, 0.0, 1.0], [true; 3]).is_none());
    }
}
