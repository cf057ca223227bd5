//! The certificate: is this a solution? Computed from u and λ alone, afterwards, with the
//! assembled K and the element forces, by a way that knows nothing of the solver's residuals.
//!
//! Every figure is dimensionless, and zero for an exact solution.

use serde::Serialize;

use tresca_qcqp::Settings;

use crate::measures::{Elastic, Interface, Scales};

pub use crate::measures::scale;

/// How far a pair (u, λ) is from solving the contact problem (docs/theory.md, "The contact problem").
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Certificate {
    /// ‖Ku + Bᵀλ − f‖ over the forces that act, ‖f‖ or ‖Bᵀλ‖: the worst body.
    pub equilibrium: f64,
    /// Largest penetration max(Nu − d, 0), over the largest displacement component. Of pairs that never open,
    /// |Nu − d|; of glued ones, also |Tu|.
    pub penetration: f64,
    /// Largest adhesive normal force max(−λν, 0) of pairs that may open, over the largest normal force.
    pub normal_force_sign: f64,
    /// Σ |λν,i (Nu − d)_i| over the energy: the elastic one ½uᵀKu, or what friction takes.
    pub complementarity: f64,
    /// Largest excess of a friction force over its slip bound (with Coulomb's law, over F λν), over the
    /// largest slip bound, or the largest force where that is smaller.
    pub cone_violation: f64,
    /// Σ |h_i(s_i) − λτ,i·s_i| over the energy, s the slip of the step and h the work that
    /// friction at its bound dissipates along it, g‖s‖ for isotropic friction: zero exactly when every pair
    /// that slips does so at its bound in the direction that its law asks for.
    pub slip_law: f64,
    /// Σ max(−λτ,i·s_i, 0) over the energy: friction only ever takes work out.
    pub negative_dissipation: f64,
    /// (primal energy − dual energy) over the energy, with the primal energy
    /// ½uᵀKu − fᵀu + Σ h_i(s_i) and the dual energy −q(λ) − ½fᵀK⁺f. With Coulomb's law that of the
    /// problem whose bounds are F λν.
    pub duality_gap: f64,
    /// Force and moment balance body by body.
    pub bodies: Vec<BodyBalance>,
}

/// A figure of a certificate that is not what the tolerance promises.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Failure {
    /// Which.
    pub item: String,
    /// What it is.
    pub value: f64,
    /// What it may be.
    pub limit: f64,
}

/// Loads, contact forces and support reactions of one body must cancel. The reactions
/// come from the stresses of the elements at the supports.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BodyBalance {
    /// Name of the body.
    pub name: String,
    /// ‖Σ forces‖ over the sum of their magnitudes.
    pub force: f64,
    /// ‖Σ moments‖ about the body's centre, over that sum times the body's diameter.
    pub moment: f64,
    /// Resultant of the loads.
    pub load: [f64; 3],
    /// Resultant of the contact forces.
    pub contact: [f64; 3],
    /// Resultant of the support reactions.
    pub reaction: [f64; 3],
}

impl BodyBalance {
    /// The balance of a body from the resultants `[load, contact, reaction]` and what is left of forces and moments,
    /// both relative.
    pub fn new(name: String, resultants: [[f64; 3]; 3], force: f64, moment: f64) -> Self {
        let [load, contact, reaction] = resultants;
        Self {
            name,
            force,
            moment,
            load,
            contact,
            reaction,
        }
    }
}

impl Certificate {
    /// The certificate without the balance of bodies. Without a dual energy equilibrium holds by construction, and
    /// the gap follows from the pairs alone.
    pub(crate) fn new(
        elastic: &Elastic,
        interface: &Interface,
        scales: Scales,
        dual_energy: Option<f64>,
    ) -> Self {
        let Elastic {
            residual,
            strain_work,
            load_work,
            ..
        } = *elastic;
        let Scales { length, energy } = scales;
        let cone_scale = if interface.largest_bound > 0.0 {
            interface.largest_bound
        } else {
            interface.largest_force
        };
        let primal = 0.5 * strain_work - load_work + interface.friction_work;
        Certificate {
            equilibrium: residual,
            penetration: interface.penetration / length,
            normal_force_sign: interface.adhesion / scale(interface.largest_normal),
            complementarity: interface.complementarity / energy,
            cone_violation: interface.cone / scale(cone_scale),
            slip_law: interface.slip_law / energy,
            negative_dissipation: interface.negative_work / energy,
            duality_gap: dual_energy.map_or_else(|| interface.duality_gap(), |dual| primal - dual)
                / energy,
            bodies: Vec::new(),
        }
    }

    /// The figure that shows most clearly that this is no solution to the accuracy asked for, if one does.
    ///
    /// Balances of forces must hold to 1e-6 (coarser tolerances: to a hundred times the tolerance), everything that
    /// the laws of contact ask for to 1e-4 (ten thousand times the tolerance, a hundred times that on Coulomb's
    /// bounds). Gaps must be closer by the factor `sharpness`, 1 unless rows of B nearly depend on each other. A NaN
    /// fails.
    pub fn failure(&self, settings: &Settings, sharpness: f64) -> Option<Failure> {
        let forces = f64::max(1e-6, 100.0 * settings.tolerance);
        let coulomb = 100.0 * settings.coulomb_tolerance;
        let laws = f64::max(1e-4, 1e4 * settings.tolerance).max(coulomb);
        let items = self.items().into_iter().map(|(item, value)| {
            let limit = match item {
                "equilibrium" => forces,
                "penetration" => sharpness * laws,
                _ => laws,
            };
            (item.to_owned(), value.abs(), limit)
        });
        let bodies = self.bodies.iter().flat_map(|body| {
            [
                (
                    format!("balance of forces on {}", body.name),
                    body.force,
                    forces,
                ),
                (
                    format!("balance of moments on {}", body.name),
                    body.moment,
                    forces,
                ),
            ]
        });
        items
            .chain(bodies)
            .filter(|(_, value, limit)| value.is_nan() || value > limit)
            .map(|(item, value, limit)| Failure { item, value, limit })
            .max_by(|one, other| {
                let excess = |own: &Failure| own.value / own.limit;
                excess(one).total_cmp(&excess(other))
            })
    }

    /// The worst of all figures.
    pub fn worst(&self) -> f64 {
        let balances = self
            .bodies
            .iter()
            .flat_map(|body| [body.force, body.moment]);
        self.items()
            .into_iter()
            .map(|(_, value)| value.abs())
            .chain(balances)
            .fold(0.0, f64::max)
    }

    /// The figures that concern the whole model, with their names.
    pub fn items(&self) -> [(&'static str, f64); 8] {
        [
            ("equilibrium", self.equilibrium),
            ("penetration", self.penetration),
            ("normal force sign", self.normal_force_sign),
            ("complementarity", self.complementarity),
            ("cone violation", self.cone_violation),
            ("slip law", self.slip_law),
            ("negative dissipation", self.negative_dissipation),
            ("duality gap", self.duality_gap),
        ]
    }
}
