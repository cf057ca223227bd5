//! Our problems as problems of FCLIB.

use tresca_io::fclib::{LocalProblem, Matrix};
use tresca_qcqp::sets::BlockSet;
use tresca_qcqp::{CoulombBound, DualProblem};

use super::ProblemError;

/// The local problem of a dual problem with Coulomb friction or none, λ = \[normals; tangents\] in the
/// plane or in space: W = A, q = −b, contact by contact. A is formed by multiplications that are not
/// counted, unless the operator holds it.
///
/// # Errors
/// [`ProblemError::Inexpressible`] for slip bounds that do not follow from normal forces, orthotropic
/// friction, pairs that are glued or never open, and floating bodies.
pub fn local_problem(dual: &mut DualProblem) -> Result<LocalProblem, ProblemError> {
    if dual.equality_rows() > 0 {
        return Err(ProblemError::Inexpressible("floating bodies"));
    }
    let (dimension, contacts) = shape(dual)?;
    let friction = (0..contacts)
        .map(|contact| coefficient(dual, contacts, contact))
        .collect::<Result<Vec<f64>, _>>()?;
    let order = dual.dim();
    // The place of unknown i in the file.
    let place = |i: usize| match i.checked_sub(contacts) {
        None => dimension * i,
        Some(t) => dimension * (t / (dimension - 1)) + 1 + t % (dimension - 1),
    };
    let mut q = vec![0.0; order];
    for (i, b) in dual.rhs().iter().enumerate() {
        q[place(i)] = -b;
    }
    let operator = dual.operator_mut();
    let mut entries = Vec::with_capacity(order * order);
    let (mut unit, mut column) = (vec![0.0; order], vec![0.0; order]);
    for j in 0..order {
        unit[j] = 1.0;
        operator.multiply(&unit, &mut column);
        unit[j] = 0.0;
        entries.extend(column.iter().enumerate().map(|(i, &a)| (place(i), place(j), a)));
    }
    let w = Matrix::new(order, order, entries)
        .map_err(|defect| ProblemError::Part { part: "W", defect })?;
    Ok(LocalProblem {
        dimension,
        w,
        q,
        friction,
    })
}

/// Dimension and number of contacts, of half-lines followed by discs or by intervals.
fn shape(dual: &DualProblem) -> Result<(usize, usize), ProblemError> {
    let blocks = dual.set().blocks();
    let contacts = blocks.len() / 2;
    let (normals, tangents) = blocks.split_at(contacts);
    let mut normals = normals.iter().enumerate();
    if blocks.len() % 2 != 0
        || !normals.all(|(i, block)| block.start == i && matches!(block.set, BlockSet::HalfLine(_)))
    {
        return Err(ProblemError::Inexpressible("pairs that are glued or never open"));
    }
    let dimension = match tangents.first().map(|block| block.set) {
        Some(BlockSet::Disc(_)) | None => 3,
        _ => 2,
    };
    let fits = |(i, block): (usize, &tresca_qcqp::sets::Block)| {
        let shape = match block.set {
            BlockSet::Disc(_) => 3,
            BlockSet::Interval(_) => 2,
            BlockSet::Line(_) | BlockSet::HalfLine(_) => 0,
        };
        shape == dimension && block.start == contacts + (dimension - 1) * i
    };
    if tangents.iter().enumerate().all(fits) {
        Ok((dimension, contacts))
    } else {
        Err(ProblemError::Inexpressible(
            "pairs that are glued, held along a tangent, or whose friction is orthotropic",
        ))
    }
}

/// μ of a contact.
fn coefficient(dual: &DualProblem, contacts: usize, contact: usize) -> Result<f64, ProblemError> {
    let block = contacts + contact;
    let own: Option<&CoulombBound> = dual.coulomb().iter().find(|own| own.block == block);
    match own {
        Some(own) if own.normal == contact && own.limit == f64::INFINITY => Ok(own.coefficient),
        Some(_) => Err(ProblemError::Inexpressible("Coulomb friction with a limit")),
        None if dual.set().blocks()[block].set.bound() == Some(0.0) => Ok(0.0),
        None => Err(ProblemError::Inexpressible("Tresca friction: it has coefficients alone")),
    }
}
