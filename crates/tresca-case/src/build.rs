//! From the tables of a case file to the model.

use std::sync::Arc;

use crate::{
    Analysis, Body, CaseError, CaseFile, Coupling, Friction, ObstacleShape, Partners, Span, Surface,
};
use tresca_contact::{CouplingMethod, FrictionLaw, RigidShape, RigidSurface};
use tresca_fem::FemError;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{self, BrickSpec, RectangleSpec, Space};
use tresca_qcqp::Settings;

use tresca_model::ModelError;
use tresca_model::{
    Amount, BodyForce, Contact, ContactId, ContactWithin, Gravity, Load, LoadId, Model, ObstacleId,
    PlaceName, PlaceNames, Pressure, Step, Support, SupportId, Traction, VectorField,
};

/// The model that a case file describes, and for each contact of the model the table that it comes from:
/// one table makes several contacts where bodies are paired by distance.
pub(super) fn build(file: &CaseFile<Settings>) -> Result<(Model, Vec<usize>), CaseError> {
    let mut model = Model::new(&file.title);
    let builder = Builder { file };
    for body in &file.bodies {
        builder.body(&mut model, body)?;
    }
    builder.supports(&mut model)?;
    builder.loads(&mut model)?;
    builder.obstacles(&mut model)?;
    let tables = builder.contacts(&mut model)?;
    builder.steps(&mut model, &tables)?;
    Ok((model, tables))
}

struct Builder<'a> {
    file: &'a CaseFile<Settings>,
}

