//! Which instruction set a loop is compiled for, and how many numbers it works on together.

/// Numbers that are worked on together: one AVX-512 register, two of AVX2.
pub(crate) const LANES: usize = 8;

/// Consecutive vector entries.
pub(crate) type Chunk = [f64; LANES];

/// An instruction set that this processor has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Isa(pub(super) Kind);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Isa {
    /// All instruction sets of this processor for which kernels are compiled,
    /// the widest last.
    pub(crate) fn available() -> impl Iterator<Item = Isa> {
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
    pub(crate) fn best() -> Isa {
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
        pub(crate) fn $name(isa: Isa, $($arg: $type),*) $(-> $ret)? {
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

pub(super) use for_each_isa;

/// a b + c, rounded once where the instruction set does that in one instruction.
#[inline(always)]
pub(super) fn multiply_add<const FMA: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FMA { a.mul_add(b, c) } else { a * b + c }
}
