//! The warps over surfaces, whose points say more than a position: here they have three coordinates.

use super::evidence::disk;
use super::picture::{Body, Face, View};
use super::{Domain, Entry, Measure, Registered, Uniforms, ends, entry};
use crate::adversary::words::Kind::{self, Any, Positive, Within};
use crate::truth::{self, OnTriangle, Truth, dot, exact};
use microwarp::Error::{self, *};
use microwarp::discrete::{Cdf, Mesh, MeshPoint, Word};
use microwarp::tier::Tier;
use microwarp::uniform::Canonical;
use microwarp::warp::{BoxSurface, CapsuleSurface, FrustumSurface, SurfacePoint};
use microwarp::{Invert, Warp};
use rand_core::TryRng;
use std::sync::Arc;

const NAN: f32 = f32::NAN;
const UNIT: Kind = Within(-1.0, 1.0);

/// A mesh in memory of its own. Its points are the number of the face and the shares of the second and the third vertex,
/// with the density of these.
#[derive(Clone)]
struct Soup<W> {
    vertices: Vec<[f32; 3]>,
    faces: Vec<[u32; 3]>,
    areas: Vec<f32>,
    words: Vec<W>,
    /// Twice the exact areas.
    twice: Vec<f64>,
}

impl<W: Word + Default> Soup<W> {
    fn new(vertices: Vec<[f32; 3]>, faces: Vec<[u32; 3]>) -> Result<Self, Error> {
        let (mut areas, mut words) = (vec![0.0; faces.len()], vec![W::default(); faces.len()]);
        Mesh::new_in(&vertices, &faces, &mut areas, &mut words)?;
        let corners = |face: &[u32; 3]| face.map(|i| vertices[i as usize].map(f64::from));
        let twice = faces
            .iter()
            .map(|f| 2.0 / OnTriangle(corners(f)).pdf([0.0; 3]));
        Ok(Self {
            twice: twice.collect(),
            areas,
            words,
            faces,
            vertices,
        })
    }

    /// The mesh, which borrows.
    fn mesh(&self) -> Mesh<'_, u32, &[W]> {
        let table = Cdf::from_trusted_words(self.words.as_slice()).expect("words of a table");
        let mesh = Mesh::from_trusted_parts(&self.vertices, &self.faces, &self.areas, table);
        mesh.expect("as many areas as faces")
    }

    fn flat(at: MeshPoint) -> [f32; 3] {
        let [_, v, w] = at.barycentrics;
        [at.triangle as f32, v, w]
    }

    fn unflat([k, v, w]: [f32; 3]) -> MeshPoint {
        MeshPoint {
            position: [0.0; 3],
            barycentrics: [(1.0 - v - w).max(0.0), v, w],
            triangle: if k >= 0.0 {
                k.round() as usize
            } else {
                usize::MAX
            },
        }
    }
}

impl<W: Word + Default> Warp for Soup<W> {
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        Self::flat(self.mesh().sample_canonical(u))
    }
    fn pdf(&self, x: [f32; 3]) -> f32 {
        let at = Self::unflat(x);
        let twice = self.twice.get(at.triangle).copied().unwrap_or(0.0);
        // Rounded once more, by the change of coordinates.
        (f64::from(self.mesh().pdf(at)) * twice) as f32
    }
    fn sample_words(&self, words: [u32; 2]) -> [f32; 3] {
        Self::flat(self.mesh().sample_words(words))
    }
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[f32; 3], R::Error> {
        self.mesh().try_draw(rng).map(Self::flat)
    }
}

impl<W: Word + Default> Invert for Soup<W> {
    fn invert(&self, x: [f32; 3]) -> [f32; 2] {
        self.mesh().invert(Self::unflat(x))
    }
}

