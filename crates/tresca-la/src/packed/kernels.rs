//! The three loops over a panel of tiles, compiled once per instruction set.
//!
//! A panel is a column of 8×8 tiles, each stored by columns. The loops do
//! nothing but stream the panel once: eight columns are worked on together, so
//! that the vector along the rows is read and written once per eight columns.

/// Edge of a tile.
pub(super) const EDGE: usize = 8;

/// Eight consecutive vector entries.
pub(super) type Chunk = [f64; EDGE];

/// An 8×8 block stored by columns, on its own cache lines.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(super) struct Tile(pub(super) [Chunk; EDGE]);

impl Tile {
    pub(super) const ZERO: Tile = Tile([[0.0; EDGE]; EDGE]);
}

/// An instruction set that this processor has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Isa(Kind);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Isa {
    /// All instruction sets of this processor for which kernels are compiled,
    /// the widest last.
    pub(super) fn available() -> impl Iterator<Item = Isa> {
        let mut kinds = [Some(Kind::Portable), None, None];
        #[cfg(target_arch = "x86_64")]
        {
            let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            kinds[1] = avx2.then_some(Kind::Avx2);
            kinds[2] = (avx2 && is_x86_feature_detected!("avx512f")).then_some(Kind::Avx512);
        }
        kinds.into_iter().flatten().map(Isa)
    }

    /// The widest instruction set of this processor.
    pub(super) fn best() -> Isa {
        Self::available().last().unwrap_or(Isa(Kind::Portable))
    }
}

/// Defines `$name`, which runs the loop `$body` as compiled for `isa`, or, on
/// AVX-512, as compiled for the features `$wide`.
macro_rules! for_each_isa {
    (
        $(#[$doc:meta])*
        $name:ident = $body:ident($($arg:ident: $type:ty),*) $(-> $ret:ty)?,
        $wide:literal
    ) => {
        $(#[$doc])*
        #[inline]
        pub(super) fn $name(isa: Isa, $($arg: $type),*) $(-> $ret)? {
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma")]
            fn avx2($($arg: $type),*) $(-> $ret)? {
                $body::<true>($($arg),*)
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = $wide)]
            fn avx512($($arg: $type),*) $(-> $ret)? {
                $body::<true>($($arg),*)
            }
            match isa.0 {
                Kind::Portable => $body::<false>($($arg),*),
                // SAFETY: an `Isa` comes from `available` alone, which has found
                // the features that the function is compiled for.
                #[cfg(target_arch = "x86_64")]
                Kind::Avx2 => unsafe { avx2($($arg),*) },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                Kind::Avx512 => unsafe { avx512($($arg),*) },
            }
        }
    };
}

for_each_isa! {
    /// y ← y − P x for the panel P of tiles, one chunk of y per tile.
    // Not AVX-512: for it the compiler turns this loop around and gathers one
    // entry from each of eight tiles, which is ten times slower.
    subtract_product = subtract_product_loop(tiles: &[Tile], x: &Chunk, y: &mut [Chunk]),
    "avx2,fma"
}

for_each_isa! {
    /// Pᵀ y for the panel P of tiles, one chunk of y per tile.
    // Not AVX-512: from memory it reaches two thirds of the rate of AVX2.
    transposed_product = transposed_product_loop(tiles: &[Tile], y: &[Chunk]) -> Chunk,
    "avx2,fma"
}

for_each_isa! {
    /// y ← y + P x, and returns Pᵀ z: both products with one reading of the panel.
    both_products = both_products_loop(tiles: &[Tile], x: &Chunk, z: &[Chunk], y: &mut [Chunk]) -> Chunk,
    "avx512f,avx2,fma"
}

/// a b + c, rounded once where the instruction set does that in one instruction.
#[inline(always)]
fn multiply_add<const FMA: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FMA { a.mul_add(b, c) } else { a * b + c }
}

#[inline(always)]
fn subtract_product_loop<const FMA: bool>(tiles: &[Tile], x: &Chunk, y: &mut [Chunk]) {
    let minus_x = x.map(|x| -x);
    for (tile, y) in tiles.iter().zip(y) {
        let mut sum = *y;
        for (column, &x) in tile.0.iter().zip(&minus_x) {
            for (s, &a) in sum.iter_mut().zip(column) {
                *s = multiply_add::<FMA>(a, x, *s);
            }
        }
        *y = sum;
    }
}

#[inline(always)]
fn transposed_product_loop<const FMA: bool>(tiles: &[Tile], y: &[Chunk]) -> Chunk {
    let mut sums = [[0.0; EDGE]; EDGE];
    for (tile, y) in tiles.iter().zip(y) {
        for (sum, column) in sums.iter_mut().zip(&tile.0) {
            for ((s, &a), &y) in sum.iter_mut().zip(column).zip(y) {
                *s = multiply_add::<FMA>(a, y, *s);
            }
        }
    }
    sums.map(|sum| sum.iter().sum())
}

#[inline(always)]
fn both_products_loop<const FMA: bool>(
    tiles: &[Tile],
    x: &Chunk,
    z: &[Chunk],
    y: &mut [Chunk],
) -> Chunk {
    let mut sums = [[0.0; EDGE]; EDGE];
    for ((tile, z), y) in tiles.iter().zip(z).zip(y) {
        let mut product = *y;
        for ((column, &x), sum) in tile.0.iter().zip(x).zip(&mut sums) {
            for (((p, s), &a), &z) in product.iter_mut().zip(sum).zip(column).zip(z) {
                *p = multiply_add::<FMA>(a, x, *p);
                *s = multiply_add::<FMA>(a, z, *s);
            }
        }
        *y = product;
    }
    sums.map(|sum| sum.iter().sum())
}
