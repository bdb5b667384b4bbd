//! Keeps the process alive when a mapped file is cut short while it is being read.
//!
//! Reading a page of a mapping that its file no longer covers raises SIGBUS. The handler here
//! replaces such a page of a registered mapping by an anonymous page of zeros and marks the mapping
//! as damaged; a fault anywhere else goes to whoever handled SIGBUS before. Everything that the
//! handler touches is lock-free and async-signal-safe.

#[cfg(unix)]
pub(crate) use unix::Guard;

#[cfg(not(unix))]
pub(crate) use elsewhere::Guard;

/// The table of guarded mappings is full.
#[derive(Debug)]
pub(crate) struct TooMany;

/// Mappings that may be guarded at the same time.
pub(crate) const MOST_MAPPINGS: usize = 256;

#[cfg(unix)]
mod unix {
    use super::{MOST_MAPPINGS, TooMany};
    use std::fs::File;
    use std::os::fd::AsRawFd;
    use std::sync::Mutex;
    use std::sync::atomic::{AtomicBool, AtomicI32, AtomicPtr, AtomicUsize, Ordering};

    /// One guarded mapping; `end` is 0 while the slot is unused.
    struct Slot {
        taken: AtomicBool,
        start: AtomicUsize,
        end: AtomicUsize,
        file: AtomicI32,
        damaged: AtomicBool,
    }

    impl Slot {
        const fn unused() -> Self {
            Self {
                taken: AtomicBool::new(false),
                start: AtomicUsize::new(0),
                end: AtomicUsize::new(0),
                file: AtomicI32::new(-1),
                damaged: AtomicBool::new(false),
            }
        }

        fn length(&self) -> usize {
            let end = self.end.load(Ordering::Acquire);
            end.saturating_sub(self.start.load(Ordering::Relaxed))
        }

        fn contains(&self, address: usize) -> bool {
            let end = self.end.load(Ordering::Acquire);
            address < end && address >= self.start.load(Ordering::Relaxed)
        }

        /// Whether the file now ends before the mapping does.
        fn is_cut(&self) -> bool {
            let length = self.length();
            if length == 0 {
                return false;
            }
            // SAFETY: `stat` is plain data, and fstat only writes to it (async-signal-safe by POSIX).
            unsafe {
                let mut stat: libc::stat = std::mem::zeroed();
                libc::fstat(self.file.load(Ordering::Relaxed), &mut stat) == 0
                    && (stat.st_size as usize) < length
            }
        }
    }

    static SLOTS: [Slot; MOST_MAPPINGS] = [const { Slot::unused() }; MOST_MAPPINGS];
    static PAGE: AtomicUsize = AtomicUsize::new(4096);
    /// What handled SIGBUS before; leaked, because a handler may be reading it at any time.
    static PREVIOUS: AtomicPtr<libc::sigaction> = AtomicPtr::new(std::ptr::null_mut());
    /// The thread whose signal was handed over to the previous handler last, or 0.
    static HANDED_OVER: AtomicI32 = AtomicI32::new(0);

    /// A registered mapping; dropping it ends the registration, and must happen before unmapping.
    #[derive(Debug)]
    pub(crate) struct Guard {
        slot: usize,
    }

    impl Guard {
        /// Registers `length` bytes at `start`, mapped from `file` (kept open by the caller).
        pub(crate) fn new(start: *const u8, length: usize, file: &File) -> Result<Self, TooMany> {
            install_handler();
            let take = |slot: &Slot| !slot.taken.swap(true, Ordering::AcqRel);
            let number = SLOTS.iter().position(take).ok_or(TooMany)?;
            let slot = &SLOTS[number];
            slot.damaged.store(false, Ordering::Relaxed);
            slot.file.store(file.as_raw_fd(), Ordering::Relaxed);
            slot.start.store(start as usize, Ordering::Relaxed);
            slot.end.store(start as usize + length, Ordering::Release);
            Ok(Self { slot: number })
        }

