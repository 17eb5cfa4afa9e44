//! Where rays meet planes.

use crate::exact::{abs, dot, exact, exact_vector, minus, power_of_two, products, sum};
use crate::property::{Sample, Verdict, for_all, is_unit, ray, vector};
use crate::report::show;
use dashu_ratio::RBig;
use ombrage::{Plane, Quality, Ray, Shape, Span, Vector};
use proptest::prelude::*;

/// The parameter of the kit, over all of the line.
fn hit<F: Sample>(plane: &Plane<F>, ray: &Ray<F>) -> Option<F> {
    let hit = plane.intersect(ray, &Span::new(-F::MAX, F::MAX), Quality::Textbook);
    hit.mask.then_some(hit.t)
}

/// The exact numerator and denominator of t, and a bound of the relative error of the computed t.
///
/// A difference, a product and two sums make 4 roundings of each term of the numerator, 3 of the
/// denominator's, and the division 1 more: to first order `(4 κ_num + 3 κ_den + 1) u`, where κ is
/// the sum of the terms' magnitudes over the magnitude of their sum. In full, with
/// `γ_k = k u / (1 - k u)` (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed.,
/// section 3.1), it is `(e_num + e_den + u + e_num u) / (1 - e_den)`. `None` where the ray is
/// nearly parallel: `e_den > 1/2`.
fn t_and_bound<F: Sample>(plane: &Plane<F>, ray: &Ray<F>) -> Option<(RBig, RBig, RBig)> {
    let u = power_of_two(-(F::PRECISION as i32));
    let normal = exact_vector::<F>(plane.normal());
    let direction = exact_vector::<F>(ray.direction);
    let to_point = minus(
        &exact_vector::<F>(plane.point()),
        &exact_vector::<F>(ray.origin),
    );
    let (above, below) = (products(&to_point, &normal), products(&direction, &normal));
    let (numerator, denominator) = (sum(above.clone()), sum(below.clone()));
    if numerator == RBig::ZERO || denominator == RBig::ZERO {
        return None;
    }
    let gamma = |k: f64| exact(k) * &u / (RBig::ONE - exact(k) * &u);
    let kappa = |terms: [RBig; 3], total: &RBig| sum(terms.map(abs)) / abs(total.clone());
    let e_num = gamma(4.0) * kappa(above, &numerator);
    let e_den = gamma(3.0) * kappa(below, &denominator);
    if e_den > exact(0.5) {
        return None;
    }
    let bound = (&e_num + &e_den + &u + &e_num * &u) / (RBig::ONE - e_den);
    Some((numerator, denominator, bound))
}

fn planes<F: Sample>() -> impl Strategy<Value = Plane<F>> {
    let normal = vector::<F>(-3..3);
    (vector::<F>(-6..6), normal).prop_filter_map("a normal", |(q, n)| Plane::new(q, n).ok())
}

pub fn t_is_within_its_bound<F: Sample>() {
    for_all((planes::<F>(), ray::<F>(-6..6)), |(plane, ray)| {
        let Some((numerator, denominator, bound)) = t_and_bound(&plane, &ray) else {
            return Ok(());
        };
        let t = hit(&plane, &ray).ok_or_else(|| TestCaseError::fail("no hit"))?;
        let error = abs(exact(t) * &denominator - &numerator);
        let truth = (&numerator / &denominator).to_f64().value();
        let words = format!("t is {}, exactly {truth:e}", show(t));
        prop_assert!(error <= bound * abs(numerator), "{words}");
        Ok(())
    });
}

/// The height of the hit point over the plane: what the error of t makes of it, and two roundings
/// of every coordinate.
pub fn hit_point_lies_on_plane<F: Sample>() {
    for_all((planes::<F>(), ray::<F>(-6..6)), |(plane, ray)| {
        let Some((numerator, _, bound)) = t_and_bound(&plane, &ray) else {
            return Ok(());
        };
        let t = hit(&plane, &ray).ok_or_else(|| TestCaseError::fail("no hit"))?;
        let point = exact_vector::<F>(ray.point_at(t));
        let normal = exact_vector::<F>(plane.normal());
        let height = dot(&normal, &minus(&point, &exact_vector::<F>(plane.point())));
        let direction = exact_vector::<F>(ray.direction);
        let u = power_of_two(-(F::PRECISION as i32));
        let rounded = |i: usize| {
            let (step, end) = (abs(&direction[i] * exact(t)), abs(point[i].clone()));
            abs(normal[i].clone()) * &u * (step + end)
        };
        let allowed = bound * abs(numerator) + rounded(0) + rounded(1) + rounded(2);
        let words = format!("height {:e}", height.to_f64().value());
        prop_assert!(abs(height) <= allowed, "{words}");
        Ok(())
    });
}

