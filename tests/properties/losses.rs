//! What an explanation says of lost digits: every loss is a condition number, the most that small
//! relative errors in what a number is made of can grow, or the geometry that it stands for.

use crate::property::{Verdict, for_all, number, positive, vector};
use glam::DVec3;
use ombrage::conformance::{Drawing, Explanation, Loss, Step, Trace, explain};
use ombrage::{
    DirectLighting, DoubleDouble, Film, Integrator, Invalid, Plane, PointLight, Quality, Scene,
    Shadow, ShadowQuery, Size, Sphere, Triple, Vector, View,
};
use proptest::prelude::*;
use std::cell::Cell;

const SIZE: (u32, u32) = (60, 40);

/// A sphere, a plane and a light; object 0 is the sphere.
#[derive(Clone, Copy, Debug)]
struct Setting {
    sphere: Sphere<f64>,
    plane: Plane<f64>,
    light: DVec3,
    power: f64,
    view: View<f64>,
    pixel: [u32; 2],
    quality: Quality,
}

impl Setting {
    fn explained(&self) -> Result<Explanation, TestCaseError> {
        let direct = DirectLighting {
            quality: self.quality,
            shadow: Some(Shadow::UlpOffset),
            query: ShadowQuery::Any,
        };
        let drawing = Drawing {
            size: Size::new(SIZE.0, SIZE.1).expect("a size"),
            pixel: self.pixel,
            integrator: Integrator::DirectLighting(direct),
            film: Film::Wrap,
        };
        let explained = || -> Result<_, Invalid> {
            let light = PointLight::new(self.light, DVec3::ONE, self.power)?;
            let scene = Scene::new(DVec3::ZERO, f64::INFINITY)?
                .with_sphere(self.sphere, DVec3::ONE)?
                .with_plane(self.plane, DVec3::ONE)?
                .with_light(light);
            explain(&scene, &self.view, &drawing)
        };
        explained().map_err(|error| TestCaseError::reject(error.to_string()))
    }
}

fn settings() -> impl Strategy<Value = Setting> {
    let sphere = (vector::<f64>(-2..2), positive::<f64>(-2..2));
    let sphere = sphere.prop_filter_map("a sphere", |(c, r)| Sphere::new(c, r).ok());
    let plane = (vector::<f64>(-2..2), vector::<f64>(-3..3));
    let plane = plane.prop_filter_map("a plane", |(q, n)| Plane::new(q, n).ok());
    let view = (
        vector::<f64>(-1..3),
        vector::<f64>(-3..1),
        vector::<f64>(-2..2),
    );
    let view = (view, 20.0..120.0f64).prop_map(|((position, look_at, up), fov)| View {
        position,
        look_at,
        up,
        fov,
    });
    let light = (vector::<f64>(-2..3), positive::<f64>(0..14));
    let pixel = [0..SIZE.0, 0..SIZE.1];
    let quality = proptest::sample::select(Quality::ALL.to_vec());
    (sphere, plane, view, light, pixel, quality).prop_map(
        |(sphere, plane, view, (light, power), pixel, quality)| Setting {
            sphere,
            plane,
            light,
            power,
            view,
            pixel,
            quality,
        },
    )
}

/// Explains many pixels; each check says how often it had something to say.
fn for_all_pixels(check: impl Fn(&Setting, &Explanation, &Cell<u32>) -> Verdict) {
    let said = Cell::new(0);
    for_all(proptest::collection::vec(settings(), 8), |settings| {
        settings
            .iter()
            .try_for_each(|setting| check(setting, &setting.explained()?, &said))
    });
    assert!(said.get() >= 50, "only {} losses", said.get());
}

/// How much a sum grows relative errors of its terms.
fn condition(terms: &[f64]) -> f64 {
    let magnitudes: f64 = terms.iter().map(|term| term.abs()).sum();
    magnitudes / terms.iter().sum::<f64>().abs()
}

