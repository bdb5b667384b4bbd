//! What contact models cost and where they end: the trade of speed for accuracy, measured in one
//! process, with the code that the wheel ships.
//!
//! Prints tables, and writes every figure to `contact.json` (with `--large`, `contact-large.json`)
//! in the output folder.

mod cache;
mod cell;
mod conduct;
mod contenders;
mod crossings;
mod decimation;
mod errors;
mod goals;
mod limits;
mod notes;
mod options;
mod path;
mod planet;
mod real;
mod report;
mod scene;
mod sizes;
mod storage;
mod tables;
mod timing;
mod trace;
mod worst;

// What other benches use too. Modules here find them under their old names.
use contact_bench::{clock, figures, machine, random, statistics, terrain, tile};

use cell::{Cell, Updates};
use figures::Figures;
use goals::SWIPE;
use machine::Machine;
use options::{Options, USAGE};
use planet::{Planet, SIZE_2G, SIZE_10G, SIZE_33M, SIZE_133M, Size, require_room};
use scene::{Field, Mode, Scene};
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;
use tables::SceneCells;
use terrain::{Relief, Terrain};
use timing::Stopwatch;

/// Cells over the ground per update.
const SPEEDS: [f64; 7] = [0.001, 0.01, 0.3, 1.0, 3.4, 13.4, 50.0];

/// The same for ground that is there for comparison.
const FEW_SPEEDS: [f64; 3] = [0.01, 1.0, 13.4];

/// Cells from the middle of the canyon's wall that the hand goes: on the wall and beside it.
const BESIDE_WALL: f64 = 28.0;

