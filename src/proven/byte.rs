//! Bytes that are certain.

use crate::film::Film;
use crate::real::{Bounded, Proof, Real, Rounded};

/// The byte of a component of radiance, as a whole number from 0 to 255, and where it is certain:
/// where every number within the bound has the same.
///
/// It is `floor(255 x)`, as [`Film::byte`] has it. Whether a whole number lies within the bound is
/// asked of the exact fraction `z - trunc z`: near a whole number `z - e` may round to z.
#[inline(always)]
pub fn byte<B: Real<Scalar: Rounded>, P: Proof>(film: Film, x: Bounded<B, P>) -> (B, B::Mask) {
    let [zero, one, most, turn] = [0.0, 1.0, 255.0, 256.0].map(|c| x.value.constant(c));
    let z = x * Bounded::exact(most);
    let reach = z.reach();
    let whole = z.value.trunc();
    let above = z.value - whole;
    let same = above.ge(reach) & (one - above).gt(reach);
    let dark = (z.value + reach).lt(one);
    let level = B::select(whole.gt(zero), whole, zero);
    match film {
        Film::Clamp => {
            let bright = (z.value - reach).ge(most);
            (B::select(level.lt(most), level, most), same | dark | bright)
        }
        Film::Wrap => {
            let turns = (level * turn.constant(1.0 / 256.0)).trunc();
            (level - turns * turn, same | dark)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Rigorous;

    /// Around every border of bytes: certain only where both ends of what the number may be have the
    /// byte, and wherever they have it with some room.
    #[test]
    fn a_byte_is_certain_where_both_ends_have_it() {
        for film in [Film::Clamp, Film::Wrap] {
            for border in 0..600 {
                for away in [-0.5, -1e-3, -1e-7, 1e-7, 1e-3, 0.5] {
                    for error in [0.0, 1e-9, 1e-5, 1e-2] {
                        let x = (f64::from(border) + away) / 255.0;
                        let (level, certain) = byte(film, Bounded::<f64, Rigorous>::new(x, error));
                        let ends = |reach: f64| [x - reach, x + reach].map(|x| film.byte(x));
                        let what = format!("{film:?} {border} + {away}, give or take {error}");
                        if certain {
                            assert_eq!(ends(error), [level; 2], "{what}");
                        }
                        let [least, most] = ends(2.0 * error + 1e-12);
                        assert!(certain || least != most, "{what}");
                    }
                }
            }
        }
    }
}
