//! The warps over directions.

use super::evidence::direction;
use super::picture::View::Sky;
use super::{Domain, Entry, Measure, Registered, entry, evidence, in_both};
use crate::adversary::words::Kind::{self, Any, Positive, Within};
use crate::truth::{self, Truth, exact};
use microwarp::Error::{self, *};
use microwarp::tier::Tier;
use microwarp::warp::*;
use microwarp::{Invert, warp::Frame};
use std::f32::consts::PI as PI_32;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

const NAN: f32 = f32::NAN;
const INF: f32 = f32::INFINITY;

const TINY: f32 = 1.0e-45;

/// Directions about +z.
fn about_z<T: Tier, W>(name: &'static str, warp: W, truth: Arc<dyn Truth>) -> Entry
where
    W: Invert<Uniforms = [f32; 2], Point = [f32; 3], Density = f32> + Send + Sync + 'static,
{
    entry::<T, _>(name, Domain::Directions, Measure::Length(1.0), warp, truth)
}

/// Marks a density that is 0 below the horizon.
fn upper(mut entry: Entry) -> Entry {
    entry.inside = |[_, _, z]| z >= 0.0;
    entry.outside(&[[0.6, 0.0, -0.8], [0.0, 0.0, -1.0]])
}

fn cone<T: Tier>(warp: Result<Cone<T>, Error>, truth: Arc<dyn Truth>) -> Result<Entry, Error> {
    let mut entry = about_z::<T, _>("Cone", warp?, truth);
    entry.cosine = false;
    Ok(entry.outside(&[[0.0, 0.0, -1.0], [0.0, 0.999, -0.044_7]]))
}

/// Normals, of a density that is 0 below the horizon.
fn visible<T: Tier>(
    p: &[f32],
    warp: Result<GgxVisible<T>, Error>,
    bounded: bool,
) -> Result<Entry, Error> {
    let truth = exact!(GgxVisible::new([p[0], p[1], p[2]], [p[3], p[4]], bounded));
    let mut entry = upper(about_z::<T, _>("GgxVisible", warp?, truth));
    (entry.polar, entry.cosine, entry.own_density) = (false, false, true);
    let alpha = [p[3], p[4]].map(f64::from);
    let ratio = (alpha[0] / alpha[1]).max(alpha[1] / alpha[0]);
    // Next to the pole of the cap, whither no uniform of the grid but 0 leads, the azimuth is the rounding of the normal.
    Ok(entry.variables(&[("q", ratio), ("h", 1.0)]))
}

/// Reflections of a view in the plane of x and z, at so much of the sine, by two roughnesses.
fn reflected<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let (view, alpha) = ([p[0], 0.0, (1.0 - p[0] * p[0]).sqrt()], [p[1], p[2]]);
    let warp = Reflected::<T>::new(GgxVisible::bounded(view, alpha)?);
    let truth = exact!(Reflected(GgxVisible::new(view, alpha, true)));
    let mut entry = about_z::<T, _>("Reflected", warp, truth);
    (entry.polar, entry.cosine) = (false, false);
    // At a first uniform of 1e-5 the cap's pole is some 1e-3 away, where the rounding of a direction turns the azimuth by 5e-5.
    entry.slack = 1e-4;
    // As of the normals.
    let entry = entry.variables(&[("h", 1.0)]);
    Ok(entry.own_density().outside(&[]))
}

/// A view and two roughnesses.
const VIEW: [Kind; 5] = [
    Within(-1.0, 1.0),
    Within(-1.0, 1.0),
    Within(0.0, 1.0),
    Within(1e-4, 1.0),
    Within(1e-4, 1.0),
];

/// The phase function by the width of its peak, 1 − |g|.
fn peaked<T: Tier>(
    warp: Result<HenyeyGreenstein<T>, Error>,
    least: f32,
    backward: bool,
) -> Result<Entry, Error> {
    let truth = exact!(henyey_greenstein_peak(least, backward));
    let mut entry = about_z::<T, _>("HenyeyGreenstein", warp?, truth);
    entry.cosine = false;
    Ok(entry.own_density().outside(&[]))
}