impl Builder<'_> {
    fn body(&self, model: &mut Model, body: &Body) -> Result<(), CaseError> {
        let fault = |span: Span, error: String, label: &str, help: &str| {
            CaseError::semantic(&self.file.source, span, error, label, help)
        };
        let mut mesh = self.mesh(body).map_err(|error| {
            let help = "a brick or a rectangle is given by its corners `min` < `max` and by 2 or more \
                        `nodes` per axis; in the plane it is turned about z only";
            fault(body.mesh.span(), error.to_string(), "this mesh", help)
        })?;
        if let Some(map) = &body.map {
            let refuse = |error: FemError| {
                let help = "the map must give finite coordinates, keep a radius at 0 or more, and turn no \
                            cell inside out";
                fault(map.span.clone(), error.to_string(), "this map", help)
            };
            mesh = mesh.mapped(|point| map.at(point)).map_err(refuse)?;
            mesh.check_cells().map_err(refuse)?;
        }
        let constants = body.material.get_ref();
        let material = Isotropic::new(*constants.young.get_ref(), *constants.poisson.get_ref())
            .map_err(|error| {
                let help = "a material needs `young` > 0 and −1 < `poisson` < 0.5";
                fault(
                    body.material.span(),
                    error.to_string(),
                    "this material",
                    help,
                )
            })?;
        let material = match self.file.analysis {
            Analysis::PlaneStress => material.plane_stress(),
            Analysis::Solid | Analysis::PlaneStrain | Analysis::Axisymmetric => material,
        };
        let located =
            |error: ModelError| fault(body.name.span(), error.to_string(), "this body", "");
        let mut made = tresca_model::Body::new(body.name.get_ref(), mesh, material)
            .formulation(*body.formulation.get_ref());
        if let Some(density) = &constants.density {
            made = made.density(*density.get_ref());
        }
        model.add_body(made).map(drop).map_err(located)
    }

    fn mesh(&self, body: &Body) -> Result<mesh::Mesh, FemError> {
        let mesh = match body.mesh.get_ref() {
            crate::Mesh::Brick(brick) => mesh::brick(&BrickSpec {
                min: brick.min.get_ref().values(),
                max: brick.max.get_ref().values(),
                nodes: brick.nodes.get_ref().values(),
            })?
            .with_cells(brick.cells.kind())?,
            crate::Mesh::Rectangle(rectangle) => mesh::rectangle(&RectangleSpec {
                space: match self.file.analysis {
                    Analysis::Axisymmetric => Space::Axisymmetric,
                    _ => Space::Plane,
                },
                min: rectangle.min.get_ref().values(),
                max: rectangle.max.get_ref().values(),
                nodes: rectangle.nodes.get_ref().values(),
                cells: rectangle.cells.kind().linear(),
            })?
            .with_cells(rectangle.cells.kind())?,
            // It is placed already.
            crate::Mesh::File(file) => return Ok(file.body.mesh.clone()),
        };
        match body.placement.is_identity() {
            true => Ok(mesh),
            false => mesh.mapped(|point| body.placement.apply(point)),
        }
    }

    fn reference(&self, surface: &Surface) -> PlaceName {
        let body = self.file.bodies[surface.body].name.get_ref().as_str();
        PlaceName::from((body, surface.face.as_str()))
    }

    fn body_names(&self, bodies: &[usize]) -> PlaceNames {
        let names = bodies.iter().map(|&body| &self.file.bodies[body].name);
        names.map(|name| name.get_ref().as_str()).collect()
    }

    /// The fault of an item whose table stands at `span`.
    fn at(&self, span: &Span) -> impl Fn(ModelError) -> CaseError {
        move |error| {
            CaseError::semantic(
                &self.file.source,
                span.clone(),
                error.to_string(),
                "here",
                "",
            )
        }
    }

    fn supports(&self, model: &mut Model) -> Result<(), CaseError> {
        for surface in self.file.clamps.iter().flat_map(|clamp| &clamp.on) {
            let clamp = Support::clamp(self.reference(surface));
            model.add_support(clamp).map_err(self.at(&surface.span))?;
        }
        for support in &self.file.supports {
            let on = support.on.iter().map(|on| self.reference(on));
            let mut made = Support::new(on.collect::<PlaceNames>(), support.displacement);
            made.name = text(&support.name);
            model.add_support(made).map_err(self.at(&support.span))?;
        }
        Ok(())
    }

    /// In the order that the amounts of a step are put together in: see `steps`.
    fn loads(&self, model: &mut Model) -> Result<(), CaseError> {
        let file = self.file;
        let mut add = |name, span: &Span, mut load: Load<PlaceNames>| {
            load.name = text(name);
            model.add_load(load).map(drop).map_err(self.at(span))
        };
        let places =
            |on: &[Surface]| -> PlaceNames { on.iter().map(|on| self.reference(on)).collect() };
        for item in &file.tractions {
            let load = Traction::new(vector(&item.value)).on(places(&item.on));
            add(&item.name, &item.span, load)?;
        }
        for item in &file.pressures {
            let load = Pressure::new(field(item.value.get_ref())).on(places(&item.on));
            add(&item.name, &item.span, load)?;
        }
        for item in &file.body_forces {
            let load = BodyForce::new(item.value).on(self.body_names(&item.bodies));
            add(&item.name, &item.span, load)?;
        }
        for item in &file.gravities {
            let load = Gravity::new(item.value).on(self.body_names(&item.bodies));
            add(&item.name, &item.span, load)?;
        }
        Ok(())
    }

    fn obstacles(&self, model: &mut Model) -> Result<(), CaseError> {
        for own in &self.file.obstacles {
            let shape = match &own.shape {
                ObstacleShape::Plane { point, normal } => RigidShape::Plane {
                    point: *point,
                    normal: *normal,
                },
                ObstacleShape::Sphere {
                    center,
                    radius,
                    inside,
                } => RigidShape::Sphere {
                    center: *center,
                    radius: *radius,
                    inside: *inside,
                },
                ObstacleShape::Cylinder {
                    point,
                    axis,
                    radius,
                    inside,
                } => RigidShape::Cylinder {
                    point: *point,
                    axis: *axis,
                    radius: *radius,
                    inside: *inside,
                },
                ObstacleShape::Surface(surface) => RigidShape::Surface(RigidSurface {
                    points: surface.points.clone(),
                    faces: surface.faces.clone(),
                }),
            };
            let mut made = tresca_model::Obstacle::new(own.name.get_ref(), shape);
            made.motion = own.motion;
            model.add_obstacle(made).map_err(self.at(&own.span))?;
        }
        Ok(())
    }

    fn contacts(&self, model: &mut Model) -> Result<Vec<usize>, CaseError> {
        let mut tables = Vec::new();
        for (table, contact) in self.file.contacts.iter().enumerate() {
            let friction = law(&contact.friction);
            let gap = field(contact.gap.get_ref());
            let coupling = match contact.coupling {
                Coupling::Auto => CouplingMethod::Auto,
                Coupling::NodeByNode => CouplingMethod::NodeByNode,
                Coupling::Mortar => CouplingMethod::Mortar,
            };
            let (slave, master) = match &contact.partners {
                Partners::Surfaces { slave, master } => (slave, self.reference(master)),
                Partners::Obstacle { slave, obstacle } => {
                    let name = self.file.obstacles[*obstacle].name.get_ref();
                    (slave, name.as_str().into())
                }
                Partners::Near { distance, bodies } => {
                    let mut made = ContactWithin::within(*distance, friction)
                        .bodies(self.body_names(bodies))
                        .gap(gap)
                        .coupling(coupling);
                    made.name = text(&contact.name);
                    let added = model.add_contacts_within(made);
                    let count = added.map_err(self.at(&contact.span))?.len();
                    tables.extend(std::iter::repeat_n(table, count));
                    continue;
                }
            };
            let mut made = Contact::new(self.reference(slave), master, friction)
                .gap(gap)
                .coupling(coupling);
            made.name = text(&contact.name);
            made.search = contact.search;
            model.add_contact(made).map_err(self.at(&contact.span))?;
            tables.push(table);
        }
        Ok(tables)
    }

    /// `tables`: the table of each contact of the model.
    fn steps(&self, model: &mut Model, tables: &[usize]) -> Result<(), CaseError> {
        let clamped: usize = self.file.clamps.iter().map(|clamp| clamp.on.len()).sum();
        for step in &self.file.steps {
            let amounts = &step.amounts;
            let mut made = Step::new(step.time);
            made.name = step.name.as_ref().map(|name| match step.increments {
                1 => name.clone(),
                count => format!("{name}, increment {} of {count}", step.increment),
            });
            for (i, values) in amounts.supports.iter().enumerate() {
                let values = Amount::Vector(values.map(|value| value.unwrap_or(0.0)));
                made = made.with(SupportId(clamped + i), values);
            }
            let tractions = amounts
                .tractions
                .iter()
                .map(|&amount| vector_amount(amount));
            let pressures = amounts
                .pressures
                .iter()
                .map(|&amount| number_amount(amount));
            let forces = amounts.body_forces.iter().chain(&amounts.gravities);
            let loads = tractions
                .chain(pressures)
                .chain(forces.map(|&amount| vector_amount(amount)));
            for (i, amount) in loads.enumerate() {
                made = made.with(LoadId(i), amount);
            }
            for (i, &motion) in amounts.motions.iter().enumerate() {
                made = made.with(ObstacleId(i), Amount::Vector(motion));
            }
            for (i, &table) in tables.iter().enumerate() {
                made = made.with(ContactId(i), number_amount(amounts.bounds[table]));
            }
            model
                .add_step(made)
                .map_err(|error| self.at(&(0..0))(error))?;
        }
        Ok(())
    }
}

