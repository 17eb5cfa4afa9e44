//! What every check of a clause is made of.

use crate::report::{differs, show};
use ombrage::{Float, Picture, Ray, Span, Vector};

/// Conforms, or says which clause is broken and how.
pub type Verdict = Result<(), String>;

/// Ends a check with the clause's name and the words, unless the condition holds.
macro_rules! holds {
    ($clause:literal, $condition:expr, $($words:tt)+) => {
        let holds: bool = $condition;
        if !holds {
            return Err(format!("clause {}: {}", $clause, format_args!($($words)+)));
        }
    };
}
pub(crate) use holds;

/// Ends a check with the clause's name and the words of a comparison that failed.
macro_rules! agrees {
    ($clause:literal, $comparison:expr) => {
        if let Err(words) = $comparison {
            return Err(format!("clause {}: {words}", $clause));
        }
    };
}
pub(crate) use agrees;

/// Three constants as a vector.
pub fn vector<F: Float>(components: [f64; 3]) -> F::Vector {
    F::Vector::constant((), components)
}

/// A ray from constants.
pub fn ray<F: Float>(origin: [f64; 3], direction: [f64; 3]) -> Ray<F> {
    Ray {
        origin: vector::<F>(origin),
        direction: vector::<F>(direction),
    }
}

/// An interval from constants.
pub fn span<F: Float>([min, max]: [f64; 2]) -> Span<F> {
    Span::new(F::from_f64(min), F::from_f64(max))
}

/// A parameter of a hit, for messages.
fn told<F: Float>(t: Option<F>) -> String {
    t.map_or("no hit".into(), show)
}

/// Fails unless two parameters of a hit are the same; says all about them otherwise.
pub fn same_t<F: Float>(
    name: &str,
    ray: &Ray<F>,
    expected: Option<F>,
    actual: Option<F>,
) -> Result<(), String> {
    if actual == expected {
        return Ok(());
    }
    let [ox, oy, oz] = ray.origin.to_array();
    let [dx, dy, dz] = ray.direction.to_array();
    let inputs = [
        ("o.x", ox),
        ("o.y", oy),
        ("o.z", oz),
        ("d.x", dx),
        ("d.y", dy),
        ("d.z", dz),
    ];
    Err(match (expected, actual) {
        (Some(expected), Some(actual)) => differs(name, &inputs, expected, actual),
        _ => format!("{name}: {} instead of {}", told(actual), told(expected)),
    })
}

/// Fails unless every component is the constant rounded to the format, give or take `ulps`.
pub fn near<F: Float>(
    name: &str,
    expected: [f64; 3],
    actual: F::Vector,
    ulps: u64,
) -> Result<(), String> {
    for (i, actual) in actual.to_array().into_iter().enumerate() {
        let expected = F::from_f64(expected[i]);
        if actual.ulp_distance(expected) > ulps {
            return Err(differs(
                &format!("{name}, component {i}"),
                &[],
                expected,
                actual,
            ));
        }
    }
    Ok(())
}

/// What a pixel of the lab's scene shows, from the geometry of spheres and planes in closed form;
/// it shares no code with the kernels.
pub struct Seen {
    /// 0 red (the plane), 2 blue (the sphere), `None`: the background.
    pub channel: Option<usize>,
    /// The cosine between the normal and the way back to the eye.
    pub view_cosine: f64,
    /// The radiance of the light where nothing blocks it.
    pub direct: f64,
    /// Whether the sphere blocks it.
    pub shadowed: bool,
}

/// What pixel (x, y) of 600 x 400 shows; `None` where an edge runs too near to tell.
pub fn seen(x: u32, y: u32) -> Option<Seen> {
    let (sx, sy) = (f64::from(x) / 599.0, f64::from(y) / 399.0);
    let height = 2.0 / f64::sqrt(3.0);
    let through = [(0.5 - sx) * 1.5 * height, (0.5 - sy) * height, 1.0];
    let length = dot(through, through).sqrt();
    let d = through.map(|c| c / length);
    // The sphere's centre is 5 before the eye; the line passes it at the distance sqrt(miss).
    let along = 5.0 * d[2];
    let miss = 25.0 - along * along;
    if (miss - 1.0).abs() < 1e-4 {
        return None;
    }
    let light = [1.0, 10.0, 1.0];
    let at = |t: f64| [t * d[0], t * d[1], t * d[2] - 2.0];
    let toward_light = |p: [f64; 3]| std::array::from_fn(|i| light[i] - p[i]);
    if miss < 1.0 {
        let p = at(along - (1.0 - miss).sqrt());
        let l: [f64; 3] = toward_light(p);
        let square = dot(l, l);
        let facing = dot(l, [p[0], p[1], p[2] - 3.0]) / square.sqrt();
        let direct = 100.0 * facing.max(0.0) / square;
        let view_cosine = (1.0 - miss).sqrt();
        return Some(Seen {
            channel: Some(2),
            view_cosine,
            direct,
            shadowed: false,
        });
    }
    let t = -2.0 / d[1];
    if (t - 1000.0).abs() < 1.0 {
        return None;
    }
    if !(0.0..1000.0).contains(&t) {
        return Some(Seen {
            channel: None,
            view_cosine: 0.0,
            direct: 0.0,
            shadowed: false,
        });
    }
    let p = at(t);
    let l: [f64; 3] = toward_light(p);
    let square = dot(l, l);
    let direct = 100.0 * 12.0 / square.sqrt() / square;
    let to_centre = [-p[0], -p[1], 3.0 - p[2]];
    let beside = dot(to_centre, to_centre) - dot(to_centre, l).powi(2) / square;
    if (beside - 1.0).abs() < 1e-3 {
        return None;
    }
    Some(Seen {
        channel: Some(0),
        view_cosine: -d[1],
        direct,
        shadowed: beside < 1.0,
    })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Whether a picture of 600 x 400 shows `value` of what is seen at every pixel away from edges, as
/// `byte` makes it; the first pixel that does not, in words.
pub fn shows(
    picture: &Picture,
    value: impl Fn(&Seen) -> f64,
    byte: impl Fn(f64) -> u8,
) -> Result<(), String> {
    let mut judged = 0;
    for y in 0..400 {
        for x in 0..600 {
            let Some(seen) = seen(x, y) else { continue };
            judged += 1;
            let expected = |slack: f64| match seen.channel {
                None => [127; 3],
                Some(channel) => {
                    let level = 255.0 * value(&seen);
                    std::array::from_fn(|i| if i == channel { byte(level + slack) } else { 0 })
                }
            };
            let pixel = picture.pixel(x, y).unwrap_or_default();
            // Rounding may carry a level over the next whole number.
            if ![0.0, 0.01, -0.01]
                .into_iter()
                .any(|slack| pixel == expected(slack))
            {
                let expected = expected(0.0);
                return Err(format!(
                    "pixel ({x}, {y}) is {pixel:?} instead of {expected:?}"
                ));
            }
        }
    }
    assert!(judged > 235_000, "only {judged} pixels were judged");
    Ok(())
}
