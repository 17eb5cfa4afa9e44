//! Exact numbers: rationals, and what square roots add to them.

use super::integer::Integer;
use std::cmp::Ordering;
use std::rc::Rc;

/// A number of a tower of fields: a rational, or `a + b √d` with a, b and d of fields further down
/// and d above zero.
///
/// A root may be one of the field below without being known as such; nothing here relies on the
/// opposite.
#[derive(Debug)]
pub(super) enum Surd {
    /// Numerator and denominator, the latter above zero.
    Rational(Integer, Integer),
    /// The height in the tower, a and b, and d.
    Root(usize, Rc<Surd>, Rc<Surd>, Rc<Surd>),
}

type Shared = Rc<Surd>;

/// A rational without common powers of two.
fn rational(numerator: &Integer, denominator: &Integer) -> Shared {
    let bits = match numerator.sign() {
        Ordering::Equal => denominator.trailing_zeros(),
        _ => numerator.trailing_zeros().min(denominator.trailing_zeros()),
    };
    let [n, d] = [numerator, denominator].map(|x| x.shifted_down(bits));
    let (n, d) = match d.sign() {
        Ordering::Less => (-&n, -&d),
        _ => (n, d),
    };
    Rc::new(Surd::Rational(n, d))
}

/// The exact value of a finite float.
pub(super) fn float(value: f64) -> Shared {
    let (bits, one) = (value.abs().to_bits(), Integer::from(1));
    let exponent = (bits >> 52).max(1) as i64 - 1075;
    let hidden = u64::from(bits >> 52 > 0) << 52;
    let mantissa = Integer::from((bits & ((1 << 52) - 1)) | hidden);
    let mantissa = if value < 0.0 { -&mantissa } else { mantissa };
    let shift = exponent.unsigned_abs();
    if exponent < 0 {
        rational(&mantissa, &one.shifted_up(shift))
    } else {
        rational(&mantissa.shifted_up(shift), &one)
    }
}

/// How large the numbers get that are computed with: bits, all parts together.
pub(super) fn bits(x: &Surd) -> u64 {
    match x {
        Surd::Rational(n, d) => n.bits() + d.bits(),
        Surd::Root(_, a, b, _) => bits(a) + bits(b),
    }
}

fn height(x: &Surd) -> usize {
    match x {
        Surd::Rational(..) => 0,
        Surd::Root(height, ..) => *height,
    }
}

pub(super) fn add(x: &Shared, y: &Shared) -> Shared {
    match (&**x, &**y) {
        (Surd::Rational(n, d), Surd::Rational(m, e)) if d == e => rational(&(n + m), d),
        (Surd::Rational(n, d), Surd::Rational(m, e)) => rational(&(&(n * e) + &(m * d)), &(d * e)),
        (Surd::Root(h, a, b, d), Surd::Root(k, p, q, _)) if h == k => {
            Rc::new(Surd::Root(*h, add(a, p), add(b, q), d.clone()))
        }
        (Surd::Root(h, a, b, d), _) if *h > height(y) => {
            Rc::new(Surd::Root(*h, add(a, y), b.clone(), d.clone()))
        }
        _ => add(y, x),
    }
}

pub(super) fn negative(x: &Shared) -> Shared {
    multiply(x, &float(-1.0))
}

pub(super) fn multiply(x: &Shared, y: &Shared) -> Shared {
    match (&**x, &**y) {
        (Surd::Rational(n, d), Surd::Rational(m, e)) => rational(&(n * m), &(d * e)),
        (Surd::Root(h, a, b, d), Surd::Root(k, p, q, _)) if h == k => {
            let whole = add(&multiply(a, p), &multiply(&multiply(b, q), d));
            let part = add(&multiply(a, q), &multiply(b, p));
            Rc::new(Surd::Root(*h, whole, part, d.clone()))
        }
        (Surd::Root(h, a, b, d), _) if *h > height(y) => {
            Rc::new(Surd::Root(*h, multiply(a, y), multiply(b, y), d.clone()))
        }
        _ => multiply(y, x),
    }
}

/// `a² - b² d`.
fn norm(a: &Shared, b: &Shared, d: &Shared) -> Shared {
    add(&multiply(a, a), &negative(&multiply(&multiply(b, b), d)))
}

