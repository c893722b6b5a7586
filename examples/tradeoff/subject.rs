//! Makes rows of samplers of each kind.

use crate::sampler::{Block, Exact, FromWords, Law, Map, Numbers, Row, Sampler, Way, Wide};
use host::contest::{POINTS, generator};
use host::registry::Entry;
use host::truth::{Histogram, Truth};
use microwarp::Warp;
use microwarp::rejection::Rejection;
use microwarp::uniform::Uniforms;
use rand_pcg::Pcg32;
use std::hint::black_box;
use std::sync::Arc;

/// What names a row.
#[derive(Clone)]
pub struct Name {
    pub family: &'static str,
    pub name: String,
    pub tier: &'static str,
    /// In `docs/measured/counts.csv`.
    pub kernel: String,
}

impl Name {
    pub fn new(
        family: &'static str,
        name: &str,
        tier: &'static str,
        kernel: impl Into<String>,
    ) -> Self {
        Self {
            family,
            name: name.to_owned(),
            tier,
            kernel: kernel.into(),
        }
    }
}

impl Row {
    fn new(
        name: Name,
        ours: bool,
        law: Law,
        way: Way,
        fill: crate::sampler::Fill,
        draw: Block,
    ) -> Self {
        Self {
            sampler: Sampler {
                family: name.family,
                name: name.name,
                tier: name.tier,
                ours,
                law,
                way,
                fill,
                judged: None,
                kernel: name.kernel,
                calls: 1.0,
                entry: None,
            },
            draw,
            fill: None,
        }
    }

    /// One that makes half of what others of its family make: two of it are a sample.
    pub fn twice(mut self) -> Self {
        self.sampler.calls = 2.0;
        self
    }

    fn of(mut self, entry: Entry) -> Self {
        let law = &mut self.sampler.law;
        law.open = entry.open;
        if !law.inverts() {
            law.chart = entry.chart.clone();
            law.axes = 1;
        }
        self.sampler.entry = Some(Arc::new(entry));
        self
    }
}

/// A block of points, one after the other.
fn one_by_one<P: Exact>(draw: impl Fn(&mut Pcg32) -> P + 'static) -> Block {
    let (mut kept, mut points) = (generator(), vec![P::BLANK; POINTS]);
    Box::new(move || {
        let mut rng = kept.clone();
        for point in black_box(&mut points) {
            *point = draw(&mut rng);
        }
        kept = rng;
        black_box(&points);
    })
}

pub fn law(truth: Box<dyn Truth>, axes: usize) -> Law {
    Law::new(truth.into(), axes)
}

/// A warp of the registry.
pub fn registered(entry: Entry) -> Row {
    let trade = entry.trade.expect("it has a place in comparisons");
    let space = if entry.parameters.is_empty() { "" } else { " " };
    let name = format!("{}{space}{}", entry.name, entry.parameters);
    let kernel = format!("{}_{}", entry.tier, trade.kernel);
    let name = Name::new(trade.family, &name, entry.tier, kernel);
    let (at, fill) = (entry.warp.clone(), entry.warp.clone());
    let map = Map {
        bits: <f32 as FromWords>::BITS,
        at: Box::new(move |words| {
            let x = at.sample(FromWords::of(&words));
            (x.exact(), Some(at.pdf(x).wide()))
        }),
    };
    let fill = move |rng: &mut Pcg32, out: &mut [[f64; 3]]| {
        let points = fill.fill(rng, out.len());
        out.iter_mut()
            .zip(points)
            .for_each(|(out, x)| *out = x.exact());
    };
    let law = Law::new(entry.truth.clone(), entry.uniforms);
    let draw = entry.warp.block(false);
    let mut row = Row::new(name, true, law, Way::Map(map), Box::new(fill), draw);
    row.fill = Some(entry.warp.block(true));
    row.sampler.calls = trade.calls;
    row.of(entry)
}

