//! The bound of roundings.

use super::gamma;

/// So many factors between 1 - u and 1 + u are no further from 1 than the bound, and the bound is not
/// much more.
#[test]
fn roundings_in_a_row_are_within_their_bound() {
    let u = 0.5_f64.powi(24);
    for n in 1..100 {
        let n = f64::from(n);
        let worst = (n * u.ln_1p()).exp_m1();
        let bound = gamma::<f32>(n);
        assert!(worst < bound && bound < worst * (1.0 + 2.0 * n * u), "{n}");
    }
}
