//! The numbers of the table: each warp is tested against its density, compared with its exact map, and timed.

use host::cli as table;
use host::draw::text::thousands;
use host::figures::{self, Exact, sample_error};
use host::registry::{Domain, Entry, Measure, Point, Uniforms};
use host::stats::{self, Axis};
use microwarp::uniform;
use rand_pcg::Pcg32;
use std::time::Instant;

/// A p-value below this is not chance, in any number of runs.
pub const ALARM: f64 = 1e-9;

/// Cells along the axes of a chart of two dimensions; odd, so that no symmetry of a warp falls onto
/// a border. On the line there are as many as `f32` bears.
const AREA_CELLS: [usize; 2] = [61, 33];

/// How often the panels of the quadrature are halved towards the ends, where maps have singularities.
const GRADES: i32 = 8;

/// Points drawn at a time: a block stays in the nearest cache.
const BLOCK: usize = 512;

/// The generator of one purpose (`purpose`) for one row of the table.
pub fn generator(seed: u64, entry: &Entry, purpose: u64) -> Pcg32 {
    // FNV-1a over the label, so that a row keeps its numbers when another is added above it.
    let hash = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let stream = entry.to_string().bytes().fold(0xcbf2_9ce4_8422_2325, hash);
    Pcg32::new(seed, stream ^ purpose)
}

/// The measurements of one warp in one tier.
pub struct Figures {
    pub shape: Shape,
    /// The largest error of a sample, in the measure of the entry.
    pub error: f64,
    pub nanoseconds: f64,
}

/// The outcome of the chi-square test.
pub struct Shape {
    pub samples: usize,
    /// Samples that are NaN or have density 0.
    pub astray: usize,
    /// The p-value, or why there is none.
    pub outcome: Result<f64, String>,
}

/// The p-value in print.
pub fn p_text(shape: &Shape) -> String {
    match shape.outcome {
        Err(_) => "none".into(),
        Ok(p) => table::p_text(p),
    }
}

impl Shape {
    /// The complaints, if any.
    pub fn complaint(&self) -> Option<String> {
        match &self.outcome {
            _ if self.astray > 0 => Some(format!("{} samples where the density is 0", self.astray)),
            Err(fault) => Some(fault.clone()),
            Ok(p) if *p >= ALARM => None,
            Ok(_) => Some(format!(
                "samples do not follow the density, p-value {}",
                p_text(self)
            )),
        }
    }
}

pub fn measure(entry: &Entry, seed: u64, samples: usize) -> Figures {
    Figures {
        nanoseconds: time(entry, &mut generator(seed, entry, 0)),
        error: largest_error(entry, &mut generator(seed, entry, 1), samples),
        shape: shape(entry, &mut generator(seed, entry, 2), samples),
    }
}

/// Nanoseconds per sample by `fill`: the fastest of many blocks, since other work only slows one down.
fn time(entry: &Entry, rng: &mut Pcg32) -> f64 {
    let block = |rng: &mut Pcg32| {
        let start = Instant::now();
        for _ in 0..8 {
            std::hint::black_box(entry.warp.fill(rng, BLOCK));
        }
        start.elapsed().as_secs_f64() * 1e9 / (8 * BLOCK) as f64
    };
    (0..200).map(|_| block(rng)).fold(f64::INFINITY, f64::min)
}

/// The largest error of samples at drawn uniforms.
fn largest_error(entry: &Entry, rng: &mut Pcg32, samples: usize) -> f64 {
    let mut errors = figures::Figures::default();
    for _ in 0..samples {
        let mut u: Uniforms = [0.0; 4];
        for u in &mut u[..entry.uniforms] {
            *u = uniform::grid(rng);
        }
        let exact = Exact::of(entry, u, false);
        sample_error(entry, &exact, entry.warp.sample(u), &mut errors);
    }
    errors.sample
}

