//! The warps of the plane, of boxes and of triangles in space.

use super::evidence::{disk, leftover};
use super::picture::{CORNER, EQUILATERAL, FLAT, window};
use super::{Domain, Entry, Flat, Measure, Registered, ends, entry, evidence, in_both};
use crate::adversary::words::Kind::{Any, Positive, Within};
use crate::truth::{self, Truth, exact};
use microwarp::Error::{self, *};
use microwarp::Invert;
use microwarp::tier::Tier;
use microwarp::warp::*;
use std::sync::Arc;

const NAN: f32 = f32::NAN;

const TINY: f32 = 1.0e-45;

/// Four numbers as two rows.
pub(super) fn square(p: &[f32]) -> [[f32; 2]; 2] {
    [[p[0], p[1]], [p[2], p[3]]]
}

fn on_disk<T: Tier, W>(name: &'static str, warp: W, truth: Arc<dyn Truth>) -> Entry
where
    W: Invert<Uniforms = [f32; 2], Point = [f32; 2], Density = f32> + Send + Sync + 'static,
{
    let mut entry = entry::<T, _>(name, Domain::Plane, Measure::Length(1.0), warp, truth);
    entry.inside = |[x, y, _]| x * x + y * y <= 1.0;
    entry.outside(&[[1.0, 0.1, 0.0], [-0.8, 0.7, 0.0]])
}

fn normal_pair<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let (mean, std_dev) = ([p[0], p[1]], p[2]);
    let truth = exact!(NormalPair {
        mean: mean.map(Real::from),
        deviation: Real::from(std_dev),
    });
    let size = Measure::Length(truth::normal_pair_size(mean, std_dev));
    let warp = NormalPair::<T>::new(mean, std_dev)?;
    let mut entry = entry::<T, _>("NormalPair", Domain::Plane, size, warp, truth);
    let far = mean[0].abs().max(mean[1].abs());
    entry.azimuth = true;
    // Whatever the plane holds may be a sample; its inverse far out is an end.
    entry.slack = f64::INFINITY;
    Ok(entry
        .own_density()
        .variables(&[("w", f64::from(far) / f64::from(std_dev))])
        .outside(&[]))
}

fn student_pair<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let [degrees, scale] = [p[0], p[3]];
    let location = [p[1], p[2]];
    let warp = StudentPair::<T>::new(degrees, location, scale)?;
    let [a, b] = location.map(f64::from);
    let truth = exact!(StudentPair {
        degrees: Real::from(degrees),
        location: location.map(Real::from),
        scale: Real::from(scale),
    });
    let measure = Measure::From([a, b]);
    let mut entry = entry::<T, _>("StudentPair", Domain::Plane, measure, warp, truth);
    entry.azimuth = true;
    // Whatever the plane holds may be a sample; its inverse far out is an end.
    entry.slack = f64::INFINITY;
    let far = a.abs().max(b.abs());
    Ok(entry
        .deep()
        .variables(&[("w", far / f64::from(scale))])
        .outside(&[]))
}

/// The covariance matrix of two deviations and their correlation.
fn covariance(p: &[f32]) -> [[f32; 2]; 2] {
    let both = p[2] * p[0] * p[1];
    [[p[0] * p[0], both], [both, p[1] * p[1]]]
}

/// Two normal numbers of two means, two deviations and a correlation.
fn multivariate_normal<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let (mean, matrix) = ([p[0], p[1]], covariance(&p[2..]));
    let warp = MultivariateNormal::<T, 2>::new(mean, matrix)?;
    if warp.rank() < 2 {
        // There is no density of the plane then; `tests/laws` has these.
        return Err(OutOfRange(1));
    }
    let (factor, free) = (*warp.factor(), warp.free());
    let truth = exact!(MultivariateNormal::new(mean, matrix, &factor, free));
    let [[xx, xy], [_, yy]] = matrix.map(|row| row.map(f64::from));
    let size = largest(&mean) + 14.2 * xx.max(yy).sqrt();
    let share = (xy * xy / xx / yy).sqrt();
    let unit = Measure::Length(size);
    let mut entry = entry::<T, _>("MultivariateNormal", Domain::Plane, unit, warp, truth);
    (entry.open, entry.slack) = (true, f64::INFINITY);
    Ok(entry
        .own_density_of_word()
        .variables(&[("c", (1.0 + share) / (1.0 - share))])
        .outside(&[]))
}

