//! Parts, instances and the assembly: which keywords belong together.

use super::super::error::{MeshFault, MeshFileError};
use super::super::file::{MeshFile, note_skipped};
use super::super::placement::{Placement, Rotation};
use super::deck::{Deck, Keyword, same_name};
use super::part::Model;
use crate::names::listed;

/// Keywords that are read.
const READ: [&str; 5] = ["NODE", "ELEMENT", "NSET", "ELSET", "SURFACE"];

/// Keywords that make or move nodes or elements by a rule: a mesh without them would be another.
const GENERATORS: [&str; 8] = [
    "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM", "IMPORT",
];

/// A deck, sorted by parts.
#[derive(Debug, Default)]
struct Scopes<'d, 'a> {
    /// Outside of parts and assembly, or in the assembly.
    common: Vec<&'d Keyword<'a>>,
    parts: Vec<(&'a str, Vec<&'d Keyword<'a>>)>,
    instances: Vec<Instance<'d, 'a>>,
    skipped: Vec<String>,
}

#[derive(Debug)]
struct Instance<'d, 'a> {
    name: &'a str,
    /// The `*INSTANCE` line, with the placement.
    head: &'d Keyword<'a>,
    /// What stands in the instance itself.
    own: Vec<&'d Keyword<'a>>,
}

/// The mesh of a deck.
pub(super) fn read(deck: &Deck<'_>) -> Result<MeshFile, MeshFileError> {
    let scopes = sort(deck)?;
    let mut model = Model::default();
    model.skipped = scopes.skipped;
    // Without instances every part is there once, where it was made.
    if scopes.instances.is_empty() {
        for (name, keywords) in &scopes.parts {
            add(&mut model, name, keywords, &Placement::default())?;
        }
    }
    for instance in &scopes.instances {
        let part = instance.head.required("PART")?;
        let found = scopes.parts.iter().find(|(name, _)| same_name(name, part));
        let Some((_, keywords)) = found else {
            let known: Vec<&str> = scopes.parts.iter().map(|(name, _)| *name).collect();
            return Err(MeshFault::syntax(
                instance.head.place(instance.head.line),
                "the name of a part",
                format!("`{part}`"),
            )
            .with_help(format!("the parts are {}", listed(&known))));
        };
        let keywords = [keywords.as_slice(), &instance.own].concat();
        add(
            &mut model,
            instance.name,
            &keywords,
            &placement(instance.head)?,
        )?;
    }
    add(&mut model, "", &scopes.common, &Placement::default())?;
    let name = |&space: &usize| model.spaces[space].name.clone();
    let instances = match model.spaces.as_slice() {
        [_] => Vec::new(),
        _ => model.space_of_entity.iter().map(name).collect(),
    };
    Ok(MeshFile {
        path: deck.path.clone(),
        format: "Abaqus deck".to_owned(),
        points: model.points,
        point_numbers: model.point_numbers,
        cells: model.cells,
        groups: model.groups.finish(),
        skipped: model.skipped,
        instances,
    })
}

fn add(
    model: &mut Model,
    name: &str,
    keywords: &[&Keyword<'_>],
    placement: &Placement,
) -> Result<(), MeshFileError> {
    let first = model.cells.len();
    model.add_space(name, keywords, placement)?;
    if !name.is_empty() {
        // An instance is a group by itself.
        let cells: Vec<usize> = (first..model.cells.len()).collect();
        model.group_of_cells(name, &cells);
    }
    let space = model.spaces.len() - 1;
    model.read_sets(space, keywords)?;
    model.read_surfaces(space, keywords)
}

fn sort<'d, 'a>(deck: &'d Deck<'a>) -> Result<Scopes<'d, 'a>, MeshFileError> {
    let mut scopes = Scopes::default();
    #[derive(Clone, Copy)]
    enum Scope {
        Common,
        Part,
        Instance,
    }
    let mut scope = Scope::Common;
    for keyword in &deck.keywords {
        match keyword.name.as_str() {
            "PART" => {
                scopes.parts.push((keyword.required("NAME")?, Vec::new()));
                scope = Scope::Part;
            }
            "INSTANCE" => {
                scopes.instances.push(Instance {
                    name: keyword.required("NAME")?,
                    head: keyword,
                    own: Vec::new(),
                });
                scope = Scope::Instance;
            }
            "END PART" | "END INSTANCE" => scope = Scope::Common,
            "ASSEMBLY" | "END ASSEMBLY" => {}
            "STEP" => {
                note_skipped(&mut scopes.skipped, "*STEP and what follows");
                break;
            }
            "INCLUDE" => {
                return Err(MeshFault::Unsupported {
                    what: "the keyword `*INCLUDE`".to_owned(),
                }
                .at(keyword.place(keyword.line))
                .with_help("put the text of the included file in its place"));
            }
            name if READ.contains(&name) => {
                refuse_cylindrical(keyword)?;
                match (scope, scopes.parts.last_mut(), scopes.instances.last_mut()) {
                    (Scope::Part, Some((_, keywords)), _) => keywords.push(keyword),
                    (Scope::Instance, _, Some(instance)) => instance.own.push(keyword),
                    _ => scopes.common.push(keyword),
                }
            }
            name if GENERATORS.contains(&name) => {
                return Err(MeshFault::Unsupported {
                    what: format!("the keyword `*{name}`"),
                }
                .at(keyword.place(keyword.line))
                .with_help(
                    "write the deck with all nodes and elements spelled out, as pre-processors do",
                ));
            }
            name => note_skipped(&mut scopes.skipped, format!("*{name}")),
        }
    }
    Ok(scopes)
}

/// Nodes in cylindrical or spherical coordinates.
fn refuse_cylindrical(keyword: &Keyword<'_>) -> Result<(), MeshFileError> {
    match keyword
        .parameter("SYSTEM")
        .map(str::to_uppercase)
        .as_deref()
    {
        None | Some("R" | "") => Ok(()),
        Some(system) => Err(MeshFault::Unsupported {
            what: format!("`SYSTEM={system}`"),
        }
        .at(keyword.place(keyword.line))
        .with_help("write the nodes in rectangular coordinates")),
    }
}

/// The first line of data of an `*INSTANCE` is a translation, the second one a rotation: two points
/// of the axis, and an angle in degrees. The translation comes first.
fn placement(head: &Keyword<'_>) -> Result<Placement, MeshFileError> {
    let mut lines = head.data.iter().map(|&(line, text)| {
        let entries = text
            .split(',')
            .map(str::trim)
            .filter(|entry| !entry.is_empty());
        let numbers = entries.map(|entry| head.real(line, entry, "a number of a placement"));
        numbers
            .collect::<Result<Vec<f64>, _>>()
            .map(|numbers| (line, numbers))
    });
    let wrong = |line, expected: &str, found: usize| {
        MeshFault::syntax(head.place(line), expected, format!("{found} numbers"))
    };
    let mut shift = [0.0; 3];
    if let Some((line, numbers)) = lines.next().transpose()? {
        let [x, y, z] = numbers[..] else {
            return Err(wrong(line, "a translation x, y, z", numbers.len()));
        };
        shift = [x, y, z];
    }
    let Some((line, numbers)) = lines.next().transpose()? else {
        return Ok(Placement {
            translation: shift,
            ..Placement::default()
        });
    };
    let [ax, ay, az, bx, by, bz, angle] = numbers[..] else {
        return Err(wrong(
            line,
            "two points of an axis and an angle",
            numbers.len(),
        ));
    };
    let axis = [bx - ax, by - ay, bz - az];
    if axis == [0.0; 3] {
        return Err(MeshFault::syntax(
            head.place(line),
            "two different points of an axis",
            "one point twice",
        ));
    }
    // Ours is x ↦ R(x − a) + a + t with the translation behind: Abaqus' R(x + s − a) + a is ours
    // about the point a − s, followed by s.
    Ok(Placement {
        scale: 1.0,
        rotation: Some(Rotation {
            axis,
            angle,
            about: [ax - shift[0], ay - shift[1], az - shift[2]],
        }),
        translation: shift,
    })
}
