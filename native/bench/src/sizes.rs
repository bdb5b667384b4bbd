//! Whether an update costs more on a larger planet: the same local terrain at random places.
//!
//! Paths are made from the generator, not from the file, so that no line of it is touched before
//! the model comes but one in each page: the pages are in the system's page cache and mapped.

use crate::cache::{CAN_FLUSH, Lines, Warmth};
use crate::contenders::{CONTENDERS, Contender, GRAPH, WALK};
use crate::path::{Course, Hand};
use crate::planet::Planet;
use crate::random::Random;
use crate::scene::{Field, Mode, Scene};
use crate::statistics::Spread;
use crate::terrain::NORTH_OF_CANYON;
use crate::tile::PERIOD;
use crate::timing::{BLOCK, Entry, Runner, Stopwatch, Track};
use crate::trace::trace;
use surface::GridPoint;

/// Speeds, cells per update.
pub const SPEEDS: [f64; 3] = [0.3, 1.0, 13.4];

/// Legs, each at another place of the planet, and updates in each.
const LEGS: usize = 96;
const LEG: usize = 64;

/// Rows that a path keeps from the poles.
const MARGIN: usize = 240;

/// Models that are measured: the default and the paper's.
pub const MODELS: [&str; 2] = [WALK, GRAPH];

/// One model at one speed, on every planet.
pub struct SizeRow {
    /// The model.
    pub key: &'static str,
    /// Cells per update.
    pub speed: f64,
    /// State of the caches.
    pub warmth: Warmth,
    /// Nanoseconds on each planet.
    pub times: Vec<Spread>,
}

/// Measures all models at all speeds.
pub fn measure(planets: &[Planet], stopwatch: &Stopwatch) -> Vec<SizeRow> {
    let mut rows = Vec::new();
    for (turn, speed) in SPEEDS.into_iter().enumerate() {
        for (model, key) in MODELS.into_iter().enumerate() {
            // Every model gets places of its own: none profits from what another has touched.
            let seed = (2 * turn + model) as u64;
            let contender = CONTENDERS.iter().find(|contender| contender.key == key);
            let contender = contender.expect("the models measured are contenders");
            rows.extend(measure_one(contender, speed, seed, planets, stopwatch));
        }
    }
    rows
}

fn measure_one(
    contender: &Contender,
    speed: f64,
    seed: u64,
    planets: &[Planet],
    stopwatch: &Stopwatch,
) -> Vec<SizeRow> {
    let size = |planet: &Planet| {
        let layout = planet.grid.layout();
        (layout.columns() as usize, layout.rows() as usize)
    };
    let sizes: Vec<_> = planets.iter().map(size).collect();
    let places = places(&sizes, &mut Random::new(seed));
    let scenes: Vec<_> = planets.iter().map(scene).collect();
    let courses: Vec<_> = (0..planets.len())
        .map(|planet| course(&planets[planet], &scenes[planet], speed, seed, &places[planet]))
        .collect();
    for (planet, course) in planets.iter().zip(&courses) {
        planet.touch_pages(course);
    }
    let race = |lines: &[Lines], warmth| {
        let tracks: Vec<_> = (0..planets.len())
            .map(|planet| Track {
                grid: &planets[planet].grid,
                metric: scenes[planet].metric(),
                course: &courses[planet],
                lines: lines.get(planet),
            })
            .collect();
        let mut entries: Vec<_> = tracks
            .iter()
            .map(|track| Entry { runner: Runner::Model(contender.build()), track })
            .collect();
        let times = stopwatch.race(&mut entries, warmth);
        SizeRow { key: contender.key, speed, warmth, times }
    };
    let mut rows = vec![race(&[], Warmth::Untouched)];
    let lines: Vec<_> = (0..planets.len())
        .map(|planet| {
            let (scene, course) = (&scenes[planet], &courses[planet]);
            let traces = [trace(&mut *contender.build(), scene, course)];
            Lines::around(scene, course, &traces, &[], BLOCK)
        })
        .collect();
    rows.push(race(&lines, Warmth::Hot));
    if CAN_FLUSH {
        rows.push(race(&lines, Warmth::Cold));
    }
    rows
}

fn scene<'a>(planet: &'a Planet) -> Scene<'a> {
    let rows = f64::from(planet.grid.layout().rows());
    Scene {
        key: planet.size.key,
        title: String::new(),
        grid: &planet.grid,
        exaggeration: 1.0,
        mode: Mode::Swipe,
        field: Field::Rows(MARGIN as f64, rows - MARGIN as f64),
    }
}

/// For each planet of so many columns and rows the sample at which each leg begins: the same place of
/// the tile on all of them.
fn places(sizes: &[(usize, usize)], random: &mut Random) -> Vec<Vec<(i64, i64)>> {
    let northern = |rows: usize| (NORTH_OF_CANYON * rows as f64) as usize - MARGIN;
    let smallest = sizes.iter().map(|&(_, rows)| northern(rows)).min().unwrap_or(0);
    let offsets: Vec<_> = (0..LEGS)
        .map(|_| (random.below(PERIOD), MARGIN + random.below(smallest - MARGIN)))
        .collect();
    let mut on_planet = |&(columns, rows): &(usize, usize)| {
        let mut place = |&(column, row): &(usize, usize)| {
            let tiles_down = (northern(rows) - row - 1) / PERIOD + 1;
            let column = column + PERIOD * random.below(columns / PERIOD);
            (column as i64, (row + PERIOD * random.below(tiles_down)) as i64)
        };
        offsets.iter().map(&mut place).collect()
    };
    sizes.iter().map(&mut on_planet).collect()
}

/// A path of short legs. The hand's way is the same on every planet, only begun elsewhere.
fn course(planet: &Planet, scene: &Scene, speed: f64, seed: u64, places: &[(i64, i64)]) -> Course {
    let surface = |point: &GridPoint| planet.terrain.surface(point);
    Hand { leg: LEG, ..Hand::new(speed, seed) }.starting_at(scene, &surface, places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn legs_begin_at_the_same_place_of_the_tile_on_every_planet() {
        let sizes = [(5760, 2880), (11_520, 5760), (99_840, 49_920)];
        let places = places(&sizes, &mut Random::new(1));
        for leg in 0..LEGS {
            let (column, row) = places[0][leg];
            for (size, places) in sizes.iter().zip(&places) {
                let place = places[leg];
                assert_eq!((place.0 - column) % PERIOD as i64, 0);
                assert_eq!((place.1 - row) % PERIOD as i64, 0);
                assert!((0..size.0 as i64).contains(&place.0));
                let northern = (NORTH_OF_CANYON * size.1 as f64) as i64 - MARGIN as i64;
                assert!((MARGIN as i64..northern).contains(&place.1));
            }
        }
        let tiles_used = |places: &[(i64, i64)]| {
            let mut tiles: Vec<_> = places.iter().map(|place| place.0 / PERIOD as i64).collect();
            tiles.sort_unstable();
            tiles.dedup();
            tiles.len()
        };
        assert!(tiles_used(&places[2]) > 30, "all over the planet");
    }
}
