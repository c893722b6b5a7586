//! The search: fresh parameters, and changes of the worst ones met so far.

use super::words::below;
use super::{Case, Family, Uniforms};
use crate::errors::or_infinite;
use crate::speed;
use rand_pcg::Pcg32;
use std::rc::Rc;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// How long a family is attacked, and from where.
#[derive(Clone, Copy, Debug)]
pub enum Budget {
    /// So many points, from a fixed seed.
    Points(u32),
    /// For so long, from a given seed.
    Time(Duration, u64),
}

/// Points with which the search of any family comes near its worst case: about half a second.
pub const USUAL: u32 = 320_000;

impl Budget {
    /// `MICROWARP_SEARCH=seconds` a family, from a new seed; otherwise the usual budget, or less in the quick speed.
    pub fn of_environment() -> Self {
        let seconds = std::env::var("MICROWARP_SEARCH")
            .ok()
            .and_then(|s| s.parse().ok());
        let points = || {
            Self::Points(speed::of(
                "points of the search a family",
                USUAL / 40,
                USUAL,
            ))
        };
        seconds.map_or_else(points, |seconds| {
            let now = SystemTime::now().duration_since(UNIX_EPOCH);
            let seed = now.map_or(0, |t| t.as_nanos() as u64);
            println!("search of {seconds} s a family from seed {seed}");
            Self::Time(Duration::from_secs_f64(seconds), seed)
        })
    }
}

/// The largest part of a bound that an error has reached, and where.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    pub ratio: f64,
    pub error: f64,
    pub bound: f64,
    pub parameters: Vec<u32>,
    pub uniforms: Uniforms,
}

impl Worst {
    pub fn describe(&self, family: &Family) -> String {
        use super::words::Kind;
        let say = |kind: &Kind, word: &u32| match kind {
            Kind::Word => format!("{word:#010x}"),
            _ => format!("{:e}", f32::from_bits(*word)),
        };
        let list = |kinds: &[Kind], words: &[u32]| {
            let said: Vec<_> = kinds.iter().zip(words).map(|(k, w)| say(k, w)).collect();
            said.join(", ")
        };
        format!(
            "{:.4} times the bound: {:e} where {:e} is stated, at ({}) of ({})",
            self.ratio,
            self.error,
            self.bound,
            list(&family.uniforms, &self.uniforms),
            list(&family.parameters, &self.parameters),
        )
    }
}

/// Judges one point and raises the worst of each row.
pub fn raise(case: &dyn Case, parameters: &[u32], uniforms: Uniforms, worst: &mut [Worst]) -> bool {
    let mut raised = false;
    case.judge(uniforms, &mut |row, error, bound| {
        let error = or_infinite(error);
        // An error of 0 keeps a bound of 0.
        let ratio = if error == 0.0 {
            0.0
        } else {
            or_infinite(error / bound)
        };
        if ratio > worst[row].ratio {
            raised = true;
            worst[row] = Worst {
                ratio,
                error,
                bound,
                parameters: parameters.to_vec(),
                uniforms,
            };
        }
    });
    raised
}

/// How many of the worst are kept a row, to be changed further.
const ELITES: usize = 5;

struct Search<'a> {
    family: &'a Family,
    rng: Pcg32,
    /// A row's worst cases, of different parameters.
    elites: Vec<Vec<Worst>>,
    points: u32,
    /// The case of a family without parameters.
    only: Option<Option<Rc<dyn Case>>>,
}