fn vector_amount(amount: crate::Amount<[f64; 3]>) -> Amount {
    match amount {
        crate::Amount::Factor(factor) => Amount::Factor(factor),
        crate::Amount::Value(value) => Amount::Vector(value),
    }
}

fn number_amount(amount: crate::Amount<f64>) -> Amount {
    match amount {
        crate::Amount::Factor(factor) => Amount::Factor(factor),
        crate::Amount::Value(value) => Amount::Scalar(value),
    }
}

fn text(name: &Option<crate::Spanned<String>>) -> Option<String> {
    name.as_ref().map(|name| name.get_ref().clone())
}

fn field(own: &crate::Field) -> tresca_contact::ScalarField {
    match own {
        crate::Field::Constant(value) => (*value).into(),
        varying => {
            let varying = varying.clone();
            tresca_contact::ScalarField::Function(Arc::new(move |point| varying.at(point)))
        }
    }
}

fn vector(own: &crate::VectorField) -> VectorField {
    match own.constant() {
        Some(value) => VectorField::Constant(value),
        None => {
            let own = own.clone();
            VectorField::Function(Arc::new(move |point| own.at(point)))
        }
    }
}

fn law(friction: &Friction) -> FrictionLaw {
    let limit = |limit: &Option<crate::Spanned<crate::Field>>| {
        limit.as_ref().map(|limit| field(limit.get_ref()))
    };
    match friction {
        Friction::Frictionless => FrictionLaw::Frictionless,
        Friction::Tresca { bound } => FrictionLaw::Tresca {
            bound: field(bound.get_ref()),
        },
        Friction::Orthotropic { bounds, axis } => FrictionLaw::Orthotropic {
            bounds: bounds.each_ref().map(|bound| field(bound.get_ref())),
            axis: *axis.get_ref(),
        },
        Friction::Coulomb {
            coefficient,
            limit: largest,
        } => FrictionLaw::Coulomb {
            coefficients: [*coefficient.get_ref(); 2],
            axis: None,
            limit: limit(largest),
        },
        Friction::OrthotropicCoulomb {
            coefficients,
            axis,
            limit: largest,
        } => FrictionLaw::Coulomb {
            coefficients: coefficients.each_ref().map(|f| *f.get_ref()),
            axis: Some(*axis.get_ref()),
            limit: limit(largest),
        },
        Friction::Tied => FrictionLaw::Tied,
        Friction::Bilateral { bound } => FrictionLaw::Bilateral {
            bound: limit(bound),
        },
    }
}
