//! The tabulated densities.
//!
//! Weights are whole numbers of 511ths on the line, and of 63rds of a row and 31sts of a column in the
//! plane: these are the numbers of cells with which shapes are tested, so that no jump of a density lies
//! within a cell and quadrature is exact.

use super::evidence::{direction, ramp};
use super::picture::{View, between, window};
use super::{Domain, Entry, Measure, Registered, entry};
use crate::adversary::words::Kind::{Any, Positive};
use crate::truth::{self, Truth, exact};
use microwarp::discrete::{
    Cdf, Grid, LatLongMap, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d, Storage,
    Word,
};
use microwarp::tier::Tier;
use microwarp::{Error, Invert};
use std::f64::consts::PI;
use std::sync::Arc;

/// The columns and the rows of [`sky`].
pub const SKY: [usize; 2] = [32, 16];

/// A sky of clouds with a sun in it, a column and a row without light.
pub fn sky() -> Vec<f32> {
    let [columns, rows] = SKY;
    let (dark, sun) = ([9, 6], [21, 11]);
    let mut weights = Vec::new();
    for row in 0..rows {
        // 31 in all.
        let share = match row {
            0 | 11 => 3,
            15 => 1,
            _ => 2 * u32::from(row != dark[1]),
        };
        let cloud = |column: usize| {
            let (x, y) = (column as f64, row as f64);
            (0.4 * x + 0.7 * y).sin() + (0.23 * x - 0.9 * y + 1.0).sin()
        };
        let mut brightest: Vec<usize> = (0..columns).filter(|c| *c != dark[0]).collect();
        let clouds: Vec<f64> = (0..columns).map(cloud).collect();
        brightest.sort_by(|a, b| clouds[*b].total_cmp(&clouds[*a]));
        // 63 in a row: 31 cells of 1, the rest in clouds and in the sun.
        let mut cells = vec![1; columns];
        cells[dark[0]] = 0;
        let (thick, thin) = if row == sun[1] {
            brightest.retain(|c| *c != sun[0]);
            cells[sun[0]] += 7;
            (10, 5)
        } else {
            (12, 8)
        };
        brightest[..thick].iter().for_each(|c| cells[*c] += 2);
        let rim = &brightest[thick..thick + thin];
        rim.iter().for_each(|c| cells[*c] += 1);
        assert_eq!(cells.iter().sum::<u32>(), 63);
        weights.extend(cells.iter().map(|w| (w * share) as f32));
    }
    weights
}

/// A table in memory that lives as long as the program.
fn leaked<W: Copy + Default>(entries: usize) -> &'static mut [W] {
    Box::leak(vec![W::default(); entries].into_boxed_slice())
}

fn on_line<T: Tier, W>(weights: &[f64], range: [f32; 2], warp: W) -> Entry
where
    W: Invert<Uniforms = f32, Point = f32, Density = f32> + Send + Sync + 'static,
{
    let scale = Measure::UlpOf(f64::from(range[0].abs().max(range[1].abs())));
    let truth = exact!(Histogram::new(&reals(weights), range).expect("a positive weight"));
    let entry = entry::<T, _>("PiecewiseConstant1d", Domain::Line, scale, warp, truth);
    entry.outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]])
}

fn wide_weights(weights: &[f32]) -> Vec<f64> {
    weights.iter().map(|w| f64::from(*w)).collect()
}

fn narrow<T: Tier>(weights: &[f32], range: [f32; 2]) -> Result<Entry, Error> {
    let cdf = Cdf::<&[u32]>::new_in(weights, leaked(weights.len()))?;
    let warp = PiecewiseConstant1d::from_cdf(cdf, range[0], range[1])?;
    Ok(on_line::<T, _>(&wide_weights(weights), range, warp))
}

fn wide<T: Tier>(weights: &[f32], range: [f32; 2]) -> Result<Entry, Error> {
    let cdf = Cdf::<&[u64]>::new_in(weights, leaked(weights.len()))?;
    let warp = PiecewiseConstant1d::from_cdf(cdf, range[0], range[1])?;
    Ok(on_line::<T, _>(&wide_weights(weights), range, warp).words(2))
}

