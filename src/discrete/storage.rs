//! Where a table keeps its entries: an array, a `heapless` vector, a borrowed slice, or a type of the caller's.

/// Memory that holds the entries of a table.
///
/// | storage | number of entries | made by |
/// |---|---|---|
/// | `[T; N]` | known to the compiler; a `const` table lies in flash | [`Cdf::new`](super::Cdf::new) |
/// | [`heapless::Vec`] | known at run time, at most the capacity | [`Cdf::from_slice`](super::Cdf::from_slice) |
/// | `Vec<T>`, `Box<[T]>`, with feature `alloc` | known at run time | [`Cdf::from_slice`](super::Cdf::from_slice) |
/// | `&[T]` | known at run time; the memory is the caller's | [`Cdf::new_in`](super::Cdf::new_in) |
/// | `&mut` of any of these, where entries change | known at run time | [`SumTree::new_in`](super::SumTree::new_in) |
///
/// A type of your own becomes a storage with the one method here, and then holds finished tables:
/// [`Cdf::from_words`](super::Cdf::from_words). With [`OwnedStorage`] it can hold new ones too.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot hold the entries of a table",
    label = "not a storage",
    note = "an array, a borrowed slice and a `heapless::Vec` are storages",
    note = "`Vec<_>` and `Box<[_]>` are storages too, with feature `alloc` of `microwarp`"
)]
pub trait Storage {
    /// The type of an entry.
    type Item: Copy;
    /// All entries, the same at every call.
    #[must_use]
    fn items(&self) -> &[Self::Item];
}

/// Storage that can be made at run time, for any number of entries: what `from_slice` builds a table in.
///
/// `heapless::Vec` is one, and with feature `alloc` `Vec` and `Box<[T]>`. Implement it for a container of
/// your own, and [`Grid`] too if it is to hold a [`PiecewiseConstant2d`](super::PiecewiseConstant2d).
///
/// # Examples
/// ```
/// use microwarp::discrete::{Cdf, OwnedStorage, Storage};
///
/// /// Up to eight words, in a container of another crate.
/// struct Few([u32; 8], usize);
///
/// impl Storage for Few {
///     type Item = u32;
///     fn items(&self) -> &[u32] {
///         self.0.get(..self.1).unwrap_or(&[])
///     }
/// }
/// impl OwnedStorage for Few {
///     fn filled(item: u32, length: usize) -> Option<Self> {
///         (length <= 8).then_some(Self([item; 8], length))
///     }
///     fn items_mut(&mut self) -> &mut [u32] {
///         self.0.get_mut(..self.1).unwrap_or(&mut [])
///     }
/// }
///
/// let weights = vec![1.0, 2.0, 1.0];
/// let table = Cdf::<Few>::from_slice(&weights)?;
/// assert_eq!(table.pmf(1), 0.5);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "a table cannot be made in `{Self}` from a slice",
    label = "not a storage whose length is known at run time only",
    note = "`Cdf::new` makes a table in an array, from an array of weights",
    note = "`from_slice` makes one in a `heapless::Vec<_, CAPACITY>`, or with feature `alloc` in a `Vec<_>` or a `Box<[_]>`",
    note = "`new_in` makes one in borrowed memory"
)]
pub trait OwnedStorage: Storage + Sized {
    /// Storage of so many entries, all of them `item`; `None` where there is no room for them.
    #[must_use]
    fn filled(item: Self::Item, length: usize) -> Option<Self>;
    /// All entries, as many as were asked for.
    #[must_use]
    fn items_mut(&mut self) -> &mut [Self::Item];
}

impl<T: Copy, const N: usize> Storage for [T; N] {
    type Item = T;
    #[inline]
    fn items(&self) -> &[T] {
        self
    }
}

impl<T: Copy> Storage for &[T] {
    type Item = T;
    #[inline]
    fn items(&self) -> &[T] {
        self
    }
}

impl<T: Copy> Storage for [T] {
    type Item = T;
    #[inline]
    fn items(&self) -> &[T] {
        self
    }
}

impl<S: Storage + ?Sized> Storage for &mut S {
    type Item = S::Item;
    #[inline]
    fn items(&self) -> &[S::Item] {
        S::items(self)
    }
}

/// Memory that holds the rows of a two-dimensional table: an array of arrays, or any other [`Storage`], row
/// after row.
///
/// `[[T; U]; V]`, `&[T]` and `heapless::Vec` are grids, and with feature `alloc` `Vec` and `Box<[T]>`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot hold the rows of a two-dimensional table",
    label = "not a grid of rows",
    note = "an array of arrays, a borrowed slice and a `heapless::Vec` are grids",
    note = "`Vec<_>` and `Box<[_]>` are grids too, with feature `alloc` of `microwarp`"
)]
pub trait Grid {
    /// The type of an entry.
    type Item: Copy;
    /// The entries of all rows, one row after the other; the same at every call.
    #[must_use]
    fn flat(&self) -> &[Self::Item];
}

impl<T: Copy, const U: usize, const V: usize> Grid for [[T; U]; V] {
    type Item = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self.as_flattened()
    }
}

impl<T: Copy> Grid for &[T] {
    type Item = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self
    }
}

/// A container as a storage and as rows, by what makes one.
macro_rules! owned {
    ($([$($generics:tt)*] $container:ty, $filled:expr;)*) => {$(
        impl<T: Copy, $($generics)*> Storage for $container {
            type Item = T;
            #[inline]
            fn items(&self) -> &[T] {
                self
            }
        }

        impl<T: Copy, $($generics)*> OwnedStorage for $container {
            #[inline]
            fn filled(item: T, length: usize) -> Option<Self> {
                $filled(item, length)
            }

            #[inline]
            fn items_mut(&mut self) -> &mut [T] {
                self
            }
        }

        impl<T: Copy, $($generics)*> Grid for $container {
            type Item = T;
            #[inline]
            fn flat(&self) -> &[T] {
                self
            }
        }
    )*};
}

owned! {
    [const N: usize] heapless::Vec<T, N>, |item, length| {
        let mut items = Self::new();
        items.resize(length, item).is_ok().then_some(items)
    };
}

#[cfg(feature = "alloc")]
use alloc::{boxed::Box, vec::Vec};

#[cfg(feature = "alloc")]
owned! {
    [] Vec<T>, |item, length| {
        let mut items = Self::new();
        // Full memory is an error of the table, and nothing aborts.
        items.try_reserve_exact(length).ok()?;
        items.resize(length, item);
        Some(items)
    };
    [] Box<[T]>, |item, length| Vec::filled(item, length).map(Vec::into_boxed_slice);
}
