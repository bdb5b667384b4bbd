//! Pages that the system may not take away while the loop runs.
//!
//! A page that was swapped out, or never touched, costs a tick a fault of microseconds to
//! milliseconds. So what the loop needs in every tick is kept in memory piece by piece: its stack, its
//! state, its rings. Never all memory of the process: with a limit on locked memory, that would make
//! Blender's next allocation fail. Never the grid: it may be larger than memory.

/// Bytes that the loop asked the system to keep in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LockedMemory {
    /// Kept.
    pub locked: usize,
    /// Refused: beyond the limit on locked memory (`ulimit -l`), or no such thing on this system.
    pub refused: usize,
}

/// A part of the memory, as address and length in bytes. Only a name: it is never read through.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    address: *const u8,
    length: usize,
}

impl Piece {
    pub(crate) fn of<T: ?Sized>(value: &T) -> Piece {
        Piece { address: std::ptr::from_ref(value).cast(), length: size_of_val(value) }
    }
}

/// Locked pieces; dropping it lets them go.
///
/// A piece that is freed meanwhile, as a contact model that was switched for another, harms nobody;
/// the new one is not locked, only touched. Systems lock whole pages, once: where two sessions' small
/// pieces share one, the first that ends lets it go for both.
pub(crate) struct MemoryLock {
    pieces: Vec<Piece>,
    refused: usize,
}

impl MemoryLock {
    /// Locks as many of the pieces as the system grants, the first ones first.
    pub(crate) fn of(pieces: impl IntoIterator<Item = Piece>) -> MemoryLock {
        let (granted, refused): (Vec<_>, Vec<_>) = pieces.into_iter().partition(system::lock);
        let refused = refused.iter().map(|piece| piece.length).sum();
        MemoryLock { pieces: granted, refused }
    }

    pub(crate) fn memory(&self) -> LockedMemory {
        let locked = self.pieces.iter().map(|piece| piece.length).sum();
        LockedMemory { locked, refused: self.refused }
    }
}

impl Drop for MemoryLock {
    fn drop(&mut self) {
        self.pieces.iter().for_each(system::unlock);
    }
}

/// Bytes of stack that a tick may need: contact models keep their state on the heap, and the deepest
/// of them takes about 8 KB.
const STACK: usize = 64 * 1024;

/// The stack of the calling thread below here, every page of it touched once.
#[inline(never)]
pub(crate) fn stack_below() -> Piece {
    let mut stack = [0u8; STACK];
    std::hint::black_box(&mut stack);
    Piece::of(&stack)
}

#[cfg(unix)]
mod system {
    use super::Piece;

    pub(super) fn lock(piece: &Piece) -> bool {
        // SAFETY: locking changes nothing that a program could see but how fast memory answers; an
        // address without memory is refused.
        unsafe { libc::mlock(piece.address.cast(), piece.length) == 0 }
    }

    pub(super) fn unlock(piece: &Piece) {
        // SAFETY: as above.
        unsafe {
            libc::munlock(piece.address.cast(), piece.length);
        }
    }
}

#[cfg(not(unix))]
mod system {
    use super::Piece;

    pub(super) fn lock(_piece: &Piece) -> bool {
        false
    }

    pub(super) fn unlock(_piece: &Piece) {}
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_memory_is_refused() {
        let nowhere = Piece { address: std::ptr::null(), length: 4096 };
        assert_eq!(MemoryLock::of([nowhere]).memory(), LockedMemory { locked: 0, refused: 4096 });
    }

    #[test]
    fn the_stack_is_below_the_caller() {
        let here = 0u8;
        let stack = stack_below();
        assert_eq!(stack.length, STACK);
        assert!((stack.address as usize) < std::ptr::from_ref(&here) as usize);
    }
}