/// The reciprocal; `None` of zero.
pub(super) fn reciprocal(x: &Shared) -> Option<Shared> {
    if sign(x) == Ordering::Equal {
        return None;
    }
    Some(match &**x {
        Surd::Rational(n, d) => rational(d, n),
        Surd::Root(h, a, b, d) => {
            let norm = norm(a, b, d);
            match reciprocal(&norm) {
                Some(inverse) => {
                    let part = negative(&multiply(b, &inverse));
                    Rc::new(Surd::Root(*h, multiply(a, &inverse), part, d.clone()))
                }
                // Then a = b √d, and the number is 2 a.
                None => reciprocal(&add(a, a))?,
            }
        }
    })
}

/// The sign of a number: that of `a + b √d` where the two parts are of different signs is decided
/// by their squares.
pub(super) fn sign(x: &Surd) -> Ordering {
    match x {
        Surd::Rational(n, _) => n.sign(),
        Surd::Root(_, a, b, d) => match (sign(a), sign(b)) {
            (Ordering::Equal, of_b) => of_b,
            (of_a, of_b) if of_a == of_b || of_b == Ordering::Equal => of_a,
            (Ordering::Greater, _) => sign(&norm(a, b, d)),
            (Ordering::Less, _) => sign(&norm(a, b, d)).reverse(),
        },
    }
}

/// The square root, as a new floor of a tower that has `floors` so far; `None` below zero.
pub(super) fn root(x: &Shared, floors: &mut usize) -> Option<Shared> {
    match sign(x) {
        Ordering::Less => return None,
        Ordering::Equal => return Some(float(0.0)),
        Ordering::Greater => {}
    }
    if let Surd::Rational(n, d) = &**x
        && let (Some(n), Some(d)) = (n.exact_root(), d.exact_root())
    {
        return Some(rational(&n, &d));
    }
    *floors += 1;
    let (zero, one) = (float(0.0), float(1.0));
    Some(Rc::new(Surd::Root(*floors, zero, one, x.clone())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root_of(x: f64, floors: &mut usize) -> Shared {
        root(&float(x), floors).expect("not negative")
    }

    #[test]
    fn floats_are_exact() {
        for x in [0.1, -1e300, 5e-324, 3.0, 1.0 / 3.0] {
            let tenfold = multiply(&float(x), &float(10.0));
            let sum = (0..10).fold(float(0.0), |sum, _| add(&sum, &float(x)));
            assert_eq!(sign(&add(&tenfold, &negative(&sum))), Ordering::Equal);
            assert_eq!(sign(&float(x)), x.total_cmp(&0.0));
        }
    }

    /// √2 + √3 = √(5 + 2√6), also where √6 is taken as a root of its own.
    #[test]
    fn sums_of_roots() {
        let mut floors = 0;
        let [two, three, six] = [2.0, 3.0, 6.0].map(|x| root_of(x, &mut floors));
        let nested = add(&float(5.0), &add(&six, &six));
        let nested = root(&nested, &mut floors).expect("positive");
        let sum = add(&two, &three);
        let zero = add(&sum, &negative(&nested));
        assert_eq!(sign(&zero), Ordering::Equal);
        assert!(reciprocal(&zero).is_none());
        let tiny = add(&zero, &float(1e-300));
        assert_eq!(sign(&tiny), Ordering::Greater);
        let back = multiply(&tiny, &reciprocal(&tiny).expect("not zero"));
        assert_eq!(sign(&add(&back, &float(-1.0))), Ordering::Equal);
        assert_eq!(floors, 4);
    }

    /// Whether all parts of a number are further down in the tower.
    fn is_in_order(x: &Shared) -> bool {
        match &**x {
            Surd::Rational(..) => true,
            Surd::Root(_, a, b, d) => [a, b, d]
                .into_iter()
                .all(|part| height(part) < height(x) && is_in_order(part)),
        }
    }

    #[test]
    fn parts_are_further_down() {
        let mut floors = 0;
        let [two, three] = [2.0, 3.0].map(|x| root_of(x, &mut floors));
        assert_eq!([height(&two), height(&three)], [1, 2]);
        for (x, y) in [(&two, &three), (&three, &two)] {
            let (sum, product) = (add(x, y), multiply(x, y));
            assert!([&sum, &product].into_iter().all(is_in_order));
            assert_eq!([height(&sum), height(&product)], [2, 2]);
        }
    }

    #[test]
    fn roots_of_rational_squares_are_rational() {
        let mut floors = 0;
        let x = multiply(&float(81.0), &reciprocal(&float(1024.0)).expect("not zero"));
        let root = root(&x, &mut floors).expect("positive");
        assert_eq!(sign(&add(&root, &float(-9.0 / 32.0))), Ordering::Equal);
        assert_eq!(floors, 0);
    }
}
