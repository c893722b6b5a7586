//! How the types of the crate are declared in C.

use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedU32, FixedU64};
use microwarp::discrete::MeshPoint;
use microwarp::warp::SurfacePoint;

/// A type in C: a number, an array of numbers, or a struct.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// `float`, `int32_t` or the name of a struct.
    pub base: String,
    /// The lengths of the dimensions, as they stand behind a name.
    pub lengths: Vec<usize>,
    /// The fields of a struct, each a number or an array of them.
    pub fields: Vec<(&'static str, Form)>,
    /// What its words stand for, where the type does not say.
    pub format: Option<String>,
}

impl Form {
    fn number(base: &str, format: Option<String>) -> Self {
        Self {
            base: base.into(),
            lengths: Vec::new(),
            fields: Vec::new(),
            format,
        }
    }

    pub fn is_struct(&self) -> bool {
        !self.fields.is_empty()
    }

    /// Whether it is handed over by value.
    pub fn is_number(&self) -> bool {
        self.lengths.is_empty() && !self.is_struct()
    }

    fn behind(&self, name: &str) -> String {
        let lengths: String = self.lengths.iter().map(|n| format!("[{n}]")).collect();
        format!("{name}{lengths}")
    }

    /// As a variable.
    pub fn declared(&self, name: &str) -> String {
        format!("{} {}", self.base, self.behind(name))
    }

    /// So many in an array.
    pub fn array(&self, name: &str, count: usize) -> String {
        self.declared(&format!("{name}[{count}]"))
    }

    /// Its numbers by their places, `name[0]` or `name.rest`, with their types and their indices in their arrays.
    pub fn places(&self, name: &str) -> Vec<(String, &str, usize)> {
        if self.is_struct() {
            let fields = self.fields.iter();
            let fields = fields.map(|(field, form)| form.places(&format!("{name}.{field}")));
            return fields.flatten().collect();
        }
        let mut places = vec![(name.to_owned(), &*self.base, 0)];
        for &length in &self.lengths {
            let inner = |(place, base, _): &(String, _, _)| {
                let (place, base) = (place.clone(), *base);
                (0..length).map(move |i| (format!("{place}[{i}]"), base, i))
            };
            places = places.iter().flat_map(inner).collect();
        }
        places
    }

    /// As an argument that is read.
    pub fn given(&self, name: &str) -> String {
        if self.is_number() {
            self.declared(name)
        } else if self.is_struct() {
            format!("const {} *{name}", self.base)
        } else {
            format!("const {}", self.declared(name))
        }
    }

    /// As an argument that is written.
    pub fn place(&self, name: &str) -> String {
        if self.lengths.is_empty() {
            format!("{} *{name}", self.base)
        } else {
            self.declared(name)
        }
    }

    /// As an argument of which many are written.
    pub fn many(&self, name: &str) -> String {
        if self.lengths.is_empty() {
            format!("{} *{name}", self.base)
        } else {
            format!("{} {}", self.base, self.behind(&format!("(*{name})")))
        }
    }
}

/// A type that crosses the boundary.
pub trait InC {
    /// `shares` is the name of the struct of a point of a simplex.
    fn form(shares: &str) -> Form;
}

macro_rules! whole {
    ($($number:ty, $base:literal;)*) => {$(
        impl InC for $number {
            fn form(_: &str) -> Form {
                Form::number($base, None)
            }
        }
    )*};
}

whole! {
    f32, "float";
    u16, "uint16_t";
    i32, "int32_t";
    u32, "uint32_t";
    usize, "size_t";
}

macro_rules! fixed_point {
    ($($type:ident $least:ident $base:literal $sign:literal $bits:literal;)*) => {$(
        impl<F: $least> InC for $type<F> {
            fn form(_: &str) -> Form {
                let fraction = Self::FRAC_NBITS;
                Form::number($base, Some(format!("{}Q{}.{fraction}", $sign, $bits - fraction)))
            }
        }
    )*};
}

fixed_point! {
    FixedI32 LeEqU32 "int32_t" "" 32;
    FixedU32 LeEqU32 "uint32_t" "U" 32;
    FixedU64 LeEqU64 "uint64_t" "U" 64;
}

impl<T: InC, const N: usize> InC for [T; N] {
    fn form(shares: &str) -> Form {
        let mut form = T::form(shares);
        form.lengths.insert(0, N);
        form
    }
}

impl<T: InC, const N: usize> InC for ([T; N], T) {
    fn form(shares: &str) -> Form {
        Form {
            fields: vec![("shares", <[T; N]>::form("")), ("rest", T::form(""))],
            ..Form::number(shares, T::form("").format)
        }
    }
}

impl InC for SurfacePoint {
    fn form(_: &str) -> Form {
        let of_three = <[f32; 3]>::form("");
        Form {
            fields: vec![("position", of_three.clone()), ("normal", of_three)],
            ..Form::number("mw_surface_point", None)
        }
    }
}

impl InC for MeshPoint {
    fn form(_: &str) -> Form {
        let of_three = <[f32; 3]>::form("");
        Form {
            fields: vec![
                ("position", of_three.clone()),
                ("barycentrics", of_three),
                ("triangle", usize::form("")),
            ],
            ..Form::number("mw_mesh_point", None)
        }
    }
}
