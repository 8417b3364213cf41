//! Command `tripos sweep`: runs a scene from many starts or with many parameter values.

use crate::arguments::Sweep as Request;
use crate::files::output_files::{TableFormat, refuse_overwriting_inputs};
use crate::files::scene_file::read_scene;
use crate::files::workspace::short_name;
use crate::sweep::{
    Columns, GrowingTable, KeptRows, Record, Tally, UnfinishedTableMismatch, other_sweep_failure, remove_record,
};
use crate::terminal::failure::{Failure, print_json, print_to_stderr, status, warn};
use crate::terminal::interruption;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;
use std::num::NonZero;
use std::ops::Range;
use std::time::{Duration, Instant};
use tripos::studies::sweep::{Shard, Sweep, SweepRow, work_in_order};
use tripos::{Error, integration_method_words};
use tripos_codegen::draft_file::ExistingFilePolicy;
use tripos_derive::scene::Grid;

/// Largest accepted number of threads. A larger number is probably a typing error.
const MOST_THREADS: usize = 4096;

/// Runs `tripos sweep`: runs the points of the grid, or one part of them, and writes a row for
/// each. Returns the exit status.
///
/// # Errors
/// `Failure` if a file or an option has errors, the table cannot be written, or the user
/// interrupts.
pub fn sweep(request: &Request) -> Result<u8, Failure> {
    let (mut model, mut scene) = read_scene(&request.scene)?;
    refuse_overwriting_inputs(&model, Some(&scene), [request.out.as_path()])?;
    TableFormat::of_name(&request.out)?;
    let grid = Grid::read(&request.over, "--over", &scene, &mut model).map_err(Error::Inputs)?;
    grid.hints(&model).iter().for_each(|hint| warn(hint));
    let shard = Shard::read(&request.shard)?;
    let threads = thread_count(request.threads)?;
    let how_else = request.how.overrides()?;
    how_else.apply_to_scene(&mut scene)?;
    let mut sweep = Sweep::new(&model, &scene, &grid, &how_else)?;
    sweep.tells_digits = request.digits;
    for warning in &sweep.warnings {
        warn(warning);
    }
    if let Some(name) = Columns::new(&sweep).duplicate_column_name() {
        let what = format!("two columns of the table would be called `{name}`");
        return Err(Failure::request(what, "give the scene's output another name".to_owned()));
    }
    let points = shard.shard_points(grid.count());
    let (mut table, kept) = open_sweep_table(request, &sweep, &points)?;
    interruption::listen_for_interruption();
    let (count, kept_rows) = (points.end - points.start, kept.rows);
    let begun = Instant::now();
    let tally = run_sweep_points(&sweep, points.clone(), threads, &mut table, kept)?;
    let part = table.unfinished_table_path().to_owned();
    table.finish()?;
    remove_record(&part);
    let seconds = begun.elapsed();
    if request.json {
        let summary = json!({
            "model": short_name(&model),
            "formulation": sweep.by.name(),
            "method": scene.integration.method.name(),
            "solve": sweep.solve.name(),
            "compiled": sweep.code.is_compiled(),
            "notes": sweep.note.iter().collect::<Vec<_>>(),
            "over": grid.names(),
            "points": grid.count(),
            "shard": { "part": shard.part, "of": shard.of, "first": points.start, "rows": count, "kept": kept_rows },
            "stops": tally.json(),
            "failed": tally.rows_without_result(),
            "warned": tally.rows_with_warnings(),
            "threads": threads,
            "seconds": seconds.as_secs_f64(),
            "out": request.out.display().to_string(),
        });
        print_json(&summary)?;
    } else {
        print_to_stderr(&format!(
            "{}, {}, {} code, accelerations {}, {}",
            model.title,
            sweep.by.title(),
            sweep.code.name(),
            sweep.solve.name(),
            integration_method_words(&scene)
        ));
        if let Some(note) = &sweep.note {
            print_to_stderr(&format!("note: {note}"));
        }
        print_to_stderr(&format!(
            "{}\n{}{}",
            sweep_extent_words(shard, &points, kept_rows, &grid, &SweepTime { threads, seconds }),
            tally.text(),
            request.out.display()
        ));
    }
    if tally.rows_with_warnings() > 0 {
        warn("some runs cannot be trusted: the column `warning` of the table says which ones, and why");
    }
    Ok(if tally.rows_without_result() > 0 { status::STOPPED } else { 0 })
}

/// Threads that ran a sweep, and the time that it took.
struct SweepTime {
    /// Number of threads that ran the sweep.
    threads: usize,
    /// Elapsed time of the sweep.
    seconds: Duration,
}

