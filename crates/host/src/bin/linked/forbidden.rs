//! What may not be linked, as patterns over mangled names.
//!
//! The names of crates and modules stand readable in both of Rust's manglings; in the older one `::` inside a type is
//! written `..`. Each pattern is tried on names that it must find and on near namesakes before it is used.

use crate::image::Image;
use microwarp_host::upkeep::Outcome;
use regex_lite::Regex;
use std::path::Path;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Panic,
    Alloc,
    /// Routines of double precision.
    F64,
    /// The same over `f32`, for programs of integers alone.
    F32,
}

impl Kind {
    pub fn name(self) -> &'static str {
        match self {
            Self::Panic => "panic",
            Self::Alloc => "alloc",
            Self::F64 => "f64",
            Self::F32 => "f32",
        }
    }

    /// The parts of the pattern, any of which is enough. Of routines: Arm's names, GCC's (which compiler_builtins wraps
    /// in a mangled name), and the C library's.
    fn parts(self) -> &'static [&'static str] {
        match self {
            Self::Panic => &[
                r"core9panicking|core\.\.panicking|rust_begin_unwind|rust_panic|probe_panicked|begin_panic",
                r"panic_(fmt|bounds_check|nounwind|const|display|str|misaligned|cannot_unwind|in_cleanup)",
                r"(unwrap|expect|assert)_failed|slice_[a-z_]*fail|len_mismatch_fail|_Unwind_|__aeabi_unwind",
                r"eh_personality|4core3fmt|core\.\.fmt",
            ],
            Self::Alloc => &[
                r"__rust_(alloc|dealloc|realloc|no_alloc|alloc_error)|__rg_|__rdl_|GlobalAlloc",
                r"_5alloc(5alloc|5boxed|3vec|7raw_vec|6string|2rc|4sync|11collections)",
                r"N5alloc(5alloc|5boxed|3vec|7raw_vec|6string|2rc|4sync|11collections)|alloc\.\.",
                r"alloc_error_handler|handle_alloc_error|^_?(malloc|calloc|realloc|free|sbrk)(_r)?$",
            ],
            Self::F64 => &[
                r"__aeabi_(d(add|r?sub|mul|div|neg|cmp(eq|lt|le|ge|gt|un))|cdr?cmp(eq|le)|d2(u?iz|u?lz|f|h)|(f|h|u?i|u?l)2d)$",
                r"__(add|sub|mul|div|neg|pow|powi|eq|ne|lt|le|gt|ge|cmp|unord)df[23](vfp)?$",
                r"__(extend(sf|hf)df|truncdf(sf|hf))2(vfp)?$|__fix(uns)?df(si|di|ti)(vfp)?$",
                r"__float(un)?s?(si|di|ti)df(vfp)?$",
                r"^(sin|cos|tan|sincos|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|sqrt|cbrt|hypot|fma|fmod|ceil|floor|round|roundeven|trunc|rint|nearbyint|ldexp|scalbn|frexp|modf|tgamma|lgamma|fabs|fmin|fmax|fdim|copysign)$",
            ],
            Self::F32 => &[
                r"__aeabi_(f(add|r?sub|mul|div|neg|cmp(eq|lt|le|ge|gt|un))|cfr?cmp(eq|le)|f2(u?iz|u?lz|h|d)|(d|h|u?i|u?l)2f)$",
                r"__(add|sub|mul|div|neg|pow|powi|eq|ne|lt|le|gt|ge|cmp|unord)sf[23](vfp)?$",
                r"__(extend(hf|sf)[sdt]f|trunc(df|tf|sf)[sh]f)2(vfp)?$|__fix(uns)?sf(si|di|ti)(vfp)?$",
                r"__float(un)?s?(si|di|ti)sf(vfp)?$",
                r"^(sin|cos|tan|sincos|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|sqrt|cbrt|hypot|fma|fmod|ceil|floor|round|roundeven|trunc|rint|nearbyint|ldexp|scalbn|frexp|modf|tgamma|lgamma|fabs|fmin|fmax|fdim|copysign)f$",
                r"4libm4math|libm\.\.math|17compiler_builtins5float|compiler_builtins\.\.float",
                r"17compiler_builtins4math|compiler_builtins\.\.math",
            ],
        }
    }

    fn pattern(self) -> Outcome<Regex> {
        Regex::new(&self.parts().join("|")).map_err(|e| format!("the {} pattern: {e}", self.name()))
    }
}

/// The names of a kind among some.
fn findings(names: &[String], kind: Kind) -> Outcome<Vec<&str>> {
    let pattern = kind.pattern()?;
    let names = names.iter().map(String::as_str);
    Ok(names.filter(|name| pattern.is_match(name)).collect())
}

/// The symbols of an image, among which `anchor` must be: a list that is empty or of something else would let
/// everything pass.
fn symbols(path: &Path, anchor: &str) -> Outcome<Vec<String>> {
    let mut names = Image::read(path)?.names;
    names.sort();
    names.dedup();
    if names.iter().any(|name| name == anchor) {
        return Ok(names);
    }
    let count = names.len();
    Err(format!(
        "{}: no symbol {anchor} among {count}: the check reads nothing",
        path.display()
    ))
}