fn in_plane<T: Tier>(
    weights: &[f32],
    shape: [usize; 2],
    [u, v]: [[f32; 2]; 2],
    words: usize,
) -> Result<Entry, Error> {
    let truth = exact!(Picture::new(weights, shape[0], u, v));
    let size = u.into_iter().chain(v).fold(0.0, |m: f32, x| m.max(x.abs()));
    macro_rules! of {
        ($word:ty) => {
            picture::<T, _>(
                truth,
                size,
                PiecewiseConstant2d::<&[$word], &[$word]>::new_in(
                    weights,
                    shape,
                    u,
                    v,
                    leaked(shape[1]),
                    leaked(weights.len()),
                )?,
            )
        };
    }
    let entry = if words == 1 { of!(u32) } else { of!(u64) };
    Ok(entry.words(2 * words))
}

fn picture<T: Tier, W>(truth: Arc<dyn Truth>, size: f32, warp: W) -> Entry
where
    W: Invert<Uniforms = [f32; 2], Point = [f32; 2], Density = f32> + Send + Sync + 'static,
{
    let size = Measure::Length(size.into());
    let entry = entry::<T, _>("PiecewiseConstant2d", Domain::Plane, size, warp, truth);
    entry.outside(&[[5.1, 0.5, 0.0], [0.5, f32::MAX, 0.0], [-3.1, -0.5, 0.0]])
}

/// A range and as many weights as there are cells. The truth has the words of the table, not the weights.
fn cells<T: Tier, const N: usize>(p: &[f32]) -> Result<Entry, Error> {
    let range = [p[0], p[1]];
    let weights: &[f32; N] = p[2..].try_into().expect("a weight a cell");
    let warp = PiecewiseConstant1d::new(weights, range[0], range[1])?;
    Ok(on_line::<T, _>(&numerators(warp.cdf()), range, warp))
}

/// Two ranges and the weights of two rows. The truth has the words of the tables.
fn four_cells<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let (u, v) = ([p[0], p[1]], [p[2], p[3]]);
    let weights = [[p[4], p[5]], [p[6], p[7]]];
    let warp = PiecewiseConstant2d::new(&weights, u, v)?;
    let rows = [0, 1].map(|row| numerators(warp.conditional(row).cdf()));
    let marginal = numerators(warp.marginal().cdf());
    let truth = exact!(Picture::of((&marginal, v), (&rows, u)));
    let size = p[..4].iter().fold(0.0, |m: f32, x| m.max(x.abs()));
    Ok(picture::<T, _>(truth, size, warp))
}

/// The exact probabilities of a table.
fn numerators<W: Word, S: Storage<Item = W>>(cdf: &Cdf<S>) -> Vec<f64> {
    let count = |j| -> u128 { cdf.numerator(j).into() };
    (0..cdf.entries()).map(|j| count(j) as f64).collect()
}

/// A density that is linear between weights. The truth has the words of the table.
fn linear<T: Tier, W, S, V>(warp: PiecewiseLinear1d<S, V>, words: usize) -> Entry
where
    W: Word,
    S: Storage<Item = W> + Send + Sync + 'static,
    V: Storage<Item = f32> + Send + Sync + 'static,
{
    let range = [warp.low(), warp.high()];
    let mut cells = numerators(warp.cdf());
    assert_eq!(cells.pop(), Some(0.0), "the entry beyond the last cell");
    let scale = Measure::UlpOf(f64::from(range[0].abs().max(range[1].abs())));
    let truth = exact!(Polyline::new(&cells, range, warp.weights()));
    let entry = entry::<T, _>("PiecewiseLinear1d", Domain::Line, scale, warp, truth);
    entry
        .outside(&[[f32::MAX, 0.0, 0.0], [-f32::MAX, 0.0, 0.0]])
        .words(words)
}

/// A range and as many weights as there are vertices.
fn vertices<T: Tier, const N: usize>(p: &[f32]) -> Result<Entry, Error> {
    let weights: &[f32; N] = p[2..].try_into().expect("a weight a vertex");
    Ok(linear::<T, _, _, _>(
        PiecewiseLinear1d::new(weights, p[0], p[1])?,
        1,
    ))
}

