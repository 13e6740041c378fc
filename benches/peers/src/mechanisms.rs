//! The kernels in the language of `mechanism!`.

use crate::{Motion, Position, Sensitivities1, Sensitivities2};
use linkage::{Scalar, Vector2, mechanism};

mechanism! {
    /// K1, the crank-rocker.
    pub struct K1 {
        unit mm;
        param crank   = 50mm;
        param coupler = 120mm;
        param rocker  = 100mm;
        param pivot_d = (140mm, 0mm);
        param arm     = 70mm;
        param lift    = 25deg;

        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }

    impl K1 {
        /// K1a.
        pub fn point(phi) -> K1Point { tracer }
        /// K1b.
        pub fn motion(phi) -> K1Motion { tracer, v: velocity(tracer), a: acceleration(tracer) }
        /// K1c.
        pub fn accuracy(phi) -> K1Accuracy { tracer, e: sensitivity(tracer) }
    }
}

mechanism! {
    /// K2, the drive of the hook needle.
    pub struct K2 {
        unit mm;
        const pivot_1 = (0mm, 0mm);
        const angle_456 = 90deg;
        param pivot_4 = (5mm, 150mm);
        param pivot_7 = (112.5mm, 3.5mm);
        param l12 = 5mm;
        param l23 = 46.5mm;
        param l34 = 123mm;
        param l45 = 13.5mm;
        param l78 = 10mm;
        param l89 = 160mm;
        param l910 = 122.5mm;
        param angle_345 = -62.5deg;

        input phi = -90deg in -90deg..630deg;
        let phi78 = 15deg - phi / 2;

        unknown phi23 = 48deg;
        unknown phi43 = -78deg;
        let p2 = pivot_1 + polar(l12, phi);
        loop p2 + polar(l23, phi23) = pivot_4 + polar(l34, phi43);

        let phi45 = phi43 + angle_345;
        let phi56 = phi45 + angle_456;
        let p5 = pivot_4 + polar(l45, phi45);

        unknown phi89 = 134deg;
        unknown slide = 18mm;
        let p8 = pivot_7 + polar(l78, phi78);
        let p9 = p8 + polar(l89, phi89);
        loop p9 = p5 + polar(slide, phi56);
        let p10 = p9 - polar(l910, phi56);
    }

    impl K2 {
        /// K2a.
        pub fn point(phi) -> K2Point { p10 }
        /// K2b.
        pub fn motion(phi) -> K2Motion { p10, v: velocity(p10), a: acceleration(p10) }
        /// K2c.
        pub fn accuracy(phi) -> K2Accuracy { p10, e: sensitivity(p10) }
    }
}

/// The dimensions of K1 in the order of its parameters.
#[must_use]
pub fn dimensions1(m: &K1) -> [f64; 7] {
    [
        m.crank,
        m.coupler,
        m.rocker,
        m.pivot_d.x,
        m.pivot_d.y,
        m.arm,
        m.lift,
    ]
}

/// The dimensions of K2 in the order of its parameters.
#[must_use]
pub fn dimensions2(m: &K2) -> [f64; 12] {
    let (p4, p7) = (m.pivot_4, m.pivot_7);
    [
        p4.x,
        p4.y,
        p7.x,
        p7.y,
        m.l12,
        m.l23,
        m.l34,
        m.l45,
        m.l78,
        m.l89,
        m.l910,
        m.angle_345,
    ]
}

/// A point, and vectors after it, in one row.
fn row<T: Scalar, const N: usize>(point: Vector2<T>, vectors: &[Vector2<T>]) -> [T; N] {
    let mut row = [point.x; N];
    row[1] = point.y;
    for (cells, vector) in row[2..].chunks_exact_mut(2).zip(vectors) {
        cells.copy_from_slice(&[vector.x, vector.y]);
    }
    row
}

/// The numbers of a result in one row.
macro_rules! rows {
    ($($result:ident $row:ident |$r:ident| $point:expr, $vectors:expr;)*) => {$(
        impl<T: Scalar> $result<T> {
            /// Its numbers.
            #[must_use]
            pub fn row<const N: usize>(&self) -> [T; N] {
                let $r = self;
                row($point, $vectors)
            }
        }

        impl<T: Scalar + Into<f64>> From<$result<T>> for $row {
            fn from(result: $result<T>) -> Self {
                result.row().map(Into::into)
            }
        }
    )*};
}

rows! {
    K1Point Position |r| r.tracer, &[];
    K1Motion Motion |r| r.tracer, &[r.v, r.a];
    K1Accuracy Sensitivities1 |r| r.tracer, &r.e;
    K2Point Position |r| r.p10, &[];
    K2Motion Motion |r| r.p10, &[r.v, r.a];
    K2Accuracy Sensitivities2 |r| r.p10, &r.e;
}