        /// Whether a page of the mapping had to be replaced, or the file was seen to be cut.
        pub(crate) fn damaged(&self) -> bool {
            SLOTS[self.slot].damaged.load(Ordering::Relaxed)
        }

        /// Asks the system whether the file now ends before the mapping does.
        pub(crate) fn look_at_file(&self) {
            let slot = &SLOTS[self.slot];
            if slot.is_cut() {
                slot.damaged.store(true, Ordering::Relaxed);
            }
        }
    }

    impl Drop for Guard {
        fn drop(&mut self) {
            let slot = &SLOTS[self.slot];
            slot.end.store(0, Ordering::Release);
            slot.taken.store(false, Ordering::Release);
        }
    }

    /// Puts the handler in front, also when somebody else's has been put in front of it since.
    fn install_handler() {
        static INSTALLING: Mutex<()> = Mutex::new(());
        let _one_at_a_time = INSTALLING.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        // SAFETY: plain libc calls on local structures; the handler itself keeps to what a signal
        // handler may do. `current` is leaked once per installation, which is rare.
        unsafe {
            PAGE.store(libc::sysconf(libc::_SC_PAGESIZE) as usize, Ordering::Relaxed);
            let mut current: libc::sigaction = std::mem::zeroed();
            libc::sigaction(libc::SIGBUS, std::ptr::null(), &mut current);
            let ours = handle as extern "C" fn(_, _, _) as usize;
            if current.sa_sigaction == ours {
                return;
            }
            PREVIOUS.store(Box::into_raw(Box::new(current)), Ordering::Release);
            let mut action: libc::sigaction = std::mem::zeroed();
            action.sa_sigaction = ours;
            action.sa_flags = libc::SA_SIGINFO | libc::SA_ONSTACK;
            libc::sigemptyset(&mut action.sa_mask);
            libc::sigaction(libc::SIGBUS, &action, std::ptr::null_mut());
        }
    }

    extern "C" fn handle(
        signal: libc::c_int,
        info: *mut libc::siginfo_t,
        context: *mut libc::c_void,
    ) {
        // SAFETY: the kernel passes a valid siginfo to an SA_SIGINFO handler.
        let (sent_by_a_process, address) = unsafe { ((*info).si_code <= 0, (*info).si_addr()) };
        let ours = if sent_by_a_process {
            // A handler in front of this one (Python's faulthandler) reports the fault and raises
            // the signal again, without its address. If a mapping of ours is cut, returning is
            // right: the read repeats, faults again, and comes here with its address.
            is_raised_by_itself(info) && !was_handed_over() && SLOTS.iter().any(Slot::is_cut)
        } else {
            replace_page(address as usize)
        };
        if !ours {
            hand_over(signal, info, context, sent_by_a_process);
        }
    }

    /// Whether the code of a signal that this process sent itself is that of raise().
    #[cfg(target_os = "linux")]
    fn is_of_raise(code: libc::c_int) -> bool {
        code == libc::SI_TKILL
    }

    /// Elsewhere raise() cannot be told from kill().
    #[cfg(not(target_os = "linux"))]
    fn is_of_raise(_code: libc::c_int) -> bool {
        true
    }

    /// Whether this process raised the signal, rather than somebody who wants to end it.
    fn is_raised_by_itself(info: *const libc::siginfo_t) -> bool {
        // SAFETY: the kernel passes a valid siginfo; its sender is set for signals that were sent.
        let (code, sender) = unsafe { ((*info).si_code, (*info).si_pid()) };
        // SAFETY: getpid takes nothing and cannot fail.
        let own = sender == unsafe { libc::getpid() };
        own && is_of_raise(code)
    }