/// Another point of the plane moves t by no more than the two bounds.
pub fn t_is_the_same_for_every_point_of_the_plane<F: Sample>() {
    let whole = |most: i32| [-most..=most, -most..=most, -most..=most];
    let inputs = (whole(64), whole(8), [-8..=8, -8..=8], ray::<F>(-6..6));
    for_all(inputs, |(q, n, [k, m], ray)| {
        // k (b, -a, 0) + m (0, c, -b) lies in the plane with the normal (a, b, c).
        let moved = [q[0] + k * n[1], q[1] - k * n[0] + m * n[2], q[2] - m * n[1]];
        let vector = |v: [i32; 3]| F::Vector::constant((), v.map(f64::from));
        let (Ok(here), Ok(there)) = (
            Plane::new(vector(q), vector(n)),
            Plane::new(vector(moved), vector(n)),
        ) else {
            prop_assert_eq!(n, [0; 3]);
            return Ok(());
        };
        let bounds = t_and_bound(&here, &ray).zip(t_and_bound(&there, &ray));
        let Some(((numerator, denominator, bound), (same, _, other))) = bounds else {
            return Ok(());
        };
        prop_assert_eq!(&numerator, &same);
        let both = hit(&here, &ray).zip(hit(&there, &ray));
        let (t, moved_t) = both.ok_or_else(|| TestCaseError::fail("no hit"))?;
        let apart = abs((exact(t) - exact(moved_t)) * denominator);
        let words = format!("t is {}, then {}", show(t), show(moved_t));
        prop_assert!(apart <= (bound + other) * abs(numerator), "{words}");
        Ok(())
    });
}

pub fn a_parallel_ray_misses<F: Sample>() {
    for_all(
        (vector::<F>(-6..6), vector::<F>(-6..6), 0..3usize),
        |(q, o, axis)| {
            let on = |i: usize| {
                F::Vector::constant((), std::array::from_fn(|j| f64::from(u8::from(i == j))))
            };
            let plane =
                Plane::new(q, on(axis)).map_err(|error| TestCaseError::fail(error.to_string()))?;
            let ray = Ray {
                origin: o,
                direction: on((axis + 1) % 3),
            };
            let all = Span::new(F::default(), F::from_f64(f64::INFINITY));
            prop_assert!(!plane.intersect(&ray, &all, Quality::Textbook).mask);
            prop_assert!(!plane.intersect_any(&ray, &all, Quality::Textbook));
            Ok(())
        },
    );
}

/// Whatever the normal's length, also where its square over- or underflows, the plane has a unit
/// normal or is refused. Short of underflow digits are lost, at most 6 of them.
pub fn the_normal_has_unit_length_or_is_refused<F: Sample>() {
    let exponents = if F::PRECISION == 24 {
        -148..128
    } else {
        -1070..1023
    };
    for_all(vector::<F>(exponents), |normal| {
        let zero = F::Vector::constant((), [0.0; 3]);
        if let Ok(plane) = Plane::new(zero, normal) {
            let unit = plane.normal_at::<F>(zero);
            let unit = exact_vector::<F>(unit);
            let off = abs(dot(&unit, &unit) - RBig::ONE).to_f64().value();
            prop_assert!(
                off <= 66.0 * F::EPSILON,
                "the square of the length is off by {off:e}"
            );
        }
        Ok(())
    });
}

/// Moderate lengths are never refused, and no digit is lost.
pub fn a_normal_of_any_moderate_length_is_taken<F: Sample>() {
    for_all(vector::<F>(-50..50), |normal| -> Verdict {
        let zero = F::Vector::constant((), [0.0; 3]);
        match Plane::<F>::new(zero, normal) {
            Ok(plane) => is_unit::<F>(plane.normal_at::<F>(zero)),
            Err(error) => {
                prop_assert_eq!(normal, zero, "{}", error);
                Ok(())
            }
        }
    });
}