/// A mesh with words of 32 or 64 bits.
fn mesh<T: Tier, W>(vertices: Vec<[f32; 3]>, faces: Vec<[u32; 3]>) -> Result<Entry, Error>
where
    W: Word + Default + Send + Sync + 'static,
{
    let soup = Soup::<W>::new(vertices, faces)?;
    let mesh = soup.mesh();
    let table = mesh.table();
    let count = |k| -> u128 { table.numerator(k).into() };
    let words: Vec<f64> = (0..table.entries()).map(|k| count(k) as f64).collect();
    let kept = truth::Faces::new(&words);
    let placed = soup.clone();
    let place = move |u: Uniforms| {
        let (face, [p, q, r]) = kept.place(u.map(f64::from));
        let corners = placed.faces[face].map(|i| placed.vertices[i as usize].map(f64::from));
        let at = placed.mesh().sample([u[0], u[1]]);
        let size = corners
            .iter()
            .flatten()
            .fold(0.0_f64, |m, x| m.max(x.abs()));
        let [a, b, c] = corners;
        // Apart on another face.
        let off = |k: usize| (f64::from(at.position[k]) - (p * a[k] + q * b[k] + r * c[k])) / size;
        let far = f64::from(u8::from(at.triangle != face));
        let distance = dot([0, 1, 2].map(off), [0, 1, 2].map(off)).sqrt() + far;
        ([distance as f32, 0.0, 0.0], [0.0; 3])
    };
    let truth = exact!(Faces::new(&reals(&words)));
    let mut entry = entry::<T, _>("Mesh", Domain::Space, Measure::Length(1.0), soup, truth);
    entry.place = Some(Arc::new(place));
    // From face to face.
    entry.jumps = true;
    Ok(entry.words(1 + W::BITS as usize / 32).outside(&[
        [9e9, 0.5, 0.1],
        [0.0, -0.1, 0.5],
        [0.0, 0.7, 0.7],
    ]))
}

/// Faces of their own vertices, three numbers each, times a power of two.
fn apart<T: Tier>(p: &[f32], scale: f32) -> Result<Entry, Error> {
    let vertices: Vec<_> = p
        .chunks_exact(3)
        .map(|v| [0, 1, 2].map(|k| v[k] * scale))
        .collect();
    let faces = (0..vertices.len() as u32 / 3).map(|k| [0, 1, 2].map(|i| 3 * k + i));
    let faces = faces.collect();
    mesh::<T, u32>(vertices, faces)
}

/// So far may the inverse of a rounded point lie outside.
fn loose(mut entry: Entry, slack: f64) -> Entry {
    entry.slack = slack;
    entry
}

/// What has a coordinate of one value, or of two, which has no moments.
fn constant(mut entry: Entry) -> Entry {
    entry.resolved = false;
    entry
}

/// 2 to the power of a whole number at or below; what is none is no scale.
fn power(x: f32) -> f32 {
    if x.is_finite() { x.floor().exp2() } else { NAN }
}

/// An octahedron, each axis of another length.
fn octahedron([a, b, c]: [f32; 3]) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let axes = [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]];
    let vertices = axes
        .into_iter()
        .flat_map(|v| [v, v.map(|x: f32| -x)])
        .collect();
    let mut faces = Vec::new();
    for z in [4, 5] {
        faces.extend([[0, 2, z], [2, 1, z], [1, 3, z], [3, 0, z]]);
    }
    (vertices, faces)
}

/// The four upper faces of one with axes of 1, 2 and 1/2, seen from 60 degrees above the plane and 15 beside x.
const ROOF: View = {
    let [front, back] = [[-0.13, -0.42], [0.13, 0.42]];
    let [right, left] = [[0.966, -0.224], [-0.966, 0.224]];
    let top = [0.0, 0.125];
    View::Faces(&[
        [front, right, top],
        [right, back, top],
        [back, left, top],
        [left, front, top],
    ])
};

