//! A take's file: what was written is read, and what is not whole is never taken for whole.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use takes::{Header, Loss, Reason, Spool, TICK_BYTES, Take, Tick, WriteError, claim, read, write};

/// A folder of a test's own, removed with all that is in it.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Scratch {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("takes-{}-{number}", std::process::id()));
        fs::create_dir(&path).unwrap();
        Scratch(path)
    }

    fn file(&self) -> PathBuf {
        self.0.join("take.touch")
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn header() -> Header {
    Header {
        about: "{\"terrain\": \"Kr\u{e5}ter\"}".into(),
        workspace: [0.16, 0.12, 0.1],
        pre_roll: 3,
    }
}

fn tick(number: u64) -> Tick {
    let time = number as f64 / 1000.0;
    Tick {
        number,
        time,
        hand: [0.01, -time, f64::MIN_POSITIVE],
        goal: [1e7 + time, -2.5, 0.1],
        proxy: [1e7 + time, -2.5, 0.2],
        force: [0.0, -0.0, time],
        twist: -1.5,
        window: [1e7, -2.0, 300.0, 1e6, 15.0, 0.25],
        normal: [0.0, 0.6, 0.8],
        buttons: u32::MAX,
        feature: (number % 4) as u16,
        mode: (number % 3) as u16,
    }
}

fn take(ticks: u64) -> Take {
    let mut take = Take::new(header(), Some(1));
    (1..=ticks).for_each(|number| take.push(tick(number)));
    take.miss_until(ticks + 8);
    take
}

fn ticks(take: &Take) -> Vec<Tick> {
    take.ticks.iter().copied().collect()
}

#[test]
fn what_was_written_is_read_to_the_bit() {
    let scratch = Scratch::new();
    for count in [0, 1, 8191, 8192, 8193, 20_000] {
        let take = take(count);
        write(&scratch.file(), &take).unwrap();
        let saved = read(&scratch.file()).unwrap();
        assert!(saved.finished && saved.lost.is_none());
        assert_eq!(saved.take.header, header());
        assert_eq!(saved.take.dropped, 7);
        assert_eq!(ticks(&saved.take), ticks(&take));
    }
    assert_eq!(scratch.names(), ["take.touch"]);
}

#[test]
fn a_spool_that_was_finished_is_a_whole_take() {
    let scratch = Scratch::new();
    let mut spool = Spool::create(&scratch.file(), &header()).unwrap();
    let take = take(2000);
    for part in ticks(&take).chunks(99) {
        spool.write(part, 0).unwrap();
    }
    assert_eq!(spool.ticks(), 2000);
    spool.finish(7).unwrap();
    drop(spool);
    let saved = read(&scratch.file()).unwrap();
    assert!(saved.finished && saved.lost.is_none());
    assert_eq!((ticks(&saved.take), saved.take.dropped), (ticks(&take), 7));
}

#[test]
fn a_spool_that_was_left_has_all_that_was_written() {
    let scratch = Scratch::new();
    let mut spool = Spool::create(&scratch.file(), &header()).unwrap();
    spool.write(&[tick(1), tick(2)], 0).unwrap();
    spool.write(&[tick(9)], 6).unwrap();
    drop(spool);
    let saved = read(&scratch.file()).unwrap();
    assert!(!saved.finished && saved.lost.is_none());
    assert_eq!((ticks(&saved.take), saved.take.dropped), (vec![tick(1), tick(2), tick(9)], 6));
}

/// Header, a block of two ticks, a block of one, closing block, with the place where each ends.
fn small(scratch: &Scratch) -> (Vec<u8>, [usize; 4]) {
    let mut spool = Spool::create(&scratch.file(), &header()).unwrap();
    let length = || fs::metadata(scratch.file()).unwrap().len() as usize;
    let begun = length();
    spool.write(&[tick(1), tick(2)], 0).unwrap();
    let two = length();
    spool.write(&[tick(3)], 0).unwrap();
    let three = length();
    spool.finish(0).unwrap();
    let ends = [begun, two, three, length()];
    drop(spool);
    (fs::read(scratch.file()).unwrap(), ends)
}

fn whole_ticks(ends: &[usize; 4], bytes: usize) -> usize {
    if bytes >= ends[2] {
        3
    } else if bytes >= ends[1] {
        2
    } else {
        0
    }
}

#[test]
fn a_file_cut_anywhere_is_read_to_its_last_whole_block() {
    let scratch = Scratch::new();
    let (bytes, ends) = small(&scratch);
    for length in 0..bytes.len() {
        fs::write(scratch.file(), &bytes[..length]).unwrap();
        let saved = match read(&scratch.file()) {
            Ok(saved) => saved,
            Err(error) => {
                assert!(length < ends[0], "{length}: {error}");
                match error.reason {
                    Reason::NotATake => assert_eq!(length, 0),
                    Reason::CutInHeader => assert!(length > 0),
                    other => panic!("{length}: {other}"),
                }
                continue;
            }
        };
        assert!(!saved.finished, "{length}");
        assert_eq!(saved.take.ticks.len(), whole_ticks(&ends, length), "{length}");
        let begun = ends.iter().rfind(|end| **end <= length).unwrap();
        let lost = (length > *begun).then_some(Loss::Cut((length - begun) as u64));
        assert_eq!(saved.lost, lost, "{length}");
    }
}

#[test]
fn a_byte_that_was_changed_anywhere_is_noticed() {
    let scratch = Scratch::new();
    let (bytes, ends) = small(&scratch);
    for place in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x10;
        fs::write(scratch.file(), &damaged).unwrap();
        match read(&scratch.file()) {
            Ok(saved) => {
                assert!(saved.lost.is_some(), "{place}");
                assert!(!saved.finished, "{place}");
                assert_eq!(saved.take.ticks.len(), whole_ticks(&ends, place), "{place}");
            }
            Err(error) => assert!(place < ends[0], "{place}: {error}"),
        }
    }
}

