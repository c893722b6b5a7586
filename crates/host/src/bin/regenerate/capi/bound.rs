//! The lists of `crates/list`, read as what is bound: names, constructors and types.

use super::form::{Form, InC};
use microwarp::Warp;
use microwarp_list::{float_warps, integer_warps};

/// A warp in C.
pub struct Bound {
    /// `coarse_` in `mw_coarse_disk`.
    pub tier: &'static str,
    pub name: &'static str,
    /// The type in Rust, with its arguments.
    pub of: &'static str,
    pub stored: Stored,
    pub uniforms: Form,
    pub point: Form,
    pub density: Form,
    pub constructors: Vec<Constructor>,
}

/// What a struct holds: so many pointers or lengths, and then words.
#[derive(Clone, Copy)]
pub struct Stored {
    pub pointers: usize,
    /// Of the words, without padding behind pointers.
    pub bytes: usize,
    pub align: usize,
}

fn stored<T>(pointers: usize) -> Stored {
    Stored {
        pointers,
        bytes: size_of::<T>() - pointers * size_of::<usize>(),
        align: align_of::<T>(),
    }
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
        self.stored.bytes + self.stored.pointers > 0
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
        stored: stored::<W>(0),
        uniforms: W::Uniforms::form(&shares),
        point: W::Point::form(&shares),
        density: W::Density::form(&shares),
        constructors,
    }
}

macro_rules! blocks {
    ($tier:literal $($type:ident {
        golden { $($($once:ident)? $subject:literal => $golden:expr,)* } cost $cost:tt bind $bind:tt
    })*) => {
        // A function for each: one for all would be compiled for seconds.
        [$((|| Block {
            type_name: stringify!($type),
            bound: blocks!(@ bound $tier $bind),
            reason: blocks!(@ reason $bind),
            golden: vec![$(($subject, stringify!($golden))),*],
        }) as fn() -> Block),*].iter().map(|block| block()).collect()
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

macro_rules! tables {
    ($($name:literal $table:ty, $pointers:literal;)*) => {
        vec![$(Bound {
            stored: stored::<$table>($pointers),
            ..bound::<$table>("", $name, stringify!($table), Vec::new())
        }),*]
    };
}

/// The warps whose words lie in memory of the caller. Their handles hold slices, of two pointers or lengths each.
pub fn tables() -> Vec<Bound> {
    use microwarp::discrete::{Mesh, PiecewiseConstant1d, PiecewiseConstant2d, PiecewiseLinear1d};
    use microwarp::poly::LatLongMap;
    tables! {
        "piecewise_constant_1d" PiecewiseConstant1d<&[u32]>, 2;
        "piecewise_linear_1d" PiecewiseLinear1d<&[u32], &[f32]>, 4;
        "piecewise_constant_2d" PiecewiseConstant2d<&[u32], &[u32]>, 4;
        "lat_long_map" LatLongMap<&[u32], &[u32]>, 4;
        "mesh" Mesh<'_, u32, &[u32]>, 8;
        "mesh_u16" Mesh<'_, u16, &[u32]>, 8;
    }
}

/// All that have functions.
pub fn every() -> Vec<Bound> {
    let blocks = [poly(), fine(), plain(), coarse(), compact()];
    let bound = blocks.into_iter().flatten().flat_map(|block| block.bound);
    bound.chain(tables()).collect()
}

macro_rules! structs {
    ($($name:literal $type:ty;)*) => {
        vec![$((concat!("mw_", $name), stored::<$type>(0))),*]
    };
}

/// The structs of what is no warp.
pub fn structs() -> Vec<(&'static str, Stored)> {
    use microwarp::discrete::{
        Binomial, DiscreteGaussian, DiscreteLaplace, Geometric, LightReservoir, Mixture, Poisson,
        Reservoir, WeightedReservoir,
    };
    use microwarp::estimate::{Integral, Moments, WeightedMean};
    use microwarp::rejection::{self, ZigguratExponential, ZigguratNormal};
    use microwarp::rejection::{ZigguratStandardExponential, ZigguratStandardNormal};
    use microwarp::uniform::{ChoiceInOrder, ChoiceOfStream, LatinHypercube, Permutation};
    use microwarp::uniform::{Recurrence, Screen, Sobol, Strata1d, Strata2d};
    use microwarp::warp::Frame;
    use microwarp::{fixed, poly};
    structs! {
        "frame" Frame;
        "chooser" Mixture<[poly::Disk; 32], 32>;
        "geometric" Geometric;
        "poisson" Poisson;
        "binomial" Binomial;
        "discrete_gaussian" DiscreteGaussian;
        "discrete_laplace" DiscreteLaplace;
        "reservoir" Reservoir<u32>;
        "weighted_place" WeightedReservoir<u32, 1>;
        "light_reservoir" LightReservoir<u32>;
        "ziggurat_standard_normal" ZigguratStandardNormal;
        "ziggurat_normal" ZigguratNormal;
        "ziggurat_standard_exponential" ZigguratStandardExponential;
        "ziggurat_exponential" ZigguratExponential;
        "disk_rejection" rejection::DiskRejection;
        "ball_rejection" rejection::BallRejection;
        "poisson_rejection" poly::PoissonRejection;
        "binomial_rejection" poly::BinomialRejection;
        "gamma" poly::Gamma;
        "beta" poly::Beta;
        "dirichlet_3" poly::Dirichlet<3>;
        "dirichlet_4" poly::Dirichlet<4>;
        "dirichlet_6" poly::Dirichlet<6>;
        "dirichlet_8" poly::Dirichlet<8>;
        "von_mises" poly::VonMises;
        "fixed_disk_rejection" fixed::DiskRejection;
        "fixed_disk_rejection_16" fixed::DiskRejection16;
        "moments" Moments;
        "weighted_mean" WeightedMean;
        "integral" Integral;
        "sobol_1d" Sobol<1>;
        "sobol_2d" Sobol<2>;
        "sobol_3d" Sobol<3>;
        "sobol_4d" Sobol<4>;
        "sobol_8d" Sobol<8>;
        "recurrence_1d" Recurrence<1>;
        "recurrence_2d" Recurrence<2>;
        "recurrence_3d" Recurrence<3>;
        "strata_1d" Strata1d;
        "strata_2d" Strata2d;
        "choice_in_order" ChoiceInOrder;
        "choice_of_stream" ChoiceOfStream;
        "permutation" Permutation;
        "latin_hypercube" LatinHypercube;
        "screen" Screen<Sobol<8>>;
    }
}