/// The faces of a box of 2 by 1 by 1/2, each with its coordinate across at 4 or -4: those beside the upper one are folded
/// down, and the lower one hangs on that in front.
const NET: View = {
    const fn face(corner: [f64; 3], sides: [[f64; 3]; 2], at: [f64; 2]) -> Face {
        Face { corner, sides, at }
    }
    let (x, y) = ([2.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let (up, down) = ([0.0, 0.0, 0.5], [0.0, 0.0, -0.5]);
    View::Net(
        &[
            face([-1.0, 0.0, 4.0], [x, y], [-1.0, 0.0]),
            face([-1.0, -4.0, 0.25], [x, up], [-1.0, -0.5]),
            face([-1.0, 4.0, 0.75], [x, down], [-1.0, 1.0]),
            face([-4.0, 0.0, 0.25], [up, y], [-1.5, 0.0]),
            face([4.0, 0.0, 0.75], [down, y], [1.0, 0.0]),
            face([-1.0, 1.0, -4.0], [x, [0.0, -1.0, 0.0]], [-1.0, -1.5]),
        ],
        1.54,
    )
};

/// A surface whose points are positions here, told apart where the normal decides; so that no sample says nothing, what is
/// not in order is not a number.
struct Flat<W, O, B> {
    warp: W,
    /// The position that stands for a point, or nothing for one that is not in order.
    of: O,
    /// The point that a position stands for.
    back: B,
}

impl<W, O, B> Warp for Flat<W, O, B>
where
    W: Warp<Uniforms = [f32; 2], Point = SurfacePoint, Density = f32>,
    O: Fn(SurfacePoint) -> Option<[f32; 3]>,
    B: Fn([f32; 3]) -> SurfacePoint,
{
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        let point = self.warp.sample_canonical(u);
        let place = (self.of)(point).filter(|_| self.warp.pdf(point) > 0.0);
        place.unwrap_or([NAN; 3])
    }
    fn pdf(&self, x: [f32; 3]) -> f32 {
        self.warp.pdf((self.back)(x))
    }
}

impl<W, O, B> Invert for Flat<W, O, B>
where
    W: Invert<Uniforms = [f32; 2], Point = SurfacePoint, Density = f32>,
    O: Fn(SurfacePoint) -> Option<[f32; 3]>,
    B: Fn([f32; 3]) -> SurfacePoint,
{
    fn invert(&self, x: [f32; 3]) -> [f32; 2] {
        self.warp.invert((self.back)(x))
    }
}

fn largest(p: &[f32]) -> f32 {
    p.iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// The axis of a normal that lies along one.
fn axis(normal: [f32; 3]) -> Option<usize> {
    let along =
        |k: &usize| normal[*k].abs() == 1.0 && normal.iter().filter(|x| **x == 0.0).count() == 2;
    (0..3).find(along)
}

/// The axis of the faces that first uniforms select, and where each begins and the next one does.
fn pieces(warp: &BoxSurface) -> Vec<(usize, f64, f64)> {
    let of = |bits: u32| axis(warp.sample([f32::from_bits(bits), 0.0]).normal).expect("a face");
    let (mut found, mut start, end) = (Vec::new(), 0_u32, 1.0_f32.to_bits());
    while start < end {
        let here = of(start);
        // The first that selects another one.
        let (mut low, mut high) = (start, end);
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            *(if of(middle) == here {
                &mut low
            } else {
                &mut high
            }) = middle;
        }
        found.push((
            here,
            f32::from_bits(start).into(),
            f32::from_bits(high).into(),
        ));
        start = high;
    }
    found
}

/// A box whose faces are taken apart: their coordinate across is beyond all others.
fn faces<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let [low, high] = [0, 1].map(|end| [0, 1, 2].map(|k| p[2 * k + end]));
    let warp = BoxSurface::new(low, high)?;
    let size = largest(p);
    if size > 3e37 {
        return Err(TooLarge(1)); // beyond which nothing is left
    }
    let beyond = 4.0 * size.log2().floor().exp2();
    let truth = exact!(BoxFaces {
        low: low.map(Real::from),
        high: high.map(Real::from),
        pieces: pieces(&warp)
            .into_iter()
            .map(|(k, from, to)| (k, Real::from(from), Real::from(to)))
            .collect(),
        beyond: Real::from(beyond),
    });
    let of = move |point: SurfacePoint| {
        let k = axis(point.normal)?;
        let upper = point.normal[k] > 0.0;
        let on = point.position[k].to_bits() == if upper { high[k] } else { low[k] }.to_bits();
        let mut place = point.position;
        place[k] = if upper { beyond } else { -beyond };
        on.then_some(place)
    };
    let back = move |mut position: [f32; 3]| {
        let mut normal = [0.0; 3];
        if let Some(k) = (0..3).find(|k| position[*k].abs() > 0.75 * beyond) {
            let upper = position[k] > 0.0;
            normal[k] = if upper { 1.0 } else { -1.0 };
            // What is farther off is not on the face.
            if position[k].abs() < 1.5 * beyond {
                position[k] = if upper { high[k] } else { low[k] };
            }
        }
        SurfacePoint { position, normal }
    };
    let warp = Flat { warp, of, back };
    let measure = Measure::Length(size.into());
    let mut entry = entry::<T, _>("BoxSurface", Domain::Space, measure, warp, truth);
    // From face to face.
    entry.jumps = true;
    Ok(entry.outside(&[[0.0; 3], [f32::MAX, 0.0, 0.0], [0.0, -f32::MAX, f32::MAX]]))
}

