//! The kernels in space in the language of `mechanism!`.

use linkage::{Vector3, mechanism};

mechanism! {
    /// K3, RSSR: a crank about the z axis and a rocker about any axis.
    pub struct K3 {
        unit mm;
        param crank   = 50mm;
        param coupler = 150mm;
        param rocker  = 90mm;
        param pivot   = (130mm, 40mm, 30mm);
        param tilt    = 65deg;
        param azimuth = -70deg;

        input phi = 30deg in 0deg..360deg;
        unknown psi = 150deg;
        let pin = (crank * cos(phi), crank * sin(phi), 0mm);
        let axis = (sin(tilt) * cos(azimuth), sin(tilt) * sin(azimuth), cos(tilt));
        let down = (cos(tilt) * cos(azimuth), cos(tilt) * sin(azimuth), -sin(tilt));
        let end = pivot + turn(rocker * down, axis, psi);
        loop distance(pin, end) = coupler;
    }

    impl K3 {
        /// K3a.
        pub fn point(phi) -> K3Point { end }
        /// K3b.
        pub fn motion(phi) -> K3Motion {
            end, v: velocity(end), a: acceleration(end), w: velocity(psi), e: acceleration(psi),
        }
        /// K3c.
        pub fn accuracy(phi) -> K3Accuracy { end, e: sensitivity(end) }
    }
}

mechanism! {
    /// K4, a delta robot. The arms turn downwards from the plane of the base.
    pub struct K4 {
        unit mm;
        param base     = 120mm;
        param arm      = 150mm;
        param forearm  = 320mm;
        param platform = 45mm;

        input first  = 20deg in 0deg..60deg;
        input second = 25deg in 0deg..60deg;
        input third  = 30deg in 0deg..60deg;
        unknown p = (0mm, 0mm, -350mm);

        let x = (1, 0, 0);
        let y = (cos(120deg), sin(120deg), 0);
        let z = (cos(240deg), sin(240deg), 0);
        let down = (0, 0, -1);
        loop distance(p + platform * x, (base + arm * cos(first)) * x + arm * sin(first) * down) = forearm;
        loop distance(p + platform * y, (base + arm * cos(second)) * y + arm * sin(second) * down) = forearm;
        loop distance(p + platform * z, (base + arm * cos(third)) * z + arm * sin(third) * down) = forearm;
    }

    impl K4 {
        /// K4a.
        pub fn point(first, second, third) -> K4Point { p }
        /// K4b.
        pub fn motion(first, second, third) -> K4Motion { p, j: velocity(p) }
        /// K4c.
        pub fn curvature(first, second, third) -> K4Curvature {
            p, j: velocity(p), h: acceleration(p),
        }
    }
}

/// The dimensions of K3 in the order of its parameters.
#[must_use]
pub fn dimensions3(m: &K3) -> [f64; 8] {
    let p = m.pivot;
    [
        m.crank, m.coupler, m.rocker, p.x, p.y, p.z, m.tilt, m.azimuth,
    ]
}

/// The dimensions of K4 in the order of its parameters.
#[must_use]
pub fn dimensions4(m: &K4) -> [f64; 4] {
    [m.base, m.arm, m.forearm, m.platform]
}

/// The numbers of vectors in one row, other numbers behind them.
fn row<const N: usize>(
    vectors: impl IntoIterator<Item = Vector3<f64>>,
    others: &[f64],
) -> [f64; N] {
    let mut row = [0.0; N];
    let numbers = vectors.into_iter().flat_map(|v| [v.x, v.y, v.z]);
    let numbers = numbers.chain(others.iter().copied());
    for (cell, number) in row.iter_mut().zip(numbers) {
        *cell = number;
    }
    row
}

macro_rules! rows {
    ($($result:ident $count:literal |$r:ident| $vectors:expr, $others:expr;)*) => {$(
        impl From<$result> for [f64; $count] {
            fn from($r: $result) -> Self {
                row($vectors, $others)
            }
        }
    )*};
}

rows! {
    K3Point 3 |r| [r.end], &[];
    K3Motion 11 |r| [r.end, r.v, r.a], &[r.w, r.e];
    K3Accuracy 27 |r| [r.end].into_iter().chain(r.e), &[];
    K4Point 3 |r| [r.p], &[];
    K4Motion 12 |r| [r.p].into_iter().chain(r.j), &[];
    K4Curvature 39 |r| [r.p].into_iter().chain(r.j).chain(r.h.into_iter().flatten()), &[];
}
