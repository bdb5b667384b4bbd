//! Hands from soft to stiff, to hold a simulated device with.

use crate::Hand;

/// How a device is held.
///
/// A mass on a spring and a damper is how a hand answers a force in the first tenth of a second,
/// before the person reacts (Hajian and Howe, "Identification of the mechanical impedance at the
/// human finger tip", 1997; Hasser and Cutkosky, "System identification of the human hand grasping
/// a haptic knob", 2002). Stiffness and damping rise with the force of the grip, mass hardly does.
/// The numbers are round ones in the ranges that such studies give: people differ by factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// One finger resting on the handle: some grams and some hundred N/m (Hajian and Howe).
    Finger,
    /// A relaxed hand at the end of a relaxed arm: 0.55 kg, 6.5 N s/m and 135 N/m were fitted to one
    /// (van Beek et al., "Haptic perception of force magnitude and its relation to postural arm
    /// dynamics in 3D", 2015).
    Arm,
    /// A handle held in a relaxed precision grip, the default of [`Hand`].
    Relaxed,
    /// A handle held as firmly as one can.
    Stiff,
}

impl Grip {
    /// From the lightest hand to the stiffest.
    pub const ALL: [Grip; 4] = [Grip::Finger, Grip::Arm, Grip::Relaxed, Grip::Stiff];

    /// In small letters.
    pub fn name(self) -> &'static str {
        match self {
            Grip::Finger => "finger",
            Grip::Arm => "arm",
            Grip::Relaxed => "relaxed",
            Grip::Stiff => "stiff",
        }
    }

    /// The numbers of such a hand, without a device's share in them.
    pub fn hand(self) -> Hand {
        let of = |mass, muscle_stiffness, damping| Hand {
            mass,
            muscle_stiffness,
            damping,
            ..Hand::default()
        };
        match self {
            Grip::Finger => of(0.006, 200.0, 2.0),
            Grip::Arm => of(0.55, 135.0, 6.5),
            Grip::Relaxed => of(0.1, 300.0, 8.0),
            Grip::Stiff => of(0.2, 1500.0, 20.0),
        }
    }
}