/// Returns a description of a sweep's size: the number of points, the part of the grid, and the time taken. `kept` is
/// the number of rows from an earlier, unfinished sweep.
fn sweep_extent_words(shard: Shard, points: &Range<u64>, kept: u64, grid: &Grid, effort: &SweepTime) -> String {
    let SweepTime { threads, seconds } = effort;
    let count = points.end - points.start - kept;
    let of = if shard.of == 1 {
        String::new()
    } else {
        format!(" (part {} of {}, from point {}) of {}", shard.part, shard.of, points.start, grid.count())
    };
    let each = seconds.as_secs_f64() / count.max(1) as f64;
    let beside = if kept == 0 { String::new() } else { format!(" beside {kept} that were there") };
    format!(
        "{count} points{of}{beside} in {:.1} s, {:.3} ms each, by {threads} threads",
        seconds.as_secs_f64(),
        each * 1e3
    )
}

/// Opens the table of a sweep and writes its header. If the sweep is resumed, the table keeps the rows of the
/// unfinished sweep.
///
/// # Errors
/// `Failure` if the file exists and must be kept, or if its rows are not from this sweep.
fn open_sweep_table(
    request: &Request,
    sweep: &Sweep<'_>,
    points: &Range<u64>,
) -> Result<(GrowingTable, KeptRows), Failure> {
    let existing = if request.overwrite { ExistingFilePolicy::Replaced } else { ExistingFilePolicy::Kept };
    let (columns, record) = (Columns::new(sweep), Record::new(sweep, &request.over, &request.shard));
    let left = if request.resume { GrowingTable::resume(&request.out, existing)? } else { None };
    let (mut table, kept) = if let Some(mut table) = left {
        let part = table.unfinished_table_path().to_owned();
        record.check_same_settings(&part)?;
        let kept = KeptRows::read(table.unfinished_rows_reader(), &columns, points).map_err(|alien| match alien {
            UnfinishedTableMismatch::Other(why) => other_sweep_failure(&part, &why),
            UnfinishedTableMismatch::Unread(error) => Failure::Output(part.display().to_string(), error),
        })?;
        table.truncate_rows(kept.bytes)?;
        (table, kept)
    } else {
        let table = GrowingTable::create(&request.out, existing)?;
        if request.resume {
            print_to_stderr("all points of this sweep are already run");
        }
        // A device or a pipe keeps no rows for a resumed sweep, so that no record is written.
        if table.unfinished_table_path() != request.out {
            record.write(table.unfinished_table_path())?;
        }
        (table, KeptRows::default())
    };
    if kept.bytes == 0 {
        table.add(&columns.header())?;
    }
    Ok((table, kept))
}

/// Runs the points that have no row yet and adds their rows to the table. Returns the number of
/// points with each outcome.
/// `Err` if the table cannot be written, or the user interrupts.
fn run_sweep_points(
    sweep: &Sweep<'_>,
    points: Range<u64>,
    threads: usize,
    table: &mut GrowingTable,
    kept: KeptRows,
) -> Result<Tally, Failure> {
    let columns = Columns::new(sweep);
    let all = points.end - points.start;
    let points = points.start + kept.rows..points.end;
    let count = points.end - points.start;
    let threads = threads.min(usize::try_from(count).unwrap_or(usize::MAX)).max(1);
    let workers = (0..threads).map(|_| sweep.make_worker()).collect::<Result<Vec<_>, tripos::Error>>()?;
    let bar = sweep_progress_bar(count);
    let done = || bar.inc(1);
    let (mut tally, mut done_rows) = (kept.tally, 0);
    let outcome = work_in_order(
        points,
        workers,
        &sweep.stop,
        &|worker, block| {
            let rows = worker.run_block(block, &done);
            let lines = columns.lines(&rows);
            (rows, lines)
        },
        |(rows, lines): (Vec<SweepRow>, Vec<u8>)| {
            for row in &rows {
                tally.add(row);
            }
            table.add(&lines)?;
            done_rows += rows.len() as u64;
            if interruption::is_interrupted() && done_rows < count {
                let (place, there) = (table.unfinished_table_path().display(), kept.rows + done_rows);
                let what = format!("the first {there} of {all} rows are in {place}; --resume goes on from there");
                return Err(Failure::Interrupted(what));
            }
            Ok(())
        },
    );
    bar.finish_and_clear();
    outcome.map(|()| tally)
}

/// Returns the number of threads: the given number, or else the number of cores, at most `MOST_THREADS`.
///
/// # Errors
/// `Failure` if the given number is 0 or too large.
fn thread_count(asked: Option<usize>) -> Result<usize, Failure> {
    match asked {
        None => Ok(std::thread::available_parallelism().map_or(1, NonZero::get).min(MOST_THREADS)),
        Some(n) if (1..=MOST_THREADS).contains(&n) => Ok(n),
        Some(n) => {
            let help = format!("give a number from 1 to {MOST_THREADS}, or leave it out");
            Err(Failure::request(format!("--threads is {n}"), help))
        }
    }
}

/// Returns a progress bar with the number of finished points and the remaining time.
fn sweep_progress_bar(points: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} points, {eta} left");
    ProgressBar::new(points).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