/// Weights that are listed, in borrowed memory.
fn interpolated<T: Tier>(weights: &[f32], range: [f32; 2]) -> Result<Entry, Error> {
    let kept: &'static [f32] = Box::leak(weights.to_vec().into_boxed_slice());
    let memory = leaked::<u32>(kept.len());
    let warp = PiecewiseLinear1d::<&[u32], &[f32]>::new_in(kept, range[0], range[1], memory)?;
    Ok(linear::<T, _, _, _>(warp, 1))
}

/// A sky by latitude and longitude. The truth has the words of the table.
fn lat_long<T: Tier, W, M, C>(warp: LatLongMap<T, M, C>, words: usize) -> Entry
where
    W: Word,
    M: Storage<Item = W> + Send + Sync + 'static,
    C: Grid<Item = W> + Send + Sync + 'static,
{
    let table = warp.table();
    let marginal = numerators(table.marginal().cdf());
    let rows = (0..warp.shape()[1]).map(|row| numerators(table.conditional(row).cdf()));
    let rows: Vec<_> = rows.collect();
    let beside = truth::Sky::of(&marginal, &rows).beside(1.0 / 8_388_608.0, 1.6e-6);
    let truth = exact!(Sky::of(&marginal, &rows));
    let size = Measure::Length(1.0);
    let mut entry = entry::<T, _>("LatLongMap", Domain::Directions, size, warp, truth);
    // The first uniform is the azimuth.
    (entry.azimuth, entry.polar, entry.cosine) = (false, false, false);
    entry.slack = 1e-4;
    entry
        .outside(&[])
        .words(2 * words)
        .variables(&[("m", beside)])
}

/// Radiances that are listed.
fn radiances<T: Tier, W: Word + Default + Send + Sync + 'static>(
    weights: &[f32],
    shape: [usize; 2],
    words: usize,
) -> Result<Entry, Error> {
    // Searches build it again and again.
    let warp = LatLongMap::<T, Vec<W>, Vec<W>>::from_slice(weights, shape)?;
    Ok(lat_long::<T, W, _, _>(warp, words))
}

/// Radiances that give the pixels these masses, so that rows and columns end where the cells of the statistics do.
fn of_masses(masses: &[f32], [columns, rows]: [usize; 2]) -> Vec<f32> {
    let cos = |row: usize| (std::f64::consts::PI * row as f64 / rows as f64).cos();
    let radiance = |(pixel, mass): (usize, &f32)| {
        let row = pixel / columns;
        (f64::from(*mass) / (cos(row) - cos(row + 1))) as f32
    };
    masses.iter().enumerate().map(radiance).collect()
}

/// As many radiances as pixels.
fn pixels<T: Tier, const U: usize, const V: usize>(p: &[f32]) -> Result<Entry, Error> {
    let mut rows = [[0.0; U]; V];
    for (row, weights) in rows.iter_mut().zip(p.chunks_exact(U)) {
        row.copy_from_slice(weights);
    }
    Ok(lat_long::<T, u32, _, _>(
        LatLongMap::<T, [u32; V], [[u32; U]; V]>::new(&rows)?,
        1,
    ))
}

/// A density of weights that are listed: no numbers are searched.
fn listed(
    name: &'static str,
    label: &'static str,
    build: fn(&[f32]) -> Result<Entry, Error>,
    change: fn(Entry) -> Entry,
) -> Registered {
    Registered::new(name, label, &[], build).case_with(label, &[], change)
}

const FOUR: [f32; 4] = [146.0, 0.0, 292.0, 73.0];
const UNIT: [f32; 2] = [0.0, 1.0];

/// Weights that are products of a row's and a column's.
fn product(along_u: &[f32], along_v: &[f32]) -> Vec<f32> {
    let row = |v: &f32| along_u.iter().map(|u| u * v).collect::<Vec<_>>();
    along_v.iter().flat_map(row).collect()
}

