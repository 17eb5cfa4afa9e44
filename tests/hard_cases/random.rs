//! Random spheres and planes at coordinates between 10^-8 and 10^8, and rays a few units in the last
//! place from tangency, against the oracle.

use ombrage::conformance::{Allowed, Case, Judged, Kernel, Kernels, output};
use ombrage::{Float, Quality, Scalar};
use ombrage_oracle::{Format, truth};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use serde_json::{Value, json};

/// A number of either sign between 10^-8 and 10^8, uniform in its logarithm.
fn coordinate<F: Float>() -> impl Strategy<Value = F> + Clone {
    (-26.0..26.0f64, any::<bool>()).prop_map(|(exponent, negative)| {
        let magnitude = exponent.exp2();
        F::from_f64(if negative { -magnitude } else { magnitude })
    })
}

fn coordinates<F: Float>() -> impl Strategy<Value = [F; 3]> + Clone {
    [coordinate::<F>(), coordinate::<F>(), coordinate::<F>()]
}

fn hex<F: Float, const N: usize>(v: [F; N]) -> Value {
    json!(v.map(Float::hex).to_vec())
}

fn request<F: Float>(kind: &str, mut input: Value) -> Value {
    input["tmin"] = F::from_f64(0.0).hex().into();
    input["tmax"] = F::from_f64(f64::INFINITY).hex().into();
    json!({ "id": "random", "kind": kind, "prec": F::NAME, "in": input })
}

/// The oracle's truth about a request, and the kit's answer, within what is allowed.
fn check(mut case: Value, quality: Quality, allowed: Allowed) -> Result<(), TestCaseError> {
    case["exp"] = truth(&case).map_err(|error| TestCaseError::fail(error.to_string()))?;
    let kernels = Kernels {
        quality,
        shadow: None,
    };
    let out = output(&kernels, &case).and_then(|out| out);
    let out = out.map_err(TestCaseError::fail)?;
    let case = Case::new(case).map_err(TestCaseError::fail)?;
    let judged = Judged::new(&case, out, allowed);
    prop_assert!(!judged.fails, "{}", crate::report::describe(&judged));
    Ok(())
}

fn for_all<T: std::fmt::Debug>(
    inputs: impl Strategy<Value = T>,
    check: impl Fn(T) -> Result<(), TestCaseError>,
) {
    let config = Config {
        failure_persistence: None,
        ..Config::default()
    };
    if let Err(failure) = TestRunner::new(config).run(&inputs, check) {
        panic!("{failure}");
    }
}

/// Toward a point of the sphere's ball, so that most rays hit.
fn sphere<F: Float>(quality: Quality, allowed: Allowed) {
    let inside = [-1.2..1.2f64, -1.2..1.2f64, -1.2..1.2f64];
    let inputs = (
        coordinates::<F>(),
        coordinates::<F>(),
        coordinate::<F>(),
        inside,
    );
    for_all(inputs, |(o, c, r, inside)| {
        let r = F::from_f64(r.to_f64().abs());
        let d: [F; 3] = std::array::from_fn(|i| {
            F::from_f64(c[i].to_f64() + inside[i] * r.to_f64() - o[i].to_f64())
        });
        let input = json!({ "o": hex(o), "d": hex(d), "c": hex(c), "r": r.hex() });
        check(
            request::<F>(Kernel::RaySphere.name(), input),
            quality,
            allowed,
        )
    });
}

/// A sphere whose radius is a few units in the last place from the distance of the line.
fn tangent<F: Float>(quality: Quality, allowed: Allowed) {
    let inputs = (
        coordinates::<F>(),
        coordinates::<F>(),
        coordinates::<F>(),
        -3..=3i64,
    );
    for_all(inputs, |(o, d, c, ulps)| {
        let [f, d64]: [[f64; 3]; 2] = [
            std::array::from_fn(|i| c[i].to_f64() - o[i].to_f64()),
            d.map(Scalar::to_f64),
        ];
        let cross = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| f[i] * d64[j] - f[j] * d64[i]);
        let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let format = if F::NAME == "f32" {
            Format::F32
        } else {
            Format::F64
        };
        let r = format.step(format.narrow(length(cross) / length(d64)), ulps);
        prop_assume!(r > 0.0);
        let input = json!({ "o": hex(o), "d": hex(d), "c": hex(c), "r": F::from_f64(r).hex() });
        check(
            request::<F>(Kernel::RaySphere.name(), input),
            quality,
            allowed,
        )
    });
}

fn plane<F: Float>(quality: Quality, allowed: Allowed) {
    let vector = coordinates::<F>;
    for_all((vector(), vector(), vector(), vector()), |(o, d, q, n)| {
        let input = json!({ "o": hex(o), "d": hex(d), "q": hex(q), "n": hex(n) });
        check(
            request::<F>(Kernel::RayPlane.name(), input),
            quality,
            allowed,
        )
    });
}

macro_rules! in_both_floats {
    ($($name:ident: $property:ident, $quality:ident, $allowed:expr;)+) => {
        $(mod $name {
            use super::*;

            #[test]
            fn f32() {
                $property::<f32>(Quality::$quality, $allowed);
            }

            #[test]
            fn f64() {
                $property::<f64>(Quality::$quality, $allowed);
            }
        })+
    };
}

/// Where nothing cancels, for instance near the center of a large sphere, the bound of the case is 1
/// and roundings add up: 3 of d², 1 of r², 1 of their difference from the residual and 1 of the
/// product make 6, the root halves them and adds 1, the sum with b adds 1, and the quotient by d² 4.
const ROUNDINGS_IN_A_ROW: u32 = 9;

in_both_floats! {
    wide_sphere: sphere, Wide, Allowed::Ulp(1);
    wide_tangent: tangent, Wide, Allowed::Ulp(1);
    wide_plane: plane, Wide, Allowed::Ulp(1);
    stable_sphere: sphere, Stable, Allowed::Bound(ROUNDINGS_IN_A_ROW);
    stable_tangent: tangent, Stable, Allowed::Bound(3);
    stable_plane: plane, Stable, Allowed::Bound(1);
}
