//! Words of the messages.

use crate::names::{listed, nearest};

pub(super) fn cell_word(dimension: usize) -> &'static str {
    match dimension {
        1 => "line",
        2 => "surface",
        _ => "volume",
    }
}

pub(super) fn group_word(dimension: usize) -> &'static str {
    match dimension {
        0 => "point",
        1 => "curve",
        2 => "surface",
        _ => "volume",
    }
}

pub(super) fn members_word(dimension: usize) -> &'static str {
    match dimension {
        0 => "points",
        1 => "lines",
        2 => "surface elements",
        _ => "volume elements",
    }
}

pub(super) fn found_cells([lines, surfaces, volumes]: [usize; 3]) -> String {
    match lines + surfaces + volumes {
        0 => "it has no elements at all".to_owned(),
        _ => format!("it has {volumes} volume, {surfaces} surface and {lines} line elements"),
    }
}

pub(super) fn no_cells_help(dimension: usize, found: [usize; 3]) -> &'static str {
    match (dimension, found) {
        (_, [0, 0, 0]) => {
            "was the mesh generated before it was saved, and are there physical groups or `Mesh.SaveAll = 1`?"
        }
        (3, _) => {
            "was the mesh generated in two dimensions only (`gmsh -2` for `gmsh -3`)? With physical groups, Gmsh saves the elements of groups only: \
             the volumes need one, or `Mesh.SaveAll = 1`"
        }
        _ => {
            "with physical groups, Gmsh saves the elements of groups only: the surfaces need one, or `Mesh.SaveAll = 1`"
        }
    }
}

pub(super) fn nearest_hint(name: &str, known: &[String]) -> String {
    match nearest(name, known.iter().map(String::as_str)) {
        Some(near) => format!("; did you mean `{near}`?"),
        None => String::new(),
    }
}

pub(super) fn known_groups(dimension: usize, known: &[String]) -> String {
    let names: Vec<&str> = known.iter().map(String::as_str).collect();
    match names.as_slice() {
        [] => format!("the file has no {} groups", group_word(dimension)),
        _ => format!(
            "its {} groups are {}",
            group_word(dimension),
            listed(&names)
        ),
    }
}
