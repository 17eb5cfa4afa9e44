//! What JPEG takes from a picture: the file's own quantisation tables and chroma subsampling,
//! applied to other pixels.

use ombrage::conformance::diagnosis::Loss;
use std::f32::consts::PI;
use std::sync::LazyLock;

/// The loss of one JPEG file.
#[derive(Clone, Debug, PartialEq)]
pub struct Jpeg {
    /// Quantisation steps of luma and chroma, row by row.
    tables: [[u16; 64]; 2],
    /// How many luma samples a chroma sample covers, across and down; `None` for a grey picture.
    chroma: Option<[u32; 2]>,
    /// Whether a chroma sample is the mean of what it covers, or only its upper left.
    is_mean: bool,
}

/// The order in which JPEG stores the 64 coefficients (ITU-T T.81, figure A.6).
const ZIGZAG: [usize; 64] = [
    0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20,
    13, 6, 7, 14, 21, 28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59,
    52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63,
];

/// The first row of the luma steps that T.81, table K.1, recommends for quality 50.
const RECOMMENDED: [u16; 8] = [16, 11, 10, 16, 24, 40, 51, 61];

impl Jpeg {
    /// The loss of a file, from its headers; `None` where they are not those of a JPEG picture of
    /// one or three components.
    pub fn of(file: &[u8]) -> Option<Self> {
        let mut rest = file.strip_prefix(&[0xff, 0xd8])?;
        let (mut tables, mut frame) = ([None; 4], None);
        loop {
            let &[0xff, marker, high, low, ..] = rest else {
                return None;
            };
            if marker == 0xff {
                rest = &rest[1..];
                continue;
            }
            let length = usize::from(u16::from_be_bytes([high, low]));
            let segment = rest.get(4..2 + length)?;
            match marker {
                0xdb => read_tables(segment, &mut tables)?,
                0xc0..=0xc2 => frame = Some(segment),
                // The scan: every header has been seen.
                0xda => return Self::of_frame(frame?, &tables),
                _ => {}
            }
            rest = &rest[2 + length..];
        }
    }

    /// From the frame header (T.81, B.2.2).
    fn of_frame(segment: &[u8], tables: &[Option<[u16; 64]>; 4]) -> Option<Self> {
        let components = segment.get(6..)?.as_chunks::<3>().0;
        let table = |component: &[u8; 3]| *tables.get(usize::from(component[2]))?;
        let factors = |component: &[u8; 3]| {
            let [across, down] = [component[1] >> 4, component[1] & 15].map(u32::from);
            (across > 0 && down > 0).then_some([across, down])
        };
        match components {
            [luma] => Some(Self {
                tables: [table(luma)?; 2],
                chroma: None,
                is_mean: true,
            }),
            [luma, blue, _] => {
                let ([across, down], [less, lower]) = (factors(luma)?, factors(blue)?);
                Some(Self {
                    tables: [table(luma)?, table(blue)?],
                    chroma: Some([(across / less).max(1), (down / lower).max(1)]),
                    is_mean: true,
                })
            }
            _ => None,
        }
    }

    /// The losses that the file may have had: its headers do not say how chroma was halved.
    pub fn each(&self) -> Vec<Self> {
        let halved = matches!(self.chroma, Some([across, down]) if across * down > 1);
        let means = if halved {
            vec![true, false]
        } else {
            vec![true]
        };
        let of = |is_mean| Self {
            is_mean,
            ..self.clone()
        };
        means.into_iter().map(of).collect()
    }

    /// A chroma component at full size, after its loss.
    fn chroma_plane(
        &self,
        [width, height]: [usize; 2],
        sample: impl Fn(usize, usize) -> f32,
    ) -> Plane {
        let [across, down] = self.chroma.unwrap_or([1, 1]).map(|n| n as usize);
        let small = [width.div_ceil(across), height.div_ceil(down)];
        let mut plane = Plane::new(small, |x, y| {
            if self.chroma.is_none() {
                return 128.0;
            }
            let (left, top) = (x * across, y * down);
            if !self.is_mean {
                return sample(left, top);
            }
            let mut sum = 0.0;
            for row in (top..top + down).map(|row| row.min(height - 1)) {
                for column in (left..left + across).map(|column| column.min(width - 1)) {
                    sum += sample(column, row);
                }
            }
            // Halves go down and up in turns.
            let all = (across * down) as f32;
            let rounding = if x.is_multiple_of(2) {
                all / 2.0 - 1.0
            } else {
                all / 2.0
            };
            ((sum + rounding.max(0.0)) / all).floor()
        });
        plane.quantise(&self.tables[1]);
        plane.enlarged([across, down])
    }

    /// The quality from 1 to 100 whose steps are nearest, as the Independent JPEG Group counts it.
    pub fn quality(&self) -> u32 {
        let off = |quality: &u32| {
            let scale = if *quality < 50 {
                5000 / quality
            } else {
                200 - 2 * quality
            };
            let steps = RECOMMENDED
                .iter()
                .map(|&step| ((u32::from(step) * scale + 50) / 100).clamp(1, 255));
            let own = self.tables[0].iter().map(|&step| u32::from(step));
            steps.zip(own).map(|(a, b)| a.abs_diff(b)).sum::<u32>()
        };
        (1..=100).rev().min_by_key(off).unwrap_or(100)
    }