fn revolved(mut entry: Entry) -> Entry {
    entry.azimuth = true;
    entry.outside(&[
        [f32::MAX, 0.0, 0.0],
        [0.0, 0.0, -f32::MAX],
        [0.0, f32::MAX, 0.5],
    ])
}

/// A frustum whose side is told from its disks by the height.
fn frustum<T: Tier>(p: &[f32], closed: bool) -> Result<Entry, Error> {
    let (radii, height) = ([p[0], p[1]], p[2]);
    let warp = if closed {
        FrustumSurface::<T>::new(radii, height)?
    } else {
        FrustumSurface::<T>::tube(radii, height)?
    };
    // Flatter ones are in `tests/laws`, by their normals.
    if closed && (height < 1e-30 * largest(&radii) || height < 1e-36) {
        return Err(Empty(1));
    }
    let truth = truth::Frustum::new(radii.map(f64::from), height.into(), closed);
    let slope = truth.slope().map(|x| x as f32);
    let size = f64::from(largest(p));
    let variables = [("g", truth.side() * size)];
    let truth = exact!(Frustum::new(
        radii.map(Real::from),
        Real::from(height),
        closed
    ));
    let back = move |position: [f32; 3]| {
        let [x, y, z] = position;
        let disk = |radius: f32| closed && radius > 0.0;
        let normal = if z == 0.0 && disk(radii[0]) {
            [0.0, 0.0, -1.0]
        } else if z == height && disk(radii[1]) {
            [0.0, 0.0, 1.0]
        } else {
            let (s, c) = y.atan2(x).sin_cos();
            [slope[0] * c, slope[0] * s, slope[1]]
        };
        SurfacePoint { position, normal }
    };
    let of = |point: SurfacePoint| Some(point.position);
    let warp = Flat { warp, of, back };
    let entry = entry::<T, _>(
        "FrustumSurface",
        Domain::Space,
        Measure::Length(size),
        warp,
        truth,
    );
    Ok(revolved(entry.variables(&variables)))
}

