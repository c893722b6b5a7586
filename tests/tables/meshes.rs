//! Triangle meshes: exact areas of any sliver, faces without area that are never met, weights of the caller, refusals.

use host::docs::of_floats;
use host::speed;
use host::truth::{OnTriangle, Point, Truth, cross, dot};
use microwarp::Error::{
    AllZero, Empty, NegativeWeight, NoWeights, NotFiniteWeight, OutOfRange, TooLarge,
    TooManyWeights, Unreachable,
};
use microwarp::discrete::{Cdf, Mesh, MeshPoint};
use microwarp::{Error, Invert, Warp, uniform};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Finite vertices far off or near, every second time on nearly one line.
fn triangle(rng: &mut Pcg32) -> [[f32; 3]; 3] {
    let centred = |rng: &mut Pcg32| 2.0 * uniform::grid(rng) - 1.0;
    let far = (40.0 * centred(rng)).exp2();
    let shift = [(); 3].map(|()| far * centred(rng));
    let mut v = [[0.0; 3]; 3].map(|p: [f32; 3]| p.map(|_| centred(rng)));
    if rng.next_u32() & 1 == 0 {
        let (along, height) = (uniform::grid(rng), (-38.0 * uniform::grid(rng)).exp2());
        v[2] = [0, 1, 2].map(|k| v[0][k] + along * (v[1][k] - v[0][k]) + height * centred(rng));
    }
    v.map(|p| [0, 1, 2].map(|k| p[k] + shift[k]))
}

fn wide(v: [[f32; 3]; 3]) -> [Point; 3] {
    v.map(|p| p.map(f64::from))
}

fn difference(p: Point, q: Point) -> Point {
    [0, 1, 2].map(|k| p[k] - q[k])
}

/// The area in `f32` by the textbook.
fn plain([a, b, c]: [[f32; 3]; 3]) -> f32 {
    let [p, q] = [b, c].map(|v| [0, 1, 2].map(|k| v[k] - a[k]));
    let n = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| p[i] * q[j] - p[j] * q[i]);
    0.5 * n.iter().map(|x| x * x).sum::<f32>().sqrt()
}

#[test]
fn areas_and_normals_are_right_for_any_sliver() {
    let mut rng = Pcg32::new(31, 4);
    let (mut worst, mut textbook, mut turned, mut none) = (0.0_f64, 0.0_f64, 0.0_f64, 0);
    for _ in 0..speed::of("triangles", 100_000, 2_000_000) {
        let vertices = triangle(&mut rng);
        let (mut areas, mut words) = ([0.0], [0_u32]);
        let made = Mesh::new_in(&vertices, &[[0_u8, 1, 2]], &mut areas, &mut words);
        let truth = OnTriangle(wide(vertices));
        let exact = 1.0 / truth.pdf([0.0; 3]);
        let Ok(mesh) = made else {
            let [a, b, c] = wide(vertices);
            let sides = [difference(a, b), difference(b, c), difference(c, a)];
            let longest = sides.map(|s| dot(s, s)).into_iter().fold(0.0, f64::max);
            let low = 2.0 * exact <= 1.000_01 * 2f64.powi(-40) * longest;
            assert!(
                low || exact == 0.0 || exact.is_nan(),
                "{vertices:?} refused"
            );
            none += 1;
            continue;
        };
        worst = worst.max((f64::from(mesh.area()) / exact - 1.0).abs());
        textbook = textbook.max((f64::from(plain(vertices)) / exact - 1.0).abs());
        assert!((f64::from(mesh.density(0)) * exact - 1.0).abs() <= 4e-7);
        let normal = mesh.normal(0).expect("a face with an area").map(f64::from);
        assert!((dot(normal, normal).sqrt() - 1.0).abs() <= 3e-7);
        // Doubles do for triangles that are not thin.
        let [a, b, c] = wide(vertices);
        let n = cross(difference(b, a), difference(c, a));
        let square = dot(difference(b, a), difference(b, a));
        if dot(n, n) > 1e-8 * square * square {
            let size = dot(n, n).sqrt();
            let off = difference(normal, n.map(|x| x / size));
            turned = turned.max(dot(off, off).sqrt());
        }
    }
    println!(
        "areas off by {worst:.1e}, normals by {turned:.1e}; the textbook's area by {textbook:.1e}"
    );
    let (_, stated) = of_floats("Mesh")
        .into_iter()
        .find(|r| r.0 == "pdf, relative")
        .unwrap();
    assert!(worst <= stated[1].number().unwrap(), "{worst:e}");
    assert!(
        turned <= 3e-7 && textbook > 0.1 && none > 100,
        "{turned:e} {textbook} {none}"
    );
}