impl Search<'_> {
    fn fresh(&mut self) -> Vec<u32> {
        let seeds = &self.family.seeds;
        if !seeds.is_empty() && below(&mut self.rng, 16) == 0 {
            return seeds[below(&mut self.rng, seeds.len() as u32) as usize].clone();
        }
        let mut parameters: Vec<u32> = Vec::new();
        for kind in &self.family.parameters {
            let related = !parameters.is_empty() && below(&mut self.rng, 5) == 0;
            let word = if related {
                let other = parameters[below(&mut self.rng, parameters.len() as u32) as usize];
                kind.beside(other, &mut self.rng)
            } else {
                kind.draw(&mut self.rng)
            };
            parameters.push(word);
        }
        parameters
    }

    fn fresh_uniforms(&mut self) -> Uniforms {
        let mut u = [0; 4];
        for (u, kind) in u.iter_mut().zip(&self.family.uniforms) {
            *u = kind.draw(&mut self.rng);
        }
        u
    }

    /// One of a row's worst with some of its parameters, some of its uniforms or both changed.
    fn changed(&mut self) -> Option<(Vec<u32>, Uniforms)> {
        let row = below(&mut self.rng, self.elites.len() as u32) as usize;
        let elites = &self.elites[row];
        if elites.is_empty() {
            return None;
        }
        let elite = elites[below(&mut self.rng, elites.len() as u32) as usize].clone();
        let (mut parameters, mut uniforms) = (elite.parameters, elite.uniforms);
        let (kinds, many) = (&self.family.parameters, self.family.parameters.len() as u32);
        if many > 0 && below(&mut self.rng, 2) == 0 {
            for _ in 0..=below(&mut self.rng, 2) {
                let k = below(&mut self.rng, many) as usize;
                parameters[k] = kinds[k].mutate(parameters[k], &mut self.rng);
            }
        } else {
            let k = below(&mut self.rng, self.family.uniforms.len() as u32) as usize;
            uniforms[k] = self.family.uniforms[k].mutate(uniforms[k], &mut self.rng);
        }
        Some((parameters, uniforms))
    }

    fn judge(&mut self, case: &dyn Case, parameters: &[u32], uniforms: Uniforms) {
        self.points += 1;
        let mut here = vec![Worst::default(); self.elites.len()];
        raise(case, parameters, uniforms, &mut here);
        for (elites, here) in self.elites.iter_mut().zip(here) {
            // Of one set of parameters only the worst uniforms stay.
            if let Some(same) = elites.iter_mut().find(|e| e.parameters == here.parameters) {
                if here.ratio > same.ratio {
                    *same = here;
                }
            } else if here.ratio > 0.0 {
                let full = elites.len() == ELITES;
                if full && elites.last().is_some_and(|last| last.ratio >= here.ratio) {
                    continue;
                }
                if full {
                    elites.pop();
                }
                elites.push(here);
            }
            elites.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
        }
    }

    /// What has no parameters is built once: that of a table takes longer than all else.
    fn build(&mut self, parameters: &[u32]) -> Option<Rc<dyn Case>> {
        let family = self.family;
        let new = || (family.build)(parameters).map(Rc::from);
        if parameters.is_empty() {
            self.only.get_or_insert_with(new).clone()
        } else {
            new()
        }
    }

    /// Several points of new parameters, or one of changed ones.
    fn round(&mut self) {
        if below(&mut self.rng, 3) > 0 {
            if let Some((parameters, uniforms)) = self.changed() {
                if let Some(case) = self.build(&parameters) {
                    self.judge(case.as_ref(), &parameters, uniforms);
                }
                self.points += 1;
                return;
            }
        }
        let parameters = self.fresh();
        if let Some(case) = self.build(&parameters) {
            for _ in 0..8 {
                let uniforms = self.fresh_uniforms();
                self.judge(case.as_ref(), &parameters, uniforms);
            }
        }
        self.points += 1;
    }
}

/// The worst of each row of a family.
pub fn worst(family: &Family, budget: Budget) -> Vec<Worst> {
    let name = family
        .label
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    let seed = match budget {
        Budget::Points(_) => 0,
        Budget::Time(_, seed) => seed,
    };
    let mut search = Search {
        family,
        rng: Pcg32::new(name ^ seed, name),
        elites: vec![Vec::new(); family.rows.len()],
        points: 0,
        only: None,
    };
    let began = Instant::now();
    while match budget {
        Budget::Points(points) => search.points < points,
        Budget::Time(time, _) => began.elapsed() < time,
    } {
        search.round();
    }
    let best = |elites: Vec<Worst>| elites.into_iter().next().unwrap_or_default();
    search.elites.into_iter().map(best).collect()
}
