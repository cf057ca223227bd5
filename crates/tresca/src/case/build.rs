//! From the tables of a case file to the model.

use std::sync::Arc;

use tresca_contact::{CouplingMethod, FrictionLaw, RigidShape, RigidSurface};
use tresca_fem::FemError;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{self, BrickSpec, RectangleSpec, Space};
use tresca_io::case::{
    self, Analysis, Body, CaseError, CaseFile, Coupling, Friction, ObstacleShape, Partners, Span,
    Surface,
};
use tresca_qcqp::Settings;

use super::locate;
use crate::ModelError;
use crate::model::{
    Amount, ContactSpec, LoadKind, Model, PartnerRef, Step, SurfaceRef, VectorField,
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
        let fault = |span: Span, error: FemError, label: &str, help: &str| {
            CaseError::semantic(&self.file.source, span, error.to_string(), label, help)
        };
        let mut mesh = self.mesh(body).map_err(|error| {
            let help = "a brick or a rectangle is given by its corners `min` < `max` and by 2 or more \
                        `nodes` per axis; in the plane it is turned about z only";
            fault(body.mesh.span(), error, "this mesh", help)
        })?;
        if let Some(map) = &body.map {
            let refuse = |error| {
                let help = "the map must give finite coordinates, keep a radius at 0 or more, and turn no \
                            cell inside out";
                fault(map.span.clone(), error, "this map", help)
            };
            mesh = mesh.mapped(|point| map.at(point)).map_err(refuse)?;
            mesh.check_cells().map_err(refuse)?;
        }
        let constants = body.material.get_ref();
        let material = Isotropic::new(*constants.young.get_ref(), *constants.poisson.get_ref())
            .map_err(|error| {
                let help = "a material needs `young` > 0 and −1 < `poisson` < 0.5";
                fault(body.material.span(), error, "this material", help)
            })?;
        let material = match self.file.analysis {
            Analysis::PlaneStress => material.plane_stress(),
            Analysis::Solid | Analysis::PlaneStrain | Analysis::Axisymmetric => material,
        };
        let located = |error: ModelError| locate(self.file, &[], &error);
        model
            .add_body(body.name.get_ref(), mesh, material)
            .map_err(located)?;
        let formulation = *body.formulation.get_ref();
        model.formulation(formulation).map_err(located)?;
        if let Some(density) = &constants.density {
            model.density(*density.get_ref()).map_err(located)?;
        }
        Ok(())
    }

    fn mesh(&self, body: &Body) -> Result<mesh::Mesh, FemError> {
        let mesh = match body.mesh.get_ref() {
            case::Mesh::Brick(brick) => mesh::brick(&BrickSpec {
                min: brick.min.get_ref().values(),
                max: brick.max.get_ref().values(),
                nodes: brick.nodes.get_ref().values(),
            })?
            .with_cells(brick.cells.kind())?,
            case::Mesh::Rectangle(rectangle) => mesh::rectangle(&RectangleSpec {
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
            case::Mesh::File(file) => return Ok(file.body.mesh.clone()),
        };
        match body.placement.is_identity() {
            true => Ok(mesh),
            false => mesh.mapped(|point| body.placement.apply(point)),
        }
    }

    fn reference<'a>(&'a self, surface: &'a Surface) -> SurfaceRef<'a> {
        SurfaceRef {
            body: self.file.bodies[surface.body].name.get_ref(),
            faces: &surface.face,
        }
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
            model
                .clamp(self.reference(surface))
                .map_err(self.at(&surface.span))?;
        }
        for support in &self.file.supports {
            let on: Vec<_> = support.on.iter().map(|on| self.reference(on)).collect();
            let name = support.name.as_ref().map(|name| name.get_ref().as_str());
            model
                .support(name, &on, support.displacement)
                .map_err(self.at(&support.span))?;
        }
        Ok(())
    }

    /// In the order that the amounts of a step are put together in: see `steps`.
    fn loads(&self, model: &mut Model) -> Result<(), CaseError> {
        let file = self.file;
        let mut add =
            |name: Option<&str>,
             span: &Span,
             on: &[Surface],
             kind: &dyn Fn(Vec<crate::model::Surface>) -> LoadKind| {
                let surfaces = on.iter().map(|on| model.resolve(self.reference(on)));
                let surfaces = surfaces.collect::<Result<_, _>>().map_err(self.at(span))?;
                model
                    .add_load(name, kind(surfaces))
                    .map_err(self.at(span))?;
                Ok::<(), CaseError>(())
            };
        fn text(name: &Option<case::Spanned<String>>) -> Option<&str> {
            name.as_ref().map(|name| name.get_ref().as_str())
        }
        for item in &file.tractions {
            add(text(&item.name), &item.span, &item.on, &|on| {
                LoadKind::Traction {
                    on,
                    value: vector(&item.value),
                }
            })?;
        }
        for item in &file.pressures {
            add(text(&item.name), &item.span, &item.on, &|on| {
                LoadKind::Pressure {
                    on,
                    value: field(item.value.get_ref()),
                }
            })?;
        }
        for item in &file.body_forces {
            let (bodies, value) = (&item.bodies, item.value);
            add(text(&item.name), &item.span, &[], &|_| {
                LoadKind::BodyForce {
                    bodies: bodies.clone(),
                    value,
                }
            })?;
        }
        for item in &file.gravities {
            let (bodies, value) = (&item.bodies, item.value);
            add(text(&item.name), &item.span, &[], &|_| LoadKind::Gravity {
                bodies: bodies.clone(),
                value,
            })?;
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
            model
                .add_obstacle(own.name.get_ref(), shape, own.motion.unwrap_or([0.0; 3]))
                .map_err(self.at(&own.span))?;
        }
        Ok(())
    }

    fn contacts(&self, model: &mut Model) -> Result<Vec<usize>, CaseError> {
        let mut tables = Vec::new();
        for (table, contact) in self.file.contacts.iter().enumerate() {
            let name = contact.name.as_ref().map(|name| name.get_ref().as_str());
            let friction = law(&contact.friction);
            let gap = field(contact.gap.get_ref());
            let coupling = match contact.coupling {
                Coupling::Auto => CouplingMethod::Auto,
                Coupling::NodeByNode => CouplingMethod::NodeByNode,
                Coupling::Mortar => CouplingMethod::Mortar,
            };
            let (slave, master) = match &contact.partners {
                Partners::Surfaces { slave, master } => {
                    (slave, PartnerRef::Surface(self.reference(master)))
                }
                Partners::Obstacle { slave, obstacle } => {
                    let name = self.file.obstacles[*obstacle].name.get_ref();
                    (slave, PartnerRef::Obstacle(name))
                }
                Partners::Near { distance, bodies } => {
                    let names = bodies.iter();
                    let names: Vec<&str> = names
                        .map(|&body| self.file.bodies[body].name.get_ref().as_str())
                        .collect();
                    let count = model
                        .add_contacts_within(*distance, &names, name, &friction, &gap, coupling)
                        .map_err(self.at(&contact.span))?;
                    tables.extend(std::iter::repeat_n(table, count));
                    continue;
                }
            };
            let spec = ContactSpec {
                name,
                gap,
                coupling,
                search: contact.search,
                ..ContactSpec::new(self.reference(slave), master, friction)
            };
            model.add_contact_as(spec).map_err(self.at(&contact.span))?;
            tables.push(table);
        }
        Ok(tables)
    }

    /// `tables`: the table of each contact of the model.
    fn steps(&self, model: &mut Model, tables: &[usize]) -> Result<(), CaseError> {
        let clamped: usize = self.file.clamps.iter().map(|clamp| clamp.on.len()).sum();
        for step in &self.file.steps {
            let amounts = &step.amounts;
            let clamps = std::iter::repeat_n(Amount::Factor(1.0), clamped);
            let vectors = amounts.body_forces.iter().chain(&amounts.gravities);
            let pressures = amounts.pressures.iter().map(|&amount| match amount {
                case::Amount::Factor(factor) => Amount::Factor(factor),
                case::Amount::Value(value) => Amount::Value([value, 0.0, 0.0]),
            });
            let tractions = amounts.tractions.iter().copied().map(same);
            let name = step.name.as_ref().map(|name| match step.increments {
                1 => name.clone(),
                count => format!("{name}, increment {} of {count}", step.increment),
            });
            let step = Step {
                time: step.time,
                name,
                supports: clamps
                    .chain(amounts.supports.iter().map(|&values| Amount::Value(values)))
                    .collect(),
                loads: tractions
                    .chain(pressures)
                    .chain(vectors.copied().map(same))
                    .collect(),
                obstacles: amounts.motions.iter().map(|&v| Amount::Value(v)).collect(),
                bounds: tables
                    .iter()
                    .map(|&table| same(amounts.bounds[table]))
                    .collect(),
            };
            model
                .add_step(step)
                .map_err(|error| locate(self.file, &[], &error))?;
        }
        Ok(())
    }
}

fn same<T>(amount: case::Amount<T>) -> Amount<T> {
    match amount {
        case::Amount::Factor(factor) => Amount::Factor(factor),
        case::Amount::Value(value) => Amount::Value(value),
    }
}

fn field(own: &case::Field) -> tresca_contact::ScalarField {
    match own {
        case::Field::Constant(value) => (*value).into(),
        varying => {
            let varying = varying.clone();
            tresca_contact::ScalarField::Function(Arc::new(move |point| varying.at(point)))
        }
    }
}

fn vector(own: &case::VectorField) -> VectorField {
    match own.constant() {
        Some(value) => VectorField::Constant(value),
        None => {
            let own = own.clone();
            VectorField::Function(Arc::new(move |point| own.at(point)))
        }
    }
}

fn law(friction: &Friction) -> FrictionLaw {
    let limit = |limit: &Option<case::Spanned<case::Field>>| {
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