/// A warp.
pub fn warp<W>(name: Name, warp: W, truth: Arc<dyn Truth>) -> Row
where
    W: Warp + Copy + Send + Sync + 'static,
    W::Uniforms: FromWords,
    W::Point: Exact,
    W::Density: Wide,
{
    let map = Map {
        bits: W::Uniforms::BITS,
        at: Box::new(move |words| {
            let x = warp.sample(W::Uniforms::of(&words));
            (x.exact(), Some(warp.pdf(x).wide()))
        }),
    };
    let fill = move |rng: &mut Pcg32, out: &mut [[f64; 3]]| {
        let mut points = vec![W::Point::BLANK; out.len()];
        warp.fill(rng, &mut points);
        out.iter_mut()
            .zip(points)
            .for_each(|(out, x)| *out = x.exact());
    };
    let law = Law::new(truth, <W::Uniforms as Uniforms>::COUNT);
    let draw = one_by_one(move |rng| warp.draw(rng));
    let mut row = Row::new(name, true, law, Way::Map(map), Box::new(fill), draw);
    let (mut kept, mut points) = (generator(), vec![W::Point::BLANK; POINTS]);
    row.fill = Some(Box::new(move || {
        let mut rng = kept.clone();
        warp.fill(&mut rng, black_box(&mut points));
        kept = rng;
        black_box(&points);
    }));
    row
}

/// Anything that draws points.
pub fn drawn<P: Exact>(
    name: Name,
    ours: bool,
    draw: impl Fn(&mut Pcg32) -> P + Copy + Send + Sync + 'static,
    law: Law,
    way: Way,
) -> Row {
    let fill = move |rng: &mut Pcg32, out: &mut [[f64; 3]]| {
        out.iter_mut().for_each(|out| *out = draw(rng).exact());
    };
    Row::new(name, ours, law, way, Box::new(fill), one_by_one(draw))
}

/// A sampler of this crate that rejects, with its density. A budget that is spent, which no true generator does, shows
/// as the point 0.
pub fn rejection<S, D: Wide>(
    name: Name,
    sampler: S,
    pdf: impl Fn(&S, S::Point) -> D + Send + Sync + 'static,
    law: Law,
    numbers: Numbers,
) -> Row
where
    S: Rejection + Copy + Send + Sync + 'static,
    S::Point: Exact,
{
    let draw = move |rng: &mut Pcg32| match sampler.draw(rng) {
        Ok(accepted) => accepted.point,
        Err(_) => S::Point::BLANK,
    };
    let mut row = drawn(name, true, draw, law, Way::Rejection(numbers));
    row.sampler.judged = Some(Box::new(move |rng| {
        let x = draw(rng);
        (x.exact(), pdf(&sampler, x).wide())
    }));
    row
}

/// A peer's map of uniforms.
pub fn map<P: Exact, const N: usize>(
    name: Name,
    map: impl Fn([f32; N]) -> P + Copy + Send + Sync + 'static,
    truth: Box<dyn Truth>,
) -> Row
where
    [f32; N]: FromWords,
{
    let way = Way::Map(Map {
        bits: <[f32; N]>::BITS,
        at: Box::new(move |words| (map(<[f32; N]>::of(&words)).exact(), None)),
    });
    let draw = host::peers::drawn(map);
    let fill = move |rng: &mut Pcg32, out: &mut [[f64; 3]]| {
        let draw = host::peers::drawn(map);
        out.iter_mut().for_each(|out| *out = draw(rng).exact());
    };
    Row::new(
        name,
        false,
        law(truth, N),
        way,
        Box::new(fill),
        one_by_one(draw),
    )
}

/// Anything that draws indices: a histogram over the line, each index spread over its cell by uniforms of its own.
pub fn indices(
    name: Name,
    ours: bool,
    index: impl Fn(&mut Pcg32) -> usize + Clone + Send + Sync + 'static,
    weights: &[f32],
    way: Way,
) -> Row {
    let weights: Vec<f64> = weights.iter().map(|w| f64::from(*w)).collect();
    let range = [0.0, weights.len() as f32];
    let truth = Histogram::new(&weights, range).expect("a positive weight");
    let kept = index.clone();
    let fill = move |rng: &mut Pcg32, out: &mut [[f64; 3]]| {
        for out in out {
            let index = kept(rng) as f64;
            *out = [index + f64::from(host::peers::uniform(rng)), 0.0, 0.0];
        }
    };
    let (mut kept, mut points) = (generator(), vec![0_usize; POINTS]);
    let draw = move || {
        let mut rng = kept.clone();
        for point in black_box(&mut points) {
            *point = index(&mut rng);
        }
        kept = rng;
        black_box(&points);
    };
    let law = law(Box::new(truth), 1);
    Row::new(name, ours, law, way, Box::new(fill), Box::new(draw))
}
