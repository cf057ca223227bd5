//! The compliance of the contact in rigid motions.
//!
//! ```text
//! H = G Z (ZᵀAZ + C)⁻¹ Zᵀ Gᵀ
//! ```
//!
//! with Z and C at the solution λ(α) for a frozen multiplier: a change δα of it changes λ by
//! Z (ZᵀAZ + C)⁻¹ ZᵀGᵀ δα, and Gλ by H δα. −H is the generalised Hessian of the dual function.

use crate::inner_problem::Ending;
use crate::newton::tangent::Tangent;
use crate::session::Session;
use faer::Mat;
use tresca_la::vector::dot;

/// H, and what it is made of.
pub(super) struct Compliance {
    /// H, both triangles.
    pub matrix: Mat<f64>,
    /// Z (ZᵀAZ + C)⁻¹ ZᵀG_jᵀ for every row G_j, in the space of λ.
    pub responses: Vec<Vec<f64>>,
}

/// H at the end of an inner problem, for the `rows` of G; systems solved iteratively are solved
/// to the relative residual `accuracy`. The rows are few and smooth, and change with Z only: what is
/// learnt from one serves the others.
pub(super) fn compliance(
    session: &mut Session,
    ending: &Ending,
    rows: &[Vec<f64>],
    accuracy: f64,
) -> Compliance {
    let Session {
        operator,
        memory,
        settings,
        ..
    } = session;
    let tangent = Tangent::at_projection(
        &**operator,
        settings.inner_solver,
        &ending.set,
        &ending.active,
        &ending.point,
        1.0 / memory.spectrum.sigma,
    );
    let respond = |row: &Vec<f64>| {
        let (response, _) = tangent.respond(&mut **operator, memory, settings, row, accuracy);
        response
    };
    let responses: Vec<Vec<f64>> = rows.iter().map(respond).collect();
    let order = rows.len();
    let product = |i: usize, j: usize| dot(&rows[i], &responses[j]);
    // Symmetric but for the accuracy of the responses.
    let matrix = Mat::from_fn(order, order, |i, j| 0.5 * (product(i, j) + product(j, i)));
    Compliance { matrix, responses }
}
