//! The force-mixing room: several things push at once, and the sum is as stable as each alone.
//!
//! Springs that are stable one by one need not be so together: where their directions overlap,
//! their stiffnesses add (paper, section 4.2). The paper keeps forces linearly independent where it
//! can, and where it cannot it fades one as the other grows. Here both follow from one rule:
//!
//! > The mixed push is the smallest one that gives every contributor its push along its own direction.
//!
//! Where directions are at right angles that is the plain sum. Where they are the same it is the
//! larger one: as the one grows, the other's share fades by as much. In between it is in between.
//!
//! Why this is stable: a contributor wants the hand on the far side of a plane, so the rule moves the
//! hand to the nearest point that lies beyond all planes. A projection onto a convex set moves no
//! further than what it projects (it is firmly nonexpansive; Moreau, 1965), and so the spring to that
//! point is in no direction stiffer than a single one, never has a negative stiffness, makes no step
//! where the hand makes none, and takes back all energy that it gives: it has a potential, which a
//! fade of forces has not.

/// What pushes at once at most: two walls that meet in a corner, the surface, and one more.
pub(crate) const CONTRIBUTORS: usize = 4;

/// Planes that face each other, with no point beyond both, ask for the impossible: each plane yields
/// by this share of what holds it, and so there is always an answer, found to some ten digits. What
/// is said of stiffness above holds but for this share.
const GIVE: f64 = 1e-6;

/// A plane that the hand shall be beyond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Contributor {
    /// Unit vector out of the plane, workspace frame.
    pub(crate) direction: [f64; 3],
    /// Metres along `direction` from the hand to the plane; negative where the hand is beyond it.
    /// The room has one spring for all: a contributor that is to be weaker by a factor asks for a
    /// push that is shorter by it, and should be at right angles to the others then.
    pub(crate) push: f64,
}

/// The contributors of one tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mix {
    contributors: [Contributor; CONTRIBUTORS],
    count: usize,
}

impl Mix {
    /// Nothing pushes.
    pub(crate) fn new() -> Mix {
        let nothing = Contributor { direction: [0.0; 3], push: 0.0 };
        Mix { contributors: [nothing; CONTRIBUTORS], count: 0 }
    }

    /// Adds one. There is room for [`CONTRIBUTORS`]; each must be finite.
    pub(crate) fn add(&mut self, contributor: Contributor) {
        debug_assert!(self.count < CONTRIBUTORS, "a room of fixed size");
        if let Some(place) = self.contributors.get_mut(self.count) {
            *place = contributor;
            self.count += 1;
        }
    }

    /// Metres from the hand to the nearest point beyond all planes: along this the spring pulls.
    pub(crate) fn push(&self) -> [f64; 3] {
        match self.alone() {
            Some(only) => only,
            None => self.together(),
        }
    }

    fn all(&self) -> &[Contributor] {
        &self.contributors[..self.count]
    }

    /// The push of the one that wants most, if it is enough for all the others.
    fn alone(&self) -> Option<[f64; 3]> {
        let most = self.all().iter().max_by(|one, other| one.push.total_cmp(&other.push))?;
        if most.push <= 0.0 {
            return Some([0.0; 3]);
        }
        let push = most.direction.map(|part| part * most.push);
        // The one itself is not asked: its direction's length is not 1 to the last bit.
        let is_enough =
            |other: &Contributor| *other == *most || dot(other.direction, push) >= yielded(other);
        self.all().iter().all(is_enough).then_some(push)
    }

    /// The smallest push is a sum of pushes along some of the directions. Of all sets of directions
    /// whose sum pulls nowhere, the right one has the largest energy (the dual of the least-squares
    /// problem), so that no tolerance is needed to tell which it is.
    fn together(&self) -> [f64; 3] {
        let mut best = ([0.0; 3], 0.0);
        for set in 1..1u32 << self.count {
            if let Some((push, energy)) = self.of_set(set)
                && energy > best.1
            {
                best = (push, energy);
            }
        }
        best.0.map(|metres| metres * (1.0 + GIVE))
    }

    /// The smallest push that gives exactly their wish to those in `set` (a bit for each), and its
    /// energy; `None` where one of them would have to pull.
    fn of_set(&self, set: u32) -> Option<([f64; 3], f64)> {
        let shares = self.shares(set)?;
        let mut push = [0.0; 3];
        let mut energy = 0.0;
        for (contributor, share) in self.all().iter().zip(shares) {
            energy += 0.5 * share * contributor.push;
            for (part, along) in push.iter_mut().zip(contributor.direction) {
                *part += share * along;
            }
        }
        Some((push, energy))
    }

    /// How much of each direction of a set the push is made of: Gauss's elimination on the directions'
    /// products, which are positive definite thanks to [`GIVE`] and need no pivots.
    fn shares(&self, set: u32) -> Option<[f64; CONTRIBUTORS]> {
        let mut rows = [[0.0; CONTRIBUTORS + 1]; CONTRIBUTORS];
        for (index, row) in rows.iter_mut().enumerate() {
            if set & (1 << index) == 0 {
                row[index] = 1.0;
                continue;
            }
            let own = &self.contributors[index];
            for (column, other) in self.contributors.iter().enumerate() {
                if set & (1 << column) != 0 {
                    row[column] = dot(own.direction, other.direction);
                }
            }
            row[index] += GIVE;
            row[CONTRIBUTORS] = own.push;
        }
        for pivot in 0..CONTRIBUTORS {
            let above = rows[pivot];
            for row in &mut rows[pivot + 1..] {
                let factor = row[pivot] / above[pivot];
                for (part, lead) in row.iter_mut().zip(above).skip(pivot) {
                    *part -= factor * lead;
                }
            }
        }
        let mut shares = [0.0; CONTRIBUTORS];
        for index in (0..CONTRIBUTORS).rev() {
            let known: f64 =
                (index + 1..CONTRIBUTORS).map(|column| rows[index][column] * shares[column]).sum();
            shares[index] = (rows[index][CONTRIBUTORS] - known) / rows[index][index];
            if shares[index].is_nan() || shares[index] < 0.0 {
                return None;
            }
        }
        Some(shares)
    }
}

/// What a plane that yields asks of a push that is nevertheless given in full to the one that is alone.
fn yielded(contributor: &Contributor) -> f64 {
    contributor.push * (1.0 + GIVE)
}

fn dot(one: [f64; 3], other: [f64; 3]) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

#[cfg(test)]
mod tests;