/// Nothing of these kinds is linked.
pub fn clean(path: &Path, anchor: &str, kinds: &[Kind]) -> Outcome {
    let names = symbols(path, anchor)?;
    let mut found = String::new();
    for &kind in kinds {
        for name in findings(&names, kind)? {
            found += &format!("\n    {}: {name}", kind.name());
        }
    }
    if !found.is_empty() {
        return Err(format!("{} links:{found}", path.display()));
    }
    let kinds: Vec<_> = kinds.iter().map(|kind| kind.name()).collect();
    println!(
        "{}: {} symbols, none of: {}",
        path.display(),
        names.len(),
        kinds.join(" ")
    );
    Ok(())
}

/// The same reading finds what was put there on purpose.
pub fn caught(path: &Path, anchor: &str, kind: Kind) -> Outcome {
    let count = findings(&symbols(path, anchor)?, kind)?.len();
    if count == 0 {
        return Err(format!(
            "{}: the check does not see its {}",
            path.display(),
            kind.name()
        ));
    }
    println!(
        "{}: caught, {count} symbols of {}",
        path.display(),
        kind.name()
    );
    Ok(())
}

/// Functions of the crate itself are linked. One warp may be inlined whole, but not all of them; where they are missing,
/// constants were folded and the probe has proved nothing.
pub fn calls_the_library(path: &Path, anchor: &str) -> Outcome {
    let names = symbols(path, anchor)?;
    let ours = |name: &String| name.contains("9microwarp") || name.contains("microwarp..");
    if names.iter().any(ours) {
        return Ok(());
    }
    Err(format!(
        "{}: no function of microwarp is linked: the probe calls nothing",
        path.display()
    ))
}

/// `a{b,c}d` as `abd acd`, any number of times.
fn expanded(text: &str) -> Vec<String> {
    let words = text.split_whitespace().flat_map(|word| {
        let mut done = vec![String::new()];
        for part in word.split('}') {
            let (fixed, choices) = part.split_once('{').unwrap_or((part, ""));
            let choices: Vec<&str> = choices.split(',').collect();
            let longer = |start: &String| {
                choices
                    .iter()
                    .map(|choice| [start, fixed, choice].concat())
                    .collect::<Vec<_>>()
            };
            done = done.iter().flat_map(longer).collect();
        }
        done
    });
    words.collect()
}

const INTEGERS: &str = "__aeabi_{idiv,uidiv,ldivmod,uldivmod,lmul,llsl,lasr,lcmp,idiv0,ldiv0,memcpy4,memclr} \
    __{mul,div,mod,ashl,cmp}di3 __{mul,udiv}ti3 __{clz,ctz,udiv}si2 __clzsi2 memset memcpy probe_main \
    _RNvNtNtCsa_17compiler_builtins3int3mul8___muldi3 _ZN9microwarp10metropolis5chain4step17h0E sincos_table fixed";
const SINGLE: &str = "__aeabi_{fadd,frsub,fsub,fmul,fdiv,fcmplt,fcmpun,cfcmple,f2iz,f2uiz,f2lz,f2ulz,i2f,ui2f,l2f,ul2f} \
    __{add,sub,mul,div}sf3 __{eq,unord,cmp,neg}sf2 __fix{,uns}sf{si,di} __float{,un}{si,di}sf \
    sqrtf expf fmaf powf sincosf";
const DOUBLE: &str = "__aeabi_{dadd,drsub,dmul,ddiv,dcmpun,cdcmple,cdrcmple,d2iz,d2uiz,d2lz,i2d,ui2d,l2d,ul2d} \
    __{add,sub,mul,div}df3 __{eq,unord,cmp,neg}df2 __fix{,uns}df{si,di} __float{,un}{si,di}df sqrt exp";
/// What converts from one width to the other belongs to both.
const BOTH: &str = "__aeabi_{d2f,f2d} __extendsfdf2 __truncdfsf2";
const MANGLED_DOUBLE: &str = "_RNvNtNtCsa_17compiler_builtins5float3mul8___muldf3";
const MANGLED_SINGLE: &str = "_RNvNtNtCsa_17compiler_builtins5float3mul8___mulsf3 \
    _ZN17compiler_builtins5float3add3add17h0E _RNvNtNtCs_4libm4math5sqrtf5sqrtf";

/// The routines of one width live beside near namesakes over the other and over integers, so both patterns are tried on
/// all of them.
pub fn control() -> Outcome {
    let lists = [
        (
            Kind::F64,
            [DOUBLE, BOTH, MANGLED_DOUBLE].join(" "),
            [INTEGERS, SINGLE].join(" "),
        ),
        (
            Kind::F32,
            [SINGLE, BOTH, MANGLED_SINGLE].join(" "),
            [INTEGERS, DOUBLE].join(" "),
        ),
    ];
    for (kind, takes, refuses) in lists {
        let (takes, refuses) = (expanded(&takes), expanded(&refuses));
        let (found, wrong) = (findings(&takes, kind)?, findings(&refuses, kind)?);
        if let Some(missed) = takes.iter().find(|name| !found.contains(&name.as_str())) {
            return Err(format!("the {} pattern misses {missed}", kind.name()));
        }
        if !wrong.is_empty() {
            return Err(format!("the {} pattern takes {wrong:?}", kind.name()));
        }
    }
    Ok(())
}
