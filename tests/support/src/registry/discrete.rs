//! The piecewise-constant densities.
//!
//! Weights are whole numbers of 511ths on the line, and of 63rds of a row and 31sts of a column in the
//! plane: these are the numbers of cells with which shapes are tested, so that no jump of a density lies
//! within a cell and quadrature is exact.

use super::{Domain, Entry, Measure, entry};
use crate::truth::{self, Truth};
use microwarp::Warp;
use microwarp::discrete::{Cdf, PiecewiseConstant1d, PiecewiseConstant2d};
use microwarp::tier::Tier;

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
        brightest.sort_by(|a, b| cloud(*b).total_cmp(&cloud(*a)));
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

fn on_line<T: Tier, W>(label: &'static str, weights: &[f32], range: [f32; 2], warp: W) -> Entry
where
    W: Warp<Uniforms = f32, Point = f32, Density = f32> + Send + Sync + 'static,
{
    let wide: Vec<f64> = weights.iter().map(|w| f64::from(*w)).collect();
    let truth = truth::Histogram::new(&wide, range).unwrap();
    entry::<T, _>(
        "PiecewiseConstant1d",
        label,
        Domain::Line,
        Measure::UlpOf(f64::from(range[0].abs().max(range[1].abs()))),
        warp,
        Box::new(truth) as Box<dyn Truth>,
    )
}

fn narrow<T: Tier>(label: &'static str, weights: &[f32], range: [f32; 2]) -> Entry {
    let cdf = Cdf::<&[u32]>::new_in(weights, leaked(weights.len())).unwrap();
    let warp = PiecewiseConstant1d::new(cdf, range[0], range[1]).unwrap();
    on_line::<T, _>(label, weights, range, warp)
}

fn wide<T: Tier>(label: &'static str, weights: &[f32], range: [f32; 2]) -> Entry {
    let cdf = Cdf::<&[u64]>::new_in(weights, leaked(weights.len())).unwrap();
    let warp = PiecewiseConstant1d::new(cdf, range[0], range[1]).unwrap();
    on_line::<T, _>(label, weights, range, warp).words(2)
}

fn in_plane<T: Tier>(
    label: &'static str,
    weights: &[f32],
    shape: [usize; 2],
    [u, v]: [[f32; 2]; 2],
    words: usize,
) -> Entry {
    let truth = truth::Picture::new(weights, shape[0], u, v);
    let size = u.into_iter().chain(v).fold(0.0, |m: f32, x| m.max(x.abs()));
    macro_rules! of {
        ($word:ty) => {
            entry::<T, _>(
                "PiecewiseConstant2d",
                label,
                Domain::Plane,
                Measure::Length(f64::from(size)),
                PiecewiseConstant2d::<&[$word], &[$word]>::new_in(
                    weights,
                    shape,
                    u,
                    v,
                    leaked(shape[1]),
                    leaked(weights.len()),
                )
                .unwrap(),
                Box::new(truth) as Box<dyn Truth>,
            )
        };
    }
    let entry = if words == 1 { of!(u32) } else { of!(u64) };
    entry.words(2 * words)
}

pub(crate) fn entries<T: Tier>() -> Vec<Entry> {
    let four = [146.0, 0.0, 292.0, 73.0];
    let dark_ends = [0.0, 0.0, 219.0, 292.0, 0.0];
    let decades: Vec<f32> = (0..8).map(|k| 10f32.powi(k - 7)).collect();
    let mut many: Vec<f32> = (0..73).map(|k| (5 * k % 13 + 1) as f32).collect();
    many[72] = 511.0 - many[..72].iter().sum::<f32>();
    let mut bright = vec![1.0; 64];
    bright[37] = 1e6;
    let array = PiecewiseConstant1d::<[u32; 4]>::from_weights(&four, 0.0, 8.0).unwrap();
    let mut t = vec![
        on_line::<T, _>("2:0:4:1 on [0, 8]", &four, [0.0, 8.0], array),
        narrow::<T>("0:0:3:4:0 on [-3, 5]", &dark_ends, [-3.0, 5.0]),
        narrow::<T>("10 equal on [-3e38, 3e38]", &[0.1; 10], [-3e38, 3e38]),
        narrow::<T>("1 on [0, 1e-35]", &[1e-30], [0.0, 1e-35]),
        narrow::<T>("73 on [0, 1]", &many, [0.0, 1.0]),
        wide::<T>("2:0:4:1 on [1e30, 3e30], u64", &four, [1e30, 3e30]),
        wide::<T>("8 decades on [-1, 0], u64", &decades, [-1.0, 0.0]),
        // Nearly all of u goes into the 3e5 floats of one cell.
        wide::<T>("1e6 among 63 of 1, u64", &bright, [-20.0, 300.0]).no_round_trip(),
    ];

    let product = |along_u: &[f32], along_v: &[f32]| -> Vec<f32> {
        let row = |v: &f32| along_u.iter().map(|u| u * v).collect::<Vec<_>>();
        along_v.iter().flat_map(row).collect()
    };
    let sun = product(
        &[1.0, 1.0, 1.0, 55.0, 1.0, 1.0, 1.0, 1.0, 1.0],
        &[1.0, 29.0, 1.0],
    );
    let frame = product(
        &[0.0, 7.0, 0.0, 21.0, 35.0, 0.0],
        &[0.0, 5.0, 0.0, 0.0, 26.0, 0.0],
    );
    let column: Vec<f32> = [3.0, 0.0, 7.0, 1.0, 20.0].into();
    let row: Vec<f32> = [9.0, 0.0, 27.0, 6.0, 21.0, 0.0].into();
    let unit = [0.0, 1.0];
    let far = [[0.0, 1e-30], [-3e38, 3e38]];
    t.extend([
        in_plane::<T>("32 x 16 sky", &sky(), SKY, [unit; 2], 1),
        in_plane::<T>(
            "sun 1595:1, 9 x 3",
            &sun,
            [9, 3],
            [[-3.0, 5.0], [0.1, 0.7]],
            1,
        ),
        in_plane::<T>("dark frame, 6 x 6", &frame, [6, 6], [[-0.5, 1.0], unit], 1),
        in_plane::<T>("1 x 1", &[0.25], [1, 1], [[-3.0, 5.0], unit], 1),
        in_plane::<T>("1 x 5", &column, [1, 5], [unit, [-3.0, 5.0]], 1),
        in_plane::<T>("6 x 1", &row, [6, 1], [unit, [-3.0, 5.0]], 1),
        in_plane::<T>("6 x 6 on 1e-30 by 6e38", &frame, [6, 6], far, 1),
        in_plane::<T>("32 x 16 sky, u64", &sky(), SKY, [unit, [-2.0, 0.3]], 2),
    ]);
    t
}
