//! The faults that pictures show, each with a stable code.

/// What is wrong with a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Code {
    /// It is another of the lab's figures.
    OtherFigure,
    /// Bytes wrap where they should be clamped.
    Wrapped,
    /// Bytes stop at 255 where Figure 2(a) wraps: the conversion to a byte saturates.
    Saturated,
    /// The same, by a clamp. One picture cannot tell it from [`Code::Saturated`].
    Clamped,
    /// Nothing casts a shadow.
    NoShadow,
    /// Surfaces falsely shadow themselves.
    Acne,
    /// Shadow rays start so far off their surface that the shadow moves.
    OffsetTooLarge,
    /// The shadow lies elsewhere, and no offset along the normal explains it.
    ShadowShifted,
    /// Cosines below 0 darken, or light from behind.
    CosineUnclamped,
    /// Radiance is not divided by the distance.
    NoFalloff,
    /// Radiance is divided by the distance, not by its square.
    LinearFalloff,
    /// The light's power is another.
    WrongPower,
    /// Radiance is divided by π.
    ExtraPi,
    /// There is no plane.
    PlaneMissing,
    /// A normal shows to the wrong side.
    NormalFlipped,
    /// Left and right are exchanged.
    Mirrored,
    /// Top and bottom are exchanged.
    UpsideDown,
    /// Bytes are gamma-encoded.
    Gamma,
    /// Red and blue are exchanged.
    RedBlueSwapped,
    /// An object has another colour.
    WrongColour,
    /// The background has another colour.
    WrongBackground,
    /// The field of view is another.
    WrongFov,
    /// Colours of the lab, but objects, light or camera elsewhere.
    OtherScene,
}

/// How much a fault matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Severity {
    /// A clause of the lab does not hold.
    Error,
    /// The clauses of the lab may hold, but the engine underneath differs.
    Warning,
}

impl Severity {
    /// `error` or `warning`.
    pub fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
        }
    }
}

impl Code {
    /// All codes, in the order of tables.
    pub const ALL: [Code; 23] = [
        Code::Wrapped,
        Code::Saturated,
        Code::Clamped,
        Code::NoShadow,
        Code::Acne,
        Code::OffsetTooLarge,
        Code::ShadowShifted,
        Code::CosineUnclamped,
        Code::NoFalloff,
        Code::LinearFalloff,
        Code::WrongPower,
        Code::ExtraPi,
        Code::PlaneMissing,
        Code::NormalFlipped,
        Code::Mirrored,
        Code::UpsideDown,
        Code::Gamma,
        Code::RedBlueSwapped,
        Code::WrongColour,
        Code::WrongBackground,
        Code::WrongFov,
        Code::OtherFigure,
        Code::OtherScene,
    ];