fn capsule<T: Tier>(p: &[f32]) -> Result<Entry, Error> {
    let (height, radius) = (p[0], p[1]);
    let warp = CapsuleSurface::<T>::new(height, radius)?;
    let truth = exact!(Capsule {
        height: Real::from(height),
        radius: Real::from(radius),
    });
    let size = f64::from(height) + f64::from(radius);
    let of = |point: SurfacePoint| Some(point.position);
    let back = |position| SurfacePoint {
        position,
        normal: [0.0; 3],
    };
    let warp = Flat { warp, of, back };
    let entry = entry::<T, _>(
        "CapsuleSurface",
        Domain::Space,
        Measure::Length(size),
        warp,
        truth,
    );
    Ok(revolved(entry))
}

#[rustfmt::skip] // one line a case
pub(super) fn registered<T: Tier>() -> Vec<Registered> {
    vec![
        Registered::new("Mesh", "octahedron", &[], |_| {
            let (vertices, mut faces) = octahedron([1.0, 2.0, 0.5]);
            // One of two vertices, one on a line, one of half the area.
            faces.extend([[0, 2, 2], [0, 1, 6], [0, 2, 6]]);
            mesh::<T, u32>([vertices, vec![[0.0; 3]]].concat(), faces)
        })
            .case_with("octahedron", &[], |e| {
                e.picture("the upper faces of an octahedron", ROOF)
            })
            .control("a mesh without its last face", |[u, v, _], _| [(8.0 * u).floor(), (8.0 * u).fract().sqrt() * (1.0 - v), (8.0 * u).fract().sqrt() * v], &["chi-square", "distance"]),
        Registered::new("Mesh", "decades", &[], |_| {
            let small = |k: i32| { let s = 10f32.powi(-k); [[1e6, 0.0, s], [1e6, 2.0 * s, 0.0], [1e6, 0.0, 0.0]] };
            let vertices: Vec<_> = (0..6).flat_map(small).collect();
            mesh::<T, u64>(vertices, (0..6).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect())
        })
            .case_with("decades, u64", &[], |e| e),
        Registered::new("Mesh", "of 1 face", &[Any; 9], |p| apart::<T>(p, 1.0))
            .case_with("of 1 face", &[1.0, 0.0, 0.0, 0.0, 2.0, 0.5, -1.0, 0.0, 3.0], |mut e| {
                // All faces are the first one.
                e.resolved = false;
                e
            })
            .seed(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.5, 1e-11, 0.0])
            .seed(&[1e6, 0.1, -7e3, 1_000_001.0, -0.3, -7001.0, 1e6, 0.7, -7002.0])
            .refuse(&[0.0; 9], AllZero)
            .refuse(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0], AllZero)
            .refuse(&[0.0, 0.0, 0.0, 1e20, 0.0, 0.0, 0.0, 1e20, 0.0], NotFiniteWeight(0))
            .refuse(&[0.0, 0.0, 0.0, 1.4e19, 0.0, 0.0, 0.0, 1.4e19, 0.0], TooLarge(1))
            .refuse(&[0.0, NAN, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0], NotFiniteWeight(0)),
        Registered::new("Mesh", "of 2 faces", &[Within(-62.0, 62.0), UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT], |p| {
            apart::<T>(&p[1..], power(p[0]))
        })
            .seed(&[0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.5, -1.0, 0.0, 1.0, 1e-3, 0.0, 0.0, 0.0, 1e-3, 0.0, 0.0, 0.0, 1e-3]),
        Registered::new("BoxSurface", "", &[Any; 6], faces::<T>)
            .parameters(&[0, 1, 0, 1, 0, 1])
            .ordered(&[[0, 1], [2, 3], [4, 5]])
            .case_with("2 x 1 x 0.5", &[-1.0, 1.0, 0.0, 1.0, 0.25, 0.75], |e| {
                e.picture("a box of 2 × 1 × ½, unfolded", NET)
            })
            .control("a box with as many points on each of its faces", |[u, v, _], _| on_faces(u, v), &["chi-square", "distance"])
            .case("cube", &[-1.0, 1.0, -1.0, 1.0, -1.0, 1.0])
            .case_with("flat", &[0.0, 3.0, 1.0, 1.0, -2.0, 5.0], constant)
            .case_with("thin", &[0.0, 1.0, 0.0, 1e-9, -1e-3, 1e-3], constant)
            .case_with("1e-30 by 1e30", &[-1e-30, 1e-30, 1.0, 1.0, -1e30, 1e30], constant)
            .case_with("far off", &[1e6, 1_000_001.0, -3e5, -299_999.5, 7.0, 8.0], |e| loose(e.unresolved(), 0.1))
            .seed(&[0.0, 1.0, 0.0, 1.0, 0.0, 1.0]).seed(&[1e-40, 1e-39, -1e36, 1e36, 0.0, 0.0])
            .seed(&[0.0, 1e-9, 0.0, 1e-9, 0.0, 1e9]).seed(&[1e6, 1_000_000.06, -1.0, 1.0, 0.0, 1e-3])
            .refuse(&[0.0, 1.0, NAN, 1.0, 0.0, 1.0], NotFinite(0)).refuse(&[0.0, 1.0, 0.0, 1.0, 1.0, 0.0], Reversed(1))
            .refuse(&[1.0; 6], Empty(1)).refuse(&[0.0, 1.0, 2.0, 2.0, 3.0, 3.0], Empty(1))
            .refuse(&[0.0, 1e-20, 0.0, 1e-20, 0.0, 1e-20], Empty(1)).refuse(&[0.0, 1e20, 0.0, 1e20, 0.0, 0.0], TooLarge(1))
            .gives_back(|p| BoxSurface::new([p[0], p[2], p[4]], [p[1], p[3], p[5]]).map(|warp| ends(warp.low(), warp.high())))
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("FrustumSurface", "", &[Positive; 3], |p| frustum::<T>(p, true))
            .parameters(&[0, 0, 1])
            .case_with("1 to 0.5, 2 high", &[1.0, 0.5, 2.0], |e| {
                e.picture("radii 1 and 0.5, height 2", View::Solid(Body::Frustum([1.0, 0.5], 2.0)))
            })
            .case("cylinder", &[1.0, 1.0, 2.0]).case("cone", &[3.0, 0.0, 4.0])
            .control("a cone whose side is uniform in its height", |[u, v, _], _| on_cone(u, v), &["chi-square", "distance", "mean z"])
            .case("funnel", &[0.0, 1.0, 0.1])
            .case("needle", &[1e-3, 2e-3, 5.0]).case_with("coin", &[2.0, 2.0, 1e-3], constant).case("lid", &[1.0, 0.75, 1e-8])
            .case("1e-20 by 1e20", &[1e-20, 2e-20, 1e20])
            .seed(&[1.0, 1.0, 1.0]).seed(&[1.0, 0.0, 1.0]).seed(&[0.0, 1.0, 1e-3]).seed(&[1.0, 1e-4, 2.0]).seed(&[1.0, 0.999_999_9, 1e-6])
            .refuse(&[NAN, 1.0, 1.0], NotFinite(0)).refuse(&[1.0, -1.0, 1.0], Negative(0)).refuse(&[1.0, 1.0, -1.0], Negative(1))
            .refuse(&[0.0, 0.0, 1.0], Empty(1)).refuse(&[0.0; 3], Empty(1)).refuse(&[1e-20, 1e-20, 1e-20], Empty(1))
            .refuse(&[1e20, 1.0, 1.0], TooLarge(1)).refuse(&[3e38, 3e38, 0.0], TooLarge(0)),
        Registered::new("FrustumSurface", "tube", &[Positive; 3], |p| frustum::<T>(p, false))
            .parameters(&[0, 0, 1])
            .case("tube", &[1.0, 1.0, 2.0]).case("open cone", &[1.0, 0.0, 2.0]).case_with("ring", &[1.0, 2.0, 0.0], constant)
            .case_with("narrow ring", &[1.0, 0.999_9, 0.0], |e| loose(constant(e), 1e-3))
            .seed(&[1.0, 0.0, 0.0]).seed(&[1.0, 1.0, 1e-9]).seed(&[1e-30, 3e-30, 1e30])
            .refuse(&[1.0, 1.0, 0.0], Empty(1)).refuse(&[1.0, f32::INFINITY, 0.0], NotFinite(0))
            .gives_back(|p| FrustumSurface::<T>::tube([p[0], p[1]], p[2]).map(|warp| vec![warp.radii()[0], warp.radii()[1], warp.height()]))
            .without("constant", "its constructor is no constant function: it takes roots"),
        Registered::new("CapsuleSurface", "", &[Positive; 2], capsule::<T>)
            .case_with("1 high, radius 0.5", &[1.0, 0.5], |e| {
                e.picture("height 1, radius 0.5", View::Solid(Body::Capsule(1.0, 0.5)))
            })
            .control("a capsule with slightly too many points on its ends", |[u, v, _], wrong| on_capsule(u, v, 0.25 * (1.0 + wrong)), &["chi-square", "distance", "mean z²"])
            .case("sphere", &[0.0, 1.0]).case("needle", &[5.0, 1e-3]).case("nearly a sphere", &[1e-3, 7.0])
            .case("1e30 by 1e-30", &[1e30, 1e-30])
            .seed(&[0.0, 1.0]).seed(&[1.0, 1.0]).seed(&[1.0, 1e-6]).seed(&[1e-6, 1.0])
            .refuse(&[NAN, 1.0], NotFinite(0)).refuse(&[-1.0, 1.0], Negative(0)).refuse(&[1.0, 0.0], NotPositive(1))
            .refuse(&[1e-20, 1e-20], Empty(1)).refuse(&[1.0, 1e20], TooLarge(1)).refuse(&[3e38, 1e38], TooLarge(1))
            .gives_back(|p| CapsuleSurface::<T>::new(p[0], p[1]).map(|warp| vec![warp.height(), warp.radius()]))
            .without("constant", "its constructor is no constant function: it takes roots"),
    ]
}