/// 6 x 6 cells, those along the edges dark.
fn frame() -> Vec<f32> {
    product(
        &[0.0, 7.0, 0.0, 21.0, 35.0, 0.0],
        &[0.0, 5.0, 0.0, 0.0, 26.0, 0.0],
    )
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    const LINE: &str = "PiecewiseConstant1d";
    const PLANE: &str = "PiecewiseConstant2d";
    const LINEAR: &str = "PiecewiseLinear1d";
    const SKY_OF: &str = "LatLongMap";
    vec![
        listed(LINE, "2:0:4:1 on [0, 8]", |_| {
            let warp = PiecewiseConstant1d::new(&FOUR, 0.0, 8.0)?;
            Ok(on_line::<T, _>(&wide_weights(&FOUR), [0.0, 8.0], warp))
        }, |e| {
            e.picture("cells of weight 2, 0, 4 and 1", View::Line(between(-0.4, 8.4)))
        })
            .control("a cell with slightly too much", |[u, ..], wrong| [four(u, 2.0 * (1.0 + wrong) / 7.0), 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .control("a cell that leaks into one of weight zero", |[u, ..], _| [four(u, 2.0 / 7.0) + if u < 2.0 / 7.0 { 0.01 } else { 0.0 }, 0.0, 0.0], &["has density 0"]),
        listed(LINE, "0:0:3:4:0 on [-3, 5]", |_| narrow::<T>(&[0.0, 0.0, 219.0, 292.0, 0.0], [-3.0, 5.0]), |e| e),
        listed(LINE, "10 equal on [-3e38, 3e38]", |_| narrow::<T>(&[0.1; 10], [-3e38, 3e38]), |e| e),
        listed(LINE, "1 on [0, 1e-35]", |_| narrow::<T>(&[1e-30], [0.0, 1e-35]), |e| e),
        listed(LINE, "73 on [0, 1]", |_| {
            let mut many: Vec<f32> = (0..73).map(|k| (5 * k % 13 + 1) as f32).collect();
            many[72] = 511.0 - many[..72].iter().sum::<f32>();
            narrow::<T>(&many, UNIT)
        }, |e| e),
        listed(LINE, "2:0:4:1 on [1e30, 3e30], u64", |_| wide::<T>(&FOUR, [1e30, 3e30]), |e| e),
        listed(LINE, "8 decades on [-1, 0], u64", |_| {
            let decades: Vec<f32> = (0..8).map(|k| 10f32.powi(k - 7)).collect();
            wide::<T>(&decades, [-1.0, 0.0])
        }, |e| e),
        // Nearly all of u goes into the 3e5 floats of one cell.
        listed(LINE, "1e6 among 63 of 1, u64", |_| {
            let mut bright = vec![1.0; 64];
            bright[37] = 1e6;
            wide::<T>(&bright, [-20.0, 300.0])
        }, Entry::no_round_trip),
        Registered::new(LINE, "of 2 cells", &[Any, Any, Positive, Positive], cells::<T, 2>)
            .ordered(&[[0, 1]])
            .seed(&[-1.945_361_4, 1.981_400_4, 0.123_744_264, 0.151_265_96]),
        Registered::new(LINE, "of 4 cells", &[Any, Any, Positive, Positive, Positive, Positive], cells::<T, 4>)
            .ordered(&[[0, 1]]),
        listed(PLANE, "32 x 16 sky", |_| in_plane::<T>(&sky(), SKY, [UNIT; 2], 1), |e| {
            e.picture("clouds, a sun, a dark row", window(0.5, 0.5, 0.51))
        }),
        listed(PLANE, "sun 1595:1, 9 x 3", |_| {
            let sun = product(&[1.0, 1.0, 1.0, 55.0, 1.0, 1.0, 1.0, 1.0, 1.0], &[1.0, 29.0, 1.0]);
            in_plane::<T>(&sun, [9, 3], [[-3.0, 5.0], [0.1, 0.7]], 1)
        }, |e| e)
            .control("a picture without its sun", |[u, v, _], _| [8.0 * u - 3.0, 0.1 + 0.6 * v, 0.0], &["chi-square", "distance"]),
        listed(PLANE, "dark frame, 6 x 6", |_| in_plane::<T>(&frame(), [6, 6], [[-0.5, 1.0], UNIT], 1), |e| e),
        listed(PLANE, "1 x 1", |_| in_plane::<T>(&[0.25], [1, 1], [[-3.0, 5.0], UNIT], 1), |e| e),
        listed(PLANE, "1 x 5", |_| in_plane::<T>(&[3.0, 0.0, 7.0, 1.0, 20.0], [1, 5], [UNIT, [-3.0, 5.0]], 1), |e| e),
        listed(PLANE, "6 x 1", |_| in_plane::<T>(&[9.0, 0.0, 27.0, 6.0, 21.0, 0.0], [6, 1], [UNIT, [-3.0, 5.0]], 1), |e| e),
        listed(PLANE, "6 x 6 on 1e-30 by 6e38", |_| in_plane::<T>(&frame(), [6, 6], [[0.0, 1e-30], [-3e38, 3e38]], 1), |e| e),
        listed(PLANE, "32 x 16 sky, u64", |_| in_plane::<T>(&sky(), SKY, [UNIT, [-2.0, 0.3]], 2), |e| e),
        Registered::new(PLANE, "of 2 by 2 cells", &[Any, Any, Any, Any, Positive, Positive, Positive, Positive], four_cells::<T>)
            .ordered(&[[0, 1], [2, 3]])
            .seed(&[-1.136_488_4, 1.123_338_6, -1.131_686_4, 1.149_362_9, 0.069_521_83, 0.290_617_5, 0.890_342_7, 0.496_947_02]),
        listed(LINEAR, "0:3:1:1:0:0:2 on [0, 6]", |_| interpolated::<T>(&[0.0, 3.0, 1.0, 1.0, 0.0, 0.0, 2.0], [0.0, 6.0]), |e| {
            e.picture("linear between 0, 3, 1, 1, 0, 0 and 2", View::Line(between(-0.3, 6.3)))
        }),
        listed(LINEAR, "1:3 on [0, 1]", |_| interpolated::<T>(&[1.0, 3.0], UNIT), |e| e)
            .control("a slope taken for a step", |[u, ..], _| [u, 0.0, 0.0], &["chi-square", "distance", "mean x"])
            .control("a slope of the first cell slightly off", |[u, ..], wrong| [ramp(u, 1.0 + 4.0 * wrong, 3.0), 0.0, 0.0], &["chi-square", "distance", "mean x"]),
        listed(LINEAR, "5:0:1e-6:4 on [-3, 5]", |_| interpolated::<T>(&[5.0, 0.0, 1e-6, 4.0], [-3.0, 5.0]), |e| e),
        listed(LINEAR, "9 on [-3e38, 3e38]", |_| interpolated::<T>(&[1.0, 2.0, 0.5, 0.0, 3.0, 3.0, 1.0, 1e-3, 2.0], [-3e38, 3e38]), |e| e),
        listed(LINEAR, "74 on [0, 1]", |_| {
            let many: Vec<f32> = (0..74).map(|k| (5 * k % 13 + 13) as f32).collect();
            interpolated::<T>(&many, UNIT)
        }, |e| e),
        listed(LINEAR, "8 decades on [1e30, 3e30], u64", |_| {
            let decades: [f32; 8] = std::array::from_fn(|k| 10f32.powi(k as i32 - 7));
            Ok(linear::<T, _, _, _>(PiecewiseLinear1d::new_u64(&decades, 1e30, 3e30)?, 2))
        }, |e| e),
        Registered::new(LINEAR, "of 2 vertices", &[Any, Any, Positive, Positive], vertices::<T, 2>)
            .ordered(&[[0, 1]])
            .seed(&[0.0, 1.0, 0.0, 1.0]).seed(&[1.0, 2.0, 1.0, 0.0]).seed(&[-1.0, 1.0, 0.3, 1.0])
            .seed(&[-0.059_033_4, 0.059_913_926, 0.263_348_88, 30.369_606])
            .seed(&[-2.017_598_9, 0.059_918_76, 0.263_349_1, 30.369_635]),
        Registered::new(LINEAR, "of 4 vertices", &[Any, Any, Positive, Positive, Positive, Positive], vertices::<T, 4>)
            .ordered(&[[0, 1]])
            .seed(&[0.0, 1.0, 0.0, 1.0, 0.0, 1.0]),
        listed(SKY_OF, "32 x 16 sky", |_| radiances::<T, u32>(&of_masses(&sky(), SKY), SKY, 1), |e| e),
        listed(SKY_OF, "32 x 16 radiances", |_| radiances::<T, u32>(&sky(), SKY, 1), |mut e| {
            // Edges of pixels lie within the cells of the quadrature.
            e.resolved = false;
            e.picture("clouds, a sun, a dark row and column", View::Sky(std::f64::consts::PI))
        }),
        // The same as a uniform sphere.
        listed(SKY_OF, "6 x 7 grey", |_| radiances::<T, u32>(&[0.25; 42], [6, 7], 1), |e| e)
            .control("a grey sky without sin theta in the weights of its rows", |[u, v, _], _| grey(u, 7.0 * v, false), &["chi-square", "distance", "mean z²"])
            .control("a grey sky with theta linear within a row", |[u, v, _], _| grey(u, weighed(v), true), &["chi-square", "distance"]),
        listed(SKY_OF, "dark frame, 6 x 6", |_| radiances::<T, u32>(&frame(), [6, 6], 1), |e| e),
        listed(SKY_OF, "1 x 1", |_| radiances::<T, u32>(&[1e30], [1, 1], 1), |e| e),
        listed(SKY_OF, "1 x 5", |_| radiances::<T, u32>(&of_masses(&[3.0, 0.0, 7.0, 1.0, 20.0], [1, 5]), [1, 5], 1), |e| e),
        listed(SKY_OF, "6 x 1", |_| radiances::<T, u32>(&[9.0, 0.0, 27.0, 6.0, 21.0, 0.0], [6, 1], 1), |e| e),
        listed(SKY_OF, "50 x 25 checked", |_| {
            let checked: Vec<f32> = (0..50 * 25).map(|k| ((k % 50 + k / 50) % 2) as f32).collect();
            radiances::<T, u32>(&checked, [50, 25], 1)
        }, |mut e| {
            // Nodes of the quadrature lie on edges, and round to the dark side of them.
            e.resolved = false;
            e
        }),
        listed(SKY_OF, "32 x 16 sky, u64", |_| radiances::<T, u64>(&of_masses(&sky(), SKY), SKY, 2), |e| e),
        Registered::new(SKY_OF, "of 3 by 2 pixels", &[Positive; 6], pixels::<T, 3, 2>)
            .seed(&[1.0; 6]).seed(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]),
        Registered::new(SKY_OF, "of 2 by 5 pixels", &[Positive; 10], pixels::<T, 2, 5>)
            .seed(&[1.0; 10]).seed(&[1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0]),
    ]
}

/// Cells of 2, 0, 4, 1 on [0, 8), the first with a share of its own.
fn four(u: f64, first: f64) -> f64 {
    if u < first {
        2.0 * u / first
    } else if u < 6.0 / 7.0 {
        4.0 + 2.0 * (u - first) / (6.0 / 7.0 - first)
    } else {
        6.0 + 14.0 * (u - 6.0 / 7.0)
    }
}

/// cos θ at both edges of one of seven rows.
fn edges(row: f64) -> [f64; 2] {
    [row, row + 1.0].map(|j| (PI * j / 7.0).cos())
}

/// A place that counts seven rows of a grey sky, each of the right weight.
fn weighed(v: f64) -> f64 {
    let cos = 1.0 - 2.0 * v;
    let row = (7.0 * cos.acos() / PI).min(6.999_999).floor();
    let [top, bottom] = edges(row);
    row + (top - cos) / (top - bottom)
}

/// A direction of a grey sky in seven rows, at a place that counts rows: uniform within its row, or with equal steps of
/// θ, which crowd towards the poles.
fn grey(u: f64, place: f64, linear: bool) -> [f64; 3] {
    let row = place.min(6.999_999).floor();
    let [top, bottom] = edges(row);
    let theta = if linear {
        PI * place / 7.0
    } else {
        (top + (place - row) * (bottom - top)).acos()
    };
    direction(theta, u)
}
