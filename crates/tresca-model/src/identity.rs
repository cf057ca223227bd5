//! What a load step changes and what a report speaks of, by identity.

macro_rules! identities {
    ($($(#[$doc:meta])* $id:ident => $list:ident,)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $id(
            #[doc = concat!("Its index in [`Model::", stringify!($list), "`](crate::Model::", stringify!($list), ").")]
            pub usize,
        );
    )*};
}

identities! {
    /// A support of a model.
    SupportId => supports,
    /// A load of a model.
    LoadId => loads,
    /// An obstacle of a model.
    ObstacleId => obstacles,
    /// A contact of a model.
    ContactId => contacts,
}

/// What load steps may change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Quantity {
    /// The displacement that a support prescribes.
    Support(SupportId),
    /// A load.
    Load(LoadId),
    /// The motion of an obstacle.
    Motion(ObstacleId),
    /// The slip bounds of a contact.
    SlipBound(ContactId),
}

/// A part of a [`Model`](crate::Model), so that whoever wrote the model can be pointed at the place where it stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Subject {
    /// The model as a whole.
    Model,
    /// A body, by its index.
    Body(usize),
    /// A support.
    Support(SupportId),
    /// A load.
    Load(LoadId),
    /// An obstacle.
    Obstacle(ObstacleId),
    /// A contact.
    Contact(ContactId),
    /// A load step, by its index.
    Step(usize),
}

macro_rules! parts {
    ($($id:ident: $quantity:ident, $subject:ident;)*) => {
        $(
            impl From<$id> for Quantity {
                fn from(id: $id) -> Self {
                    Quantity::$quantity(id)
                }
            }

            impl From<$id> for Subject {
                fn from(id: $id) -> Self {
                    Subject::$subject(id)
                }
            }
        )*

        impl From<Quantity> for Subject {
            fn from(quantity: Quantity) -> Self {
                match quantity {
                    $(Quantity::$quantity(id) => Subject::$subject(id),)*
                }
            }
        }
    };
}

parts! {
    SupportId: Support, Support;
    LoadId: Load, Load;
    ObstacleId: Motion, Obstacle;
    ContactId: SlipBound, Contact;
}
