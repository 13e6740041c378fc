//! The four-bar with the dual numbers of num-dual.

use nalgebra::SVector;
use num_dual::{DualNum, first_derivative, jacobian, second_derivative};

/// Tracer point and rocker angle for the angle of the crank and seven dimensions.
fn four_bar<D: DualNum<Primitive = f64> + Copy>(phi: D, [a, b, c, dx, dy, p, u]: [D; 7]) -> [D; 3] {
    let (sin, cos) = phi.sin_cos();
    let (ax, ay) = (a * cos, a * sin);
    let (x, y) = (dx - ax, dy - ay);
    let square = x * x + y * y;
    let along = (square + b * b - c * c) / (square + square);
    let across = (b * b / square - along * along).sqrt();
    let (bx, by) = (x * along - y * across, y * along + x * across);
    let (sin, cos) = u.sin_cos();
    let (m, n) = (p * cos / b, p * sin / b);
    [
        ax + bx * m - by * n,
        ay + bx * n + by * m,
        (by - y).atan2(bx - x),
    ]
}

/// The tracer point.
pub fn point(phi: f64, dimensions: [f64; 7]) -> [f64; 2] {
    let [x, y, _] = four_bar(phi, dimensions);
    [x, y]
}

/// Value, first and second derivative of both components.
pub fn motion(phi: f64, dimensions: [f64; 7]) -> [(f64, f64, f64); 2] {
    second_derivative(
        |phi| {
            let [x, y, _] = four_bar(phi, dimensions.map(Into::into));
            [x, y]
        },
        phi,
    )
}

/// The tracer point, and its derivatives with respect to the dimensions.
pub fn sensitivities(
    phi: f64,
    dimensions: [f64; 7],
) -> (SVector<f64, 2>, nalgebra::SMatrix<f64, 2, 7>) {
    jacobian(
        |d: SVector<_, 7>| {
            let [x, y, _] = four_bar(phi.into(), d.into());
            SVector::from([x, y])
        },
        &dimensions.into(),
    )
}

/// The angle of the rocker and its derivative.
pub fn rocker(phi: f64, dimensions: [f64; 7]) -> (f64, f64) {
    first_derivative(|phi| four_bar(phi, dimensions.map(Into::into))[2], phi)
}
