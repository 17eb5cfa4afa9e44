//! Proofs that prove too much: the properties of bounded numbers find them out.

use super::bounded::{
    choices, comparisons, fused_vectors, pairs, products, quotients, roots, sums,
};
use crate::exact::Exact;
use crate::property::fails;
use ombrage::{DoubleDouble, Proof, Rounded};

/// A proof that is not one.
macro_rules! sabotaged {
    ($($name:ident: $($constant:ident: $type:ty = $value:expr),+;)*) => { $(
        #[derive(Clone, Copy, Debug)]
        pub struct $name;
        impl Proof for $name {
            $(const $constant: $type = $value;)+
        }
    )* };
}

sabotaged! {
    SmallSums: SUM: f64 = 1.0 / 16.0;
    SmallProducts: PRODUCT: f64 = 1.0 / 16.0;
    SmallQuotients: QUOTIENT: f64 = 1.0 / 16.0;
    SmallRoots: ROOT: f64 = 1.0 / 16.0;
    SmallBounds: SUM: f64 = 1.0 / 16.0, PRODUCT: f64 = 1.0 / 16.0, QUOTIENT: f64 = 1.0 / 16.0,
        ROOT: f64 = 1.0 / 16.0;
    EarlyComparisons: COMPARES_VALUES: bool = true;
    EarlyChoices: CHOOSES_POSSIBLE: bool = true;
}

pub fn bounds_too_small_are_noticed() {
    fn check<S: Rounded + Exact>() {
        let pairs = || pairs::<S>(-12..12);
        assert!(fails(pairs(), sums::<S, SmallSums>), "sums in {}", S::NAME);
        assert!(
            fails(pairs(), products::<S, SmallProducts>),
            "products in {}",
            S::NAME
        );
        assert!(
            fails(pairs(), fused_vectors::<S, SmallProducts>),
            "products of vectors in {}",
            S::NAME
        );
        assert!(
            fails(pairs(), quotients::<S, SmallQuotients>),
            "quotients in {}",
            S::NAME
        );
        assert!(
            fails(pairs(), roots::<S, SmallRoots>),
            "roots in {}",
            S::NAME
        );
    }
    check::<f32>();
    check::<f64>();
    check::<DoubleDouble>();
}

pub fn certainty_too_early_is_noticed() {
    let pairs = || pairs::<f64>(-12..12);
    assert!(fails(pairs(), comparisons::<f64, EarlyComparisons>));
    assert!(fails(pairs(), choices::<f64, EarlyChoices>));
}