#[test]
fn a_block_that_is_missing_in_the_middle_is_noticed() {
    let scratch = Scratch::new();
    let (mut bytes, ends) = small(&scratch);
    bytes.drain(ends[0]..ends[1]);
    fs::write(scratch.file(), &bytes).unwrap();
    let saved = read(&scratch.file()).unwrap();
    assert_eq!(saved.take.ticks.len(), 0);
    assert_eq!(saved.lost, Some(Loss::Damaged((bytes.len() - ends[0]) as u64)));
}

#[test]
fn what_follows_the_end_is_told() {
    let scratch = Scratch::new();
    let (mut bytes, ends) = small(&scratch);
    bytes.extend_from_within(ends[0]..ends[1]);
    fs::write(scratch.file(), &bytes).unwrap();
    let saved = read(&scratch.file()).unwrap();
    assert!(saved.finished);
    assert_eq!(saved.take.ticks.len(), 3);
    assert_eq!(saved.lost, Some(Loss::Damaged((ends[1] - ends[0]) as u64)));
}

#[test]
fn lengths_in_a_file_are_not_believed() {
    let scratch = Scratch::new();
    let (bytes, ends) = small(&scratch);
    for (place, found) in [(48, "length of its text"), (12, "size of a tick")] {
        let mut wrong = bytes.clone();
        wrong[place..place + 4].copy_from_slice(&u32::MAX.to_le_bytes());
        fs::write(scratch.file(), &wrong).unwrap();
        let error = read(&scratch.file()).unwrap_err();
        assert!(error.to_string().contains(found), "{error}");
    }
    let mut wrong = bytes.clone();
    wrong[ends[0] + 4..ends[0] + 8].copy_from_slice(&u32::MAX.to_le_bytes());
    fs::write(scratch.file(), &wrong).unwrap();
    assert!(matches!(read(&scratch.file()).unwrap().lost, Some(Loss::Damaged(_))));
}

fn refusal(bytes: &[u8]) -> String {
    let scratch = Scratch::new();
    fs::write(scratch.file(), bytes).unwrap();
    let text = read(&scratch.file()).unwrap_err().to_string();
    assert!(text.starts_with(&scratch.file().display().to_string()), "{text}");
    text
}

#[test]
fn what_is_no_take_is_refused_in_words() {
    assert!(refusal(b"").contains("no take"));
    assert!(refusal(b"{\"json\": 1}").contains("no take"));
    let scratch = Scratch::new();
    let (mut bytes, _) = small(&scratch);
    bytes[8] = 2;
    assert!(refusal(&bytes).contains("version 2 of the format, expected 1"));
    assert!(refusal(&bytes[..11]).contains("cut within its header"));
    let missing = read(Path::new("/nowhere/take.touch")).unwrap_err();
    assert!(matches!(missing.reason, Reason::System(_)));
}

#[test]
fn a_file_that_is_there_is_not_spooled_over() {
    let scratch = Scratch::new();
    fs::write(scratch.file(), b"precious").unwrap();
    assert!(matches!(Spool::create(&scratch.file(), &header()), Err(WriteError::System(_))));
    assert_eq!(fs::read(scratch.file()).unwrap(), b"precious");
}

#[test]
fn a_text_that_is_too_long_leaves_no_file() {
    let scratch = Scratch::new();
    let long = Header { about: " ".repeat((1 << 20) + 1), ..header() };
    assert!(matches!(Spool::create(&scratch.file(), &long), Err(WriteError::About(_))));
    let take = Take::new(long, None);
    assert!(matches!(write(&scratch.file(), &take), Err(WriteError::About(_))));
    assert_eq!(scratch.names(), [""; 0]);
}

#[test]
fn a_take_that_cannot_be_written_leaves_nothing() {
    let scratch = Scratch::new();
    fs::create_dir(scratch.file()).unwrap();
    assert!(write(&scratch.file(), &take(10)).is_err());
    assert_eq!(scratch.names(), ["take.touch"]);
    assert!(write(&scratch.0.join("missing").join("take.touch"), &take(10)).is_err());
}

#[test]
fn a_take_that_is_being_recorded_is_not_claimed_and_one_that_was_left_is() {
    let scratch = Scratch::new();
    let mut spool = Spool::create(&scratch.file(), &header()).unwrap();
    spool.write(&[tick(1)], 0).unwrap();
    let error = claim(&scratch.file()).unwrap_err();
    assert!(matches!(error.reason, Reason::InUse), "{error}");
    assert_eq!(read(&scratch.file()).unwrap().take.ticks.len(), 1, "reading it harms nobody");
    drop(spool);
    let (saved, left) = claim(&scratch.file()).unwrap();
    assert_eq!(saved.take.ticks.len(), 1);
    assert!(matches!(claim(&scratch.file()).unwrap_err().reason, Reason::InUse));
    left.remove().unwrap();
    assert_eq!(scratch.names(), [""; 0]);
}

#[test]
fn a_file_has_as_many_bytes_for_a_tick_as_is_said() {
    let scratch = Scratch::new();
    let lengths = [0, 1, 2].map(|ticks| {
        write(&scratch.file(), &take(ticks)).unwrap();
        fs::metadata(scratch.file()).unwrap().len()
    });
    assert_eq!(lengths[2] - lengths[1], TICK_BYTES as u64);
    assert_eq!(TICK_BYTES, 188);
}
