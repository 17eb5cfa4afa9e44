//! What recipes draw from: random numbers, and vectors of the format.

use crate::format::Format;

/// The state of a recipe: its generator, and where it stands.
pub struct Draw {
    pub format: Format,
    /// The request, from 0.
    pub index: usize,
    /// How many the family has.
    pub count: usize,
    /// The parameter of the family.
    pub parameter: f64,
    state: u64,
}

impl Draw {
    pub fn new(kind: &str, family: &str, format: Format, count: usize, parameter: f64) -> Draw {
        // FNV-1a of the names.
        let name = [kind, ".", family, ".", format.name()].concat();
        let state = name.bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
        Draw {
            format,
            index: 0,
            count,
            parameter,
            state,
        }
    }

    /// `SplitMix64`.
    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number of the format in [low, high].
    pub fn number(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.next() >> 11) as f64 / (1u64 << 53) as f64;
        self.round(low + (high - low) * unit)
    }

    /// `x` rounded to the format.
    pub fn round(&self, x: f64) -> f64 {
        self.format.narrow(x)
    }

    /// `v` rounded to the format.
    pub fn rounded(&self, v: [f64; 3]) -> [f64; 3] {
        v.map(|x| self.round(x))
    }

    /// Of two constants, the one for the format.
    pub fn by(&self, single: f64, double: f64) -> f64 {
        match self.format {
            Format::F32 => single,
            Format::F64 => double,
        }
    }

    /// The element of a list whose turn it is.
    pub fn turn<T: Copy>(&self, list: &[T]) -> T {
        list[self.index % list.len()]
    }

    /// A step in units in the last place whose turn it is: the family counts from below zero to above.
    pub fn ulps(&self) -> i64 {
        self.index as i64 - self.count as i64 / 2
    }

    /// `x` rounded to the format, and `ulps` steps further.
    pub fn step(&self, x: f64, ulps: i64) -> f64 {
        self.format.step(self.round(x), ulps)
    }

    /// The smallest subnormal number of the format.
    pub fn tiniest(&self) -> f64 {
        self.format.step(0.0, 1)
    }

    /// The smallest normal number of the format.
    pub fn smallest(&self) -> f64 {
        self.by(f64::from(f32::MIN_POSITIVE), f64::MIN_POSITIVE)
    }

    /// The largest finite number of the format.
    pub fn largest(&self) -> f64 {
        self.by(f64::from(f32::MAX), f64::MAX)
    }

    /// A point of the format in the cube [-half, half]³.
    pub fn point(&mut self, half: f64) -> [f64; 3] {
        [(); 3].map(|()| self.number(-half, half))
    }

    /// A direction, uniform on the sphere, of length 1 up to roundoff of `f64`.
    pub fn exact_unit(&mut self) -> [f64; 3] {
        loop {
            let v = [(); 3].map(|()| (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0);
            let length2 = dot(v, v);
            if 1e-4 < length2 && length2 < 1.0 {
                return scale(v, 1.0 / length2.sqrt());
            }
        }
    }

    /// A direction of the format, of length 1 up to its roundoff.
    pub fn unit(&mut self) -> [f64; 3] {
        let v = self.exact_unit();
        self.rounded(v)
    }

    /// A unit vector at right angles to `v`.
    pub fn across(&mut self, v: [f64; 3]) -> [f64; 3] {
        let other = self.exact_unit();
        unit(cross(v, other))
    }
}

pub fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scale(a: [f64; 3], s: f64) -> [f64; 3] {
    a.map(|x| x * s)
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// `a` with length 1, up to roundoff.
pub fn unit(a: [f64; 3]) -> [f64; 3] {
    scale(a, 1.0 / dot(a, a).sqrt())
}

/// `a + s b`.
pub fn along(a: [f64; 3], s: f64, b: [f64; 3]) -> [f64; 3] {
    add(a, scale(b, s))
}