/// The loss that is told is the larger of those expected, or none where that is under three bits.
/// This test computes in `f64`, which cannot tell how large a factor beyond 10^8 is.
fn agree(name: &str, told: Option<Loss>, expected: &[Loss], said: &Cell<u32>) -> Verdict {
    let bits = |loss: &Loss| loss.bits();
    let worst = expected
        .iter()
        .copied()
        .max_by(|a, b| bits(a).total_cmp(&bits(b)));
    let most = worst.map_or(0.0, Loss::bits);
    if (most - 3.0).abs() < 1e-6 {
        return Ok(());
    }
    let Some(told) = told else {
        prop_assert!(most < 3.0, "{name}: nothing is told of {worst:?}");
        return Ok(());
    };
    said.set(said.get() + 1);
    let alike = |a: Loss, b: Loss| match (a, b) {
        (Loss::Cancellation(a), Loss::Cancellation(b))
        | (Loss::Grazing(a), Loss::Grazing(b))
        | (Loss::Tangency(a), Loss::Tangency(b)) => {
            (a / b - 1.0).abs() < 1e-6 || (a > 1e8 && b > 1e8)
        }
        _ => false,
    };
    let found = expected
        .iter()
        .any(|loss| alike(*loss, told) && bits(loss) >= most - 1e-6);
    prop_assert!(found, "{name}: {told:?} is told, {expected:?} expected");
    Ok(())
}

fn near(v: Triple<DoubleDouble>) -> DVec3 {
    DVec3::new(v.0.high(), v.1.high(), v.2.high())
}

/// The losses of three steps, `p.x`, `p.y` and `p.z` for p.
fn of_three<'a>(steps: &'a [Step], name: &str) -> Option<[&'a Step; 3]> {
    let of = |axis| {
        steps
            .iter()
            .find(|step| step.name == format!("{name}.{axis}"))
    };
    Some([of("x")?, of("y")?, of("z")?])
}

/// Points, normals and the ways to a light are sums of two terms; the direction of a ray, of five:
/// the way forward, half of the viewport to the left and to the top, and back from there.
pub fn losses_of_sums_are_condition_numbers() {
    for_all_pixels(|setting, told, said| {
        let steps = told.steps(0);
        let truth = &told.truth;
        let view = setting.view;
        let forward = (view.look_at - view.position).normalize();
        let right = forward.cross(view.up).normalize();
        let half_height = (view.fov.to_radians() / 2.0).tan();
        let half_width = half_height * f64::from(SIZE.0) / f64::from(SIZE.1);
        let up = right.cross(forward) * half_height;
        let right = right * half_width;
        let [sx, sy] = truth.place.map(DoubleDouble::high);
        let mut sums = vec![(
            "d",
            vec![forward, -right, up, right * (2.0 * sx), up * (-2.0 * sy)],
        )];
        if let Some(first) = &truth.first {
            let (origin, direction) = (near(truth.ray.origin), near(truth.ray.direction));
            let point = near(first.point);
            sums.push(("p", vec![origin, direction * first.t.high()]));
            sums.push(("l", vec![setting.light, -point]));
            match first.object {
                0 => sums.push(("n", vec![point, -setting.sphere.center()])),
                _ => sums.push(("n", vec![])),
            }
        }
        for (name, terms) in sums {
            let Some(three) = of_three(&steps, name) else {
                prop_assert!(name == "l", "no {name}");
                continue;
            };
            for (axis, step) in three.into_iter().enumerate() {
                let terms: Vec<f64> = terms.iter().map(|term| term[axis]).collect();
                let expected = match terms.iter().all(|term| *term == 0.0) {
                    true => vec![],
                    false => vec![Loss::Cancellation(condition(&terms))],
                };
                // What is nothing but rounding in this test's own axes.
                let cannot_tell = terms.iter().all(|term| term.abs() < 1e-12);
                if !cannot_tell {
                    agree(&step.name, step.loss, &expected, said)?;
                }
            }
        }
        Ok(())
    });
}

