//! Our problems as problems of FCLIB.

use tresca_io::fclib::{Document, FclibMatrix, FclibProblem, Info, LocalProblem, State};
use tresca_qcqp::sets::BlockSet;
use tresca_qcqp::{CoulombBound, DualProblem};

use super::reduced::place;
use crate::fclib::error::FclibProblemError;
use crate::outcome::Outcome;
use crate::solve::PreparedModel;
use tresca_contact::FrictionLaw;

use crate::version::VERSION;

/// The dual problem of the load step solved last as a document of FCLIB, with its solution where that
/// converged: r are contact forces, u relative displacements (gaps and negative slips).
///
/// # Errors
/// [`FclibProblemError::Inexpressible`] for laws other than isotropic Coulomb friction without a limit and
/// no friction, and for floating bodies.
pub fn document(
    prepared: &mut PreparedModel<'_>,
    outcome: &Outcome,
) -> Result<Document, FclibProblemError> {
    for contact in prepared.model().contacts() {
        let reason = match &contact.friction {
            FrictionLaw::Frictionless => continue,
            FrictionLaw::Coulomb {
                coefficients: [a, b],
                limit: None,
                ..
            } if a == b => continue,
            FrictionLaw::Coulomb { limit: Some(_), .. } => "Coulomb friction with a limit",
            FrictionLaw::Coulomb { .. } => "orthotropic friction",
            _ => "laws other than Coulomb friction and no friction",
        };
        return Err(FclibProblemError::Inexpressible(reason));
    }
    let local = local_problem(prepared.system().dual())?;
    let solution = &outcome.last().solution;
    let in_file_order = |values: &[f64]| {
        let mut ordered = vec![0.0; values.len()];
        for (i, &value) in values.iter().enumerate() {
            ordered[place(local.dimension, local.friction.len(), i)] = value;
        }
        ordered
    };
    let solution = solution.status.is_converged().then(|| State {
        v: None,
        u: in_file_order(&solution.gradient),
        r: in_file_order(&solution.lambda),
    });
    Ok(Document {
        info: Info {
            title: Some(prepared.model().title().to_owned()),
            description: Some(format!(
                "linear elastic bodies in contact, exported by tresca {VERSION}"
            )),
            math_info: None,
        },
        solution,
        guesses: Vec::new(),
        problem: FclibProblem::Local(local),
    })
}

/// The local problem of a dual problem with Coulomb friction or none, λ = \[normals; tangents\] in the
/// plane or in space: W = A, q = −b, contact by contact. A is formed by multiplications that are not
/// counted, unless the operator holds it.
///
/// # Errors
/// [`FclibProblemError::Inexpressible`] for slip bounds that do not follow from normal forces, pairs that are
/// glued or never open, and floating bodies. Orthotropic friction, which a dual problem hides in its
/// scaling, goes unnoticed here, but not by [`document`].
pub fn local_problem(dual: &mut DualProblem) -> Result<LocalProblem, FclibProblemError> {
    if dual.equality_rows() > 0 {
        return Err(FclibProblemError::Inexpressible("floating bodies"));
    }
    let (dimension, contacts) = shape(dual)?;
    let friction = (0..contacts)
        .map(|contact| coefficient(dual, contacts, contact))
        .collect::<Result<Vec<f64>, _>>()?;
    let order = dual.dim();
    let place = |i| place(dimension, contacts, i);
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
        entries.extend(
            column
                .iter()
                .enumerate()
                .map(|(i, &a)| (place(i), place(j), a)),
        );
    }
    let w = FclibMatrix::new(order, order, entries)
        .map_err(|defect| FclibProblemError::Part { part: "W", defect })?;
    Ok(LocalProblem {
        dimension,
        w,
        q,
        friction,
    })
}

/// Dimension and number of contacts, of half-lines followed by discs or by intervals.
fn shape(dual: &DualProblem) -> Result<(usize, usize), FclibProblemError> {
    let blocks = dual.set().blocks();
    let contacts = blocks.len() / 2;
    let (normals, tangents) = blocks.split_at(contacts);
    let mut normals = normals.iter().enumerate();
    if !blocks.len().is_multiple_of(2)
        || !normals.all(|(i, block)| block.start == i && matches!(block.set, BlockSet::HalfLine(_)))
    {
        return Err(FclibProblemError::Inexpressible(
            "pairs that are glued or never open",
        ));
    }
    let dimension = match tangents.first().map(|block| block.set) {
        Some(BlockSet::Disc(_)) | None => 3,
        _ => 2,
    };
    let fits = |(i, block): (usize, &tresca_qcqp::sets::Block)| {
        let shape = match block.set {
            BlockSet::Disc(_) => 3,
            BlockSet::Interval(_) => 2,
            BlockSet::Line(_) | BlockSet::HalfLine(_) | BlockSet::Origin(_) => 0,
        };
        shape == dimension && block.start == contacts + (dimension - 1) * i
    };
    if tangents.iter().enumerate().all(fits) {
        Ok((dimension, contacts))
    } else {
        Err(FclibProblemError::Inexpressible(
            "pairs that are glued, held along a tangent, or whose friction is orthotropic",
        ))
    }
}

/// μ of a contact.
fn coefficient(
    dual: &DualProblem,
    contacts: usize,
    contact: usize,
) -> Result<f64, FclibProblemError> {
    let block = contacts + contact;
    let own: Option<&CoulombBound> = dual.coulomb().iter().find(|own| own.block == block);
    match own {
        Some(own) if own.normal == contact && own.limit == f64::INFINITY => Ok(own.coefficient),
        Some(_) => Err(FclibProblemError::Inexpressible(
            "Coulomb friction with a limit",
        )),
        None if dual.set().blocks()[block].set.bound() == Some(0.0) => Ok(0.0),
        None => Err(FclibProblemError::Inexpressible(
            "Tresca friction: it has coefficients alone",
        )),
    }
}