fn triangle_on<T: Tier, const D: usize>(p: &[f32], domain: Domain) -> Result<Entry, Error>
where
    [f32; D]: Flat<3> + Flat<4>,
{
    let vertices: [[f32; D]; 3] = std::array::from_fn(|i| std::array::from_fn(|k| p[i * D + k]));
    let warp = TriangleOn::new(vertices)?;
    let size = f64::from(p.iter().fold(0.0_f32, |size, x| size.max(x.abs())));
    let wide = vertices.map(|v| [0, 1, 2].map(|k| v.get(k).copied().unwrap_or(0.0)));
    let height = truth::OnTriangle(wide.map(|v| v.map(f64::from))).height() / size;
    let truth = exact!(OnTriangle(wide.map(|v| v.map(Real::from))));
    let entry = entry::<T, _>("TriangleOn", domain, Measure::Length(size), warp, truth);
    let outside: &[_] = if domain == Domain::Plane {
        &[[5.0e18, 3.0, 0.0], [0.1, -1.0e18, 0.0]]
    } else {
        &[[5.0e18, 3.0, 0.0], [0.1, -1.0e18, 0.0], [0.2, 0.2, 1.0e18]]
    };
    Ok(entry.variables(&[("h", height)]).outside(outside))
}

fn largest(ends: &[f32]) -> f64 {
    ends.iter().fold(0.0, |m: f32, x| m.max(x.abs())).into()
}