/// 2⁻³².
const NARROWEST: f32 = 1.0 / 4_294_967_296.0;

fn patch<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let warp = SphericalPatch::<T>::from_turns(p[0], p[1], p[2], p[3])?;
    let [theta, phi] = [[p[0], p[1]], [p[2], p[3]]].map(|a| a.map(f64::from));
    let truth = truth::Patch { theta, phi };
    let variables = [
        ("c", truth.drop()),
        ("q", truth.reach()),
        ("w", truth.width()),
    ];
    let truth = exact!(Patch {
        theta: [p[0], p[1]].map(Real::from),
        phi: [p[2], p[3]].map(Real::from),
    });
    let mut entry = about_z::<T, _>("SphericalPatch", warp, truth);
    entry.polar = false;
    Ok(entry
        .variables(&variables)
        .outside(&[[-0.6, -0.1, 0.8], [0.0, 0.0, -1.0]]))
}

/// A warp about the normal that the first three parameters are.
fn oriented<T: Tier, W>(p: &[f32], warp: W, truth: Arc<dyn Truth>) -> Result<Entry, Error>
where
    W: Invert<Uniforms = [f32; 2], Point = [f32; 3], Density = f32> + Send + Sync + 'static,
{
    let normal = [p[0], p[1], p[2]];
    let warp = Oriented::new(warp, Frame::new(normal)?);
    let mut entry = entry::<T, _>("Oriented", Domain::World, Measure::Length(1.0), warp, truth);
    entry.composed = true;
    Ok(entry.own_density().outside(&[[0.0, 0.0, 1.0]]))
}

/// Where the parameters say a point, a centre and a radius.
fn seen<T: Tier>(point: [f32; 3], centre: [f32; 3], radius: f32) -> Result<Entry, Error> {
    let warp = VisibleSphere::<T>::new(point, centre, radius)?;
    let k = truth::SeenSphere::new(point, centre, radius).k();
    let truth = exact!(Turned::seen(&SeenSphere::new(point, centre, radius)));
    let measure = Measure::Length(1.0);
    let mut entry = entry::<T, _>("VisibleSphere", Domain::World, measure, warp, truth);
    // What one rounding of the direction changes in the first uniform.
    entry.slack = f64::max(2e-6, 6e-7 / k.sqrt());
    (entry.resolved, entry.round_trip) = (k > 1e-8, k > 1e-8);
    Ok(entry)
}

