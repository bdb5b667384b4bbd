//! Detents: a weak force to the nearest of evenly spaced places.

/// Newtons to the nearest whole `level`, at most `force`, and joules that are kept in it.
///
/// Linear (paper, section 4.2) from a detent to a quarter of the way to the next one and falling to
/// zero half-way, where the next one begins to pull: it makes no step, and has a potential.
pub(super) fn detent(level: f64, pitch: f64, force: f64) -> (f64, f64) {
    let beside = level - level.round();
    let (share, left) = (beside.abs(), 0.5 - beside.abs());
    let pull = if share <= 0.25 { share / 0.25 } else { left / 0.25 };
    // The triangle's area up to here.
    let area =
        if share <= 0.25 { 0.5 * share * share / 0.25 } else { 0.25 - 0.5 * left * left / 0.25 };
    (-force * pull.copysign(beside), force * pitch * area)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn it_pulls_to_whole_levels_and_is_still_between_them() {
        for level in [-3.0, 0.0, 7.0] {
            assert_eq!(detent(level, 0.02, 0.4).0, 0.0);
            assert_eq!(detent(level + 0.5, 0.02, 0.4).0, 0.0);
            assert!((detent(level + 0.25, 0.02, 0.4).0 + 0.4).abs() < 1e-12);
            assert!((detent(level - 0.125, 0.02, 0.4).0 - 0.2).abs() < 1e-12);
        }
    }

    #[test]
    fn its_energy_has_no_step_where_its_force_turns() {
        for (level, share) in [(0.25, 0.125), (0.5, 0.25), (0.75, 0.125), (1.0, 0.0)] {
            for beside in [-1e-9, 0.0, 1e-9] {
                let energy = detent(level + beside, 0.02, 0.4).1;
                assert!((energy - 0.4 * 0.02 * share).abs() < 1e-10, "{level} {beside}: {energy}");
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn its_force_is_the_slope_of_its_energy(level in -20.0f64..20.0, step in 1e-6f64..1e-3) {
            let (pitch, force) = (0.02, 0.4);
            let (before, after) = (detent(level, pitch, force), detent(level + step, pitch, force));
            let metres = step * pitch;
            let slope = (after.1 - before.1) / metres;
            let steepest = force / (0.25 * pitch);
            prop_assert!((slope + before.0).abs() <= steepest * metres + 1e-8, "{slope} {before:?}");
            prop_assert!((after.0 - before.0).abs() <= steepest * metres * (1.0 + 1e-6) + 1e-12);
        }
    }
}
