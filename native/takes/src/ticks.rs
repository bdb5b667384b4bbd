//! Many ticks in memory.

use std::collections::TryReserveError;
use std::sync::Arc;

use crate::Tick;

/// Ticks in a piece of memory: about a second, 200 KB.
const PIECE: usize = 1024;

/// Ticks in their order: 192 bytes each, 11.5 MB a minute, 691 MB an hour.
///
/// They lie in pieces that never move, so growing copies nothing. A clone shares the pieces: it is
/// what there was when it was made, for the price of a pointer a second.
#[derive(Clone, Debug, Default)]
pub struct Ticks {
    pieces: Vec<Arc<Vec<Tick>>>,
}

impl Ticks {
    /// Appends a tick; an error where there is no memory left, and then nothing has changed.
    pub fn push(&mut self, tick: Tick) -> Result<(), TryReserveError> {
        match self.pieces.last_mut() {
            Some(last) if last.len() < PIECE => match Arc::get_mut(last) {
                Some(last) => last.push(tick),
                // A clone has it: from here on it is another piece.
                None => *last = Arc::new(piece(last, tick)?),
            },
            _ => {
                self.pieces.try_reserve(1)?;
                self.pieces.push(Arc::new(piece(&[], tick)?));
            }
        }
        Ok(())
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.pieces.last().map_or(0, |last| (self.pieces.len() - 1) * PIECE + last.len())
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// All of them, the oldest first.
    pub fn iter(&self) -> impl Iterator<Item = &Tick> {
        self.pieces.iter().flat_map(|piece| piece.iter())
    }

    /// The first one.
    pub fn first(&self) -> Option<&Tick> {
        self.pieces.first().and_then(|piece| piece.first())
    }

    /// The last one.
    pub fn last(&self) -> Option<&Tick> {
        self.pieces.last().and_then(|piece| piece.last())
    }

    /// Up to `most` of them, from the one at `first` on.
    pub fn part(&self, first: usize, most: usize) -> Vec<Tick> {
        let piece = (first / PIECE).min(self.pieces.len());
        let rest = self.pieces[piece..].iter().flat_map(|piece| piece.iter());
        rest.skip(first - piece * PIECE).take(most).copied().collect()
    }
}

/// A piece with room for all that it will ever have.
fn piece(begun: &[Tick], tick: Tick) -> Result<Vec<Tick>, TryReserveError> {
    let mut piece = Vec::new();
    piece.try_reserve_exact(PIECE)?;
    piece.extend_from_slice(begun);
    piece.push(tick);
    Ok(piece)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbered(numbers: std::ops::Range<u64>) -> Ticks {
        let mut ticks = Ticks::default();
        for number in numbers {
            ticks.push(Tick { number, ..Tick::default() }).unwrap();
        }
        ticks
    }

    fn numbers<'a>(ticks: impl IntoIterator<Item = &'a Tick>) -> Vec<u64> {
        ticks.into_iter().map(|tick| tick.number).collect()
    }

    #[test]
    fn ticks_come_out_as_they_went_in() {
        for count in [0, 1, 1023, 1024, 1025, 5000] {
            let ticks = numbered(0..count);
            assert_eq!(ticks.len() as u64, count);
            assert_eq!(ticks.is_empty(), count == 0);
            assert_eq!(numbers(ticks.iter()), (0..count).collect::<Vec<_>>());
            assert_eq!(ticks.first().map(|tick| tick.number), (count > 0).then_some(0));
            assert_eq!(ticks.last().map(|tick| tick.number), count.checked_sub(1));
        }
    }

    #[test]
    fn a_clone_stays_as_it_was_while_the_other_grows() {
        let mut ticks = numbered(0..1500);
        let then = ticks.clone();
        for number in 1500..3000 {
            ticks.push(Tick { number, ..Tick::default() }).unwrap();
        }
        assert_eq!(numbers(then.iter()), (0..1500).collect::<Vec<_>>());
        assert_eq!(numbers(ticks.iter()), (0..3000).collect::<Vec<_>>());
    }

    #[test]
    fn a_part_begins_and_ends_anywhere() {
        let ticks = numbered(0..3000);
        for (first, most) in
            [(0, 0), (0, 3000), (1000, 50), (1024, 1024), (2999, 9), (3000, 9), (9999, 9)]
        {
            let expected: Vec<u64> = (0..3000).skip(first).take(most).collect();
            assert_eq!(numbers(&ticks.part(first, most)), expected);
        }
    }

    #[test]
    fn growing_moves_nothing() {
        let mut ticks = numbered(0..10);
        let address = std::ptr::from_ref(ticks.first().unwrap());
        for number in 10..20_000 {
            ticks.push(Tick { number, ..Tick::default() }).unwrap();
        }
        assert_eq!(address, std::ptr::from_ref(ticks.first().unwrap()));
    }

    #[test]
    fn a_tick_takes_as_many_bytes_as_is_said() {
        assert_eq!(size_of::<Tick>(), 192);
    }
}
