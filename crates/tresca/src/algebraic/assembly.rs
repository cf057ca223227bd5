//! The matrices of a model, as a problem that anyone can solve.

use tresca_contact::{ContactPair, Opening, Sliding};
use tresca_la::SymmetricMatrix;

use tresca_model::{Model, Step};
use tresca_system::matrices::{Matrix, MatrixProblem, PairLaw};

use crate::assemble::assemble;
use crate::error::SolveError;
use crate::load_step::acting;

/// The assembled problem of a model, and what its numbers belong to.
#[derive(Debug, Clone)]
pub struct Assembly {
    /// K (one block per body), N, T, f, d, friction, over the dofs that no support holds.
    pub problem: MatrixProblem,
    /// The contact pairs, in the order of the rows of N: points, frames, areas.
    pub pairs: Vec<ContactPair>,
    /// Where each dof comes from: \[body, node, component\].
    pub dofs: Vec<[usize; 3]>,
}

impl Assembly {
    /// Assembles a load step of a model on its own: the slip before it is zero.
    ///
    /// Displacements that supports prescribe move to the right-hand sides: into f, into the gaps, and (as
    /// previous slip) into the slip; so does the motion of obstacles.
    ///
    /// # Errors
    /// When the model is wrong.
    pub fn new(model: &Model, step: &Step) -> Result<Self, SolveError> {
        let (assembled, bodies) = assemble(model)?;
        let nothing = vec![0.0; assembled.layout.unknowns()];
        let case = acting(model, &assembled, step, &nothing)?.case;
        let m = assembled.pair_count();
        let stiffness: Vec<_> = bodies
            .iter()
            .map(|body| both_triangles(&body.stiffness))
            .collect();
        let mut dofs = Vec::new();
        let mut b = Triplets::default();
        for (index, body) in assembled.bodies.iter().enumerate() {
            let components = model.dimension();
            let first = dofs.len();
            let full =
                (0..body.dofs.full_len()).filter(|&full| body.dofs.free_of_full(full).is_some());
            dofs.extend(full.map(|full| [index, full / components, full % components]));
            for row in 0..assembled.layout.unknowns() {
                for (free, value) in body.dofs.restrict_row(body.contact.row(row)) {
                    b.push(row, first + free, value);
                }
            }
        }
        let moved = &case.base;
        let gaps = assembled
            .pairs()
            .zip(moved)
            .map(|(pair, moved)| pair.gap - moved);
        let openings = model.contacts().iter().zip(&assembled.contacts);
        let openings = openings.flat_map(|(contact, data)| {
            std::iter::repeat_n(contact.friction.opening(), data.pairs.len())
        });
        let laws: Vec<PairLaw> = openings
            .zip(&case.slidings)
            .map(|(opening, sliding)| law(opening, sliding))
            .collect();
        let b = b.matrix(assembled.layout.unknowns(), dofs.len());
        let mut problem = MatrixProblem::new(stiffness, b.rows_between(0, m), case.loads.concat())
            .with_tangential(b.rows_between(m, b.rows()))
            .with_gap(gaps.collect())
            .with_friction(laws);
        if moved[m..].iter().any(|&slip| slip != 0.0) {
            problem = problem.with_previous_slip(moved[m..].iter().map(|slip| -slip).collect());
        }
        problem.points = Some(assembled.pairs().map(|pair| pair.point).collect());
        Ok(Self {
            problem,
            pairs: assembled.pairs().cloned().collect(),
            dofs,
        })
    }
}

fn law(opening: Opening, sliding: &Sliding) -> PairLaw {
    match (opening, *sliding) {
        // No law of a model glues a pair that may open.
        (_, Sliding::Never) => PairLaw::Tied,
        (
            _,
            Sliding::Coulomb {
                coefficients,
                limit,
            },
        ) => PairLaw::Coulomb {
            coefficients,
            limit,
        },
        // Where supports leave one tangent, the second bound is never looked at.
        (Opening::Never, Sliding::Bounded([bound, _])) => PairLaw::Bilateral { bound },
        (Opening::Unilateral, Sliding::Bounded([0.0, 0.0])) => PairLaw::Frictionless,
        (Opening::Unilateral, Sliding::Bounded([a, b])) if a == b => PairLaw::Tresca { bound: a },
        (Opening::Unilateral, Sliding::Bounded(bounds)) => PairLaw::Orthotropic { bounds },
    }
}

fn both_triangles(k: &SymmetricMatrix) -> Matrix {
    let mut entries = Triplets::default();
    for j in 0..k.order() {
        for (i, &value) in k.lower().row_idx_of_col(j).zip(k.lower().val_of_col(j)) {
            entries.push(i, j, value);
            if i != j {
                entries.push(j, i, value);
            }
        }
    }
    entries.matrix(k.order(), k.order())
}

#[derive(Default)]
struct Triplets {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl Triplets {
    fn push(&mut self, row: usize, column: usize, value: f64) {
        self.rows.push(row);
        self.columns.push(column);
        self.values.push(value);
    }

    /// The matrix of entries that were checked when they were made.
    fn matrix(&self, rows: usize, columns: usize) -> Matrix {
        Matrix::from_triplets((rows, columns), &self.rows, &self.columns, &self.values)
            .unwrap_or_else(|error| unreachable!("an assembled matrix is refused: {error}"))
    }
}