/// The bounds of each side, one after the other.
fn sides<T: Tier, const N: usize>(p: &[f32], domain: Domain) -> Result<Entry, Error>
where
    [f32; N]: Flat<3> + Flat<4>,
{
    let [low, high] = [0, 1].map(|end| std::array::from_fn(|i| p[2 * i + end]));
    let warp = Aabb::<N>::new(low, high)?;
    let truth = exact!(Sides(
        (0..N).map(|i| [low[i], high[i]].map(Real::from)).collect()
    ));
    let size = largest(p);
    let entry = entry::<T, _>("Aabb", domain, Measure::Length(size), warp, truth);
    let entry = entry.variables(&[("n", N as f64), ("m", size)]);
    Ok(entry.outside(&[[f32::MAX, 2.0, 0.0], [0.0, f32::MAX, 0.0]]))
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    vec![
        Registered::new("Disk", "", &[], |_| {
            let mut entry = on_disk::<T, _>("Disk", Disk::<T>::new(), exact!(Disk));
            entry.azimuth = true;
            entry.rims = &[|rim, u| [rim, u, 0.0, 0.0]];
            Ok(entry)
        })
            .case_with("", &[], |e| e.picture("polar map", window(0.0, 0.0, 1.02)).trade(evidence::DISK, "disk"))
            .control("a disk with r = xi", |[u, v, _], _| disk(u * u, v), &["chi-square", "distance", "mean x²", "mean y²"]),
        Registered::new("DiskConcentric", "", &[], |_| {
            let mut entry = on_disk::<T, _>("DiskConcentric", DiskConcentric::<T>::new(), exact!(DiskConcentric));
            entry.rims = &[
                |_, u| [0.0, u, 0.0, 0.0],
                |_, u| [u, 0.0, 0.0, 0.0],
                |rim, u| [rim, u, 0.0, 0.0],
                |rim, u| [u, rim, 0.0, 0.0],
            ];
            Ok(entry.chart(exact!(Disk)))
        })
            .case_with("", &[], |e| {
                e.picture("Shirley's concentric map", window(0.0, 0.0, 1.02)).trade(evidence::DISK, "disk_concentric")
            })
            .control("a disk turned slightly unevenly", |[u, v, _], wrong| disk(u, v.powf(1.0 + wrong)), &["chi-square", "distance", "mean y"]),
        Registered::new("Triangle", "", &[], |_| {
            let truth = exact!(Barycentric);
            let mut entry = entry::<T, _>("Triangle", Domain::Barycentric, Measure::Length(1.0), Triangle::new(), truth);
            entry.inside = |x| x.iter().all(|c| *c >= 0.0) && (x.iter().sum::<f64>() - 1.0).abs() <= 1.2e-7;
            Ok(entry.outside(&[[-0.1, 0.5, 0.6], [1.1, -0.1, 0.0]]))
        })
            .case_with("", &[], |e| e.picture("barycentric coordinates", EQUILATERAL))
            .control("a triangle with v = xi (1 - u)", |[u, v, _], _| leftover(u, v), &["chi-square", "distance", "mean x"]),
        Registered::new("NormalPair", "", &[Any, Any, Positive], normal_pair::<T>)
            .parameters(&[0, 0, 1])
            .case_with("0, 1", &[0.0, 0.0, 1.0], |e| {
                e.picture("Box and Muller, within 3σ", window(0.0, 0.0, 3.0)).trade(evidence::NORMAL, "normal_pair")
            })
            .control("a normal pair without the square root", |[u, v, _], _| disk(4.0 * (-u).ln_1p().powi(2), v), &["chi-square", "distance", "mean x²"])
            .case_with("(3, -2), 0.5", &[3.0, -2.0, 0.5], Entry::no_round_trip)
            .case_with("0, 1e-18", &[0.0, 0.0, 1e-18], Entry::no_round_trip)
            .case("0, 1e18", &[0.0, 0.0, 1e18])
            .seed(&[0.0, 0.0, 1.0]).seed(&[3.0, -2.0, 0.5])
            .refuse(&[0.0, NAN, 1.0], NotFinite(0)).refuse(&[0.0, 0.0, -1.0], NotPositive(1))
            .refuse(&[0.0, 0.0, 1.0e-30], Empty(1)).refuse(&[0.0, 0.0, 1.0e30], TooLarge(1))
            .constant(in_both!(NormalPair<T>::new([0.3, 3.0], 1.7)))
            .gives_back(|p| NormalPair::<T>::new([p[0], p[1]], p[2]).map(|warp| vec![warp.mean()[0], warp.mean()[1], warp.std_dev()])),
        Registered::new("StudentPair", "", &[Positive, Any, Any, Positive], student_pair::<T>)
            .parameters(&[0, 1, 1, 2])
            .case_with("3, 0, 1", &[3.0, 0.0, 0.0, 1.0], |e| {
                e.picture("Bailey's form, 3 degrees, within 7σ", window(0.0, 0.0, 7.0))
            })
            .control("a Student's t of other degrees in the plane", |[u, v, _], wrong| disk((3.0 + 30.0 * wrong) * (-2.0 * (-u).ln_1p() / (3.0 + 30.0 * wrong)).exp_m1(), v), &["chi-square", "distance"])
            .without("moment", "a draw takes two words, whose pairs are too many")
            .without("peer", "rand_distr has none in the plane")
            .case_with("1, (3, -2), 0.5", &[1.0, 3.0, -2.0, 0.5], Entry::no_round_trip)
            // Far out the density is below the smallest number.
            .case_with("0.3, 0, 1", &[0.3, 0.0, 0.0, 1.0], Entry::unresolved)
            .case("30, 0, 1e-18", &[30.0, 0.0, 0.0, 1e-18])
            .case("1e12, 0, 1e18", &[1e12, 0.0, 0.0, 1e18])
            .case("1e30, 0, 1", &[1e30, 0.0, 0.0, 1.0])
            .seed(&[1.0, 0.0, 0.0, 1.0]).seed(&[0.27, 0.0, 0.0, 1.0]).seed(&[1e8, 3.0, -2.0, 0.5]).seed(&[1e12, 0.0, 0.0, 1.0])
            .seed(&[1.1e12, -72.682_87, 0.003_523_225_4, 4.436_352_3]).seed(&[1.398_413e27, 0.048_473_828, 1.297_451_9, 1.417_010_3])
            .refuse(&[NAN, 0.0, 0.0, 1.0], NotFinite(0)).refuse(&[0.0, 0.0, 0.0, 1.0], NotPositive(0)).refuse(&[-1.0, 0.0, 0.0, 1.0], NotPositive(0))
            .refuse(&[1.0, NAN, 0.0, 1.0], NotFinite(1)).refuse(&[1.0, 0.0, 0.0, 0.0], NotPositive(2))
            .refuse(&[0.26, 0.0, 0.0, 1.0], TooLarge(0)).refuse(&[3.0, 0.0, 0.0, 1.0e-30], Empty(2)).refuse(&[3.0, 0.0, 0.0, 1.0e30], TooLarge(2))
            .constant(in_both!(StudentPair<T>::new(2.7, [0.3, 3.0], 1.7)))
            .gives_back(|p| StudentPair::<T>::new(p[0], [p[1], p[2]], p[3]).map(|warp| vec![warp.degrees(), warp.location()[0], warp.location()[1], warp.scale()])),
        Registered::new("MultivariateNormal", "", &[Any, Any, Positive, Positive, Within(-1.0, 1.0)], multivariate_normal::<T>)
            .parameters(&[0, 0, 1, 1, 1])
            .case_with("1, ½, 0.6", &[0.0, 0.0, 1.0, 0.5, 0.6], |e| {
                e.no_round_trip().picture("two correlated normal numbers, within 3σ", window(0.0, 0.0, 3.0))
            })
            .control(
                "correlated numbers without their correlation",
                |[u, v, _], _| [truth::normal_quantile(u), 0.5 * truth::normal_quantile(v), 0.0],
                &["chi-square"],
            )
            .case_with("(3, -2), 0.1, 4, -0.99", &[3.0, -2.0, 0.1, 4.0, -0.99], Entry::no_round_trip)
            .case_with("1e18, 1e-18, 0", &[0.0, 0.0, 1e18, 1e-18, 0.0], Entry::unresolved)
            .seed(&[0.0, 0.0, 1.0, 0.5, 0.6]).seed(&[3.0, -2.0, 0.1, 4.0, -0.99]).seed(&[0.0, 0.0, 1.0, 1.0, 0.999_999])
            .refuse(&[0.0, NAN, 1.0, 1.0, 0.0], NotFinite(0)).refuse(&[0.0, 0.0, 1.0, f32::MAX, 0.0], NotFinite(1))
            .refuse(&[0.0, 0.0, 1.0, 1.0, 1.1], NotNormalizable(1))
            .without("getters", "it keeps the factor in place of the matrix")
            .without("constant", "its constructor is no constant function: it takes roots")
            .without("moment", "a draw takes two words")
            .without("peer", "rand_distr has none"),
        Registered::new("TriangleOn", "plane", &[Any; 6], |p| triangle_on::<T, 2>(p, Domain::Plane))
            .parameters(&[0; 6])
            .case_with("plane", &[0.0, 0.0, 4.0, 0.0, 1.0, 3.0], |e| {
                e.picture("(0, 0), (4, 0), (1, 3)", FLAT)
            })
            .control("a triangle in the plane with v = xi (1 - u)", |[u, v, _], _| [4.0 * u + v * (1.0 - u), 3.0 * v * (1.0 - u), 0.0], &["chi-square", "distance", "mean x"])
            .case_with("plane 1e18", &[-1e18, 0.0, 1e18, -1e18, 0.0, 1e18], Entry::no_round_trip)
            .case_with("plane sliver", &[0.0, 0.0, 1.0, 0.0, 0.5, 1e-5], |mut e| {
                e.slack = 0.05;
                e.no_round_trip()
            })
            .seed(&[0.0, 0.0, 4.0, 0.0, 1.0, 3.0]).seed(&[0.0, 0.0, 1.0, 0.0, 0.5, 1e-11])
            .seed(&[0.1, 0.2, 0.7, 0.9, 0.4, 0.55]).seed(&[1e6, 0.1, 1_000_001.0, -0.3, 1e6, 0.7])
            .refuse(&[0.0, 0.0, 1.0, 1.0, 2.0, 2.0], Empty(0)).refuse(&[0.0; 6], Empty(0))
            .refuse(&[NAN, 0.0, 1.0, 0.0, 0.0, 1.0], NotFinite(0)).refuse(&[0.0, 0.0, 1e30, 0.0, 0.0, 1e30], TooLarge(0))
            .refuse(&[0.0, 0.0, 1e-30, 0.0, 0.0, 1e-30], Empty(0))
            .gives_back(|p| TriangleOn::new([[p[0], p[1]], [p[2], p[3]], [p[4], p[5]]]).map(|warp| warp.vertices().concat()))
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("TriangleOn", "space", &[Any; 9], |p| triangle_on::<T, 3>(p, Domain::Space))
            .parameters(&[0; 9])
            .case_with("space", &[1.0, 0.0, 0.0, 0.0, 2.0, 0.5, -1.0, 0.0, 3.0], |e| {
                e.no_round_trip().picture("three vertices in space", CORNER)
            })
            .seed(&[1.0, 0.0, 0.0, 0.0, 2.0, 0.5, -1.0, 0.0, 3.0])
            .seed(&[0.1, 0.2, 0.3, 0.7, 0.9, -0.4, 0.4, 0.55, -0.05])
            .seed(&[1e6, 0.1, -7e3, 1_000_001.0, -0.3, -7001.0, 1e6, 0.7, -7002.0])
            .refuse(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0], Empty(0)),
        Registered::new("Bilinear", "", &[Positive; 4], |p| {
            let warp = Bilinear::new(square(p))?;
            let truth = exact!(Bilinear(square(p).map(|row| row.map(Real::from))));
            let mut entry = entry::<T, _>("Bilinear", Domain::Plane, Measure::Length(1.0), warp, truth);
            (entry.open, entry.deep) = (false, true);
            entry.inside = |[x, y, _]| (0.0..1.0).contains(&x) && (0.0..1.0).contains(&y);
            Ok(entry.own_density().outside(&[[-1e-7, 0.5, 0.0], [1.000_000_1, 0.5, 0.0], [0.5, 2.0, 0.0]]))
        })
            .parameters(&[0; 4])
            .case_with("1 3 / 2 0", &[1.0, 3.0, 2.0, 0.0], |e| e.picture("corners of 1, 3, 2 and 0", window(0.5, 0.5, 0.51)))
            .without("peer", "rand_distr has none")
            .control("a square without its weights", |[u, v, _], _| [u, v, 0.0], &["chi-square", "distance", "mean x"])
            .case("0 1 / 1 2", &[0.0, 1.0, 1.0, 2.0])
            .case("1 0 / 0 1", &[1.0, 0.0, 0.0, 1.0])
            .case("0 0 / 0 1", &[0.0, 0.0, 0.0, 1.0])
            .case("1 0 / 0 0", &[1.0, 0.0, 0.0, 0.0])
            .case("0 1 / 0 1", &[0.0, 1.0, 0.0, 1.0])
            .case("equal", &[3e38; 4])
            .case_with("1e-45 3e38 / 0 1e-20", &[TINY, 3e38, 0.0, 1e-20], Entry::unresolved)
            .seed(&[TINY, 0.0, 0.0, 0.0]).seed(&[f32::MAX; 4]).seed(&[TINY, 3e-45, f32::MAX, 1e38]).seed(&[TINY; 4])
            .seed(&[1.0, 0.0, 0.0, 1.0]).seed(&[1766.677, 0.0, 0.014_073_868, 0.022_967_072]).seed(&[0.0, 1.0, 1e-4, 0.0])
            .seed(&[0.0, 1.0, 1.0, 2.0]).seed(&[1.0; 4])
            .refuse(&[1.0, NAN, 1.0, 1.0], NotFinite(0)).refuse(&[1.0, 1.0, f32::INFINITY, 1.0], NotFinite(0))
            .refuse(&[1.0, 1.0, 1.0, -1.0], Negative(0)).refuse(&[0.0; 4], NotPositive(0))
            .constant(in_both!(Bilinear::new([[0.1, 0.3], [0.7, 0.2]])))
            .without("getters", "its corners are densities")
            .without("moment", "a draw takes two words"),
        Registered::new("Aabb", "of 1 side", &[Any; 2], |p| sides::<T, 1>(p, Domain::Plane))
            .ordered(&[[0, 1]])
            .refuse(&[1.0, 0.0], Reversed(1))
            .constant(in_both!(Aabb::new([-1.0, 0.1, 1e-3], [2.0, 0.3, 1e20]))),
        Registered::new("Aabb", "of 2 sides", &[Any; 4], |p| sides::<T, 2>(p, Domain::Plane))
            .parameters(&[0, 1, 0, 1])
            .ordered(&[[0, 1], [2, 3]])
            .case_with("[-1, 1] x [2, 2.5]", &[-1.0, 1.0, 2.0, 2.5], |e| {
                e.picture("uniform on a box", window(0.0, 2.25, 1.05))
            })
            .control("a box bent by a power of xi near 1", |[u, v, _], wrong| [2.0 * u.powf(1.0 + wrong) - 1.0, 2.0 + 0.5 * v, 0.0], &["chi-square", "distance", "mean x"])
            .case("[0, 1e-30] x [-1e30, 0]", &[0.0, 1e-30, -1e30, 0.0])
            .case("[-3e38, 3e38] x [0, 1e-38]", &[-3e38, 3e38, 0.0, 1e-38])
            .refuse(&[0.0, 1.0, NAN, 1.0], NotFinite(0)).refuse(&[0.0, 1.0, 2.0, 1.0], Reversed(1))
            .refuse(&[0.0, 0.0, 0.0, 1.0], Empty(1))
            .gives_back(|p| Aabb::new([p[0], p[2]], [p[1], p[3]]).map(|warp| ends(warp.low(), warp.high()))),
        Registered::new("Aabb", "of 3 sides", &[Any; 6], |p| sides::<T, 3>(p, Domain::Space))
            .parameters(&[0, 1, 0, 1, 0, 1])
            .ordered(&[[0, 1], [2, 3], [4, 5]]),
    ]
}