/// A plane's t changes with each coordinate of its point and of the eye, and all the more the less
/// the ray descends.
pub fn losses_of_planes_are_condition_numbers_or_angles() {
    for_all_pixels(|setting, told, said| {
        let (o, d) = (near(told.truth.ray.origin), near(told.truth.ray.direction));
        let (q, n) = (setting.plane.point(), setting.plane.normal().normalize());
        let height = |q: DVec3, o: DVec3| (q - o).dot(n);
        let grown = 2.0;
        let changes = (0..3).flat_map(|axis| {
            let (mut moved, mut eye) = (q, o);
            moved[axis] *= grown;
            eye[axis] *= grown;
            [height(moved, o), height(q, eye)].map(|moved| (moved - height(q, o)).abs())
        });
        let changed = changes.sum::<f64>();
        let condition = changed / height(q, o).abs();
        let sine = (1.0 - d.cross(n).length_squared()).sqrt();
        // Of an angle near 0, the cross product knows less.
        let grazing = match sine > 1e-3 {
            true => 1.0 / sine,
            false => 1.0 / d.dot(n).abs(),
        };
        let mut expected = vec![Loss::Grazing(grazing)];
        if changed > 0.0 {
            expected.push(Loss::Cancellation(condition));
        }
        let steps = told.steps(0);
        let t = steps
            .iter()
            .find(|step| step.name == "t plane 1")
            .expect("t");
        agree(&t.name, t.loss, &expected, said)
    });
}

/// A sphere's t is lost near the rim, for every quality; elsewhere for the textbook's formula, as
/// far as b² and ac cancel.
pub fn losses_of_spheres_are_those_of_the_rim_or_of_the_formula() {
    for_all_pixels(|setting, told, said| {
        let (o, d) = (near(told.truth.ray.origin), near(told.truth.ray.direction));
        let (center, r) = (setting.sphere.center(), setting.sphere.radius());
        let nearest = o + d * (center - o).dot(d);
        let tangency = r * r / (r * r - nearest.distance_squared(center)).abs();
        let b = (o - center).dot(d);
        let c = (o - center).length_squared() - r * r;
        let formula = b * b / (b * b - c).abs();
        if (tangency - 32.0).abs() < 1e-6 {
            return Ok(());
        }
        let expected = match setting.quality {
            _ if tangency > 32.0 => Some(Loss::Tangency(tangency)),
            Quality::Textbook => Some(Loss::Cancellation(formula)),
            Quality::Stable | Quality::Wide => None,
        };
        let steps = told.steps(0);
        let t = steps
            .iter()
            .find(|step| step.name == "t sphere 0")
            .expect("t");
        agree(&t.name, t.loss, expected.as_slice(), said)
    });
}

/// The cosine is lost where the light grazes.
pub fn losses_of_cosines_are_those_of_angles() {
    for_all_pixels(|setting, told, said| {
        let steps = told.steps(0);
        let Some(step) = steps.iter().find(|step| step.name == "cos") else {
            return Ok(());
        };
        let Some(first) = &told.truth.first else {
            return Err(TestCaseError::fail("a cosine of nothing"));
        };
        let (normal, to_light) = (near(first.normal), setting.light - near(first.point));
        let angle = normal.angle_between(to_light);
        let grazing = Loss::Grazing(1.0 / (std::f64::consts::FRAC_PI_2 - angle).sin().abs());
        agree("cos", step.loss, &[grazing], said)
    });
}

/// What wraps is what the byte lacks: whole turns of 256.
pub fn turns_and_bytes_make_up_the_radiance() {
    for_all_pixels(|_, told, said| {
        let radiance = near(told.truth.radiance);
        for (axis, wraps) in told.wraps().into_iter().enumerate() {
            let turns = match wraps {
                Some(Loss::Wrap(turns)) => {
                    said.set(said.get() + 1);
                    prop_assert!(turns > 0);
                    turns
                }
                None => 0,
                Some(other) => return Err(TestCaseError::fail(format!("{other:?} of a byte"))),
            };
            let level = turns * 256 + u64::from(told.truth.bytes[axis]);
            prop_assert_eq!(level, (radiance[axis] * 255.0) as u64);
        }
        Ok(())
    });
}

