//! Rejection sampling within a budget of tries: ziggurats, disk and ball, counts, gamma numbers and what is made of them, angles,
//! and callbacks of the caller.

use crate::error::{Code, OK, code};
use crate::generators::{Pcg32, Source, forget_registers};
use crate::value::Value;
use crate::warps::{Given, InMemory, as_declared, makers};
use core::ffi::c_void;
use core_crate::rejection::{
    self, Accepted, Bounded, Failure, Region, Rejection, ZigguratExponential, ZigguratNormal,
    ZigguratStandardExponential, ZigguratStandardNormal, budget_for,
};
use core_crate::warp::{Aabb, Interval};
use core_crate::{fixed, poly};

/// A drawn point, and the tries where the caller wants them.
///
/// # Safety
/// The point is valid for writes, and the tries are or are null.
#[inline]
unsafe fn drawn<P: Value, E: Into<Code>>(
    result: Result<Accepted<P>, Failure<E>>,
    point: *mut P::C,
    tries: *mut u32,
) -> Code {
    // SAFETY: the caller's promise.
    let count = |of: u32| unsafe {
        if !tries.is_null() {
            tries.write(of);
        }
    };
    match result {
        Ok(accepted) => {
            count(accepted.tries);
            // SAFETY: the caller's promise.
            unsafe { point.write(accepted.point.to_c()) };
            OK
        }
        Err(failure) => {
            if let Failure::BudgetSpent { tries } = failure {
                count(tries);
            }
            failure.into()
        }
    }
}

macro_rules! samplers {
    ($($name:literal $sampler:ty, $point:ty $(, $pdf:ident)?;)*) => {$(
        const _: () = {
            const _: () = as_declared::<$sampler>(&["mw_", $name]);

            #[unsafe(export_name = concat!("mw_", $name, "_set_budget"))]
            extern "C" fn set_budget(sampler: &mut $sampler, budget: u32) -> Code {
                code(sampler.with_budget(budget), |made| *sampler = made)
            }

            #[unsafe(export_name = concat!("mw_", $name, "_draw"))]
            unsafe extern "C" fn draw(
                sampler: &$sampler, rng: &mut Pcg32, point: *mut InMemory<$point>, tries: *mut u32,
            ) -> Code {
                forget_registers();
                // SAFETY: the promise of the header.
                unsafe { drawn(sampler.try_draw(rng), point, tries) }
            }

            #[unsafe(export_name = concat!("mw_", $name, "_draw_from"))]
            unsafe extern "C" fn draw_from(
                sampler: &$sampler, source: &Source, point: *mut InMemory<$point>, tries: *mut u32,
            ) -> Code {
                forget_registers();
                // SAFETY: the promise of the header.
                unsafe { drawn(sampler.try_draw(&mut { *source }), point, tries) }
            }

            $(
                #[unsafe(export_name = concat!("mw_", $name, "_", stringify!($pdf)))]
                unsafe extern "C" fn $pdf(sampler: &$sampler, x: Given<$point>) -> f32 {
                    // SAFETY: the promise of the header.
                    sampler.$pdf(unsafe { <$point>::read(x) })
                }
            )?
        };
    )*};
}

samplers! {
    "ziggurat_standard_normal" ZigguratStandardNormal, f32;
    "ziggurat_normal" ZigguratNormal, f32;
    "ziggurat_standard_exponential" ZigguratStandardExponential, f32;
    "ziggurat_exponential" ZigguratExponential, f32;
    "disk_rejection" rejection::DiskRejection, [f32; 2];
    "ball_rejection" rejection::BallRejection, [f32; 3];
    "poisson_rejection" poly::PoissonRejection, u32;
    "binomial_rejection" poly::BinomialRejection, u32;
    "gamma" poly::Gamma, f32, pdf;
    "beta" poly::Beta, [f32; 2], pdf;
    "dirichlet_3" poly::Dirichlet<3>, [f32; 3], pdf;
    "dirichlet_4" poly::Dirichlet<4>, [f32; 4], pdf;
    "dirichlet_6" poly::Dirichlet<6>, [f32; 6], pdf;
    "dirichlet_8" poly::Dirichlet<8>, [f32; 8], pdf;
    "von_mises" poly::VonMises, f32, pdf;
    "fixed_disk_rejection" fixed::DiskRejection, [fixed::Coordinate; 2];
    "fixed_disk_rejection_16" fixed::DiskRejection16, [fixed::Coordinate; 2];
}

#[unsafe(export_name = "mw_gamma_draw_ln")]
unsafe extern "C" fn draw_ln(
    sampler: &poly::Gamma,
    rng: &mut Pcg32,
    ln: *mut f32,
    tries: *mut u32,
) -> Code {
    forget_registers();
    // SAFETY: the promise of the header.
    unsafe { drawn(sampler.try_draw_ln(rng), ln, tries) }
}

#[unsafe(export_name = "mw_gamma_draw_ln_from")]
unsafe extern "C" fn draw_ln_from(
    sampler: &poly::Gamma,
    source: &Source,
    ln: *mut f32,
    tries: *mut u32,
) -> Code {
    forget_registers();
    // SAFETY: the promise of the header.
    unsafe { drawn(sampler.try_draw_ln(&mut { *source }), ln, tries) }
}

