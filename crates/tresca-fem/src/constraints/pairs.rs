//! Nodes that are images of each other: periodic and cyclic faces, the two sides of a cut.

use super::equation::{Dof, Equation};
use crate::error::FemError;
use crate::mesh::data::Mesh;
use crate::vector3::{cross, dot, norm, sub};

/// Images count as one place up to this part of the size of the box around the mesh.
const TOLERANCE: f64 = 1e-6;

/// Faces of a cell that repeats itself by a translation: u_a = u_b + Σ_k amount_k (x_a − x_b)_k for each pair
/// \[a, b\], a being dependent.
///
/// `stretch` names, for each direction k of the cell's mean displacement gradient ∂u/∂x_k, the `dimension`
/// dofs beyond the mesh that are its components; without it the faces move alike.
///
/// # Errors
/// [`FemError::NotImages`] when the pairs do not all have the same offset; [`FemError::Coupling`].
pub fn periodic(
    mesh: &Mesh,
    pairs: &[[usize; 2]],
    stretch: Option<&[Vec<Dof>]>,
) -> Result<Vec<Equation>, FemError> {
    check(mesh, pairs)?;
    let d = mesh.dimension();
    let offset = |&[a, b]: &[usize; 2]| sub(mesh.points[a], mesh.points[b]);
    let first = offset(&pairs[0]);
    let image = |b: usize| std::array::from_fn(|k| mesh.points[b][k] + first[k]);
    check_images(mesh, pairs, image)?;
    let gradient = |i: usize| {
        let of_direction = stretch.into_iter().flatten().zip(first);
        of_direction.map(move |(dofs, length)| (dofs[i], length))
    };
    let of_pair = |&[a, b]: &[usize; 2]| {
        (0..d).map(move |i| {
            let on = std::iter::once((Dof::new(b, i), 1.0)).chain(gradient(i));
            Equation::dependent(Dof::new(a, i), on)
        })
    };
    Ok(pairs.iter().flat_map(of_pair).collect())
}

/// The two cut faces of a sector that repeats itself by a rotation Q about an axis: u_a = Q u_b for each pair
/// \[a, b\], where a lies at Q b and is dependent. A node on the axis, paired with itself, is held across it.
///
/// `axis` is a point of the axis and its direction, `angle` in radians. In the plane the axis is z.
///
/// # Errors
/// [`FemError::NotImages`] for a pair that the rotation does not carry over, [`FemError::Coupling`].
pub fn cyclic(
    mesh: &Mesh,
    pairs: &[[usize; 2]],
    [point, direction]: [[f64; 3]; 2],
    angle: f64,
) -> Result<Vec<Equation>, FemError> {
    check(mesh, pairs)?;
    let d = mesh.dimension();
    let length = norm(direction);
    let axis = direction.map(|x| x / length);
    let finite = axis.iter().chain(&point).all(|x| x.is_finite()) && angle.is_finite();
    if !finite || (d == 2 && axis[2].abs() < 1.0 - TOLERANCE) {
        return Err(FemError::Coupling {
            nodes: 2 * pairs.len(),
            what: "turns about no axis of the space, or by no angle",
        });
    }
    let turned = |v: [f64; 3]| -> [f64; 3] {
        let (sine, cosine) = angle.sin_cos();
        let (along, across) = (dot(axis, v), cross(axis, v));
        // Rodrigues' formula.
        std::array::from_fn(|k| cosine * v[k] + sine * across[k] + (1.0 - cosine) * along * axis[k])
    };
    check_images(mesh, pairs, |b| {
        let image = turned(sub(mesh.points[b], point));
        std::array::from_fn(|k| point[k] + image[k])
    })?;
    let unit = |j: usize| std::array::from_fn(|k| if k == j { 1.0 } else { 0.0 });
    let columns: Vec<[f64; 3]> = (0..d).map(|j| turned(unit(j))).collect();
    let mut equations = Vec::with_capacity(d * pairs.len());
    for &[a, b] in pairs {
        if a == b {
            // u is a multiple of the axis.
            let largest = (0..3).fold(0, |l, k| if axis[k].abs() > axis[l].abs() { k } else { l });
            for i in (0..d).filter(|&i| i != largest) {
                let share = axis[i] / axis[largest];
                let on = (largest < d).then(|| (Dof::new(a, largest), share));
                equations.push(Equation::dependent(Dof::new(a, i), on));
            }
            continue;
        }
        for i in 0..d {
            let on = columns.iter().enumerate();
            let on = on.map(|(j, column)| (Dof::new(b, j), column[i]));
            equations.push(Equation::dependent(Dof::new(a, i), on));
        }
    }
    Ok(equations)
}

/// The two sides of a cut through a bolt: u_a = u_b − p n for each pair \[a, b\] at one place, a being dependent.
///
/// p, a dof beyond the mesh, is by how much the sides overlap along n, the direction out of the side of the
/// b: the shortening of the bolt. A load on p is the force of the bolt, a support of p locks its length.
///
/// # Errors
/// [`FemError::NotImages`] for a pair that is not at one place, [`FemError::Coupling`].
pub fn pretension(
    mesh: &Mesh,
    pairs: &[[usize; 2]],
    direction: [f64; 3],
    amount: Dof,
) -> Result<Vec<Equation>, FemError> {
    check(mesh, pairs)?;
    check_images(mesh, pairs, |b| mesh.points[b])?;
    let length = norm(direction);
    let normal = direction.map(|x| x / length);
    if !normal.iter().all(|x| x.is_finite()) {
        return Err(FemError::Coupling {
            nodes: 2 * pairs.len(),
            what: "pulls in no direction",
        });
    }
    let of_pair = |&[a, b]: &[usize; 2]| {
        (0..mesh.dimension()).map(move |i| {
            let on = [(Dof::new(b, i), 1.0), (amount, -normal[i])];
            Equation::dependent(Dof::new(a, i), on)
        })
    };
    Ok(pairs.iter().flat_map(of_pair).collect())
}

/// Are there pairs, and are their nodes in the mesh?
fn check(mesh: &Mesh, pairs: &[[usize; 2]]) -> Result<(), FemError> {
    let what = if pairs.is_empty() {
        "needs at least one pair"
    } else if pairs.iter().flatten().any(|&n| n >= mesh.node_count()) {
        "names nodes that are not in the mesh"
    } else {
        return Ok(());
    };
    Err(FemError::Coupling {
        nodes: 2 * pairs.len(),
        what,
    })
}

/// Does every first node lie at the image of its partner?
fn check_images(
    mesh: &Mesh,
    pairs: &[[usize; 2]],
    image: impl Fn(usize) -> [f64; 3],
) -> Result<(), FemError> {
    let size = mesh.bounding_box().diagonal();
    for &[node, partner] in pairs {
        let expected = image(partner);
        let distance = norm(sub(mesh.points[node], expected));
        if distance.is_nan() || distance > TOLERANCE * size {
            return Err(FemError::NotImages {
                node,
                partner,
                expected,
                distance,
            });
        }
    }
    Ok(())
}
