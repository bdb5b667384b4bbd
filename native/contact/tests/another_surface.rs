//! The models' trait is open: a surface that is no grid has a model behind the same trait.

use contact::{Contact, ContactModel, Counters, Feature, Touchable};

/// Everything under z = 0, in metres.
struct HalfSpace;

impl Touchable for HalfSpace {
    type Point = [f64; 3];
    type Metric = f64;
    type Proxy = [f64; 3];

    fn in_space(at: [f64; 3]) -> Option<[f64; 3]> {
        at.iter().all(|number| number.is_finite()).then_some(at)
    }
}

/// Straight up out of the half-space.
struct Upward {
    proxy: [f64; 3],
}

impl ContactModel<HalfSpace> for Upward {
    fn name(&self) -> &'static str {
        "upward"
    }

    fn proxy(&self) -> [f64; 3] {
        self.proxy
    }

    fn take_over(&mut self, proxy: [f64; 3]) {
        self.proxy = proxy;
    }

    fn update(&mut self, _: &HalfSpace, scale: &f64, goal: &[f64; 3]) -> Contact<[f64; 3]> {
        let depth = (-goal[2]).max(0.0);
        self.proxy = [goal[0], goal[1], goal[2] + depth];
        let feature = if depth > 0.0 { Feature::Face } else { Feature::Free };
        let displacement = [0.0, 0.0, depth * scale];
        Contact { proxy: self.proxy, feature, displacement, counters: Counters::default() }
    }
}

#[test]
fn a_surface_that_is_no_grid_is_touched_behind_the_same_trait() {
    let mut model: Box<dyn ContactModel<HalfSpace>> = Box::new(Upward { proxy: [0.0; 3] });
    model.place([1.0, 2.0, 3.0]);
    model.place([f64::NAN, 0.0, 0.0]);
    assert_eq!(model.proxy(), [1.0, 2.0, 3.0]);
    let contact = model.update(&HalfSpace, &0.01, &[1.0, 2.0, -0.5]);
    assert_eq!((contact.proxy, contact.feature), ([1.0, 2.0, 0.0], Feature::Face));
    assert_eq!((contact.distance(), contact.normal()), (0.005, [0.0, 0.0, 1.0]));
}
