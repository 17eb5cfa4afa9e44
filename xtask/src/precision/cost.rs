//! What a quality costs, as a ratio to textbook.

use ombrage::{Float, Plane, PointLight, Quality, Ray, Shape, Span, Sphere, Vector};
use std::hint::black_box;
use std::time::Instant;

/// Calls in one measurement, and measurements.
const CALLS: usize = 512;
const ROUNDS: usize = 301;

/// The kernels that have qualities, by the name of the protocol.
pub const KERNELS: [&str; 3] = ["ray_plane", "ray_sphere", "light_sample"];

/// What one quality costs.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Median nanoseconds a call.
    pub ns: f64,
    /// Median of the ratios to textbook, each of two measurements in a row.
    pub ratio: f64,
}

/// The costs of a kernel in every quality, measured in turns, so that a machine that slows down slows all.
pub fn costs<F: Float>(kernel: &str) -> [Cost; Quality::ALL.len()] {
    let inputs = Inputs::<F>::new();
    let mut times = [const { Vec::<f64>::new() }; Quality::ALL.len()];
    for _ in 0..ROUNDS {
        for (times, quality) in times.iter_mut().zip(Quality::ALL) {
            let start = Instant::now();
            inputs.call(kernel, quality);
            times.push(start.elapsed().as_nanos() as f64 / CALLS as f64);
        }
    }
    let textbook = times[0].clone();
    times.map(|times| Cost {
        ratio: median(times.iter().zip(&textbook).map(|(a, b)| a / b).collect()),
        ns: median(times),
    })
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Shapes around the origin, and rays toward them, two of three of which hit.
struct Inputs<F: Float> {
    rays: Vec<Ray<F>>,
    points: Vec<F::Vector>,
    sphere: Option<Sphere<F>>,
    plane: Option<Plane<F>>,
    light: Option<PointLight<F>>,
}

impl<F: Float> Inputs<F> {
    fn new() -> Self {
        let mut state = 0x9e37_79b9_7f4a_7c15u64;
        let mut number = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let mut vector = |size: f64| F::Vector::constant((), [0; 3].map(|_| size * number()));
        let points: Vec<F::Vector> = (0..CALLS).map(|_| vector(8.0)).collect();
        let rays = points.iter().map(|&origin| Ray {
            origin,
            direction: (vector(1.2) - origin).normalized(),
        });
        let at = |x: f64| F::Vector::constant((), [x, 0.3 * x, 0.7 * x]);
        Self {
            rays: rays.collect(),
            sphere: Sphere::new(at(0.0), F::from_f64(1.0)).ok(),
            plane: Plane::new(at(0.1), at(1.0)).ok(),
            light: PointLight::new(at(11.0), at(0.9), F::from_f64(100.0)).ok(),
            points,
        }
    }

    fn call(&self, kernel: &str, quality: Quality) {
        let span = Span::new(F::from_f64(0.0), F::from_f64(1000.0));
        match kernel {
            "ray_plane" => meet(self.plane.as_ref(), &self.rays, span, quality),
            "ray_sphere" => meet(self.sphere.as_ref(), &self.rays, span, quality),
            _ => {
                if let Some(light) = self.light {
                    for &point in &self.points {
                        black_box(light.sample::<F>(black_box(point), quality));
                    }
                }
            }
        }
    }
}

fn meet<F: Float>(shape: Option<&impl Shape<F>>, rays: &[Ray<F>], span: Span<F>, quality: Quality) {
    if let Some(shape) = shape {
        for ray in rays {
            black_box(shape.intersect(black_box(ray), &span, quality).t);
        }
    }
}
