//! Pictures that are none of the lab's: noise of many kinds, landscapes, text, drawings.

/// A picture of these colours, from 0 to 1, at places from 0 to 1.
fn picture(width: u32, height: u32, color: impl Fn(f32, f32) -> [f32; 3]) -> Vec<u8> {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let place = |i: u32, n: u32| (i as f32 + 0.5) / n as f32;
    pixels
        .flat_map(|(x, y)| color(place(x, width), place(y, height)))
        .map(|c| (c.clamp(0.0, 1.0) * 255.0) as u8)
        .collect()
}

/// A number from 0 to 1 for a lattice point, as random as the bits of a hash.
fn hash(x: i32, y: i32, seed: u32) -> f32 {
    let mut h = (x as u32).wrapping_mul(0x85eb_ca6b) ^ (y as u32).wrapping_mul(0xc2b2_ae35) ^ seed;
    for _ in 0..3 {
        h = (h ^ h >> 15).wrapping_mul(0x2c1b_3c6d);
    }
    (h >> 8) as f32 / (1 << 24) as f32
}

/// Noise between lattice points that lie `1 / frequency` apart.
fn smooth(x: f32, y: f32, frequency: f32, seed: u32) -> f32 {
    let (x, y) = (x * frequency, y * frequency);
    let (left, top) = (x.floor(), y.floor());
    let ease = |t: f32| t * t * (3.0 - 2.0 * t);
    let (across, down) = (ease(x - left), ease(y - top));
    let at = |i: i32, j: i32| hash(left as i32 + i, top as i32 + j, seed);
    let above = at(0, 0) * (1.0 - across) + at(1, 0) * across;
    let below = at(0, 1) * (1.0 - across) + at(1, 1) * across;
    above * (1.0 - down) + below * down
}

/// Noise of many sizes: like clouds, stone, bark.
fn fractal(x: f32, y: f32, rough: f32, seed: u32) -> f32 {
    let (mut sum, mut all, mut weight) = (0.0, 0.0, 1.0);
    for octave in 0..7 {
        sum += weight * smooth(x, y, 3.0 * 2_f32.powi(octave), seed + octave as u32);
        all += weight;
        weight *= rough;
    }
    sum / all
}

/// A colour between two.
fn mix(a: [f32; 3], b: [f32; 3], t: f32) -> [f32; 3] {
    [0, 1, 2].map(|c| a[c] * (1.0 - t) + b[c] * t)
}