/// The chi-square test of samples against the density.
fn shape(entry: &Entry, rng: &mut Pcg32, samples: usize) -> Shape {
    let (samples, axes) = match entry.domain {
        Domain::Line => {
            let (cells, samples) = stats::resolve(entry, samples);
            let axis = Axis::new(cells, |u| stats::between_floats(entry, u));
            (samples, [axis, Axis::none()])
        }
        _ => (samples, AREA_CELLS.map(|cells| Axis::new(cells, |u| u))),
    };
    let [columns, rows] = axes.each_ref().map(Axis::cells);
    let mut observed = vec![0_u64; columns * rows];
    let (mut left, mut astray) = (samples, 0);
    while left > 0 {
        let block = left.min(BLOCK);
        for point in entry.warp.fill(rng, block) {
            let place = entry.chart.invert(point.map(f64::from));
            if place[0].is_finite() && place[1].is_finite() && entry.warp.pdf(point) > 0.0 {
                let [column, row] = [0, 1].map(|k| axes[k].find(place[k]) / axes[k].fine);
                observed[row * columns + column] += 1;
            } else {
                astray += 1;
            }
        }
        left -= block;
    }
    let expected = expected(entry, &axes, samples);
    let outcome = stats::chi_square(&observed, &expected).map(|(_, _, p)| p);
    Shape {
        samples,
        astray,
        outcome,
    }
}

/// How many samples the cells of the chart should hold: the crate's own density, by quadrature in f64.
fn expected(entry: &Entry, axes: &[Axis; 2], samples: usize) -> Vec<f64> {
    let columns = axes[0].cells();
    let mut expected = vec![0.0; columns * axes[1].cells()];
    let rows = axes[1].nodes(0);
    for (column, u, weight_u) in axes[0].nodes(GRADES) {
        for &(row, v, weight_v) in &rows {
            let point: Point = entry.chart.sample([u, v, 0.0, 0.0]).map(|x| x as f32);
            // The chart's own density is the reciprocal of its Jacobian.
            let stretch = entry.chart.pdf(point.map(f64::from));
            let density = f64::from(entry.warp.pdf(point)) / stretch;
            expected[row * columns + column] += samples as f64 * weight_u * weight_v * density;
        }
    }
    expected
}

// The table: one row for each warp, its parameters and a tier.

/// An error with its unit: ulp, or a distance as a share of the size of the domain.
pub fn error_text(entry: &Entry, error: f64) -> String {
    match entry.measure {
        Measure::Ulp => format!("{error:.2} ulp"),
        Measure::UlpAbove(_) => format!("{error:.2} ulp of itself or of a length"),
        Measure::UlpFrom(..) => format!("{error:.2} ulp of mean or deviate"),
        Measure::UlpOf(scale) => format!("{error:.2} ulp of {}", short(scale)),
        Measure::Length(1.0) => format!("{error:.2e}"),
        Measure::From(_) => format!("{error:.2e} of the distance or the location"),
        Measure::Length(length) => format!("{error:.2e} of {}", short(length)),
    }
}

fn short(x: f64) -> String {
    if (1e-3..1e4).contains(&x) {
        format!("{x}")
    } else {
        format!("{x:.0e}")
    }
}

pub fn print(rows: &[(&Entry, &Figures)]) {
    let header = [
        "warp",
        "parameters",
        "tier",
        "samples",
        "χ² p-value",
        "largest error",
        "ns a sample",
    ];
    let rows = rows.iter().map(|(entry, figures)| {
        vec![
            entry.name.to_string(),
            entry.parameters.to_string(),
            entry.tier.to_string(),
            thousands(figures.shape.samples),
            p_text(&figures.shape),
            error_text(entry, figures.error),
            format!("{:.1}", figures.nanoseconds),
        ]
    });
    table::print(&header, rows.collect(), 3);
    println!(
        "χ² p-value: samples against the density the crate reports, integrated over cells in f64; \
         below {ALARM:.0e} is a failure.\n\
         largest error: of a sample against f64, over as many samples; in ulp of the exact value, or as a \
         distance where no unit stands (\"of s\": in units of s).\n\
         ns a sample: through `fill` into this program's table, generator included, one thread of several at work."
    );
}
