//! What fields and facts are called. A name means the same in every file that has it.

/// Displacement of a node; on bodies.
pub const DISPLACEMENT: &str = "displacement";
/// Stress averaged to the nodes: xx, yy, zz, xy, yz, xz; on bodies.
pub const STRESS: &str = "stress";
/// Von Mises stress of the same.
pub const VON_MISES_STRESS: &str = "von_mises_stress";
/// What a support puts on a node; on bodies.
pub const REACTION: &str = "reaction";
/// Contact force on a node, all contacts together; on bodies.
pub const CONTACT_FORCE: &str = "contact_force";
/// Force along the normal per area, positive in compression; on bodies and on contact points.
pub const CONTACT_PRESSURE: &str = "contact_pressure";
/// Tangential traction on a body.
pub const CONTACT_TRACTION: &str = "contact_traction";
/// Gap left at a node; on bodies.
pub const CONTACT_GAP: &str = "contact_gap";
/// 0 no contact point, 1 open, 2 sticking, 3 slipping; on bodies.
pub const CONTACT_STATUS: &str = "contact_status";
/// A motion that nothing resists, its largest entry 1; on bodies.
pub const UNRESISTED_MOTION: &str = "unresisted_motion";
/// Components of a node that supports hold, as bits: 1 x, 2 y, 4 z; on checked bodies.
pub const HELD_COMPONENTS: &str = "held_components";
/// Load on a node; on checked bodies.
pub const LOAD: &str = "load";

/// Number of the contact in the case, from 0; on contact points.
pub const PAIR: &str = "pair";
/// Unit normal, from the slave outwards; on contact points.
pub const NORMAL: &str = "normal";
/// Force along the normal, positive in compression.
pub const NORMAL_FORCE: &str = "normal_force";
/// Force in the tangential plane, in the directions of the axes.
pub const TANGENTIAL_FORCE: &str = "tangential_force";
/// The same per area.
pub const TANGENTIAL_TRACTION: &str = "tangential_traction";
/// Largest tangential force that the law allows.
pub const SLIP_BOUND: &str = "slip_bound";
/// Distance along the normal after deformation; 0 when closed.
pub const GAP: &str = "gap";
/// Relative tangential displacement, slave minus master, since the start.
pub const SLIP: &str = "slip";
/// The same since the step before: what friction acts on.
pub const SLIP_INCREMENT: &str = "slip_increment";
/// Whether the point carries a normal force.
pub const CLOSED: &str = "closed";
/// Whether the tangential force is below the slip bound.
pub const STICKING: &str = "sticking";
/// Both in one number: 0 open, 1 sticking, 2 slipping.
pub const STATUS: &str = "status";
/// Number of the friction law; a fact of the same name says what the numbers mean.
pub const FRICTION_LAW: &str = "friction_law";
/// Area that belongs to a contact point; on checked contacts.
pub const AREA: &str = "area";
