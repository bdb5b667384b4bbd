//! A file that is cut while its terrain is touched.

#![cfg(unix)]

mod common;

use std::fs::File;
use std::path::PathBuf;
use std::sync::Arc;

use common::*;
use servo::{Fault, Session, Settings};
use surface::{ByteOrder, Grid, GridLayout, SampleType};

fn mapped_flat_ground(name: &str) -> (PathBuf, Arc<Grid>) {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let layout =
        GridLayout::packed(SIDE.into(), SIDE.into(), 1.0, 1.0, SampleType::F64, ByteOrder::Little)
            .unwrap();
    std::fs::write(&path, vec![0u8; (SIDE * SIDE * 8) as usize]).unwrap();
    let grid = Grid::open(&path, layout).unwrap();
    (path, Arc::new(grid))
}

fn press_on(grid: Arc<Grid>, log: &Log) -> Session {
    let device = Box::new(Watched::pressing(log));
    Session::new(grid, device, proxy_graph(), window(), Settings::default()).unwrap()
}

#[test]
fn stepping_on_a_cut_file_ends_touch_with_words_and_zero_force() {
    let (path, grid) = mapped_flat_ground("cut_while_stepped.f64");
    let log = Log::default();
    let mut session = press_on(grid, &log);
    session.step(10).unwrap();
    assert!(log.last_force()[2] > 0.0);
    File::options().write(true).open(&path).unwrap().set_len(0).unwrap();
    let error = session.step(10).unwrap_err();
    assert!(error.to_string().contains("cut while in use"), "{error}");
    assert_eq!(session.fault(), Some(&Fault::GridDamaged));
    assert_eq!(log.last_force(), [0.0; 3]);
}

#[test]
fn a_cut_file_ends_a_live_session() {
    let (path, grid) = mapped_flat_ground("cut_while_live.f64");
    let log = Log::default();
    let mut session = press_on(grid, &log);
    session.start().unwrap();
    wait_until(|| log.pushes());
    File::options().write(true).open(&path).unwrap().set_len(0).unwrap();
    wait_until(|| !session.running());
    assert_eq!(session.fault(), Some(&Fault::GridDamaged));
    assert_eq!(log.last_force(), [0.0; 3]);
}