/// Each number on the way is told three times, as each of the three traces has it.
pub fn steps_are_those_of_the_traces() {
    for_all_pixels(|_, told, said| {
        let steps = told.steps(0);
        let tells = |name: String,
                     single: Option<f32>,
                     double: Option<f64>,
                     truth: Option<DoubleDouble>| {
            let Some(step) = steps.iter().find(|step| step.name == name) else {
                let is_there = truth.is_some();
                prop_assert!(!is_there, "no {name} among the steps");
                return Ok(());
            };
            said.set(said.get() + 1);
            let single_bits = [step.single, single].map(|x| x.map(f32::to_bits));
            let double_bits = [step.double, double].map(|x| x.map(f64::to_bits));
            let truths = [step.truth, truth].map(|x| x.map(|x| format!("{x:?}")));
            prop_assert_eq!(&single_bits[0], &single_bits[1], "{} in f32", &name);
            prop_assert_eq!(&double_bits[0], &double_bits[1], "{} in f64", &name);
            prop_assert_eq!(&truths[0], &truths[1], "{} in truth", &name);
            Ok(())
        };
        let (a, b, c) = (&told.single, &told.double, &told.truth);
        for i in 0..3 {
            let (axis, color) = (["x", "y", "z"][i], ["r", "g", "b"][i]);
            macro_rules! tells {
                ($name:literal, $letter:ident, |$trace:ident| $vector:expr) => {{
                    let single = (|$trace: &Trace<f32>| $vector)(a).map(|v| v.to_array()[i]);
                    let double = (|$trace: &Trace<f64>| $vector)(b).map(|v| v.to_array()[i]);
                    let truth = (|$trace: &Trace<DoubleDouble>| $vector)(c);
                    let truth = truth.map(|v| v.to_array()[i]);
                    tells(format!("{}.{}", $name, $letter), single, double, truth)?;
                }};
            }
            tells!("o", axis, |t| Some(t.ray.origin));
            tells!("d", axis, |t| Some(t.ray.direction));
            tells!("p", axis, |t| t.first.map(|first| first.point));
            tells!("n", axis, |t| t.first.map(|first| first.normal));
            tells!("l", axis, |t| t
                .lights
                .first()
                .map(|from| from.sample.direction));
            tells!("E", color, |t| t
                .lights
                .first()
                .map(|from| from.sample.radiance));
            tells!("L", color, |t| Some(t.radiance));
        }
        Ok(())
    });
}

/// How losses read, from a few bits to all of them.
pub fn losses_are_told_in_words() {
    for_all((number::<f64>(3..60),), |(factor,)| {
        let factor = factor.abs();
        prop_assume!(factor > 1.0);
        let bits = format!("{:.0} bits are lost", factor.log2());
        for (loss, what) in [
            (Loss::Cancellation(factor), "cancellation: "),
            (Loss::Grazing(factor), "grazing: "),
            (Loss::Tangency(factor), "tangency: "),
        ] {
            let text = loss.to_string();
            prop_assert!(text.starts_with(what) && text.ends_with(&bits), "{text}");
            let told = text
                .rsplit_once(" is ")
                .and_then(|(_, end)| end.split_once(','));
            let told = told.expect("a factor").0;
            let is_plain = told.bytes().all(|byte| byte.is_ascii_digit());
            prop_assert_eq!(is_plain, factor < 1e6, "{}", told);
            let read: f64 = told.parse().expect("a number");
            prop_assert!((read / factor - 1.0).abs() <= 0.0625, "{told} for {factor}");
        }
        Ok(())
    });
    assert!(
        Loss::Grazing(1e6)
            .to_string()
            .contains(" is 1.0e6, 20 bits")
    );
    let all = Loss::Tangency(f64::INFINITY).to_string();
    assert!(all.ends_with("is infinite, no digit is left"), "{all}");
    assert_eq!(Loss::Wrap(3).to_string(), "wrap: 3 x 256 is dropped");
}