    /// `4:4:4`, `4:2:2`, `4:2:0`, or what else it is.
    pub fn subsampling(&self) -> String {
        match self.chroma {
            None => "grey".to_owned(),
            Some([1, 1]) => "4:4:4".to_owned(),
            Some([2, 1]) => "4:2:2".to_owned(),
            Some([1, 2]) => "4:4:0".to_owned(),
            Some([2, 2]) => "4:2:0".to_owned(),
            Some([4, 1]) => "4:1:1".to_owned(),
            Some([across, down]) => format!("chroma over {across}x{down}"),
        }
    }
}

/// Quantisation tables (T.81, B.2.4.1).
fn read_tables(mut segment: &[u8], tables: &mut [Option<[u16; 64]>; 4]) -> Option<()> {
    while let Some((&head, rest)) = segment.split_first() {
        let bytes = if head >> 4 == 0 { 1 } else { 2 };
        let steps = rest.get(..64 * bytes)?;
        let mut table = [1; 64];
        for (step, place) in steps.chunks_exact(bytes).zip(ZIGZAG) {
            let step = step.iter().fold(0, |sum, &byte| sum << 8 | u16::from(byte));
            table[place] = step.max(1);
        }
        *tables.get_mut(usize::from(head & 15))? = Some(table);
        segment = &rest[64 * bytes..];
    }
    Some(())
}

/// One component of a picture, its sides multiples of 8.
struct Plane {
    width: usize,
    height: usize,
    samples: Vec<f32>,
}

impl Plane {
    /// What `sample(x, y)` gives; the last row and column are repeated up to the next multiple
    /// of 8.
    fn new([width, height]: [usize; 2], sample: impl Fn(usize, usize) -> f32) -> Self {
        let (wide, tall) = (width.next_multiple_of(8), height.next_multiple_of(8));
        let samples = (0..tall)
            .flat_map(|y| (0..wide).map(move |x| (x.min(width - 1), y.min(height - 1))))
            .map(|(x, y)| sample(x, y))
            .collect();
        Self {
            width: wide,
            height: tall,
            samples,
        }
    }

    /// Quantises every block of 8x8.
    fn quantise(&mut self, table: &[u16; 64]) {
        for top in (0..self.height).step_by(8) {
            for left in (0..self.width).step_by(8) {
                let rows = (0..8).map(|row| (top + row) * self.width + left);
                let mut block = [0.0; 64];
                for (row, at) in block.chunks_exact_mut(8).zip(rows.clone()) {
                    row.copy_from_slice(&self.samples[at..at + 8]);
                }
                if block.iter().all(|sample| *sample == block[0]) {
                    let mean = quantised(8.0 * (block[0] - 128.0), table[0]);
                    block = [nearest(mean / 8.0 + 128.0).clamp(0.0, 255.0); 64];
                } else {
                    let shifted = block.map(|sample| sample - 128.0);
                    let mut coefficients = transform(&shifted, &BASIS, &TRANSPOSED);
                    for (coefficient, &step) in coefficients.iter_mut().zip(table) {
                        *coefficient = quantised(*coefficient, step);
                    }
                    block = transform(&coefficients, &TRANSPOSED, &BASIS)
                        .map(|sample| nearest(sample + 128.0).clamp(0.0, 255.0));
                }
                for (row, at) in block.chunks_exact(8).zip(rows) {
                    self.samples[at..at + 8].copy_from_slice(row);
                }
            }
        }
    }

    /// Twice as wide, twice as tall, or both: each sample is three quarters of the nearest one and
    /// a quarter of the next, first down, then across. Other factors repeat the samples.
    fn enlarged(&self, [across, down]: [usize; 2]) -> Self {
        let mut tall = Self {
            width: self.width,
            height: self.height * down,
            samples: Vec::with_capacity(self.samples.len() * across * down),
        };
        for y in 0..tall.height {
            let (near, next) = neighbours(y, down, self.height);
            let row = |y: usize| &self.samples[y * self.width..(y + 1) * self.width];
            let pairs = row(near).iter().zip(row(next));
            tall.samples
                .extend(pairs.map(|(near, next)| blend(*near, *next)));
        }
        if across == 1 {
            return tall;
        }
        let mut wide = Self {
            width: tall.width * across,
            height: tall.height,
            samples: Vec::with_capacity(tall.samples.len() * across),
        };
        for row in tall.samples.chunks_exact(tall.width) {
            let sample = |x| {
                let (near, next) = neighbours(x, across, tall.width);
                blend(row[near], row[next])
            };
            wide.samples.extend((0..wide.width).map(sample));
        }
        wide
    }
}

/// A coefficient as its multiple of a step: it is an eighth of a whole number, and halves go away
/// from 0.
fn quantised(coefficient: f32, step: u16) -> f32 {
    let step = f32::from(step);
    nearest(nearest(coefficient * 8.0) / (8.0 * step)) * step
}

