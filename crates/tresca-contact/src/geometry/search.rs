//! Which facets lie in front of a facet.

use rstar::{AABB, Envelope, RTree, RTreeObject, SelectionFunction};

use tresca_fem::vector3::{dot, norm};

use super::facet::Facet;

/// Facets count as facing each other when the cosine between their normals is below this. Surfaces
/// that are 17° from perpendicular have next to no area in each other's projection.
pub(crate) const FACING: f64 = -0.3;

/// A facet as a ball.
struct Ball {
    facet: usize,
    center: [f64; 3],
    normal: [f64; 3],
    radius: f64,
}

impl RTreeObject for Ball {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> Self::Envelope {
        let corner = |sign: f64| self.center.map(|x| x + sign * self.radius);
        AABB::from_corners(corner(-1.0), corner(1.0))
    }
}

/// How far in front of a surface, and behind it, another one is looked for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    given: Option<f64>,
    least: f64,
}

impl Reach {
    /// The share of a surface's size within which another one is a partner by default.
    pub const SHARE_OF_SURFACE: f64 = 0.1;

    /// `given`, or for each two facets the larger of their sizes and the share of the surface's
    /// diagonal.
    pub fn new(given: Option<f64>, diagonal: f64) -> Self {
        let least = Self::SHARE_OF_SURFACE * diagonal;
        Self { given, least }
    }

    /// For facets with these radii.
    pub fn between(&self, a: f64, b: f64) -> f64 {
        self.given
            .unwrap_or_else(|| self.least.max(2.0 * a).max(2.0 * b))
    }
}

/// A bounding-volume hierarchy of facets.
pub(crate) struct FacetTree {
    tree: RTree<Ball>,
    largest: f64,
}

impl FacetTree {
    /// The hierarchy of the given facets.
    pub fn new(facets: &[Facet]) -> Self {
        let balls = facets.iter().enumerate().map(|(facet, f)| Ball {
            facet,
            center: f.center,
            normal: f.normal,
            radius: f.radius,
        });
        let tree = RTree::bulk_load(balls.collect());
        let largest = facets.iter().map(|facet| facet.radius).fold(0.0, f64::max);
        Self { tree, largest }
    }

    /// Facets that may have a part within reach of `facet` along its normal, ascending.
    pub fn candidates(&self, facet: &Facet, reach: Reach) -> Vec<usize> {
        let largest = self.largest;
        let cylinder = Cylinder {
            facet,
            reach,
            largest,
        };
        let found = self.tree.locate_with_selection_function(cylinder);
        let mut found: Vec<usize> = found.map(|ball| ball.facet).collect();
        found.sort_unstable();
        found
    }
}

/// The space in front of a facet and behind it: around its ball, along its normal.
struct Cylinder<'a> {
    facet: &'a Facet,
    reach: Reach,
    largest: f64,
}

impl Cylinder<'_> {
    /// May a ball meet the cylinder?
    fn meets(&self, center: [f64; 3], radius: f64, reach: f64) -> bool {
        let offset: [f64; 3] = std::array::from_fn(|k| center[k] - self.facet.center[k]);
        let axial = dot(self.facet.normal, offset);
        let radial: [f64; 3] = std::array::from_fn(|k| offset[k] - axial * self.facet.normal[k]);
        let size = self.facet.radius + radius;
        axial.abs() <= reach + size && norm(radial) <= size
    }
}

impl SelectionFunction<Ball> for Cylinder<'_> {
    fn should_unpack_parent(&self, envelope: &AABB<[f64; 3]>) -> bool {
        let center = envelope.center();
        let upper = envelope.upper();
        let radius = norm(std::array::from_fn(|k| upper[k] - center[k]));
        let reach = self.reach.between(self.facet.radius, self.largest);
        self.meets(center, radius, reach)
    }

    fn should_unpack_leaf(&self, ball: &Ball) -> bool {
        let reach = self.reach.between(self.facet.radius, ball.radius);
        dot(self.facet.normal, ball.normal) < FACING && self.meets(ball.center, ball.radius, reach)
    }
}