/// Two triangles of a square, a third one along its diagonal, one of a point, and a larger one above.
const VERTICES: [[f32; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.5, 0.5, 0.0],
    [0.0, 0.0, 2.0],
];
const FACES: [[u16; 3]; 5] = [[0, 1, 2], [0, 4, 2], [3, 3, 3], [0, 2, 3], [0, 1, 5]];

#[test]
fn faces_are_met_by_their_area_and_never_without() {
    let (mut areas, mut words) = ([0.0; 5], [0_u32; 5]);
    let mesh = Mesh::new_in(&VERTICES, &FACES, &mut areas, &mut words).unwrap();
    assert_eq!((mesh.vertices(), mesh.faces()), (&VERTICES[..], &FACES[..]));
    let due = [0.25, 0.0, 0.0, 0.25, 0.5];
    for (k, due) in due.into_iter().enumerate() {
        assert_eq!(mesh.probability(k), due);
        assert_eq!(mesh.density(k), if due > 0.0 { 0.5 } else { 0.0 });
        assert_eq!(mesh.normal(k).is_some(), due > 0.0);
    }
    assert_eq!(
        (
            mesh.area(),
            mesh.probability(5),
            mesh.density(5),
            mesh.normal(5)
        ),
        (2.0, 0.0, 0.0, None)
    );
    let n = 1 << 12;
    let mut met = [0; 5];
    for k in 0..n {
        let u = [k as f32 / n as f32, 0.3];
        let point = mesh.sample(u);
        met[point.triangle] += 1;
        assert!(mesh.pdf(point) == 0.5);
        let [u1, u2] = mesh.invert(point);
        let lost = point.barycentrics[0] == 1.0;
        assert!(
            (u1 - u[0]).abs() <= 3e-7 && (lost || (u2 - 0.3).abs() <= 3e-7),
            "{u:?} {point:?}"
        );
    }
    assert_eq!(met, due.map(|p| (p * n as f32) as i32));
    // Every way to draw, at the ends of every face.
    for word in [
        0,
        0x3fff_ffff,
        0x4000_0000,
        0x7fff_ffff,
        0x8000_0000,
        u32::MAX,
    ] {
        let words = [word, 0x1234_5678];
        let point = mesh.sample_words(words);
        assert_eq!(crate::draw(&mesh, &words), point);
        assert!(due[point.triangle] > 0.0, "{word:x}");
    }
    let outside = |barycentrics, triangle| {
        mesh.pdf(MeshPoint {
            position: [0.0; 3],
            barycentrics,
            triangle,
        })
    };
    assert_eq!(outside([0.5, 0.25, 0.25], 0), 0.5);
    for (b, k) in [
        ([0.5, 0.25, 0.25], 1),
        ([0.5, 0.25, 0.25], 5),
        ([0.5, 0.6, -0.1], 0),
        ([f32::NAN; 3], 0),
    ] {
        assert_eq!(outside(b, k), 0.0, "{b:?} {k}");
    }
}

/// Radiances: three times as many points on one face, with three times the density.
#[test]
fn weights_of_the_caller_select_the_faces() {
    let mut areas = [0.0; 5];
    let areas = Mesh::areas(&VERTICES, &FACES, &mut areas).unwrap();
    let radiances = [3.0, 5.0, 7.0, 1.0, 0.0];
    let weights: Vec<f32> = areas.iter().zip(radiances).map(|(a, l)| a * l).collect();
    let mut memory = [0_u64; 5];
    let table = Cdf::<&[u64]>::new_in(&weights, &mut memory).unwrap();
    let mut again = [0.0; 5];
    let mesh = Mesh::from_table(&VERTICES, &FACES, &mut again, table).unwrap();
    assert_eq!(
        [0, 1, 2, 3, 4].map(|k| mesh.density(k)),
        [1.5, 0.0, 0.0, 0.5, 0.0]
    );
    // ∫ radiance by points and their densities is the sum of areas times radiances.
    let mut rng = Pcg32::new(5, 5);
    let n = 1000;
    let sum: f64 = (0..n)
        .map(|_| {
            let point = mesh.draw(&mut rng);
            f64::from(radiances[point.triangle] / mesh.pdf(point))
        })
        .sum();
    assert!((sum / f64::from(n) - 2.0).abs() <= 1e-6, "{sum}");
}