    /// The stable code: `NO_SHADOW`.
    pub fn name(self) -> &'static str {
        match self {
            Code::OtherFigure => "OTHER_FIGURE",
            Code::Wrapped => "WRAPPED",
            Code::Saturated => "SATURATED",
            Code::Clamped => "CLAMPED",
            Code::NoShadow => "NO_SHADOW",
            Code::Acne => "ACNE",
            Code::OffsetTooLarge => "OFFSET_TOO_LARGE",
            Code::ShadowShifted => "SHADOW_SHIFTED",
            Code::CosineUnclamped => "COSINE_UNCLAMPED",
            Code::NoFalloff => "NO_FALLOFF",
            Code::LinearFalloff => "LINEAR_FALLOFF",
            Code::WrongPower => "WRONG_POWER",
            Code::ExtraPi => "EXTRA_PI",
            Code::PlaneMissing => "PLANE_MISSING",
            Code::NormalFlipped => "NORMAL_FLIPPED",
            Code::Mirrored => "MIRRORED",
            Code::UpsideDown => "UPSIDE_DOWN",
            Code::Gamma => "GAMMA",
            Code::RedBlueSwapped => "RED_BLUE_SWAPPED",
            Code::WrongColour => "WRONG_COLOUR",
            Code::WrongBackground => "WRONG_BACKGROUND",
            Code::WrongFov => "WRONG_FOV",
            Code::OtherScene => "OTHER_SCENE",
        }
    }

    /// The clause of `docs/spec.md` that does not hold.
    pub fn clause(self) -> &'static str {
        match self {
            Code::OtherFigure => "E.4",
            Code::Wrapped => "3.3",
            Code::Saturated | Code::Clamped => "3.2",
            Code::NoShadow | Code::ShadowShifted => "4.1",
            Code::Acne => "4.2",
            Code::OffsetTooLarge => "4.3",
            Code::CosineUnclamped | Code::ExtraPi => "3.1",
            Code::NoFalloff | Code::LinearFalloff => "2.3",
            Code::WrongPower => "2.1",
            Code::PlaneMissing => "1.3",
            Code::NormalFlipped => "1.2",
            Code::Mirrored | Code::WrongFov => "E.2",
            Code::UpsideDown => "E.1",
            Code::Gamma | Code::RedBlueSwapped => "E.6",
            Code::WrongColour | Code::WrongBackground | Code::OtherScene => "E.7",
        }
    }

    /// How much it matters.
    pub fn severity(self) -> Severity {
        match self {
            Code::WrongColour | Code::WrongBackground | Code::WrongFov => Severity::Warning,
            _ => Severity::Error,
        }
    }

    /// What is seen, in a few words.
    pub fn fact(self) -> &'static str {
        match self {
            Code::OtherFigure => "it is another figure",
            Code::Wrapped => "bytes wrap around",
            Code::Saturated | Code::Clamped => "bytes stop at 255",
            Code::NoShadow => "nothing casts a shadow",
            Code::Acne => "surfaces shadow themselves",
            Code::OffsetTooLarge => "the shadow has moved toward the light",
            Code::ShadowShifted => "the shadow lies elsewhere",
            Code::CosineUnclamped => "the cosine is not clamped",
            Code::NoFalloff => "light does not fade with distance",
            Code::LinearFalloff => "light fades with the distance, not its square",
            Code::WrongPower => "the light has another power",
            Code::ExtraPi => "light is divided by π",
            Code::PlaneMissing => "there is no plane",
            Code::NormalFlipped => "normals show away from the camera",
            Code::Mirrored => "left and right are exchanged",
            Code::UpsideDown => "top and bottom are exchanged",
            Code::Gamma => "bytes are gamma-encoded",
            Code::RedBlueSwapped => "red and blue are exchanged",
            Code::WrongColour => "an object has another colour",
            Code::WrongBackground => "the background has another colour",
            Code::WrongFov => "the field of view is another",
            Code::OtherScene => "the colours are the lab's, but no scene like the lab's fits",
        }
    }

    /// What to look for in the program, in one sentence.
    pub fn advice(self) -> &'static str {
        match self {
            Code::OtherFigure => "check which figure was handed in",
            Code::Wrapped => {
                "clamp each component to [0, 1] before it becomes a byte; now 1.02 becomes 260, \
                 and 260 becomes 4"
            }
            Code::Saturated | Code::Clamped => {
                "Figure 2(a) shows what happens without the clamp: look for a clamp, or for a \
                 conversion that saturates, such as `as u8`; one picture cannot tell the two apart"
            }
            Code::NoShadow => {
                "cast a shadow ray to the light, and leave the light out where anything is hit"
            }
            Code::Acne => {
                "the shadow ray hits the surface it starts on: move its origin along the normal"
            }
            Code::OffsetTooLarge => {
                "shadow rays start too far off their surface: a few units in the last place of \
                 the coordinates are enough"
            }
            Code::ShadowShifted => {
                "shadow rays start or end at the wrong place: check origin, direction and the \
                 light's position"
            }
            Code::CosineUnclamped => "take max(0, dot(n, l)), neither the product as it is nor |x|",
            Code::NoFalloff => "divide the power by the square of the distance to the light",
            Code::LinearFalloff => "divide by the distance squared, not by the distance",
            Code::WrongPower => "the lab's has a power of 100",
            Code::ExtraPi => "the lab's materials are colour * radiance * cosine, without 1/π",
            Code::PlaneMissing => "add the plane to the scene, and test it for hits",
            Code::NormalFlipped => "turn the normal of a hit to the side the ray came from",
            Code::Mirrored => "with the lab's camera the right of the picture is -x of the world",
            Code::UpsideDown => "row 0 is the top of the picture: sy runs down",
            Code::Gamma => "write 255 x as it is, without sRGB or gamma encoding",
            Code::RedBlueSwapped => "the file's channels are red, green, blue: look for BGR",
            Code::WrongColour => "in the lab the sphere is (0, 0, 1), the plane (1, 0, 0)",
            Code::WrongBackground => "the lab's is (0.5, 0.5, 0.5)",
            Code::WrongFov => "the lab's is 60 degrees from top to bottom",
            Code::OtherScene => {
                "sphere (0, 0, 3) of radius 1, plane y = -2, light (1, 10, 1), camera (0, 0, -2)"
            }
        }
    }
}
