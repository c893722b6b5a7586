//! Shapes of which a point is one of another shape stretched, moved or turned: triangles of any vertices, rings, the normals of
//! GGX and regular polygons.

use crate::bounds::Roundings;
use crate::cover::{binades, pieces, triangle};
use crate::inputs::{STRIDE, in_parallel};
use crate::kept::largest;
use crate::line::stated;
use crate::maps::{Row, mirrored};
use crate::parametric::{Ring, Vertices};
use crate::phases::{Cell, MISSED, sincos};
use crate::programs::kept;
use crate::range::Range;
use crate::rounding::{Lost, UNIT};
use crate::several::{CELLS, Cells, Proven, complaint, samples, uniforms};
use host::errors::raise;
use host::speed;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::RegularPolygon;
use std::f64::consts::{PI, TAU};

/// A range cut into so many parts.
pub fn parts_of(low: f64, high: f64, parts: u32) -> Vec<Range> {
    let at = |i: u32| low + (high - low) * f64::from(i) / f64::from(parts);
    let each = (0..parts).map(|i| Range {
        low: at(i),
        high: at(i + 1),
    });
    each.collect()
}

/// A point of a triangle in three dimensions, in units of the largest coordinate of a vertex.
///
/// Coordinates are those of the vertices, summed with the weights of a point of the standard triangle. What holds them between
/// the vertices only mends them. Where they are sums with one of the vertices, the offsets are exact and half as large at most, and
/// the sum is rounded once more, by 2⁻²⁴. Vertices reach 1e-20 at least, since densities do not overflow.
fn on_triangles(once_more: bool) -> f64 {
    let stride = speed::of("one size of triangles tried of every", 5, 1);
    let sizes = parts_of(1.0, 2.0, 16).into_iter().step_by(stride);
    let of_sizes = sizes.map(|size| {
        let vertices = [Range::both(size.high); 3];
        triangle(&Vertices { once_more }, &vertices, &uniforms(2)) / size.low
    });
    let each = of_sizes.fold(0.0, f64::max);
    assert!(0.5 * each + UNIT <= each);
    each * 3.0_f64.sqrt() + 1e-20
}

/// What is rounded of an azimuth of a ring's sector: the product of the uniform and the width, which is below a turn. What the
/// sum with the first azimuth rounds turns the point again, and so does what the width has been rounded by; what is lost of both,
/// and their squares, are below 1e-12.
const SECTOR: Roundings = Roundings {
    turn: TAU * 0.5 * UNIT + 1e-12,
    nudged: true,
    ..Roundings::PLAIN
};

/// A point of a ring, in units of the outer radius, which is taken to [1, 2) by a power of two. A radius that is rounded past it
/// becomes it. Inner radii begin at 2⁻⁴⁰ of it: what is rounded of smaller ones is below 2⁻⁶⁰, or as much of what is there as here.
fn rings(cells: &Cells, roundings: Roundings) -> [f64; 2] {
    let mut bounds = [0.0; 2];
    for high in parts_of(1.0, 2.0, 16) {
        let small = binades(-40, 0.125, 1).into_iter().skip(1);
        let inner = small.chain(parts_of(0.125, 1.0, 14));
        let boxes: Vec<_> = inner.map(|part| [part, high]).collect();
        let pieces = pieces(&Ring, &boxes, &uniforms(2), (1.4e-7 * high.low, 2));
        for (bound, of_high) in bounds.iter_mut().zip(samples(&pieces, cells, roundings)) {
            raise(bound, of_high / high.low);
        }
    }
    bounds
}

/// The largest relative errors of sine and cosine of an eighth of a turn, and the largest difference of both, in units of 2⁻²⁴.
/// Below 2⁻¹³ turns the sine is the rounded angle, for which any binade stands.
fn relative<T: Tier>() -> [f64; 2] {
    let [first, last] = [0.5_f32.powi(14), 0.125].map(f32::to_bits);
    let parts = in_parallel(256, |part| {
        let mut worst = [0.0; 2];
        for bits in (first + part..=last).step_by(256 * *STRIDE as usize) {
            let t = f32::from_bits(bits);
            let ((s, c), (sine, cosine)) = (T::sincos_turns(t), sincos(t.into()));
            let [s, c] = [f64::from(s) / sine, f64::from(c) / cosine].map(|x| (x - 1.0) / UNIT);
            raise(&mut worst[0], s.abs().max(c.abs()));
            raise(&mut worst[1], (s - c).abs());
        }
        worst
    });
    [0, 1].map(|i| parts.iter().map(|part| part[i]).fold(0.0, f64::max))
}

/// A normal of GGX, over (αx √u₁ c, αy √u₁ s, √(1 - u₁)), in units of 2⁻²⁴ first.
///
/// The three are off by as much of themselves: the common root by 1, c and s by what is swept, both products by 1 each, and z by
/// 3/2. A vector whose coordinates are off by parts of themselves turns by half the largest difference of two of these at most.
/// Of the sum of squares at most three roundings count, of the root of it one: the length is off by 5/2, which stretches the
/// normal. The quotients are rounded by 1 together. What underflows is below 1e-37 of the length, which is 1e-4 or more.
fn of_ggx([of_phases, apart]: [f64; 2], products: f64) -> f64 {
    let turned = (0.5 * apart + products).max(0.5 * (of_phases + products + 1.0 + 1.5));
    let stretched = 2.5;
    (f64::hypot(turned, stretched) + 1.0) * UNIT * (1.0 + 1e-6)
}

/// Corners up to which all sides are tried.
const FEW: u16 = 64;

