use super::*;
use proptest::prelude::*;

/// Of a spring: what planes yield, and rounding where they are as good as parallel.
const ROUNDING: f64 = 1e-5;

/// A fixed plane in the workspace.
#[derive(Clone, Copy, Debug)]
struct Plane {
    direction: [f64; 3],
    /// Metres from the origin.
    offset: f64,
}

fn push(planes: &[Plane], hand: [f64; 3]) -> [f64; 3] {
    let mut mix = Mix::new();
    for plane in planes {
        let push = plane.offset - dot(plane.direction, hand);
        mix.add(Contributor { direction: plane.direction, push });
    }
    mix.push()
}

fn difference(one: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| one[axis] - other[axis])
}

fn length(vector: [f64; 3]) -> f64 {
    dot(vector, vector).sqrt()
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = length(vector);
    vector.map(|part| part / length)
}

fn alone(direction: [f64; 3], push: f64) -> [f64; 3] {
    let mut mix = Mix::new();
    mix.add(Contributor { direction, push });
    mix.push()
}

fn any_direction() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0f64..1.0)
        .prop_filter("a direction", |vector| length(*vector) > 0.1)
        .prop_map(unit)
}

fn any_planes() -> impl Strategy<Value = Vec<Plane>> {
    let plane = (any_direction(), -0.01f64..0.01)
        .prop_map(|(direction, offset)| Plane { direction, offset });
    prop::collection::vec(plane, 1..=CONTRIBUTORS)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// A spring's force changes against the hand's motion, and by no more than its stiffness. That
    /// the change is firmly so holds in every direction at once, and says that there is no step.
    #[test]
    fn the_mix_is_in_no_direction_stiffer_than_one_spring_and_never_steps(
        planes in any_planes(), hand in prop::array::uniform3(-0.02f64..0.02),
        way in any_direction(), exponent in -6.0f64..-1.5,
    ) {
        let metres = 10f64.powf(exponent);
        let moved: [f64; 3] = std::array::from_fn(|axis| hand[axis] + metres * way[axis]);
        let change = difference(push(&planes, moved), push(&planes, hand));
        let along = dot(change, way) / metres;
        prop_assert!((-1.0 - ROUNDING..=ROUNDING).contains(&along), "{along} of the spring");
        let size = length(change) / metres;
        prop_assert!(size * size <= -along + ROUNDING, "{size} for {along}");
    }

    /// From the nearest point of a convex set every other of its points lies ahead: there is no other
    /// point of which that is true.
    #[test]
    fn it_is_the_smallest_push_that_gives_every_contributor_its_own(
        planes in any_planes(), point in prop::array::uniform3(-0.02f64..0.02),
        hand in prop::array::uniform3(-0.02f64..0.02),
    ) {
        // Planes that all have one point beyond them.
        let beyond = |plane: &Plane| {
            Plane { offset: dot(plane.direction, point) - plane.offset.abs(), ..*plane }
        };
        let planes: Vec<Plane> = planes.iter().map(beyond).collect();
        let pushed = push(&planes, hand);
        let ahead = dot(pushed, difference(difference(point, hand), pushed));
        prop_assert!(ahead >= -ROUNDING * dot(pushed, pushed), "{ahead} m^2");
        for plane in &planes {
            let missing = plane.offset - dot(plane.direction, hand) - dot(plane.direction, pushed);
            prop_assert!(missing < 1e-5, "{missing} m");
        }
    }

    #[test]
    fn one_contributor_gets_its_push_to_the_last_bit(
        direction in any_direction(), wish in -0.01f64..0.01,
    ) {
        let expected = direction.map(|part| part * wish.max(0.0));
        prop_assert_eq!(alone(direction, wish), expected);
        // Others that want nothing that they would not get anyway cost nothing.
        let mut mix = Mix::new();
        mix.add(Contributor { direction, push: wish });
        mix.add(Contributor { direction: direction.map(|part| -part), push: -1.0 });
        prop_assert_eq!(mix.push(), expected);
    }

    /// Around any loop that leaves the planes in place the spring gives back what it took.
    #[test]
    fn around_a_loop_no_energy_is_made(
        planes in any_planes(), corners in prop::array::uniform3(
            prop::array::uniform3(-0.02f64..0.02)),
    ) {
        const STEPS: u32 = 2000;
        let (mut energy, mut tolerance) = (0.0, 0.0);
        for side in 0..3 {
            let (from, to) = (corners[side], corners[(side + 1) % 3]);
            let step = difference(to, from).map(|part| part / f64::from(STEPS));
            // Of the sum over steps, at each of the kinks.
            tolerance += 4.0 * dot(step, step);
            for index in 0..STEPS {
                let share = f64::from(index) + 0.5;
                let hand = std::array::from_fn(|axis| from[axis] + share * step[axis]);
                energy += dot(push(&planes, hand), step);
            }
        }
        prop_assert!(energy.abs() <= tolerance, "{energy} of {tolerance}");
    }
}

#[test]
fn at_right_angles_pushes_add() {
    let mut mix = Mix::new();
    mix.add(Contributor { direction: [0.0, 0.0, 1.0], push: 0.003 });
    mix.add(Contributor { direction: [-1.0, 0.0, 0.0], push: 0.004 });
    for (part, expected) in mix.push().into_iter().zip([-0.004, 0.0, 0.003]) {
        assert!((part - expected).abs() < 1e-8, "{part} for {expected}");
    }
}

#[test]
fn along_the_same_direction_one_fades_as_the_other_grows() {
    let surface = 0.003;
    for tenth in 0..60 {
        let wall = 1e-4 * f64::from(tenth);
        let mut mix = Mix::new();
        mix.add(Contributor { direction: [1.0, 0.0, 0.0], push: surface });
        mix.add(Contributor { direction: [1.0, 0.0, 0.0], push: wall });
        assert_eq!(mix.push(), [surface.max(wall), 0.0, 0.0]);
    }
}

#[test]
fn planes_that_face_each_other_share_and_nothing_overflows() {
    let mut mix = Mix::new();
    mix.add(Contributor { direction: [1.0, 0.0, 0.0], push: 0.003 });
    mix.add(Contributor { direction: [-1.0, 0.0, 0.0], push: 0.001 });
    let [x, y, z] = mix.push();
    assert!((x - 0.001).abs() < 1e-8, "half of the difference, not {x}");
    assert_eq!((y, z), (0.0, 0.0));
}

#[test]
fn nothing_pushes_nothing() {
    assert_eq!(Mix::new().push(), [0.0; 3]);
}