fn turned(
    constructor: &'static str,
    takes: &'static [Kind],
    build: fn(&[f32]) -> Result<Entry, Error>,
) -> Registered {
    Registered::new("Oriented", constructor, takes, build)
        .parameters(&[0; 4])
        .refuse(
            &[&[0.0; 3], &[1.0][..takes.len() - 3]].concat(),
            ZeroLength(0),
        )
        .refuse(
            &[&[0.0, NAN, 0.0], &[1.0][..takes.len() - 3]].concat(),
            NotFinite(0),
        )
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    vec![
        Registered::new("Sphere", "", &[], |_| {
            let mut entry = about_z::<T, _>("Sphere", Sphere::<T>::new(), exact!(sphere()));
            entry.cosine = false;
            Ok(entry.outside(&[]))
        })
            .case_with("", &[], |e| e.picture("all directions", Sky(PI)).trade(evidence::SPHERE, "sphere"))
            .control("a sphere with theta linear in xi", |[u, v, _], _| direction(PI * u, v), &["chi-square", "distance", "mean z²"]),
        Registered::new("Hemisphere", "", &[], |_| {
            Ok(upper(about_z::<T, _>("Hemisphere", Hemisphere::<T>::new(), exact!(hemisphere()))))
        })
            .case_with("", &[], |e| e.picture("the upper half", Sky(FRAC_PI_2)).trade(evidence::HEMISPHERE, "hemisphere"))
            .control("a hemisphere with theta linear in xi", |[u, v, _], _| direction(0.5 * PI * u, v), &["chi-square", "distance", "mean z", "mean z²"]),
        Registered::new("CosineHemisphere", "", &[], |_| {
            Ok(upper(about_z::<T, _>("CosineHemisphere", CosineHemisphere::<T>::new(), exact!(cosine_hemisphere()))))
        })
            .case_with("", &[], |e| {
                e.picture("p = cos θ / π, by inversion", Sky(FRAC_PI_2)).trade(evidence::COSINE, "cosine_hemisphere")
            })
            .control("a uniform hemisphere for Lambert's law", |[u, v, _], _| direction((1.0 - u).acos(), v), &["chi-square", "distance", "mean z"]),
        Registered::new("MalleyHemisphere", "", &[], |_| {
            let mut entry = upper(about_z::<T, _>("MalleyHemisphere", MalleyHemisphere::<T>::new(), exact!(Malley)));
            (entry.azimuth, entry.polar) = (false, false);
            Ok(entry.chart(exact!(cosine_hemisphere())))
        })
            .case_with("", &[], |e| {
                e.picture("p = cos θ / π, Malley's method", Sky(FRAC_PI_2)).trade(evidence::COSINE, "malley_hemisphere")
            })
            .control("a disk with r = xi, lifted", |[u, v, _], _| direction(u.asin(), v), &["chi-square", "distance", "mean z"]),
        Registered::new("PhongLobe", "", &[Positive], |p| {
            Ok(upper(about_z::<T, _>("PhongLobe", PhongLobe::<T>::new(p[0])?, exact!(phong(p[0])))).own_density().variables(&[("k", p[0].into())]))
        })
            .case("n=0", &[0.0])
            .case("n=1", &[1.0])
            .case("n=1.4136", &[1.413_630_8])
            .case("n=3.4715", &[3.471_497_3])
            .case_with("n=50", &[50.0], |e| e.picture("p ∝ cosⁿθ, n = 50", Sky(0.5)).trade(evidence::LOBE, "phong_lobe_50"))
            .control("a lobe of an exponent slightly off", |[u, v, _], wrong| direction((1.0 - u).powf((1.0 + wrong) / 51.0).acos(), v), &["chi-square", "distance"])
            .case("n=1e4", &[1e4])
            .case_with("n=1e6", &[1e6], |e| e.picture("p ∝ cosⁿθ, n = 10⁶", Sky(0.0035)))
            .case("n=1e8", &[1e8])
            .seed(&[50.0]).seed(&[1e8]).seed(&[TINY]).seed(&[1.0e20]).seed(&[f32::MAX])
            .refuse(&[NAN], NotFinite(0)).refuse(&[-0.1], Negative(0))
            .constant(in_both!(PhongLobe<T>::new(13.7)))
            .gives_back(|p| PhongLobe::<T>::new(p[0]).map(|warp| vec![warp.exponent()])),
        Registered::new("HenyeyGreenstein", "", &[Within(-1.0, 1.0)], |p| {
            let warp = HenyeyGreenstein::<T>::new(p[0])?;
            let mut entry = about_z::<T, _>("HenyeyGreenstein", warp, exact!(henyey_greenstein(p[0])));
            entry.cosine = false;
            Ok(entry.own_density().outside(&[]))
        })
            .case_with("g=0.8", &[0.8], |e| {
                e.picture("g = 0.8: p ∝ (1.64 − 1.6 cos θ)^−1.5", Sky(PI))
            })
            .control("fog of a g slightly off", |[u, v, _], wrong| direction(fog(0.8 * (1.0 - wrong), u).acos(), v), &["chi-square", "distance", "mean z"])
            .case("g=-0.5", &[-0.5])
            .case("g=0", &[0.0])
            .case("g=0.999", &[0.999])
            // Moments rest on directions far from the peak, too rare for any number of samples.
            .case_with("g=1-2^-24", &[0.999_999_94], |mut e| {
                e.resolved = false;
                e
            })
            .case_with("g=2^-24-1", &[-0.999_999_94], |mut e| {
                e.resolved = false;
                e
            })
            .seed(&[0.8]).seed(&[-0.5]).seed(&[0.3]).seed(&[1e-3]).seed(&[-1e-8]).seed(&[0.999_999_94]).seed(&[-0.999_999_94])
            .refuse(&[NAN], NotFinite(0)).refuse(&[INF], NotFinite(0)).refuse(&[1.0], OutOfRange(0)).refuse(&[-1.0], OutOfRange(0))
            .constant(in_both!(HenyeyGreenstein<T>::new(-0.6)))
            .constant(in_both!(HenyeyGreenstein<T>::from_one_minus_g(1e-7)))
            .constant(in_both!(HenyeyGreenstein<T>::from_one_plus_g(0.7)))
            .gives_back(|p| HenyeyGreenstein::<T>::new(p[0]).map(|warp| vec![warp.asymmetry()])),
        Registered::new("HenyeyGreenstein", "from_one_minus_g", &[Within(NARROWEST, 1.0)], |p| {
            peaked(HenyeyGreenstein::<T>::from_one_minus_g(p[0]), p[0], false)
        })
            .case("1-g=1e-3", &[1e-3])
            .case_with("1-g=1e-9", &[1e-9], |mut e| {
                e.resolved = false;
                e
            })
            .seed(&[1.0]).seed(&[0.2]).seed(&[1e-7]).seed(&[NARROWEST])
            .refuse(&[NAN], NotFinite(0)).refuse(&[0.0], NotPositive(0)).refuse(&[1.1], OutOfRange(0)).refuse(&[1e-10], OutOfRange(0)),
        Registered::new("HenyeyGreenstein", "from_one_plus_g", &[Within(NARROWEST, 1.0)], |p| {
            peaked(HenyeyGreenstein::<T>::from_one_plus_g(p[0]), p[0], true)
        })
            .case("1+g=0.3", &[0.3])
            .case_with("1+g=1e-9", &[1e-9], |mut e| {
                e.resolved = false;
                e
            })
            .seed(&[1.0]).seed(&[0.2]).seed(&[1e-7]).seed(&[NARROWEST])
            .refuse(&[INF], NotFinite(0)).refuse(&[-0.1], NotPositive(0)).refuse(&[1.1], OutOfRange(0)).refuse(&[1e-10], OutOfRange(0)),
        Registered::new("VonMisesFisher", "", &[Positive], |p| {
            let warp = VonMisesFisher::<T>::new(p[0])?;
            let mut entry = about_z::<T, _>("VonMisesFisher", warp, exact!(von_mises_fisher(p[0])));
            entry.cosine = false;
            Ok(entry.own_density().outside(&[]))
        })
            .case_with("k=10", &[10.0], |e| {
                e.picture("p ∝ exp(κ cos θ), κ = 10", Sky(FRAC_PI_2))
            })
            .control("a concentration slightly off", |[u, v, _], wrong| direction((1.0 + (-u * (1.0 - (-20f64).exp())).ln_1p() / (10.0 + 10.0 * wrong)).acos(), v), &["chi-square", "distance", "mean z"])
            .case("k=0", &[0.0])
            .case("k=1e-6", &[1e-6])
            .case("k=0.5", &[0.5])
            .case("k=3", &[3.0])
            .case("k=19", &[19.0])
            .case("k=1e3", &[1e3])
            .case("k=1e8", &[1e8])
            .case("k=1e30", &[1e30])
            .seed(&[0.0]).seed(&[1e-20]).seed(&[1e-8]).seed(&[1e-3]).seed(&[0.3]).seed(&[1.0]).seed(&[4.0]).seed(&[16.0])
            .seed(&[20.0]).seed(&[39.0]).seed(&[100.0]).seed(&[1e8]).seed(&[1e15]).seed(&[1e30])
            .refuse(&[NAN], NotFinite(0)).refuse(&[INF], NotFinite(0)).refuse(&[-0.1], Negative(0)).refuse(&[1.1e30], OutOfRange(0))
            .without("getters", "it keeps a smallest concentration in place of 0")
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("Ggx", "", &[Within(1e-4, 1.0), Within(1e-4, 1.0)], |p| {
            let truth = exact!(Ggx { alpha: [p[0], p[1]].map(Real::from) });
            Ok(upper(about_z::<T, _>("Ggx", Ggx::<T>::new([p[0], p[1]])?, truth)).own_density())
        })
            .parameters(&[0, 0])
            .case("α=0.3", &[0.3, 0.3])
            .control("a roughness slightly off", |[u, v, _], wrong| direction((0.3 * (1.0 + wrong) * (u / (1.0 - u)).sqrt()).atan(), v), &["chi-square", "distance", "mean z"])
            .case_with("α=0.1, 0.5", &[0.1, 0.5], |e| e.picture("roughness 0.1 along x, 0.5 along y", Sky(FRAC_PI_2)))
            .case("α=1", &[1.0, 1.0])
            .case("α=0.01", &[0.01, 0.01])
            .case("α=1, 1e-4", &[1.0, 1e-4])
            .seed(&[1e-4, 1.0]).seed(&[0.3, 0.3]).seed(&[1e-4, 1e-4])
            .refuse(&[NAN, 0.5], NotFinite(0)).refuse(&[0.5, 0.0], NotPositive(0)).refuse(&[0.5, 1.1], OutOfRange(0)).refuse(&[9e-5, 0.5], OutOfRange(0))
            .constant(in_both!(Ggx<T>::new([0.3, 0.1])))
            .gives_back(|p| Ggx::<T>::new([p[0], p[1]]).map(|warp| warp.alpha().to_vec())),
        Registered::new("GgxVisible", "", &VIEW, |p| {
            visible(p, GgxVisible::<T>::new([p[0], p[1], p[2]], [p[3], p[4]]), false)
        })
            .parameters(&[0, 0, 0, 1, 1])
            .case_with("α=0.3 at 60°", &[0.866, 0.0, 0.5, 0.3, 0.3], |e| e.picture("seen at 60°, roughness 0.3", Sky(FRAC_PI_2)))
            .control("all normals for those that are seen", |[u, v, _], _| direction((0.3 * (u / (1.0 - u)).sqrt()).atan(), v), &["chi-square", "distance", "mean x"])
            .case("α=0.1, 0.5 at 60°", &[0.5, -0.7, 0.5, 0.1, 0.5])
            .case("α=1 from above", &[0.0, 0.0, 1.0, 1.0, 1.0])
            .case("α=1 at the horizon", &[1.0, 0.0, 0.0, 1.0, 1.0])
            .case("α=0.01 at 40°", &[0.64, 0.0, 0.77, 0.01, 0.01])
            .case("α=0.01 at 89.9°", &[0.0, 1.0, 1.7e-3, 0.01, 0.01])
            .seed(&[0.6, 0.5, 0.5, 1e-3, 1.0]).seed(&[-0.5, -0.25, 0.5, 1.0, 1e-4])
            .seed(&[1e-36, 0.0, 6e-31, 0.8, 0.01])
            .seed(&[0.0, 0.0, 1.0, 0.5, 0.5]).seed(&[1.0, 0.0, 0.0, 1e-4, 1.0]).seed(&[1.0, 0.0, 0.0, 1.0, 1.0])
            .refuse(&[0.0, 0.0, 0.0, 0.5, 0.5], ZeroLength(0)).refuse(&[NAN, 0.0, 1.0, 0.5, 0.5], NotFinite(0))
            .refuse(&[0.0, 0.6, -0.8, 0.5, 0.5], OutOfRange(0)).refuse(&[0.0, 0.0, 1.0, 0.0, 0.5], NotPositive(1))
            .without("constant", "its constructor is no constant function: it takes roots")
            .without("getters", "it keeps the view as a unit vector"),
        Registered::new("GgxVisible", "bounded", &VIEW, |p| {
            visible(p, GgxVisible::<T>::bounded([p[0], p[1], p[2]], [p[3], p[4]]), true)
        })
            .parameters(&[0, 0, 0, 1, 1])
            .case("α=0.5 at 30°, bounded", &[0.5, 0.0, 0.866, 0.5, 0.5])
            .case("α=1, 0.3 at 85°, bounded", &[0.7, 0.7, 0.09, 1.0, 0.3])
            .seed(&[0.0, 0.0, 1.0, 1.0, 1.0]).seed(&[1.0, 0.0, 0.0, 1.0, 1.0])
            .refuse(&[0.0, 0.0, 0.0, 0.5, 0.5], ZeroLength(0)),
        Registered::new("Reflected", "", &[Within(0.0, 0.866), Within(0.2, 1.0), Within(0.2, 1.0)], reflected::<T>)
            .parameters(&[0, 1, 1])
            .case_with("α=0.3 at 53°", &[0.8, 0.3, 0.3], |e| e.picture("seen at 53°, roughness 0.3", Sky(PI)))
            .control("the normals for the directions", |[u, v, _], _| direction((0.3 * (u / (1.0 - u)).sqrt()).atan(), v), &["chi-square", "distance", "mean x"])
            .case("α=1, 0.2 at 30°", &[0.5, 1.0, 0.2])
            .case("α=0.5 from above", &[0.0, 0.5, 0.5])
            .seed(&[0.866, 0.2, 0.2]).seed(&[0.866, 1.0, 0.2]).seed(&[0.0, 0.2, 1.0])
            .refuse(&[0.5, 1.5, 0.5], OutOfRange(1)).refuse(&[NAN, 0.5, 0.5], NotFinite(0))
            .without("constant", "its normals take roots")
            .without("getters", "it keeps the view as a unit vector"),
        Registered::new("Cone", "from_radians", &[Within(0.0, PI_32)], |p| {
            cone(Cone::<T>::from_radians(p[0]), exact!(cone(one_minus_cos(p[0]), one_plus_cos(p[0]))))
        })
            .case_with("1e-7 rad", &[1e-7], |e| e.picture("half angle 10⁻⁷ rad", Sky(1.02e-7)))
            .case("1e-4 rad", &[1e-4])
            .case("3.9e-3 rad", &[0.003_918_659])
            .case("1e-2 rad", &[1e-2])
            .case("1.6e-2 rad", &[0.016_239_65])
            .case_with("0.1 rad", &[0.1], |e| e.picture("half angle 0.1 rad", Sky(0.102)))
            .control("a cone with theta linear in xi", |[u, v, _], _| direction(0.1 * u, v), &["chi-square", "distance", "mean z"])
            .case("1.5 rad", &[1.5])
            .case_with("3 rad", &[3.0], |e| e.outside(&[[0.0, 0.0, -1.0]]))
            .seed(&[1.05])
            .refuse(&[NAN], NotFinite(0)).refuse(&[0.0], NotPositive(0)).refuse(&[3.2], OutOfRange(0)).refuse(&[1.0e-20], Empty(0))
            .constant(in_both!(Cone<T>::from_one_minus_cos(0.3))),
        Registered::new("Cone", "from_one_minus_cos", &[Within(0.0, 2.0)], |p| {
            let truth = exact!(cone(Real::from(p[0]), 2.0 - Real::from(p[0])));
            cone(Cone::<T>::from_one_minus_cos(p[0]), truth)
        })
            .refuse(&[2.1], OutOfRange(0)).refuse(&[TINY], Empty(0))
            .without("getters", "it is tried of one number alone, in tests/laws/constructors.rs"),
        Registered::new("Cone", "from_sine", &[Within(0.0, 1.0)], |p| {
            cone(Cone::<T>::from_sine(p[0]), exact!(cone_of_sine(p[0])))
        })
            .case("sphere at 1e-3", &[1e-3])
            .refuse(&[1.5], OutOfRange(0)).refuse(&[-0.1], NotPositive(0)),
        Registered::new("SphericalPatch", "", &[Within(0.0, 0.5), Within(0.0, 0.5), Within(-1.0, 1.0), Within(-1.0, 2.0)], patch::<T>)
            .case_with("octant", &[0.0, 0.25, 0.0, 0.25], |e| {
                e.picture("0 ≤ θ ≤ 90°, 0 ≤ φ ≤ 90°", Sky(FRAC_PI_2))
            })
            .control("a patch with theta linear in xi", |[u, v, _], _| direction(0.5 * PI * u, 0.25 * v), &["chi-square", "distance", "mean z"])
            .case_with("band", &[0.2, 0.3, -0.5, 0.5], |e| e.picture("72° ≤ θ ≤ 108°, every φ", Sky(PI)))
            .case_with("south", &[0.45, 0.5, 0.1, 0.6], |e| e.outside(&[[0.6, 0.0, -0.8], [0.0, 0.0, 1.0]]))
            .case_with("1e-3 tile", &[0.125, 0.126, 0.3, 0.301], |mut e| {
                e.slack = 1e-3;
                e
            })
            .seed(&[0.499_999_85, 0.5, 0.0, 1.0]).seed(&[0.0, 0.25, 0.0, 0.25])
            .refuse(&[0.0, 0.25, NAN, 0.5], NotFinite(2)).refuse(&[0.3, 0.2, 0.0, 0.5], Reversed(1))
            .refuse(&[0.0, 0.6, 0.0, 0.5], OutOfRange(1)).refuse(&[0.0, 0.5, 0.0, 1.5], OutOfRange(3))
            .refuse(&[0.1, 0.1, 0.0, 0.5], Empty(1)).refuse(&[0.1, 0.2, 0.5, 0.5], Empty(3)).refuse(&[0.0, 0.2, 0.0, INF], NotFinite(3))
            .gives_back(|p| SphericalPatch::<T>::from_turns(p[0], p[1], p[2], p[3]).map(|warp| [warp.theta_turns(), warp.phi_turns()].concat()))
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("VisibleSphere", "", &[Any, Any, Any, Any, Any, Any, Positive], |p| {
            seen::<T>([p[0], p[1], p[2]], [p[3], p[4], p[5]], p[6])
        })
            .parameters(&[0, 0, 0, 1, 1, 1, 2])
            .case_with("half angle 30°", &[1.0, -2.0, 0.5, 1.8, -2.4, 2.3, 1.0], |e| {
                e.outside(&[[0.0, -1.0, 0.0], [-0.6, 0.8, 0.0]]).picture("a sphere seen from twice its radius", Sky(FRAC_PI_2))
            })
            .case_with("5 m off", &[0.0, 0.0, 0.0, 0.0, 3.0, 4.0, 0.5], |e| e.outside(&[[0.0, 0.8, 0.6], [0.0, -0.6, -0.8]]))
            .control("a sphere seen with theta linear in xi", |[u, v, _], _| tilted(direction(0.1f64.asin() * u, v)), &["chi-square", "distance"])
            .case_with("1e-6 above", &[1.000_001, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], |e| e.outside(&[[0.1, 0.0, 0.995]]))
            .case_with("on the surface", &[1.0, 2.0, 2.0, 0.0, 0.0, 0.0, 3.0], |e| e.outside(&[[0.1, 0.7, 0.7]]))
            .case_with("inside", &[1.0, 2.0, 2.0, 0.0, 0.1, 0.0, 3.0], |e| e.outside(&[]))
            .case_with("at the centre", &[1.0, 2.0, 2.0, 1.0, 2.0, 2.0, 3.0], |e| e.outside(&[]))
            .seed(&[0.0, 0.0, 0.0, 0.0, 3.0, 4.0, 0.5]).seed(&[1.0, 2.0, 2.0, 0.0, 0.0, 0.0, 3.0]).seed(&[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.7e-19])
            .seed(&[1e-45, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-45]).seed(&[0.0, 1e-45, 0.0, 0.0, 0.0, 0.0, 1.7e38]).seed(&[1e38, 0.0, 0.0, -1e38, 0.0, 0.0, 1e38])
            .refuse(&[0.0, NAN, 0.0, 0.0, 3.0, 4.0, 0.5], NotFinite(0)).refuse(&[0.0, 0.0, 0.0, 0.0, 3.0, 4.0, 0.0], NotPositive(2))
            .refuse(&[0.0, 0.0, 0.0, 0.0, 3.0, 4.0, -1.0], NotPositive(2)).refuse(&[0.0, 0.0, 0.0, 0.0, 3.0, 4.0, 1e-20], Empty(Error::NO_PLACE))
            .refuse(&[3e38, 0.0, 0.0, -3e38, 0.0, 0.0, 1.0], TooLarge(Error::NO_PLACE)).refuse(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, TINY], Empty(Error::NO_PLACE))
            .gives_back(|p| VisibleSphere::<T>::new([p[0], p[1], p[2]], [p[3], p[4], p[5]], p[6]).map(|warp| [&warp.point()[..], &warp.centre(), &[warp.radius()]].concat()))
            .without("constant", "its constructor is no constant function: it takes roots"),
        // At a height above the surface in radii, or below it, in any direction from the centre.
        Registered::new("VisibleSphere", "near", &[Within(-1.0, 1.0), Within(-1.0, 1.0), Within(-1.0, 1.0), Within(-0.5, 1.0), Any, Within(0.0, 1e3)], |p| {
            let normal = [p[0], p[1], p[2]].map(f64::from);
            let length = truth::dot(normal, normal).sqrt();
            let centre = p[4] % 1e4;
            let reach = f64::from(p[5]) * (1.0 + f64::from(p[3]));
            seen::<T>(normal.map(|c| (f64::from(centre) - reach * c / length) as f32), [centre; 3], p[5])
        }),
        turned("CosineHemisphere", &[Any; 3], |p| {
            oriented::<T, _>(p, CosineHemisphere::<T>::new(), exact!(Turned::new(cosine_hemisphere(), about(p))))
        })
            .case_with("cosine about (1, 2, 3)", &[1.0, 2.0, 3.0], |e| {
                e.outside(&[[-0.3, -0.5, -0.8]]).picture("cosine about (1, 2, 3)", Sky(PI))
            })
            .control("a cosine hemisphere left at +z", |[u, v, _], _| direction(u.sqrt().asin(), v), &["chi-square", "distance", "mean x"])
            .case("cosine about -z", &[0.0, 0.0, -1.0])
            .case("cosine about (1e-4, 0, -1)", &[1e-4, 0.0, -1.0]),
        turned("Hemisphere", &[Any; 3], |p| oriented::<T, _>(p, Hemisphere::<T>::new(), exact!(Turned::new(hemisphere(), about(p))))),
        turned("MalleyHemisphere", &[Any; 3], |p| {
            // Its second uniform is no azimuth, and is held as one: at the seam both are the same.
            oriented::<T, _>(p, MalleyHemisphere::<T>::new(), exact!(Turned::new(Box::new(Malley), about(p))))
        }),
        turned("Cone", &[Any, Any, Any, Within(0.0, 2.0)], |p| {
            let truth = exact!(Turned::new(cone(Real::from(p[3]), 2.0 - Real::from(p[3])), about(p)));
            oriented::<T, _>(p, Cone::<T>::from_one_minus_cos(p[3])?, truth)
        }),
        turned("PhongLobe", &[Any, Any, Any, Within(1.0, 1e8)], |p| {
            oriented::<T, _>(p, PhongLobe::<T>::new(p[3])?, exact!(Turned::new(phong(p[3]), about(p))))
        }),
    ]
}

/// The cosine of Henyey and Greenstein's law.
fn fog(g: f64, u: f64) -> f64 {
    let part = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
    ((1.0 + g * g - part * part) / (2.0 * g)).clamp(-1.0, 1.0)
}

/// A direction about +z, turned about (0, 0.6, 0.8).
fn tilted([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, 0.8 * y + 0.6 * z, 0.8 * z - 0.6 * y]
}
