//! The lists of `tests/golden`, read as what is bound: names, constructors and types.

use super::form::{Form, InC};
use microwarp::Warp;
use microwarp_golden::{float_warps, integer_warps};

/// A warp in C.
pub struct Bound {
    /// `coarse_` in `mw_coarse_disk`.
    pub tier: &'static str,
    pub name: &'static str,
    /// The type in Rust, with its arguments.
    pub of: &'static str,
    pub size: usize,
    pub align: usize,
    pub uniforms: Form,
    pub point: Form,
    pub density: Form,
    pub constructors: Vec<Constructor>,
}

pub struct Constructor {
    pub name: &'static str,
    pub parameters: Vec<(&'static str, Form)>,
}

impl Bound {
    pub fn symbol(&self) -> String {
        format!("mw_{}{}", self.tier, self.name)
    }

    /// Its name in Rust.
    pub fn type_name(&self) -> &str {
        self.of.split('<').next().unwrap_or(self.of).trim()
    }

    /// Whether it has a struct.
    pub fn is_stored(&self) -> bool {
        self.size > 0
    }
}

/// A block of a list: what is bound of it and its golden subjects, as tokens.
pub struct Block {
    pub type_name: &'static str,
    pub bound: Vec<Bound>,
    /// Why nothing is.
    pub reason: Option<&'static str>,
    pub golden: Vec<(&'static str, &'static str)>,
}

fn bound<W>(
    tier: &'static str,
    name: &'static str,
    of: &'static str,
    constructors: Vec<Constructor>,
) -> Bound
where
    W: Warp<Uniforms: InC, Point: InC, Density: InC>,
{
    let shares = if tier.is_empty() { "mw_" } else { "mw_fixed_" };
    let shares = format!("{shares}{name}_point");
    Bound {
        tier,
        name,
        of,
        size: size_of::<W>(),
        align: align_of::<W>(),
        uniforms: W::Uniforms::form(&shares),
        point: W::Point::form(&shares),
        density: W::Density::form(&shares),
        constructors,
    }
}

macro_rules! blocks {
    ($tier:literal $($type:ident {
        golden { $($subject:literal => $golden:expr,)* } cost $cost:tt page $page:tt bind $bind:tt
    })*) => {
        vec![$(Block {
            type_name: stringify!($type),
            bound: blocks!(@ bound $tier $bind),
            reason: blocks!(@ reason $bind),
            golden: vec![$(($subject, stringify!($golden))),*],
        }),*]
    };
    (@ reason { none $reason:literal }) => { Some($reason) };
    (@ reason $bind:tt) => { None };
    (@ bound $tier:literal { none $reason:literal }) => { Vec::new() };
    (@ bound $tier:literal { $($name:literal = $warp:ty {
        $($constructor:ident($($parameter:ident: $type:ty),*),)*
    })* }) => {
        vec![$(bound::<$warp>($tier, $name, stringify!($warp), vec![$(Constructor {
            name: stringify!($constructor),
            parameters: vec![$((stringify!($parameter), <$type>::form(""))),*],
        }),*])),*]
    };
}

macro_rules! of_grade {
    ($tier:literal in every grade { $($graded:tt)* } with floats { $($floats:tt)* } without grade $plain:tt) => {
        blocks! { $tier $($graded)* $($floats)* }
    };
}

macro_rules! without_grade {
    (in every grade $graded:tt with floats $floats:tt without grade { $($plain:tt)* }) => {
        blocks! { "fixed_" $($plain)* }
    };
}

pub fn poly() -> Vec<Block> {
    use microwarp::poly::*;
    float_warps!(blocks "")
}

macro_rules! grade {
    ($($name:ident $tier:literal $($path:ident)::+;)*) => {$(
        pub fn $name() -> Vec<Block> {
            use fixed::types::extra::U16;
            use fixed::types::{I2F30, I16F16, U0F32, U2F62, U16F16, U32F32};
            use microwarp::$($path)::+::*;
            integer_warps!(of_grade $tier)
        }
    )*};
}

grade! {
    fine "fixed_" fixed;
    coarse "coarse_" fixed::coarse;
    compact "compact_" fixed::compact;
}

pub fn plain() -> Vec<Block> {
    use fixed::types::{I16F16, U16F16};
    use microwarp::fixed::Interval;
    integer_warps!(without_grade)
}
