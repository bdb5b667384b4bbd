//! The trial that the models stand at the extremes, on trial itself: it sees each broken promise.

mod common;

use common::trial::Trial;
use common::*;
use contact::{Contact, ContactModel, Counters, Feature, Place, Proxy, ProxyGraph};
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

/// A proxy graph that is called exact, and whose outcome is spoilt.
struct Spoilt<F> {
    inside: ProxyGraph,
    updates: u32,
    spoil: F,
}

/// What a fault changes: how many updates there were, and the outcome.
type Change = fn(u32, &mut Contact, &mut Proxy);

impl ContactModel for Spoilt<Change> {
    fn name(&self) -> &'static str {
        "surface_walk"
    }

    fn proxy(&self) -> Proxy {
        let mut proxy = self.inside.proxy();
        let mut contact = Contact {
            proxy: proxy.position,
            feature: proxy.place.feature(),
            displacement: [0.0; 3],
            counters: Counters::default(),
        };
        (self.spoil)(self.updates, &mut contact, &mut proxy);
        proxy
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.inside.take_over(proxy);
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        let mut contact = self.inside.update(grid, metric, goal);
        self.updates += 1;
        (self.spoil)(self.updates, &mut contact, &mut self.inside.proxy());
        contact
    }
}

/// Presses on flat ground, and holds the hand still; what the trial says.
fn verdict(spoil: Change, twin_spoil: Change) -> String {
    let grid = grid(40, 40, false, |_, _| 1.0);
    let spoilt = |spoil| -> Box<dyn ContactModel> {
        Box::new(Spoilt { inside: ProxyGraph::new(BUDGET), updates: 0, spoil })
    };
    let over = GridPoint::new(20.3, 20.1, 50.0);
    let models = [spoilt(spoil), spoilt(twin_spoil)];
    let mut trial = Trial::of(&grid, SQUARE, models, BUDGET, over);
    let goal = GridPoint::new(20.3, 20.1, -5.0);
    for goal in [over, goal, goal, goal, goal] {
        if let Err(broken) = trial.update(&goal) {
            return broken;
        }
    }
    "nothing is broken".to_owned()
}

fn assert_seen(words: &str, spoil: Change) {
    let verdict = verdict(spoil, spoil);
    assert!(verdict.contains(words), "{words}: {verdict}");
}

fn move_both(contact: &mut Contact, proxy: &mut Proxy, columns: f64, elevation: f64) {
    for position in [&mut contact.proxy, &mut proxy.position] {
        position.u = (position.u + columns).clamp(0.0, 1.0);
        position.elevation += elevation;
    }
}

#[test]
fn a_model_without_fault_passes() {
    assert_eq!(verdict(|_, _, _| (), |_, _, _| ()), "nothing is broken");
}

#[test]
fn each_broken_promise_is_seen() {
    assert_seen("not finite", |_, contact, proxy| {
        (contact.proxy.u, proxy.position.u) = (f64::NAN, f64::NAN);
    });
    assert_seen("two places", |_, contact, _| contact.proxy.elevation += 1.0);
    assert_seen("distance is not finite", |_, contact, _| contact.displacement[0] = f64::NAN);
    assert_seen("steps of 4096", |_, contact, _| contact.counters.faces += BUDGET);
    assert_seen("collision tests of", |_, contact, _| {
        contact.counters.collision_tests += 2 * BUDGET
    });
    assert_seen("under the surface", |_, contact, proxy| {
        if contact.feature != Feature::Free {
            move_both(contact, proxy, 0.0, -1e-6);
        }
    });
    assert_seen("under the surface", |_, contact, proxy| {
        contact.feature = Feature::Free;
        if proxy.position.elevation < 20.0 {
            move_both(contact, proxy, 0.0, -1.0);
        }
    });
    assert_seen("in the air", |_, contact, proxy| {
        if contact.feature != Feature::Free {
            move_both(contact, proxy, 0.0, 1e-6);
        }
    });
    assert_seen("is not on", |_, contact, proxy| {
        if contact.feature != Feature::Free {
            proxy.place = Place::Vertex { column: 3, row: 4 };
        }
    });
    assert_seen("the distance grew", |updates, contact, proxy| {
        if updates == 3 {
            move_both(contact, proxy, 0.3, 0.0);
        }
    });
    assert_seen("moved by a still hand", |updates, contact, proxy| {
        if updates == 5 {
            move_both(contact, proxy, f64::EPSILON, 0.0);
        }
    });
    assert_seen("no minimum", |_, contact, _| {
        if contact.feature != Feature::Free {
            contact.feature = Feature::Free;
        }
    });
}

#[test]
fn models_that_do_not_repeat_themselves_are_seen() {
    let verdict = verdict(|_, _, _| (), |_, contact, _| contact.displacement[2] *= 2.0);
    assert!(verdict.contains("a twin came to"), "{verdict}");
}
