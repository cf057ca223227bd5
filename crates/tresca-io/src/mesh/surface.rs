//! Rigid surfaces: faces without a body behind them.

use std::collections::HashMap;

use tresca_fem::mesh::CellKind;

use super::error::{MeshFault, MeshFileError};
use super::faces::side;
use super::file::MeshFile;
use super::order::{reorder, turned_over};
use super::placement::Placement;

/// A surface that does not deform; in the plane, a curve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SurfaceMesh {
    /// Coordinates (length); in the plane the third is 0.
    pub points: Vec<[f64; 3]>,
    /// Kind and points of each face. The normal ∂x/∂ξ₁ × ∂x/∂ξ₂ (in the plane: the tangent turned
    /// clockwise) points out of the solid side, to where bodies are.
    pub faces: Vec<(CellKind, Vec<usize>)>,
}

/// A face on its way.
struct Draft {
    /// The cell of the file that it comes from.
    cell: usize,
    kind: CellKind,
    nodes: Vec<usize>,
    /// Other way round than in the file.
    turned: bool,
}

impl MeshFile {
    /// The faces of a group, or all elements of one dimension less than the space has. No cells of a
    /// body are needed.
    ///
    /// Faces that hang together are made to have the same sides, whatever the file says: a closed
    /// surface has its normals outwards, an open one as most of its elements have them in the file.
    /// `flip` turns all of them over.
    ///
    /// `dimension` is that of the space: 3, or 2 for curves in the plane.
    ///
    /// # Errors
    /// [`MeshFault::NoCells`], [`MeshFault::UnknownGroup`],
    /// [`MeshFault::GroupDimension`], [`MeshFault::OffPlane`],
    /// [`MeshFault::Orientation`].
    pub fn surface(
        &self,
        dimension: usize,
        group: Option<&str>,
        placement: &Placement,
        flip: bool,
    ) -> Result<SurfaceMesh, MeshFileError> {
        let mut faces = self.drafts(dimension, group)?;
        self.orient(&mut faces, group)?;
        let mut numbers = vec![usize::MAX; self.points.len()];
        let (mut surface, mut used) = (
            SurfaceMesh {
                points: Vec::new(),
                faces: Vec::with_capacity(faces.len()),
            },
            Vec::new(),
        );
        let mut scratch = Vec::new();
        for mut face in faces {
            if face.turned != flip {
                reorder(turned_over(face.kind), &mut face.nodes, &mut scratch);
            }
            for node in &mut face.nodes {
                if numbers[*node] == usize::MAX {
                    numbers[*node] = used.len();
                    used.push(*node);
                    surface.points.push(placement.apply(self.points[*node]));
                }
                *node = numbers[*node];
            }
            surface.faces.push((face.kind, face.nodes));
        }
        if dimension == 2 {
            self.flatten(&mut surface.points, &used)?;
        }
        Ok(surface)
    }

    fn drafts(&self, dimension: usize, group: Option<&str>) -> Result<Vec<Draft>, MeshFileError> {
        let (cells, sides) = match group {
            Some(name) => {
                let group = self.group(name, dimension - 1)?;
                (group.cells.clone(), group.faces.as_slice())
            }
            None => (self.cells.of_dimension(dimension - 1).collect(), &[][..]),
        };
        let elements = cells
            .into_iter()
            .map(|cell| (cell, self.cells.kind(cell), self.cells.nodes(cell).to_vec()));
        let sides = sides.iter().map(|&of| {
            let (kind, nodes) = side(&self.cells, of);
            (of[0], kind, nodes)
        });
        let drafts: Vec<Draft> = elements
            .chain(sides)
            .map(|(cell, kind, nodes)| Draft {
                cell,
                kind,
                nodes,
                turned: false,
            })
            .collect();
        if drafts.is_empty() {
            let count = |dimension| self.cells.of_dimension(dimension).count();
            return Err(MeshFault::NoCells {
                dimension: dimension - 1,
                found: [count(1), count(2), count(3)],
            }
            .at(self.path.clone()));
        }
        Ok(drafts)
    }