/// The box of 2 by 1 by ½, with as many points on each of its faces.
fn on_faces(u: f64, v: f64) -> [f64; 3] {
    let (k, s) = ((3.0 * u).min(2.999_999) as usize, (3.0 * u).fract());
    let (low, side) = ([-1.0, 0.0, 0.25], [2.0, 1.0, 0.5]);
    let mut point = [0.0; 3];
    point[k] = if v < 0.5 { -4.0 } else { 4.0 };
    for (k, part) in [((k + 1) % 3, s), ((k + 2) % 3, (2.0 * v).fract())] {
        point[k] = low[k] + part * side[k];
    }
    point
}

/// The cone of radius 3 and height 4, with a side uniform in its height. The disk has 3/8 of the area.
fn on_cone(u: f64, v: f64) -> [f64; 3] {
    let (r, z) = if u < 0.375 {
        (3.0 * (u / 0.375).sqrt(), 0.0)
    } else {
        let up = (u - 0.375) / 0.625;
        (3.0 * (1.0 - up), 4.0 * up)
    };
    let [x, y, _] = disk(r * r, v);
    [x, y, z]
}

/// The capsule of height 1 and radius ½, each of whose ends has a given part of the points.
fn on_capsule(u: f64, v: f64, end: f64) -> [f64; 3] {
    let (ring, z) = if u < end || 1.0 - u < end {
        let q = u.min(1.0 - u) / end;
        let z = 0.5 * (1.0 - q);
        (0.25 * q * (2.0 - q), if u < 0.5 { -z } else { 1.0 + z })
    } else {
        (0.25, (u - end) / (1.0 - 2.0 * end))
    };
    let [x, y, _] = disk(ring, v);
    [x, y, z]
}