makers! {
    "ziggurat_standard_normal_init" ZigguratStandardNormal, () { Ok(Default::default()) }
    "ziggurat_standard_exponential_init" ZigguratStandardExponential, () { Ok(Default::default()) }
    "disk_rejection_init" rejection::DiskRejection, () { Ok(Default::default()) }
    "ball_rejection_init" rejection::BallRejection, () { Ok(Default::default()) }
    "fixed_disk_rejection_init" fixed::DiskRejection, () { Ok(Default::default()) }
    "fixed_disk_rejection_16_init" fixed::DiskRejection16, () { Ok(Default::default()) }
    "ziggurat_normal_init" ZigguratNormal, (mean: f32, std_dev: f32) { ZigguratNormal::new(mean, std_dev) }
    "ziggurat_exponential_init" ZigguratExponential, (rate: f32) { ZigguratExponential::from_rate(rate) }
    "ziggurat_exponential_init_from_mean" ZigguratExponential, (mean: f32) { ZigguratExponential::from_mean(mean) }
    "poisson_rejection_init" poly::PoissonRejection, (mean: f32) { poly::PoissonRejection::new(mean) }
    "binomial_rejection_init" poly::BinomialRejection, (trials: u32, p: f32) { poly::BinomialRejection::new(trials, p) }
    "gamma_init" poly::Gamma, (shape: f32, scale: f32) { poly::Gamma::new(shape, scale) }
    "gamma_init_chi_squared" poly::Gamma, (degrees: f32) { poly::Gamma::chi_squared(degrees) }
    "beta_init" poly::Beta, (a: f32, b: f32) { poly::Beta::new(a, b) }
    "dirichlet_3_init" poly::Dirichlet<3>, (shapes: *const [f32; 3]) { poly::Dirichlet::new(shapes.read()) }
    "dirichlet_4_init" poly::Dirichlet<4>, (shapes: *const [f32; 4]) { poly::Dirichlet::new(shapes.read()) }
    "dirichlet_6_init" poly::Dirichlet<6>, (shapes: *const [f32; 6]) { poly::Dirichlet::new(shapes.read()) }
    "dirichlet_8_init" poly::Dirichlet<8>, (shapes: *const [f32; 8]) { poly::Dirichlet::new(shapes.read()) }
    "von_mises_init" poly::VonMises, (mean: f32, concentration: f32) { poly::VonMises::new(mean, concentration) }
}

#[unsafe(export_name = "mw_budget_for")]
extern "C" fn budget(efficiency: f32, budget: &mut u32) -> Code {
    code(budget_for(efficiency), |tries| *budget = tries)
}

/// `mw_region_*` and `mw_density_*`: callbacks with their context.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Callback<P: Value, T> {
    call: unsafe extern "C" fn(*mut c_void, Given<P>) -> T,
    context: *mut c_void,
}

impl<P: Value, T> Callback<P, T> {
    /// # Safety
    /// The caller of the library promises a function that takes this context.
    #[inline]
    pub unsafe fn of(&self, point: P) -> T {
        // SAFETY: the promise above.
        unsafe { (self.call)(self.context, P::given(&point.to_c())) }
    }
}

/// The domains from which callbacks choose: an interval and boxes.
macro_rules! callbacks {
    ($($region:literal $bounded:literal $domain:ty, $point:ty;)*) => {$(
        const _: () = {
            type Domain = $domain;
            type Point = $point;
            type Inside = Callback<$point, bool>;
            type Density = Callback<$point, f32>;

            callbacks! { @ $region $bounded "_draw" (rng: &mut Pcg32) rng }
            callbacks! { @ $region $bounded "_draw_from" (source: &Source) &mut { *source } }
        };
    )*};
    (@ $region:literal $bounded:literal $draw:literal ($given:ident: $of:ty) $rng:expr) => {
        const _: () = {
            #[unsafe(export_name = concat!("mw_", $region, $draw))]
            unsafe extern "C" fn region(
                domain: &Domain, inside: &Inside, budget: u32, $given: $of, point: *mut Point,
                tries: *mut u32,
            ) -> Code {
                // SAFETY: the promise of the header.
                let inside = |x: Point| unsafe { inside.of(x) };
                match Region::new(domain, inside).with_budget(budget) {
                    // SAFETY: the promise of the header.
                    Ok(sampler) => unsafe { drawn(sampler.try_draw($rng), point, tries) },
                    Err(error) => error.into(),
                }
            }

            #[unsafe(export_name = concat!("mw_", $bounded, $draw))]
            unsafe extern "C" fn bounded(
                domain: &Domain, density: &Density, bound: f32, budget: u32, $given: $of,
                point: *mut Point, tries: *mut u32,
            ) -> Code {
                // SAFETY: the promise of the header.
                let density = |x: Point| unsafe { density.of(x) };
                let sampler = Bounded::new(domain, density, bound);
                match sampler.and_then(|sampler| sampler.with_budget(budget)) {
                    // SAFETY: the promise of the header.
                    Ok(sampler) => unsafe { drawn(sampler.try_draw($rng), point, tries) },
                    Err(error) => error.into(),
                }
            }
        };
    };
}

callbacks! {
    "region_1d" "bounded_1d" Interval, f32;
    "region_2d" "bounded_2d" Aabb<2>, [f32; 2];
    "region_3d" "bounded_3d" Aabb<3>, [f32; 3];
}