    /// Gives all faces that hang together the same sides.
    fn orient(&self, faces: &mut [Draft], group: Option<&str>) -> Result<(), MeshFileError> {
        let fault = |face: &Draft, reason| {
            MeshFault::Orientation {
                group: group.map(str::to_owned),
                element: self.element(face.cell),
                reason,
            }
            .at(self.path.clone())
        };
        let mut edges: HashMap<[usize; 2], Vec<(usize, bool)>> = HashMap::new();
        for (i, face) in faces.iter().enumerate() {
            for (edge, forward) in rims(face) {
                let at = edges.entry(edge).or_default();
                at.push((i, forward));
                if at.len() > 2 {
                    return Err(fault(face, "three faces meet there"));
                }
            }
        }
        let mut reached = vec![false; faces.len()];
        for start in 0..faces.len() {
            if reached[start] {
                continue;
            }
            reached[start] = true;
            let (mut component, mut next, mut closed) = (vec![start], 0, true);
            while let Some(&i) = component.get(next) {
                next += 1;
                for (edge, forward) in rims(&faces[i]) {
                    let both = &edges[&edge];
                    let Some(&(other, theirs)) = both.iter().find(|(j, _)| *j != i) else {
                        closed = false;
                        continue;
                    };
                    // Neighbours go along their common edge in opposite directions.
                    let turned = faces[i].turned ^ (forward == theirs);
                    if !reached[other] {
                        reached[other] = true;
                        faces[other].turned = turned;
                        component.push(other);
                    } else if faces[other].turned != turned {
                        return Err(fault(&faces[other], "it has one side only"));
                    }
                }
            }
            let inwards = match closed {
                true => self.enclosed(faces, &component) < 0.0,
                false => {
                    let turned = component.iter().filter(|&&i| faces[i].turned).count();
                    2 * turned > component.len()
                }
            };
            if inwards {
                for &i in &component {
                    faces[i].turned = !faces[i].turned;
                }
            }
        }
        Ok(())
    }

    /// A multiple of the volume (in the plane: area) that closed faces enclose, by their corners;
    /// negative where their normals point inwards.
    fn enclosed(&self, faces: &[Draft], component: &[usize]) -> f64 {
        // Relative to a point of the surface, lest a far-away one drowns in rounding.
        let origin = self.points[faces[component[0]].nodes[0]];
        let place =
            |node: usize| -> [f64; 3] { std::array::from_fn(|i| self.points[node][i] - origin[i]) };
        let of_face = |face: &Draft| -> f64 {
            let corners = &face.nodes[..face.kind.corner_count()];
            let volume = match corners {
                &[a, b] => {
                    let (a, b) = (place(a), place(b));
                    a[0] * b[1] - a[1] * b[0]
                }
                _ => (1..corners.len() - 1)
                    .map(|i| {
                        let [a, b, c] = [corners[0], corners[i], corners[i + 1]].map(place);
                        a[0] * (b[1] * c[2] - b[2] * c[1])
                            + a[1] * (b[2] * c[0] - b[0] * c[2])
                            + a[2] * (b[0] * c[1] - b[1] * c[0])
                    })
                    .sum(),
            };
            if face.turned { -volume } else { volume }
        };
        component.iter().map(|&i| of_face(&faces[i])).sum()
    }
}

/// What a face shares with its neighbours, and whether it goes along it forwards: the edges of a
/// surface element, the ends of a line (entered at the first, left at the second).
fn rims(face: &Draft) -> Vec<([usize; 2], bool)> {
    let corners = &face.nodes[..face.kind.corner_count()];
    match corners {
        &[a, b] => vec![([a, a], false), ([b, b], true)],
        _ => (0..corners.len())
            .map(|i| {
                let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
                ([a.min(b), a.max(b)], a < b)
            })
            .collect(),
    }
}