    /// Puts a page of zeros where the fault was, if that is inside a guarded mapping.
    fn replace_page(address: usize) -> bool {
        let Some(slot) = SLOTS.iter().find(|slot| slot.contains(address)) else {
            return false;
        };
        let page = PAGE.load(Ordering::Relaxed);
        // SAFETY: the page lies in a mapping that we own (its registration ends before it is
        // unmapped), so replacing it harms nobody; mmap is a plain system call. errno is put back.
        let replaced = unsafe {
            let errno = errno_location();
            let saved = *errno;
            let replaced = libc::mmap(
                (address & !(page - 1)) as *mut libc::c_void,
                page,
                libc::PROT_READ,
                libc::MAP_PRIVATE | libc::MAP_ANONYMOUS | libc::MAP_FIXED,
                -1,
                0,
            );
            *errno = saved;
            replaced != libc::MAP_FAILED
        };
        slot.damaged.store(replaced, Ordering::Relaxed);
        HANDED_OVER.store(0, Ordering::Release);
        replaced
    }

    /// Lets the previous handler have a fault that is not ours.
    fn hand_over(
        signal: libc::c_int,
        info: *mut libc::siginfo_t,
        context: *mut libc::c_void,
        sent_by_a_process: bool,
    ) {
        // A handler that got this thread's signal and raises it again has done what it wanted, and
        // expects the process to end; handing it over once more would go on for ever.
        let came_round = sent_by_a_process && was_handed_over();
        // SAFETY: PREVIOUS is set before the handler is, and never freed; the transmutes give back
        // the types that sa_flags declares.
        unsafe {
            HANDED_OVER.store(thread_number(), Ordering::Release);
            let previous = &*PREVIOUS.load(Ordering::Acquire);
            let default = previous.sa_sigaction == libc::SIG_DFL;
            if previous.sa_sigaction == libc::SIG_IGN && sent_by_a_process {
                // Ignored, as it was before us.
            } else if came_round || default || previous.sa_sigaction == libc::SIG_IGN {
                let mut action: libc::sigaction = std::mem::zeroed();
                action.sa_sigaction = libc::SIG_DFL;
                libc::sigaction(signal, &action, std::ptr::null_mut());
                if sent_by_a_process {
                    libc::raise(signal);
                }
                // Otherwise the faulting read repeats and ends the process as it should.
            } else if previous.sa_flags & libc::SA_SIGINFO != 0 {
                type WithInfo = extern "C" fn(libc::c_int, *mut libc::siginfo_t, *mut libc::c_void);
                let handler: WithInfo = std::mem::transmute(previous.sa_sigaction);
                handler(signal, info, context);
            } else {
                let handler: extern "C" fn(libc::c_int) =
                    std::mem::transmute(previous.sa_sigaction);
                handler(signal);
            }
        }
    }

    /// Whether the previous handler was the last to get this thread's signal.
    fn was_handed_over() -> bool {
        // SAFETY: takes nothing and cannot fail.
        HANDED_OVER.load(Ordering::Acquire) == unsafe { thread_number() }
    }

    #[cfg(target_os = "linux")]
    unsafe fn thread_number() -> i32 {
        // SAFETY: gettid takes nothing and cannot fail.
        unsafe { libc::syscall(libc::SYS_gettid) as i32 }
    }

    #[cfg(not(target_os = "linux"))]
    unsafe fn thread_number() -> i32 {
        // SAFETY: pthread_self takes nothing and cannot fail; it is told from 0 ("nobody") by | 1.
        unsafe { libc::pthread_self() as usize as i32 | 1 }
    }

    #[cfg(target_os = "linux")]
    unsafe fn errno_location() -> *mut libc::c_int {
        // SAFETY: gives this thread's errno, always valid.
        unsafe { libc::__errno_location() }
    }

    #[cfg(not(target_os = "linux"))]
    unsafe fn errno_location() -> *mut libc::c_int {
        // SAFETY: gives this thread's errno, always valid.
        unsafe { libc::__error() }
    }
}

#[cfg(not(unix))]
mod elsewhere {
    use super::TooMany;
    use std::fs::File;

    /// Windows refuses to cut a file while it is mapped: nothing to guard.
    #[derive(Debug)]
    pub(crate) struct Guard;

    impl Guard {
        pub(crate) fn new(_: *const u8, _: usize, _: &File) -> Result<Self, TooMany> {
            Ok(Self)
        }

        pub(crate) fn damaged(&self) -> bool {
            false
        }

        pub(crate) fn look_at_file(&self) {}
    }
}
