//! How a mass on a spring and a damper moves, exactly.

/// The exact motion of a damped spring over one step, as a linear map of offset and velocity:
/// the exponential of [[0, 1], [-stiffness / mass, -damping / mass]] times the step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    offset_from_offset: f64,
    offset_from_velocity: f64,
    velocity_from_offset: f64,
    velocity_from_velocity: f64,
}

impl Motion {
    /// Of `mass` kilograms on a spring of `stiffness` N/m and a damper of `damping` N s/m, over `dt`
    /// seconds.
    pub(crate) fn over(mass: f64, stiffness: f64, damping: f64, dt: f64) -> Motion {
        let decay = damping / (2.0 * mass); // 1/s
        let spring = stiffness / mass; // 1/s^2
        let discriminant = decay * decay - spring;
        // `even` and `odd` are exp(-decay dt) times cosh(s dt) and sinh(s dt) / s, with s the root
        // of the discriminant; for an imaginary s these are cos and sin.
        let (even, odd) = if discriminant > 0.0 {
            let root = discriminant.sqrt();
            // decay - root, without the cancellation in a strongly damped hand.
            let slow = spring / (decay + root);
            let slow_part = (-slow * dt).exp();
            let fast_part = (-(decay + root) * dt).exp();
            let odd = -slow_part * (-2.0 * root * dt).exp_m1() / (2.0 * root);
            (0.5 * (slow_part + fast_part), odd)
        } else if discriminant < 0.0 {
            let frequency = (-discriminant).sqrt();
            let envelope = (-decay * dt).exp();
            let (sine, cosine) = (frequency * dt).sin_cos();
            (envelope * cosine, envelope * sine / frequency)
        } else {
            let envelope = (-decay * dt).exp();
            (envelope, envelope * dt)
        };
        Motion {
            offset_from_offset: even + decay * odd,
            offset_from_velocity: odd,
            velocity_from_offset: -spring * odd,
            velocity_from_velocity: even - decay * odd,
        }
    }

    /// Offset (metres) and velocity (m/s) after the step.
    pub(crate) fn apply(&self, offset: f64, velocity: f64) -> (f64, f64) {
        (
            self.offset_from_offset * offset + self.offset_from_velocity * velocity,
            self.velocity_from_offset * offset + self.velocity_from_velocity * velocity,
        )
    }
}
