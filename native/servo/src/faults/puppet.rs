//! A contact model that can be told to fail.

use std::panic::resume_unwind;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

use contact::{Contact, ContactModel, Feature, Proxy};
use surface::{Grid, GridPoint, Metric};

/// What a puppet shall do in the next update.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Order {
    /// As long as nothing else is said.
    Behave = 0,
    Panic,
    LoseProxy,
    /// Say that the proxy is higher than it is.
    Jump,
}

/// How a puppet is told.
#[derive(Clone, Default)]
pub(super) struct Strings(Arc<AtomicU8>);

impl Strings {
    pub(super) fn pull(&self, order: Order) {
        self.0.store(order as u8, Ordering::Relaxed);
    }
}

/// Metres of ground by which a proxy jumps: 5 cm of workspace.
const JUMP: f64 = 5.0;

/// Does as its model does, or as it is told.
pub(super) struct Puppet {
    model: Box<dyn ContactModel>,
    strings: Strings,
}

impl Puppet {
    /// A puppet that may hang on the strings of another one.
    pub(super) fn on(model: Box<dyn ContactModel>, strings: Strings) -> Puppet {
        Puppet { model, strings }
    }

    fn is_told(&self, order: Order) -> bool {
        self.strings.0.load(Ordering::Relaxed) == order as u8
    }
}

impl ContactModel for Puppet {
    fn name(&self) -> &'static str {
        "puppet"
    }

    fn proxy(&self) -> Proxy {
        self.model.proxy()
    }

    fn place(&mut self, goal: GridPoint) {
        self.model.place(goal);
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.model.take_over(proxy);
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        if self.is_told(Order::Panic) {
            // A panic without its message on the terminal.
            resume_unwind(Box::new("the puppet panics"));
        }
        let mut contact = self.model.update(grid, metric, goal);
        if self.is_told(Order::LoseProxy) {
            contact.proxy.elevation = f64::NAN;
            contact.feature = Feature::Face;
        }
        if self.is_told(Order::Jump) {
            contact.proxy.elevation += JUMP;
            contact.feature = Feature::Face;
        }
        contact
    }
}
