//! Kernels that are wrong in one way, as a program that speaks the kernel protocol: what
//! `tests/conform.rs` judges. `broken_kernels FAULT [FILE]`

use ombrage::conformance::{Answer, Ends, Kernels, Question, Surface, answer};
use ombrage::{Float, Quality, Ray, Real, Scalar, Vector};
use serde_json::{Value, json};
use std::env;
use std::io::{self, BufRead, BufWriter, Write};
use std::process::{self, Command};
use std::thread;
use std::time::Duration;

const RIGHT: Kernels = Kernels {
    quality: Quality::Wide,
    shadow: None,
};

fn main() -> io::Result<()> {
    let mut arguments = env::args().skip(1);
    let fault = arguments.next().unwrap_or_default();
    match fault.as_str() {
        "never-reads" => sleep(),
        "crashes-at-once" => process::abort(),
        "floods-stderr" => {
            let noise = [b'!'; 1 << 16];
            for _ in 0..1000 {
                io::stderr().write_all(&noise)?;
            }
        }
        "leaves-a-child" => {
            let child = Command::new(env::current_exe()?)
                .arg("never-reads")
                .spawn()?;
            std::fs::write(arguments.next().unwrap_or_default(), child.id().to_string())?;
        }
        _ => {}
    }
    let mut output: Box<dyn Write> = match fault.as_str() {
        "never-flushes" | "never-flushes-and-crashes" => {
            Box::new(BufWriter::with_capacity(1 << 14, io::stdout()))
        }
        _ => Box::new(io::stdout()),
    };
    let mut held = None;
    for (number, line) in io::stdin().lock().lines().enumerate() {
        let request: Value = serde_json::from_str(&line?)?;
        let id = request["id"].as_str().unwrap_or_default();
        let is_unlucky = id.ends_with(".0003");
        let reply = json!({ "id": id, "out": out(&fault, &request) });
        match fault.as_str() {
            "crashes" | "never-flushes-and-crashes" if is_unlucky => process::abort(),
            "hangs" if id.ends_with("generic.f32.0003") => sleep(),
            "ends-early" if number == 100 => return Ok(()),
            "says-hello" if number == 0 => writeln!(output, "ready")?,
            "floods" if is_unlucky => loop {
                output.write_all(&[b'x'; 1 << 16])?;
            },
            "floods-lines" if is_unlucky => loop {
                output.write_all(&b"{}\n".repeat(1 << 12))?;
            },
            "answers-twice" if is_unlucky => writeln!(output, "{reply}")?,
            "swaps" => {
                match held.take() {
                    None => held = Some(reply),
                    Some(first) => writeln!(output, "{reply}\n{first}")?,
                }
                continue;
            }
            "answers-others" if is_unlucky => writeln!(output, r#"{{"id":"me","out":{{}}}}"#)?,
            _ => {}
        }
        writeln!(output, "{reply}")?;
    }
    if let Some(last) = held {
        writeln!(output, "{last}")?;
    }
    output.flush()
}

fn sleep() -> ! {
    loop {
        thread::sleep(Duration::from_secs(60));
    }
}

fn out(fault: &str, request: &Value) -> Value {
    let out = match request["prec"].as_str() {
        Some("f32") => answered::<f32>(fault, request).map(|answer| answer.out()),
        _ => answered::<f64>(fault, request).map(|answer| answer.out()),
    };
    match (fault, out) {
        ("answers-text", _) => json!("hit"),
        (_, Some(out)) => out,
        (_, None) => answer(&RIGHT, request).unwrap_or_default()["out"].clone(),
    }
}

/// The wrong answer; `None` for the right one.
fn answered<F: Float>(fault: &str, request: &Value) -> Option<Answer<F>> {
    let question = Question::<F>::of(request).ok()?;
    match question {
        Question::Hit { ray, ends, surface } => Some(Answer::Hit(hit(fault, ray, ends, &surface))),
        Question::AnyHit {
            ray,
            ends,
            surfaces,
        } => {
            let mut surfaces = surfaces.iter();
            let occluded = surfaces.any(|surface| hit(fault, ray, ends, surface).is_some());
            Some(Answer::AnyHit(occluded))
        }
        Question::Offset(question) if fault == "moves-by-a-constant" => {
            let way = question.normal * F::from_f64(1e-3);
            Some(Answer::Offset(question.point + way))
        }
        _ => None,
    }
}

fn hit<F: Float>(fault: &str, ray: Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    let [tmin, tmax] = ends;
    let right = |ends| RIGHT.hit(&ray, ends, surface);
    let along = match *surface {
        Surface::Plane { normal, .. } => ray.direction.dot(normal).to_f64(),
        Surface::Sphere { .. } => 0.0,
    };
    match (fault, *surface) {
        ("never-hits", _) => None,
        ("ignores-t-max", _) => right([tmin, F::from_f64(f64::INFINITY)]),
        ("ignores-t-min", _) => right([F::from_f64(0.0), tmax]),
        ("t-min-of-its-own", _) => right([F::from_f64(1e-4), tmax]),
        ("half-open", _) => right(ends).filter(|t| *t > tmin),
        ("open", _) => right(ends).filter(|t| *t > tmin && *t < tmax),
        ("culls", _) => right(ends).filter(|_| along <= 0.0),
        ("culls-the-front", _) => right(ends).filter(|_| along >= 0.0),
        ("misses-from-inside", Surface::Sphere { center, radius }) => {
            let from_center = ray.origin - center;
            let outside = from_center.dot(from_center) > radius * radius;
            right(ends).filter(|_| outside)
        }
        ("textbook", Surface::Sphere { center, radius })
            if is_moderate::<F, _>([ray.origin, ray.direction, center], radius) =>
        {
            half_b(&ray, ends, center, radius)
        }
        ("unit", Surface::Sphere { center, radius })
            if is_moderate::<F, _>([ray.origin, center], radius) =>
        {
            unit(&ray, ends, center, radius)
        }
        ("distance", _) => {
            let sizes = ray.direction.abs().to_array();
            let largest = sizes
                .into_iter()
                .fold(sizes[0], |a, b| if a < b { b } else { a });
            let direction = ray.direction * (F::from_f64(1.0) / largest);
            let direction = direction.normalized();
            RIGHT.hit(&Ray { direction, ..ray }, ends, surface)
        }
        ("overflows", _) => Kernels::default().hit(&ray, ends, surface),
        _ => right(ends),
    }
}

/// The textbook's roots with b halved, in the order that comes to mind.
fn half_b<F: Float>(
    ray: &Ray<F>,
    [tmin, tmax]: Ends<F>,
    center: F::Vector,
    radius: F,
) -> Option<F> {
    let a = ray.direction.dot(ray.direction);
    let to_center = center - ray.origin;
    let half_b = to_center.dot(ray.direction);
    let discriminant = half_b * half_b - a * (to_center.dot(to_center) - radius * radius);
    let root = Real::sqrt(discriminant);
    let mut roots = [(half_b - root) / a, (half_b + root) / a].into_iter();
    roots.find(|t| *t >= tmin && *t <= tmax && Scalar::is_finite(*t))
}

/// A stable form for unit directions.
fn unit<F: Float>(ray: &Ray<F>, [tmin, tmax]: Ends<F>, center: F::Vector, radius: F) -> Option<F> {
    let to_center = center - ray.origin;
    let along = to_center.dot(ray.direction);
    let aside = to_center - ray.direction * along;
    let half_chord = Real::sqrt(radius * radius - aside.dot(aside));
    let mut roots = [along - half_chord, along + half_chord].into_iter();
    roots.find(|t| *t >= tmin && *t <= tmax && Scalar::is_finite(*t))
}

/// Whether no square overflows or underflows.
fn is_moderate<F: Float, const N: usize>(vectors: [F::Vector; N], radius: F) -> bool {
    let mut numbers = vectors
        .map(Vector::to_array)
        .into_iter()
        .flatten()
        .chain([radius]);
    numbers.all(|x| x.to_f64() == 0.0 || (1e-6..1e8).contains(&x.to_f64().abs()))
}
