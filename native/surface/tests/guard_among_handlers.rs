//! SIGBUS handlers before, after and beside the guard's own. Every test runs in a process of its
//! own: a handler belongs to the whole process, and some of these end it.
#![cfg(all(target_os = "linux", target_env = "gnu"))]

use std::fs::File;
use std::os::fd::AsRawFd;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, exit};
use std::sync::atomic::{AtomicBool, Ordering};
use surface::{ByteOrder, Grid, GridLayout, SampleType};

/// Names the test that a process was started for.
const CHILD: &str = "HAPTIC_TERRAIN_TEST_IN_CHILD";

/// What the handlers here end their process with.
const FAULT_HANDED_OVER: i32 = 42;
const ERRNO_CHANGED: i32 = 43;
const FAULT_OF_A_GRID: i32 = 44;

const ERRNO: i32 = 77;

/// Whether the next fault is not a grid's.
static ELSEWHERE: AtomicBool = AtomicBool::new(false);

/// Runs `body` in another process, which begins this test anew, and says how that ended.
fn in_a_process_of_its_own(test: &str, body: impl FnOnce()) -> ExitStatus {
    if std::env::var_os(CHILD).is_some_and(|name| name == test) {
        set_limit(libc::RLIMIT_CORE, 0);
        body();
        exit(0);
    }
    let program = std::env::current_exe().unwrap();
    let child = Command::new(program).args(["--exact", test]).env(CHILD, test).output().unwrap();
    println!("{}", String::from_utf8_lossy(&child.stdout));
    child.status
}

fn set_limit(resource: libc::__rlimit_resource_t, most: libc::rlim_t) {
    // SAFETY: plain system calls on a local structure.
    unsafe {
        let mut limit: libc::rlimit = std::mem::zeroed();
        libc::getrlimit(resource, &mut limit);
        limit.rlim_cur = most;
        assert_eq!(libc::setrlimit(resource, &limit), 0);
    }
}

type Handler = extern "C" fn(libc::c_int, *mut libc::siginfo_t, *mut libc::c_void);

fn handle_bus_errors(handler: Handler) {
    // SAFETY: the handler has the type that SA_SIGINFO declares, and only ends the process.
    unsafe {
        let mut action: libc::sigaction = std::mem::zeroed();
        action.sa_sigaction = handler as usize;
        action.sa_flags = libc::SA_SIGINFO;
        assert_eq!(libc::sigaction(libc::SIGBUS, &action, std::ptr::null_mut()), 0);
    }
}

extern "C" fn end(_: libc::c_int, _: *mut libc::siginfo_t, _: *mut libc::c_void) {
    let elsewhere = ELSEWHERE.load(Ordering::Relaxed);
    // SAFETY: ends the process at once.
    unsafe { libc::_exit(if elsewhere { FAULT_HANDED_OVER } else { FAULT_OF_A_GRID }) }
}

extern "C" fn end_by_errno(_: libc::c_int, _: *mut libc::siginfo_t, _: *mut libc::c_void) {
    // SAFETY: errno is always readable; ends the process at once.
    unsafe {
        let kept = *libc::__errno_location() == ERRNO;
        libc::_exit(if kept { FAULT_HANDED_OVER } else { ERRNO_CHANGED })
    }
}

/// A file of 4 x 1024 samples, two pages, all 7.
fn samples(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let bytes: Vec<u8> = (0..4 * 1024).flat_map(|_| 7i16.to_be_bytes()).collect();
    std::fs::write(&path, bytes).unwrap();
    path
}

fn open(path: &Path) -> Grid {
    let layout = GridLayout::packed(4, 1024, 1.0, 1.0, SampleType::I16, ByteOrder::Big).unwrap();
    Grid::open(path, layout).unwrap()
}

fn cut(path: &Path) {
    File::options().write(true).open(path).unwrap().set_len(0).unwrap();
}

/// Where a file is mapped, as the kernel says it.
fn mapped_at(path: &Path) -> usize {
    let path = path.canonicalize().unwrap();
    let maps = std::fs::read_to_string("/proc/self/maps").unwrap();
    let line = maps.lines().find(|line| line.ends_with(path.to_str().unwrap())).unwrap();
    usize::from_str_radix(line.split('-').next().unwrap(), 16).unwrap()
}

/// Reads a mapping of somebody else's whose file was cut. Where `address` is 0, the kernel chooses.
fn fault_elsewhere(name: &str, address: usize) {
    let path = samples(name);
    let file = File::open(&path).unwrap();
    // SAFETY: a new mapping that replaces none; the read either faults or gives a byte.
    unsafe {
        let fixed = if address == 0 { 0 } else { libc::MAP_FIXED_NOREPLACE };
        let (protection, flags) = (libc::PROT_READ, libc::MAP_PRIVATE | fixed);
        let wanted = address as *mut libc::c_void;
        let mapping = libc::mmap(wanted, 8192, protection, flags, file.as_raw_fd(), 0);
        assert_ne!(mapping, libc::MAP_FAILED);
        assert!(address == 0 || mapping == wanted);
        cut(&path);
        ELSEWHERE.store(true, Ordering::Relaxed);
        mapping.cast::<u8>().read_volatile();
    }
}

#[test]
fn a_grid_is_guarded_though_another_handler_was_put_in_front_since() {
    let test = "a_grid_is_guarded_though_another_handler_was_put_in_front_since";
    let status = in_a_process_of_its_own(test, || {
        let _first = open(&samples("guarded_before.i16"));
        handle_bus_errors(end);
        let path = samples("guarded_after.i16");
        let grid = open(&path);
        cut(&path);
        assert_eq!(grid.elevation(3, 3), Some(0.0));
        assert!(grid.damaged());
        fault_elsewhere("not_a_grid.i16", 0);
    });
    assert_eq!(status.code(), Some(FAULT_HANDED_OVER), "the other handler gets what is its own");
}

#[test]
fn where_a_grid_was_a_fault_is_no_longer_the_guards() {
    let test = "where_a_grid_was_a_fault_is_no_longer_the_guards";
    let status = in_a_process_of_its_own(test, || {
        let path = samples("grid_that_is_gone.i16");
        let grid = open(&path);
        assert_eq!(grid.elevation(3, 3), Some(7.0));
        let address = mapped_at(&path);
        drop(grid);
        fault_elsewhere("in_its_place.i16", address);
    });
    assert_eq!(status.signal(), Some(libc::SIGBUS), "{status:?}");
}

#[test]
fn a_fault_that_cannot_be_mended_is_handed_over_with_errno_as_it_was() {
    let test = "a_fault_that_cannot_be_mended_is_handed_over_with_errno_as_it_was";
    let status = in_a_process_of_its_own(test, || {
        handle_bus_errors(end_by_errno);
        let path = samples("cannot_be_mended.i16");
        let grid = open(&path);
        cut(&path);
        // Less than the process has already: no page can be put anywhere.
        set_limit(libc::RLIMIT_AS, 4096);
        // SAFETY: errno is always writable.
        unsafe { *libc::__errno_location() = ERRNO };
        grid.elevation(3, 3);
    });
    assert_eq!(status.code(), Some(FAULT_HANDED_OVER), "{status:?}");
}
