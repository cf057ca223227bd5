//! What of a model a report speaks of, so that a door can point at the place that it came from.

/// A part of a [`Model`](crate::Model), by its index there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Subject {
    /// The model as a whole.
    Model,
    /// A body.
    Body(usize),
    /// A support.
    Support(usize),
    /// A load.
    Load(usize),
    /// An obstacle.
    Obstacle(usize),
    /// A contact.
    Contact(usize),
    /// A load step.
    Step(usize),
}
