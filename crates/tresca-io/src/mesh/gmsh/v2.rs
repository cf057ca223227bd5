//! Sections of version 2.2.

use super::super::error::{MeshFault, MeshFileError};
use super::elements::{Draft, Membership, Names};
use super::input::{Encoding, Input};

/// `$Nodes`: number, x, y, z.
pub(super) fn nodes(input: &mut Input<'_>, draft: &mut Draft) -> Result<(), MeshFileError> {
    let start = input.mark();
    let count: u64 = input.number_in_text("the number of nodes")?;
    input.end_line();
    draft.points.reserve(input.at_most(count));
    draft.point_numbers.reserve(input.at_most(count));
    for _ in 0..count {
        let mark = input.mark();
        let number = input.number("the number of a node")?;
        let mut point = [0.0; 3];
        for x in &mut point {
            *x = input.real("a coordinate")?;
        }
        draft.push_node(|| input.place_of(mark), number, point)?;
    }
    draft.end_nodes(input.place_of(start))
}

/// `$Elements`: in text number, type, tags and nodes of each; in binary blocks of one type.
pub(super) fn elements(
    input: &mut Input<'_>,
    draft: &mut Draft,
    names: &Names,
) -> Result<(), MeshFileError> {
    let count: u64 = input.number_in_text("the number of elements")?;
    input.end_line();
    let mut read = 0;
    while read < count {
        if input.encoding() == Encoding::Text {
            let number = input.number("the number of an element")?;
            let element_type = input.int("the type of an element")?;
            let tags = input.int("the number of tags of an element")?;
            element(input, draft, names, (element_type, number, tags))?;
            read += 1;
            continue;
        }
        let element_type = input.int("the type of a block of elements")?;
        let mark = input.mark();
        let block = input.int("the number of elements of a block")?;
        let tags = input.int("the number of tags of an element")?;
        if block < 1 {
            return Err(MeshFault::syntax(
                input.place_of(mark),
                "the number of elements of a block, 1 or more",
                block.to_string(),
            ));
        }
        for _ in 0..block {
            let number = input.number("the number of an element")?;
            element(input, draft, names, (element_type, number, tags))?;
        }
        read += u64::from(block.unsigned_abs());
    }
    Ok(())
}

/// Tags and nodes of one element. The first tag is its physical group, the second its entity.
fn element(
    input: &mut Input<'_>,
    draft: &mut Draft,
    names: &Names,
    (element_type, number, tags): (i32, u64, i32),
) -> Result<(), MeshFileError> {
    let mut first = [0; 2];
    for i in 0..tags.max(0) as usize {
        let tag = input.int("a tag of an element")?;
        if let Some(slot) = first.get_mut(i) {
            *slot = tag;
        }
    }
    let [physical, entity] = first;
    let membership = Membership {
        entity,
        physical: &[physical],
        names,
    };
    draft.element(input, (element_type, number), membership, |input| {
        input.number("a node of an element")
    })
}