fn main() -> ExitCode {
    if std::env::args().any(|argument| argument == "--help") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    let options = match Options::read(std::env::args().skip(1)) {
        Ok(options) => options,
        Err(mistake) => {
            eprintln!("{mistake}\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    if machine::IS_TUNED {
        eprintln!("This program was compiled for one processor (target-cpu); the wheel is not.");
        return ExitCode::from(2);
    }
    match run(&options) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(under) => {
            eprintln!("{under} updates ended under the surface, and there must be none.");
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Measures what is asked for; how many updates ended under the surface.
fn run(options: &Options) -> Result<u64, Box<dyn Error>> {
    let began = Instant::now();
    std::fs::create_dir_all(&options.output)?;
    let machine = Machine::found();
    println!("{}", machine.line());
    let mut figures = Figures::default();
    machine.note(&mut figures);
    let stopwatch = Stopwatch::new()?;
    let relief = Relief::new();
    if options.large {
        measure_large(options, &relief, &stopwatch, &mut figures)?;
    } else {
        measure_frontier(options, &relief, &stopwatch, &mut figures)?;
    }
    goals::print(&figures);
    figures.set("seconds", began.elapsed().as_secs_f64().round());
    let name = if options.large { "contact-large.json" } else { "contact.json" };
    let path = options.output.join(name);
    figures.write(&path)?;
    println!("\nFigures: {} ({:.0} s)", path.display(), began.elapsed().as_secs_f64());
    Ok(figures.get("under_surface_updates").and_then(|count| count.as_u64()).unwrap_or(0))
}

fn measure_frontier(
    options: &Options,
    relief: &Relief,
    stopwatch: &Stopwatch,
    figures: &mut Figures,
) -> Result<(), Box<dyn Error>> {
    let planets = make(&[SIZE_33M, SIZE_133M], options, relief)?;
    let scenes = measure_scenes(options, &planets, stopwatch);
    report::print_times(&scenes);
    report::print_visits(&scenes);
    report::print_errors(&scenes);
    report::print_passivity(&scenes);
    notes::note_scenes(&scenes, figures);
    goals::note(&scenes, figures);

    measure_sizes(&planets, stopwatch, figures);
    progress("storage");
    let storage = storage::measure(&planets[0], stopwatch)?;
    report::print_storage(&storage);
    notes::note_storage(&storage, figures);
    progress("decimation");
    let decimated = decimation::measure(&planets[0].grid, stopwatch)?;
    report::print_decimation(&decimated);
    notes::note_decimation(&decimated, figures);
    progress("jumps");
    let worst = worst::measure(&rough(&planets[0]), stopwatch);
    report::print_worst(&worst, &scenes);
    notes::note_worst(&worst, &scenes, figures);
    Ok(())
}

fn measure_large(
    options: &Options,
    relief: &Relief,
    stopwatch: &Stopwatch,
    figures: &mut Figures,
) -> Result<(), Box<dyn Error>> {
    let sizes = [SIZE_33M, SIZE_2G, SIZE_10G];
    let bytes: u64 = sizes.iter().map(Size::bytes).sum();
    println!("Synthetic grids take {:.1} GB in {}.", bytes as f64 / 1e9, options.output.display());
    let planets = make(&sizes, options, relief)?;
    measure_sizes(&planets, stopwatch, figures);
    if options.keep {
        return Ok(());
    }
    for planet in planets {
        planet.remove()?;
    }
    Ok(())
}

fn make<'a>(
    sizes: &[Size],
    options: &Options,
    relief: &'a Relief,
) -> Result<Vec<Planet<'a>>, Box<dyn Error>> {
    require_room(sizes, &options.output)?;
    let mut planets = Vec::new();
    for size in sizes {
        progress(&format!("planet of {} triangles", size.key));
        let planet = Planet::make(*size, relief, &options.output)?;
        planet.read_through()?;
        planets.push(planet);
    }
    Ok(planets)
}

fn measure_sizes(planets: &[Planet], stopwatch: &Stopwatch, figures: &mut Figures) {
    progress("sizes");
    let rows = sizes::measure(planets, stopwatch);
    let names: Vec<_> = planets.iter().map(|planet| planet.size.key).collect();
    report::print_sizes(&rows, &names);
    notes::note_sizes(&rows, &names, figures);
}

fn measure_scenes(options: &Options, planets: &[Planet], stopwatch: &Stopwatch) -> Vec<SceneCells> {
    let (small, large) = (&planets[0], &planets[1]);
    let mut measured = Vec::new();
    let mut all = |scene: Scene, speeds: &[f64]| {
        let measure = |speed: &f64| {
            progress(&format!("{} at {speed} cells per update", scene.title));
            Cell::measure(&scene, *speed, updates(&scene, *speed), stopwatch)
        };
        let cells = speeds.iter().map(measure).collect();
        measured.push(SceneCells { key: scene.key, title: scene.title, cells });
    };
    let wall = |column: f64| canyon_wall(&small.terrain, column);
    let along = || Field::Along(&wall, BESIDE_WALL);
    all(synthetic(small, "x1", "33 M triangles, unscaled", 1.0), &SPEEDS);
    all(synthetic(small, "x5", "33 M triangles, x5", 5.0), &SPEEDS);
    all(rough(small), &SPEEDS);
    let canyon = synthetic(small, "x20_canyon", "33 M triangles, canyon walls, x20", 20.0);
    all(Scene { field: along(), ..canyon }, &SPEEDS);
    let poke = synthetic(small, "x20_poke", "33 M triangles, canyon walls, pokes, x20", 20.0);
    all(Scene { field: along(), mode: Mode::Poke, ..poke }, &SPEEDS);
    all(synthetic(large, "133M_x1", "133 M triangles, unscaled", 1.0), &FEW_SPEEDS);

    match real::mars(options.mola.as_deref()) {
        Ok(mars) => {
            let scene = |key, title: &str, exaggeration, field| Scene {
                key,
                title: title.to_owned(),
                grid: &mars,
                exaggeration,
                mode: Mode::Swipe,
                field,
            };
            let rows = f64::from(mars.layout().rows());
            let planet = Field::Rows(rows / 12.0, rows * 11.0 / 12.0);
            let [west, east, north, south] = real::VALLES;
            let valles = Field::Part(west, east, north, south);
            all(scene("mola_x1", "MOLA 4 px/degree, unscaled", 1.0, planet), &FEW_SPEEDS);
            all(scene("valles_x20", "MOLA, Valles Marineris, x20", 20.0, valles), &FEW_SPEEDS);
        }
        Err(reason) => println!("\nReal Mars is left out: {reason}."),
    }
    let noise = real::white_noise();
    let noise = Scene {
        key: "noise_x1",
        title: "white noise, slopes of 1".to_owned(),
        grid: &noise,
        exaggeration: 1.0,
        mode: Mode::Swipe,
        field: Field::Rows(50.0, 460.0),
    };
    all(noise, &FEW_SPEEDS);
    measured
}

fn synthetic<'a>(
    planet: &'a Planet,
    key: &'static str,
    title: &str,
    exaggeration: f64,
) -> Scene<'a> {
    let rows = f64::from(planet.grid.layout().rows());
    Scene {
        key,
        title: title.to_owned(),
        grid: &planet.grid,
        exaggeration,
        mode: Mode::Swipe,
        field: Field::Rows(rows / 12.0, rows * 11.0 / 12.0),
    }
}

fn rough<'a>(planet: &'a Planet) -> Scene<'a> {
    synthetic(planet, "x20", "33 M triangles, x20", 20.0)
}

fn canyon_wall(terrain: &Terrain, column: f64) -> f64 {
    terrain.canyon_wall(column).0
}

/// As many as a few minutes allow, and more times over where ratios are worked out.
fn updates(scene: &Scene, speed: f64) -> Updates {
    let is_compared = ["x1", "x20_canyon"].contains(&scene.key) && [1.0, SWIPE].contains(&speed);
    let repeats = if is_compared { 3 } else { 1 };
    if speed > 20.0 {
        Updates { timed: 4096, repeats, judged: 16_384, compared: 2048 }
    } else {
        Updates { timed: 8192, repeats, judged: 32_768, compared: 6144 }
    }
}

/// What is being done, for those who wait.
fn progress(what: &str) {
    eprintln!("[bench] {what}");
}