/// `x.round()`, for numbers of a picture; a fraction of its time.
fn nearest(x: f32) -> f32 {
    (x + 0.5_f32.copysign(x)) as i32 as f32
}

/// The sample that covers a place, and the other one next to it.
fn neighbours(place: usize, factor: usize, count: usize) -> (usize, usize) {
    let near = place / factor;
    if factor != 2 {
        return (near, near);
    }
    let next = if place.is_multiple_of(2) {
        near.saturating_sub(1)
    } else {
        (near + 1).min(count - 1)
    };
    (near, next)
}

/// Three quarters of one sample and a quarter of the other, rounded.
fn blend(near: f32, next: f32) -> f32 {
    ((3.0 * near + next + 2.0) / 4.0) as i32 as f32
}

type Matrix = [[f32; 8]; 8];

/// The orthonormal cosine transform of 8 samples (T.81, A.3.3), a row for each frequency.
static BASIS: LazyLock<Matrix> = LazyLock::new(|| {
    let mut basis = [[0.0; 8]; 8];
    for (frequency, row) in basis.iter_mut().enumerate() {
        let scale: f32 = if frequency == 0 { 0.125 } else { 0.25 };
        for (at, entry) in row.iter_mut().enumerate() {
            *entry = scale.sqrt() * ((2 * at + 1) as f32 * frequency as f32 * PI / 16.0).cos();
        }
    }
    basis
});

/// Its inverse.
static TRANSPOSED: LazyLock<Matrix> = LazyLock::new(|| {
    let mut transposed = [[0.0; 8]; 8];
    for (i, row) in transposed.iter_mut().enumerate() {
        for (entry, basis) in row.iter_mut().zip(BASIS.iter()) {
            *entry = basis[i];
        }
    }
    transposed
});

/// `matrix * block * transposed`.
fn transform(block: &[f32; 64], matrix: &Matrix, transposed: &Matrix) -> [f32; 64] {
    let mut columns = [0.0; 64];
    for (sums, weights) in columns.chunks_exact_mut(8).zip(matrix) {
        for (row, weight) in block.chunks_exact(8).zip(weights) {
            for (sum, sample) in sums.iter_mut().zip(row) {
                *sum += weight * sample;
            }
        }
    }
    let mut result = [0.0; 64];
    for (sums, row) in result.chunks_exact_mut(8).zip(columns.chunks_exact(8)) {
        for (weights, column) in transposed.iter().zip(row) {
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum += weight * column;
            }
        }
    }
    result
}

/// Luma and chroma of a colour (JFIF 1.02), in whole numbers; halves go down, so that chroma
/// never leaves a byte.
fn encode([red, green, blue]: [u8; 3]) -> [f32; 3] {
    let [red, green, blue] = [red, green, blue].map(f32::from);
    let components = [
        0.299 * red + 0.587 * green + 0.114 * blue,
        128.0 - 0.168_736 * red - 0.331_264 * green + 0.5 * blue,
        128.0 + 0.5 * red - 0.418_688 * green - 0.081_312 * blue,
    ];
    components.map(|component| {
        let whole = component as i32 as f32;
        if component - whole > 0.5 {
            whole + 1.0
        } else {
            whole
        }
    })
}

/// The way back.
fn decode([luma, blueness, redness]: [f32; 3]) -> [u8; 3] {
    let (blueness, redness) = (blueness - 128.0, redness - 128.0);
    let rgb = [
        luma + 1.402 * redness,
        luma - 0.344_136 * blueness - 0.714_136 * redness,
        luma + 1.772 * blueness,
    ];
    rgb.map(|component| nearest(component).clamp(0.0, 255.0) as u8)
}

impl Loss for Jpeg {
    fn degrade(&self, width: u32, height: u32, pixels: &mut [[u8; 3]]) {
        let size = [width as usize, height as usize];
        if pixels.iter().all(|pixel| pixel == &pixels[0]) && !pixels.is_empty() {
            let mut one = [pixels[0]; 64];
            if pixels.len() > one.len() {
                self.degrade(8, 8, &mut one);
                pixels.fill(one[0]);
                return;
            }
        }
        let encoded: Vec<[f32; 3]> = pixels.iter().map(|&pixel| encode(pixel)).collect();
        let mut luma = Plane::new(size, |x, y| encoded[y * size[0] + x][0]);
        luma.quantise(&self.tables[0]);
        let [blueness, redness] = [1, 2].map(|component| {
            let samples = |x: usize, y: usize| encoded[y * size[0] + x][component];
            self.chroma_plane(size, samples)
        });
        for (at, pixel) in pixels.iter_mut().enumerate() {
            let (x, y) = (at % size[0], at / size[0]);
            let chroma = y * blueness.width + x;
            *pixel = decode([
                luma.samples[y * luma.width + x],
                blueness.samples[chroma],
                redness.samples[chroma],
            ]);
        }
    }

    fn tolerance(&self) -> u8 {
        let [luma, chroma] = self.tables.map(|table| table[0] / 6);
        (2 + luma + chroma).min(16) as u8
    }
}
