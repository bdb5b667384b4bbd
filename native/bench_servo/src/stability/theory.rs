//! What theory says of the stiffest stable spring.

/// A hand and a device as one mass on a spring and a damper, and the servo that reads it.
#[derive(Clone, Copy, Debug)]
pub struct Plant {
    /// Kilograms.
    pub mass: f64,
    /// Of all that brakes, N s/m.
    pub damping: f64,
    /// Of the hand, N/m.
    pub stiffness: f64,
    /// Seconds from tick to tick.
    pub period: f64,
    /// Ticks from reading to pushing.
    pub delay: u32,
}

/// The most terms that the characteristic polynomial has: two of the plant, one, and the delay's.
const TERMS: usize = 8;

impl Plant {
    /// K < 2b/((1 + 2d)T): passive, hence stable with every passive hand (Colgate and Schenkel, 1997;
    /// the delay as in Diolaiti et al., 2006).
    pub fn passive_bound(&self) -> f64 {
        2.0 * self.damping / ((1.0 + 2.0 * f64::from(self.delay)) * self.period)
    }

    /// The stiffness at which this very plant, sampled and held, begins to swing: the smallest at
    /// which a root of its characteristic polynomial leaves the unit circle.
    pub fn exact_boundary(&self) -> f64 {
        let (mut stable, mut unstable) = (0.0, 100.0 * self.passive_bound());
        for _ in 0..60 {
            let middle = 0.5 * (stable + unstable);
            if self.is_stable(middle) { stable = middle } else { unstable = middle }
        }
        stable
    }

    /// Whether a spring of `stiffness` N/m that pushes both ways is stable.
    fn is_stable(&self, stiffness: f64) -> bool {
        let [[a, b, to_position], [c, d, to_speed], _] = self.transition();
        // z^delay (z^2 - trace z + determinant) + stiffness (position's answer to a held force).
        let mut polynomial = [0.0; TERMS];
        let delay = self.delay as usize;
        polynomial[delay] = a * d - b * c;
        polynomial[delay + 1] = -(a + d);
        polynomial[delay + 2] = 1.0;
        polynomial[0] += stiffness * (b * to_speed - d * to_position);
        polynomial[1] += stiffness * to_position;
        has_roots_inside_unit_circle(polynomial, delay + 2)
    }

    /// Position, speed and a held force after a period, from those before: the exponential of the
    /// equations of motion, by its series over a small part of the period and repeated squaring.
    fn transition(&self) -> [[f64; 3]; 3] {
        const HALVINGS: i32 = 20;
        let part = self.period / 2f64.powi(HALVINGS);
        let motion = [
            [0.0, part, 0.0],
            [
                -self.stiffness / self.mass * part,
                -self.damping / self.mass * part,
                part / self.mass,
            ],
            [0.0; 3],
        ];
        // Without the identity, which would swallow the digits of a small part.
        let mut change = motion;
        let mut term = motion;
        for order in 2..6 {
            term = product(term, motion).map(|row| row.map(|entry| entry / f64::from(order)));
            change = sum(change, term);
        }
        for _ in 0..HALVINGS {
            change = sum(sum(change, change), product(change, change));
        }
        sum(change, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    }
}

fn product(one: [[f64; 3]; 3], other: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            (0..3).map(|inner| one[row][inner] * other[inner][column]).sum()
        })
    })
}

fn sum(one: [[f64; 3]; 3], other: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| std::array::from_fn(|column| one[row][column] + other[row][column]))
}

/// The test of Schur and Cohn: the polynomial, lowest power first, is reduced degree by degree, and
/// its last coefficient must outweigh its first each time.
fn has_roots_inside_unit_circle(mut polynomial: [f64; TERMS], degree: usize) -> bool {
    for degree in (1..=degree).rev() {
        let (first, last) = (polynomial[0], polynomial[degree]);
        if first.abs() >= last.abs() {
            return false;
        }
        let ratio = first / last;
        let before = polynomial;
        for power in 0..degree {
            polynomial[power] = before[power + 1] - ratio * before[degree - 1 - power];
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plant(mass: f64, delay: u32) -> Plant {
        Plant { mass, damping: 2.0, stiffness: 0.0, period: 1e-3, delay }
    }

    #[test]
    fn a_heavy_mass_has_the_passive_bound() {
        for delay in 0..4 {
            let plant = plant(10.0, delay);
            let ratio = plant.exact_boundary() / plant.passive_bound();
            assert!((ratio - 1.0).abs() < 1e-3, "{delay} ticks late: {ratio}");
        }
    }

    #[test]
    fn a_damper_without_mass_has_the_textbooks_bounds() {
        // z - 1 + k = 0, z^2 - z + k = 0 and z^3 - z^2 + k = 0, with k = K T / b.
        for (delay, bound) in [(0, 2.0), (1, 1.0), (2, 0.5 * (5f64.sqrt() - 1.0))] {
            let plant = plant(1e-6, delay);
            let found = plant.exact_boundary() * plant.period / plant.damping;
            assert!((found / bound - 1.0).abs() < 2e-3, "{delay} ticks late: {found} for {bound}");
        }
    }

    #[test]
    fn roots_are_told_apart_by_the_circle() {
        let with_roots = |one: f64, other: f64| {
            let mut polynomial = [0.0; TERMS];
            polynomial[..3].copy_from_slice(&[one * other, -(one + other), 1.0]);
            has_roots_inside_unit_circle(polynomial, 2)
        };
        assert!(with_roots(0.999, -0.5));
        assert!(!with_roots(1.001, -0.5));
        assert!(!with_roots(0.2, -1.001));
    }
}
