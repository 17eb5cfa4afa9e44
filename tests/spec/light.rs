//! Clauses 2.1 to 2.3: point lights.

use super::check::{Verdict, agrees, holds, near, vector};
use ombrage::{Float, LightSample, PointLight, Quality};

/// A light from constants.
#[derive(Clone, Copy)]
pub struct Light {
    position: [f64; 3],
    color: [f64; 3],
    power: f64,
}

const WHITE: [f64; 3] = [1.0; 3];
/// The largest error of a direction, 6.5 roundings, in units in the last place.
const ULPS: u64 = 7;

/// Clause 2.1: colour and power.
pub fn check_2_1<F: Float>(sample: impl Fn(Light, [f64; 3]) -> LightSample<F>) -> Verdict {
    let color = [1.0, 0.5, 0.25];
    for (power, expected) in [
        (8.0, [2.0, 1.0, 0.5]),
        (16.0, [4.0, 2.0, 1.0]),
        (0.0, [0.0; 3]),
    ] {
        let light = Light {
            position: [0.0, 2.0, 0.0],
            color,
            power,
        };
        let radiance = sample(light, [0.0; 3]).radiance;
        let right = radiance == vector::<F>(expected);
        holds!(
            "2.1",
            right,
            "power {power}: radiance is {radiance:?} instead of {expected:?}"
        );
    }
    Ok(())
}

/// Clause 2.2: a light is at its position and shines equally in every direction.
pub fn check_2_2<F: Float>(sample: impl Fn(Light, [f64; 3]) -> LightSample<F>) -> Verdict {
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let toward: [f64; 3] = std::array::from_fn(|i| if i == axis { sign } else { 0.0 });
            let position = std::array::from_fn(|i| 1.0 + 4.0 * toward[i]);
            let sample = sample(
                Light {
                    position,
                    color: WHITE,
                    power: 16.0,
                },
                [1.0; 3],
            );
            let right = sample.direction == vector::<F>(toward);
            holds!(
                "2.2",
                right,
                "light at {position:?}: direction {:?}",
                sample.direction
            );
            let right = sample.radiance == vector::<F>(WHITE);
            holds!(
                "2.2",
                right,
                "light at {position:?}: radiance {:?}",
                sample.radiance
            );
        }
    }
    Ok(())
}

/// Clause 2.3: the four attributes of a sample.
pub fn check_2_3<F: Float>(sample: impl Fn(Light, [f64; 3]) -> LightSample<F>) -> Verdict {
    let light = Light {
        position: [4.0, 6.0, 15.0],
        color: WHITE,
        power: 169.0,
    };
    let sample = sample(light, [1.0, 2.0, 3.0]);
    let unit = [3.0 / 13.0, 4.0 / 13.0, 12.0 / 13.0];
    agrees!("2.3", near::<F>("direction", unit, sample.direction, ULPS));
    let right = sample.distance == F::from_f64(13.0);
    holds!(
        "2.3",
        right,
        "distance is {:?} instead of 13",
        sample.distance
    );
    let right = sample.radiance == vector::<F>(WHITE);
    holds!(
        "2.3",
        right,
        "radiance is {:?} instead of 169 / 13²",
        sample.radiance
    );
    holds!(
        "2.3",
        sample.pdf == F::from_f64(1.0),
        "pdf is {:?} instead of 1",
        sample.pdf
    );
    Ok(())
}

pub fn kit_sample<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    let power = F::from_f64(light.power);
    PointLight::new(vector::<F>(light.position), vector::<F>(light.color), power)
        .expect("the light is valid")
        .sample(vector::<F>(point), Quality::Textbook)
}

pub fn power_ignored<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    kit_sample(
        Light {
            power: 1.0,
            ..light
        },
        point,
    )
}

pub fn color_ignored<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    kit_sample(
        Light {
            color: WHITE,
            ..light
        },
        point,
    )
}

pub fn from_one_direction<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    let position = [point[0], point[1] + 4.0, point[2]];
    kit_sample(Light { position, ..light }, point)
}

pub fn distance_not_squared<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    let sample = kit_sample::<F>(light, point);
    LightSample {
        radiance: sample.radiance * sample.distance,
        ..sample
    }
}

pub fn direction_of_any_length<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    let sample = kit_sample::<F>(light, point);
    LightSample {
        direction: sample.direction * sample.distance,
        ..sample
    }
}

pub fn direction_from_the_light<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    let sample = kit_sample::<F>(light, point);
    LightSample {
        direction: -sample.direction,
        ..sample
    }
}

pub fn pdf_of_a_sphere<F: Float>(light: Light, point: [f64; 3]) -> LightSample<F> {
    let pdf = F::from_f64(0.25 / std::f64::consts::PI);
    LightSample {
        pdf,
        ..kit_sample(light, point)
    }
}
