//! Sections of version 4.1.

use std::collections::HashMap;

use super::super::error::{MeshFault, MeshFileError};
use super::elements::{Draft, Membership, Names};
use super::input::Input;

/// Physical groups of the elementary entities, by dimension and number of the entity.
pub(super) type Entities = HashMap<(i32, i32), Vec<i32>>;

/// `$Entities`: points have a place, the others a box and the entities that bound them.
pub(super) fn entities(input: &mut Input<'_>) -> Result<Entities, MeshFileError> {
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = input.size("a number of entities")?;
    }
    let mut entities = Entities::new();
    for (dimension, count) in (0..).zip(counts) {
        for _ in 0..count {
            let number = input.int("the number of an entity")?;
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                input.real("a bound of an entity")?;
            }
            let groups = input.size("the number of physical groups of an entity")?;
            let mut physical = Vec::new();
            for _ in 0..groups {
                physical.push(input.int("the number of a physical group")?);
            }
            if dimension > 0 {
                for _ in 0..input.size("the number of bounding entities")? {
                    input.int("a bounding entity")?;
                }
            }
            if !physical.is_empty() {
                entities.insert((dimension, number), physical);
            }
        }
    }
    Ok(entities)
}

/// `$Nodes`: blocks by entity, first the numbers, then the coordinates.
pub(super) fn nodes(input: &mut Input<'_>, draft: &mut Draft) -> Result<(), MeshFileError> {
    let start = input.mark();
    let blocks = input.size("the number of blocks of nodes")?;
    let count = input.size("the number of nodes")?;
    draft.points.reserve(input.at_most(count));
    draft.point_numbers.reserve(input.at_most(count));
    for _ in 0..2 {
        input.size("the range of the node numbers")?;
    }
    for _ in 0..blocks {
        let dimension = input.int("the dimension of an entity")?;
        input.int("the number of an entity")?;
        let parametric = input.int("0, or 1 for parametric coordinates")?;
        let block = input.size("the number of nodes of a block")?;
        let mut numbers = Vec::with_capacity(input.at_most(block));
        for _ in 0..block {
            numbers.push(input.size("the number of a node")?);
        }
        for number in numbers {
            let mark = input.mark();
            let mut point = [0.0; 3];
            for x in &mut point {
                *x = input.real("a coordinate")?;
            }
            draft.push_node(|| input.place_of(mark), number, point)?;
            // The place in the parameters of the curve or surface.
            for _ in 0..if parametric == 0 { 0 } else { dimension } {
                input.real("a parametric coordinate")?;
            }
        }
    }
    if draft.points.len() as u64 != count {
        return Err(MeshFault::syntax(
            input.place_of(start),
            format!("{count} nodes in this section"),
            draft.points.len().to_string(),
        ));
    }
    draft.end_nodes(input.place_of(start))
}

/// `$Elements`: blocks by entity and type.
pub(super) fn elements(
    input: &mut Input<'_>,
    draft: &mut Draft,
    entities: &Entities,
    names: &Names,
) -> Result<(), MeshFileError> {
    let blocks = input.size("the number of blocks of elements")?;
    for _ in 0..3 {
        input.size("the number and range of the elements")?;
    }
    for _ in 0..blocks {
        let dimension = input.int("the dimension of an entity")?;
        let entity = input.int("the number of an entity")?;
        let element_type = input.int("the type of a block of elements")?;
        let count = input.size("the number of elements of a block")?;
        let physical = entities.get(&(dimension, entity));
        let membership = Membership {
            entity,
            physical: physical.map_or(&[], Vec::as_slice),
            names,
        };
        for _ in 0..count {
            let number = input.size("the number of an element")?;
            draft.element(input, (element_type, number), membership, |input| {
                input.size("a node of an element")
            })?;
        }
    }
    Ok(())
}