/// What a point of a regular polygon is off by of which the middle of a side is at this sine and cosine, which are off by `turned`
/// together. The apothem and half the side are up to `a` and `h`, and off by `off`.
///
/// In the frame of the side: the root is rounded by 2⁻²⁵. The place along the side is rounded by as much where it is a half or more,
/// where 1 less than twice of it is exact, and by half as much below, where that is rounded by 2⁻²⁵. Products are rounded by half an ulp, the one across twice. In the plane: two products of each coordinate,
/// their sum, and that with what turns the point by the rounding of the angle, whose square and own errors are below 1e-12.
fn of_side([s, c]: [Range; 2], turned: f64, [a, h]: [f64; 2], off: [f64; 2]) -> f64 {
    let half = |x: Range| Lost::of(x).absolute;
    let mut worst = 0.0;
    for root in parts_of(0.0, 1.0, 8) {
        for along in parts_of(-1.0, 1.0, 16) {
            let (out, across) = (root * Range::only(a), root * along * Range::only(h));
            let of_out = 0.5 * UNIT * a + off[0] + half(out);
            let of_across = 0.5 * UNIT * h * along.size() + UNIT * h + off[1];
            let of_across = of_across + half(along * Range::only(h)) + half(across);
            let coordinate = |a: Range, b: Range| {
                let products = half(a) + half(b);
                let sum = (a - b).wider(products);
                products + half(sum) + half(sum.wider(4.0 * UNIT))
            };
            let x = coordinate(out * c, across * s);
            let y = coordinate(out * s, across * c.times(-1.0));
            raise(
                &mut worst,
                of_out.hypot(of_across) + turned + x.hypot(y) + 1e-12,
            );
        }
    }
    worst
}

/// Of all regular polygons, with sines and cosines that are off by so much `more` than they are. Of many corners all angles may be
/// the middle of a side.
fn polygons<T: Tier>(cells: &[Cell], more: f64) -> f64 {
    let of = |corners: u16| {
        let polygon = RegularPolygon::<T>::new(corners).expect("a polygon");
        let (half, size) = (PI / f64::from(corners), ["apothem", "half_side"]);
        let [is, due] = [
            size.map(|name| f64::from(kept(&polygon, name))),
            [half.cos(), half.sin()],
        ];
        (due, [0, 1].map(|i| (is[i] - due[i]).abs()))
    };
    let larger = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a.max(c), b.max(d)];
    let many = (FEW + 1..=u16::MAX).map(of);
    let (size, off) = many
        .reduce(|one, other| (larger(one.0, other.0), larger(one.1, other.1)))
        .expect("polygons");
    let along = cells.iter().flat_map(|cell| cell.along);
    let turned = MISSED * along.map(Range::size).fold(0.0, f64::max) + more;
    let mut worst = 0.0;
    for Range { low, high } in parts_of(0.0, 0.5 * PI, 256) {
        let sine = Range::of(&[low.sin(), high.sin(), high.sin(), high.sin()]);
        let cosine = Range::of(&[high.cos(), low.cos(), low.cos(), low.cos()]);
        raise(&mut worst, of_side([sine, cosine], turned, size, off));
    }
    for corners in 3..=FEW {
        let (size, off) = of(corners);
        for side in 0..corners {
            let turn = f32::from(2 * side + 1) / f32::from(2 * corners);
            let ((s, c), (sine, cosine)) = (mirrored::<T>(turn), (TAU * f64::from(turn)).sin_cos());
            let turned = (f64::from(s) - sine).hypot(f64::from(c) - cosine) + more + 1e-14;
            raise(
                &mut worst,
                of_side([s, c].map(|x| Range::only(x.into())), turned, size, off),
            );
        }
    }
    worst
}

/// What is proven of these shapes.
pub fn rows(cells: &Cells) -> Vec<Proven> {
    let [libm, poly] = cells;
    vec![
        ("TriangleOn", "sample", [on_triangles(false); 2]),
        ("Annulus", "sample", rings(cells, SECTOR)),
        (
            "Ggx",
            "sample",
            [relative::<Libm>(), relative::<Poly>()].map(|phases| of_ggx(phases, 2.0)),
        ),
        (
            "RegularPolygon",
            "sample",
            [polygons::<Libm>(libm, 0.0), polygons::<Poly>(poly, 0.0)],
        ),
    ]
}

/// A rounding more, or one that is left out, is noticed.
#[test]
fn a_broken_link_of_the_argument_about_shapes_is_noticed() {
    let cells = &*CELLS;
    let judged = |name, proven: [f64; 2]| {
        let ((_, stated), found) = (stated(name, "sample"), largest(name, "sample"));
        [0, 1].map(|tier| {
            let [proven, found] = [proven[tier], found[tier]];
            complaint(stated[tier], Row { proven, found }).is_some() || proven < found
        })
    };
    let [libm, poly] = cells;
    let phases = [relative::<Libm>(), relative::<Poly>()];
    let twice = Roundings {
        turn: 2.0 * SECTOR.turn,
        ..SECTOR
    };
    let ulp = 2.0 * UNIT;
    for (name, wrong) in [
        ("TriangleOn", [on_triangles(true); 2]),
        ("Annulus", rings(cells, twice)),
        ("Ggx", phases.map(|phases| of_ggx(phases, 3.0))),
        (
            "RegularPolygon",
            [polygons::<Libm>(libm, ulp), polygons::<Poly>(poly, ulp)],
        ),
    ] {
        assert_eq!(judged(name, wrong), [true; 2], "{name}: {wrong:?}");
    }
}