/// The pictures, each with its name.
pub fn pictures(width: u32, height: u32) -> Vec<(&'static str, Vec<u8>)> {
    let draw = |color: &dyn Fn(f32, f32) -> [f32; 3]| picture(width, height, color);
    let pixel = |x: f32, y: f32| ((x * width as f32) as i32, (y * height as f32) as i32);
    let mut all = vec![];
    all.push((
        "white noise",
        draw(&|x, y| {
            let (i, j) = pixel(x, y);
            [1, 2, 3].map(|seed| hash(i, j, seed))
        }),
    ));
    all.push((
        "grey noise",
        draw(&|x, y| {
            let (i, j) = pixel(x, y);
            [hash(i, j, 4); 3]
        }),
    ));
    for (name, rough, seed) in [("clouds", 0.5, 10), ("stone", 0.7, 20), ("sand", 0.9, 30)] {
        all.push((
            name,
            draw(&|x, y| {
                let [a, b] = [seed, seed + 100].map(|seed| fractal(x, y, rough, seed));
                [a, 0.7 * a + 0.3 * b, 0.4 * a + 0.4 * b]
            }),
        ));
    }
    all.push((
        "landscape",
        draw(&|x, y| {
            let hill = 0.45 + 0.15 * fractal(x, 0.0, 0.5, 40);
            let grass = fractal(x, y, 0.9, 50);
            if y > hill {
                [0.15 + 0.25 * grass, 0.3 + 0.3 * grass, 0.1 + 0.1 * grass]
            } else {
                mix([0.35, 0.55, 0.9], [0.9, 0.9, 0.95], y / hill)
            }
        }),
    ));
    all.push((
        "sunset",
        draw(&|x, y| {
            let sea = if y > 0.6 {
                0.15 * fractal(x, 4.0 * y, 0.8, 60)
            } else {
                0.0
            };
            let sky = mix([0.3, 0.2, 0.5], [1.0, 0.5, 0.2], (y / 0.6).min(1.0));
            let sun = ((x - 0.5).powi(2) + (y - 0.5).powi(2)).sqrt() < 0.08;
            if sun {
                [1.0, 0.9, 0.6]
            } else {
                mix(sky, [0.0; 3], if y > 0.6 { 0.6 - sea } else { 0.0 })
            }
        }),
    ));
    all.push((
        "portrait",
        draw(&|x, y| {
            let oval = |cx: f32, cy: f32, rx: f32, ry: f32| {
                let d = (((x - cx) / rx).powi(2) + ((y - cy) / ry).powi(2)).sqrt();
                (6.0 * (1.1 - d)).clamp(0.0, 1.0)
            };
            let grain = 0.05 * (fractal(x, y, 0.9, 70) - 0.5);
            let mut color = mix([0.45, 0.35, 0.3], [0.25, 0.3, 0.35], x);
            color = mix(color, [0.85, 0.7, 0.6], oval(0.5, 0.5, 0.2, 0.35));
            for eye in [0.42, 0.58] {
                color = mix(color, [0.15, 0.1, 0.1], oval(eye, 0.42, 0.03, 0.03));
            }
            mix(color, [0.6, 0.2, 0.2], oval(0.5, 0.68, 0.07, 0.02)).map(|c| c + grain)
        }),
    ));
    all.push((
        "text",
        draw(&|x, y| {
            let (i, j) = pixel(x, y);
            let ink = j % 9 < 6
                && i % 6 < 5
                && hash(i / 2, j / 2, 80) > 0.5
                && hash(i / 24, j / 9, 81) > 0.2;
            [if ink { 0.05 } else { 0.97 }; 3]
        }),
    ));
    all.push((
        "bricks",
        draw(&|x, y| {
            let (i, j) = pixel(x, y);
            let row = j.div_euclid(12);
            let shifted = i + row % 2 * 12;
            let mortar = j % 12 < 2 || shifted % 24 < 2;
            let clay = 0.2 * fractal(x, y, 0.8, 90) + 0.2 * hash(shifted / 24, row, 91);
            if mortar {
                [0.75, 0.72, 0.7]
            } else {
                [0.45 + clay, 0.2 + 0.5 * clay, 0.15 + 0.4 * clay]
            }
        }),
    ));
    all.push((
        "stars",
        draw(&|x, y| {
            let (i, j) = pixel(x, y);
            [if hash(i, j, 95) > 0.99 { 1.0 } else { 0.02 }; 3]
        }),
    ));
    all.push((
        "window",
        draw(&|x, y| {
            let (i, j) = pixel(x, y);
            let button = x > 0.3 && j % 20 < 12 && i % 50 < 40;
            match (y < 0.1, button) {
                (true, _) => [0.2, 0.25, 0.4],
                (_, true) => [1.0; 3],
                _ => [0.9, 0.9, 0.92],
            }
        }),
    ));
    all.push((
        "colour wheel",
        draw(&|x, y| {
            let angle = (y - 0.5).atan2(x - 0.5);
            [0.0, 2.1, 4.2].map(|phase| 0.5 + 0.5 * (angle + phase).cos())
        }),
    ));
    all.push(("gradient", draw(&|x, y| [x, 0.5, y])));
    for (name, color) in [
        ("grey", [0.5; 3]),
        ("red", [1.0, 0.0, 0.0]),
        ("black", [0.0; 3]),
    ] {
        all.push((name, draw(&|_, _| color)));
    }
    all
}
