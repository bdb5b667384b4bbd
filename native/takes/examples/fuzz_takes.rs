//! Mutates takes' files and looks for panics, hangs and takes out of nothing.
//!
//! `cargo run --release --package takes --example fuzz_takes -- --seconds 600 [--seed N]`
//!
//! Every case is a small valid file with some damage: bits, bytes, numbers, pieces that are missing, twice
//! there or elsewhere, or an end at any place; in half of them the checksums are made right again, so that
//! what lies behind them is reached too. Errors are as good as takes; a panic, a case of more than two
//! seconds, or a take of more ticks than the file has bytes for is a finding.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

use takes::{Header, Spool, TICK_BYTES, Tick};

/// Longer is a hang: these files have some kilobytes.
const LONGEST: Duration = Duration::from_secs(2);

/// Files that are damaged again and again.
const WHOLE: usize = 100;

/// Before the text of a header, and before the ticks of a block.
const HEADER: usize = 52;
const BLOCK: usize = 24;

fn main() {
    let (mut seconds, mut seed) = (10, 1);
    let mut arguments = std::env::args().skip(1);
    while let (Some(name), Some(value)) = (arguments.next(), arguments.next()) {
        let number = value.parse().unwrap_or_else(|_| panic!("{name} {value} is no number"));
        match name.as_str() {
            "--seconds" => seconds = number,
            "--seed" => seed = number,
            _ => panic!("{name} is none of --seconds and --seed"),
        }
    }
    let folder = std::env::temp_dir().join(format!("fuzz-takes-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the cases");
    std::panic::set_hook(Box::new(|_| {}));
    let ending = Instant::now() + Duration::from_secs(seconds);
    let mut tally = Tally::default();
    let mut chance = Chance(seed);
    // The disk is waited for in each of them.
    let files: Vec<_> = (0..WHOLE).map(|_| whole(&folder.join("whole"), &mut chance)).collect();
    while Instant::now() < ending {
        let mut bytes = files[chance.below(WHOLE)].clone();
        for _ in 0..chance.below(4) {
            damage(&mut bytes, &mut chance);
        }
        if chance.below(2) == 0 {
            make_checksums_right(&mut bytes);
        }
        tally.run(&folder.join("case"), &bytes);
    }
    std::fs::remove_dir_all(&folder).expect("the folder of the cases");
    println!(
        "{} cases: {} takes with {} ticks, {} of them whole, {} errors, {} findings",
        tally.cases, tally.takes, tally.ticks, tally.whole, tally.errors, tally.findings
    );
    std::process::exit(i32::from(tally.findings > 0));
}

/// What came of it.
#[derive(Default)]
struct Tally {
    cases: u64,
    takes: u64,
    whole: u64,
    ticks: u64,
    errors: u64,
    findings: u64,
}

impl Tally {
    fn run(&mut self, path: &Path, bytes: &[u8]) {
        // Some systems write a file that is cut and filled anew to the disk at once.
        let _ = std::fs::remove_file(path);
        std::fs::write(path, bytes).expect("a case is written");
        self.cases += 1;
        let start = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| takes::read(path)));
        let finding = match outcome {
            Err(_) => Some("panic"),
            Ok(_) if start.elapsed() > LONGEST => Some("hang"),
            Ok(Ok(saved)) if saved.take.ticks.len() > bytes.len() / TICK_BYTES => {
                Some("a take out of nothing")
            }
            Ok(Ok(saved)) => {
                self.takes += 1;
                self.ticks += saved.take.ticks.len() as u64;
                self.whole += u64::from(saved.finished && saved.lost.is_none());
                None
            }
            Ok(Err(_)) => {
                self.errors += 1;
                None
            }
        };
        if let Some(finding) = finding {
            self.findings += 1;
            let kept = std::env::temp_dir().join(format!("finding-{}.touch", self.findings));
            std::fs::write(&kept, bytes).expect("a finding is kept");
            println!("{finding}, kept as {}", kept.display());
        }
    }
}

/// A file of some blocks.
fn whole(path: &Path, chance: &mut Chance) -> Vec<u8> {
    let _ = std::fs::remove_file(path);
    let about = "{\"terrain\": \"\u{e5}\"}".repeat(chance.below(4));
    let header = Header { about, workspace: [0.16, 0.12, 0.12], pre_roll: chance.next() };
    let mut spool = Spool::create(path, &header).expect("a spool is made");
    let mut number = 0;
    for _ in 0..chance.below(4) {
        let ticks: Vec<Tick> = (0..1 + chance.below(6))
            .map(|_| {
                number += 1;
                let (feature, mode) = (chance.below(4) as u16, chance.below(3) as u16);
                Tick { number, time: number as f64, feature, mode, ..Tick::default() }
            })
            .collect();
        spool.write(&ticks, chance.next()).expect("ticks are written");
    }
    if chance.below(3) > 0 {
        spool.finish(number).expect("a spool is finished");
    }
    std::fs::read(path).expect("a spool is read")
}

fn damage(bytes: &mut Vec<u8>, chance: &mut Chance) {
    let length = bytes.len();
    if length == 0 {
        return;
    }
    let place = chance.below(length);
    match chance.below(8) {
        0 => bytes[place] ^= 1 << chance.below(8),
        1 => bytes[place] = chance.next() as u8,
        2 => bytes.truncate(place),
        3 => {
            // A number that is too large, or too small by one.
            let number = [u32::MAX, 0, 1, 8193, 1 << 20, (1 << 20) + 1][chance.below(6)];
            let end = length.min(place + 4);
            bytes[place..end].copy_from_slice(&number.to_le_bytes()[..end - place]);
        }
        4 => {
            let end = (place + chance.below(400)).min(length);
            bytes.drain(place..end);
        }
        5 => {
            let end = (place + chance.below(400)).min(length);
            bytes.extend_from_within(place..end);
        }
        6 => {
            let more: Vec<u8> = (0..chance.below(300)).map(|_| chance.next() as u8).collect();
            bytes.splice(place..place, more);
        }
        _ => {
            let other = chance.below(length);
            bytes.swap(place, other);
        }
    }
}

/// Of the header and of every block behind it, as far as lengths lead.
fn make_checksums_right(bytes: &mut [u8]) {
    let word = |bytes: &[u8], place: usize| {
        let four = bytes.get(place..place + 4)?;
        Some(u32::from_le_bytes(four.try_into().expect("four bytes are four")) as usize)
    };
    let Some(about) = word(bytes, HEADER - 4) else { return };
    let mut begin = 0;
    let mut end = HEADER.saturating_add(about);
    while end.checked_add(4).is_some_and(|after| after <= bytes.len()) {
        let checksum = crc32fast::hash(&bytes[begin..end]).to_le_bytes();
        bytes[end..end + 4].copy_from_slice(&checksum);
        begin = end + 4;
        let Some(ticks) = word(bytes, begin + 4) else { return };
        end = (begin + BLOCK).saturating_add(ticks.saturating_mul(TICK_BYTES));
    }
}

/// A xorshift generator: the same cases for the same seed.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }
}