fn made(vertices: &[[f32; 3]], faces: &[[u32; 3]], room: usize) -> Option<Error> {
    let (mut areas, mut words) = (vec![0.0; room], vec![0_u32; room]);
    Mesh::new_in(vertices, faces, &mut areas, &mut words).err()
}

#[test]
fn what_is_no_mesh_is_refused_by_name() {
    let good = [0_u32, 1, 2];
    assert_eq!(made(&VERTICES, &[good], 1), None);
    assert_eq!(made(&VERTICES, &[], 1), Some(NoWeights));
    assert_eq!(made(&VERTICES, &[good; 2], 1), Some(TooManyWeights));
    assert_eq!(made(&VERTICES, &[good, [0, 1, 6]], 2), Some(OutOfRange(1)));
    assert_eq!(made(&[], &[good], 1), Some(OutOfRange(1)));
    assert_eq!(made(&VERTICES, &[[0, 0, 1], [0, 4, 2]], 2), Some(AllZero));
    let mut vertices = VERTICES;
    for bad in [f32::NAN, f32::INFINITY, -f32::INFINITY] {
        vertices[5][1] = bad;
        assert_eq!(
            made(&vertices, &[good, [0, 1, 5]], 2),
            Some(NotFiniteWeight(1))
        );
        assert_eq!(
            made(&vertices, &[good], 1),
            None,
            "a vertex that no face has"
        );
    }
    let scaled = |by: f32| VERTICES.map(|v| v.map(|x| x * by));
    assert_eq!(made(&scaled(1e-20), &[good], 1), Some(AllZero));
    assert_eq!(made(&scaled(1e-18), &[good], 1), None);
    assert_eq!(made(&scaled(1.5e19), &[good], 1), Some(TooLarge(1)));
    assert_eq!(made(&scaled(1e38), &[good], 1), Some(NotFiniteWeight(0)));
    assert_eq!(made(&scaled(1e19), &[good], 1), None);
    let from_table = |weights: &[f32]| {
        let mut words = vec![0_u32; weights.len()];
        let mut areas = [0.0; 5];
        Cdf::<&[u32]>::new_in(weights, &mut words)
            .and_then(|table| Mesh::from_table(&VERTICES, &FACES, &mut areas, table).map(|_| ()))
            .err()
    };
    assert_eq!(from_table(&[1.0, 0.0, 0.0, 1.0, 0.0]), None);
    assert_eq!(from_table(&[1.0, 1.0, 0.0, 1.0, 0.0]), Some(Empty(3)));
    assert_eq!(from_table(&[1.0, 0.0, 0.0, 1.0]), Some(OutOfRange(3)));
    assert_eq!(from_table(&[1.0, -1.0]), Some(NegativeWeight(1)));
    assert_ne!(from_table(&[1.0, 0.0, 0.0, 1.0, 0.0]), Some(Unreachable(0)));
}

/// Parts that do not belong together: nothing panics, and all is finite.
#[test]
fn parts_that_are_trusted_wrongly_stay_total() {
    let words = [7_u32, 3, u32::MAX, 0, 9];
    let areas = [0.0, f32::NAN, -1.0, f32::INFINITY, 1e-45];
    let faces = [
        [0_u32, 1, 2],
        [9, 9, 9],
        [0, 1, u32::MAX],
        [3, 3, 3],
        [0, 1, 5],
    ];
    let table = Cdf::from_trusted_words(words).unwrap();
    let mesh = Mesh::from_trusted_parts(&VERTICES, &faces, &areas, table).unwrap();
    for k in 0..1000 {
        let point = mesh.sample([k as f32 / 1000.0, 0.7]);
        assert!(point.position.iter().all(|x| x.is_finite()) && point.triangle < 5);
        let pdf = mesh.pdf(point);
        assert!((0.0..=f32::MAX).contains(&pdf), "{pdf}");
        assert!(mesh.invert(point).iter().all(|u| (0.0..1.0).contains(u)));
        assert!(
            mesh.normal(point.triangle)
                .is_none_or(|n| n.iter().all(|x| x.is_finite()))
        );
    }
    let short = Mesh::from_trusted_parts(&VERTICES, &faces[..4], &areas, table).err();
    assert_eq!(short, Some(OutOfRange(2)));
}
