//! The formulas that textbooks and most programs have. Each returns what the dyad's generated
//! function does.

/// Circle and circle: sixteen times the squared area of the triangle, multiplied out.
pub(crate) fn expanded_links(data: &[f64]) -> Vec<f64> {
    let &[left, right, x, y] = data else {
        return Vec::new();
    };
    let square = x * x + y * y;
    let [a, b] = [left * left, right * right];
    let area = 2.0 * (a * b + a * square + b * square) - (a * a + b * b + square * square);
    let (along, across) = (
        (square + a - b) / (2.0 * square),
        area.sqrt() / (2.0 * square),
    );
    links_from_pin([along * x - across * y, along * y + across * x], [x, y])
}

/// `A cos + B sin = C` by the tangent of half of the angle.
pub(crate) fn tangent_links(data: &[f64]) -> Vec<f64> {
    let &[left, right, x, y] = data else {
        return Vec::new();
    };
    let [a, b] = [x, y].map(|z| 2.0 * left * z);
    let c = x * x + y * y + left * left - right * right;
    let theta = half_angle([a, b, c], 1.0);
    links_from_pin([left * theta.cos(), left * theta.sin()], [x, y])
}

/// The law of cosines.
pub(crate) fn arc_links(data: &[f64]) -> Vec<f64> {
    let &[left, right, x, y] = data else {
        return Vec::new();
    };
    let square = x * x + y * y;
    let cosine = (square + left * left - right * right) / (2.0 * left * square.sqrt());
    let theta = y.atan2(x) + cosine.acos();
    links_from_pin([left * theta.cos(), left * theta.sin()], [x, y])
}

fn links_from_pin([px, py]: [f64; 2], [x, y]: [f64; 2]) -> Vec<f64> {
    vec![py.atan2(px), (py - y).atan2(px - x), px, py]
}

/// Circle and line: a quadratic equation for the slide.
pub(crate) fn expanded_rod(data: &[f64]) -> Vec<f64> {
    let &[rod, gamma, x, y] = data else {
        return Vec::new();
    };
    let (sin, cos) = gamma.sin_cos();
    let b = x * cos + y * sin;
    let c = x * x + y * y - rod * rod;
    let s = b + (b * b - c).sqrt();
    vec![(s * sin - y).atan2(s * cos - x), s]
}

/// The rod's end on the line, by the tangent of half of the angle.
pub(crate) fn tangent_rod(data: &[f64]) -> Vec<f64> {
    let &[rod, gamma, x, y] = data else {
        return Vec::new();
    };
    let (sin, cos) = gamma.sin_cos();
    let theta = half_angle([rod * sin, -rod * cos, cos * y - sin * x], -1.0);
    let theta = if theta.is_nan() {
        theta
    } else {
        nearest(theta, gamma, [sin, cos, x, y, rod])
    };
    vec![
        theta,
        (x + rod * theta.cos()) * cos + (y + rod * theta.sin()) * sin,
    ]
}

/// The solution of the half-angle formula that lies along the guide.
fn nearest(theta: f64, gamma: f64, [sin, cos, x, y, rod]: [f64; 5]) -> f64 {
    if (theta - gamma).cos() >= 0.0 {
        return theta;
    }
    half_angle([rod * sin, -rod * cos, cos * y - sin * x], 1.0)
}

/// The angle between rod and guide by its arc sine, which is an arc cosine.
pub(crate) fn arc_rod(data: &[f64]) -> Vec<f64> {
    let &[rod, gamma, x, y] = data else {
        return Vec::new();
    };
    let (sin, cos) = gamma.sin_cos();
    let angle = core::f64::consts::FRAC_PI_2 - ((sin * x - cos * y) / rod).acos();
    vec![gamma + angle, x * cos + y * sin + rod * angle.cos()]
}

/// A quadratic equation for the slide, then the angle from two arc tangents.
pub(crate) fn expanded_guide(data: &[f64]) -> Vec<f64> {
    let &[offset, beta, x, y] = data else {
        return Vec::new();
    };
    let (sin, cos) = beta.sin_cos();
    let foot = offset * cos;
    let c = offset * offset - (x * x + y * y);
    let s = -foot + (foot * foot - c).sqrt();
    let psi = y.atan2(x) - (offset * sin).atan2(s + foot);
    guide_from_angle(psi, s, [offset, beta])
}

/// The line through the given point at the offset's distance from the pivot, by the tangent of half
/// of the angle.
pub(crate) fn tangent_guide(data: &[f64]) -> Vec<f64> {
    let &[offset, beta, x, y] = data else {
        return Vec::new();
    };
    let (sin, cos) = beta.sin_cos();
    let psi = half_angle([y, -x, offset * sin], 1.0);
    let psi = if psi.cos() * x + psi.sin() * y < 0.0 {
        half_angle([y, -x, offset * sin], -1.0)
    } else {
        psi
    };
    guide_from_angle(
        psi,
        psi.cos() * x + psi.sin() * y - offset * cos,
        [offset, beta],
    )
}

/// The angle at the pivot by its arc sine, which is an arc cosine.
pub(crate) fn arc_guide(data: &[f64]) -> Vec<f64> {
    let &[offset, beta, x, y] = data else {
        return Vec::new();
    };
    let (sin, cos) = beta.sin_cos();
    let distance = (x * x + y * y).sqrt();
    let angle = core::f64::consts::FRAC_PI_2 - (offset * sin / distance).acos();
    let s = distance * angle.cos() - offset * cos;
    guide_from_angle(y.atan2(x) - angle, s, [offset, beta])
}

fn guide_from_angle(psi: f64, s: f64, [offset, beta]: [f64; 2]) -> Vec<f64> {
    let angle = psi + beta;
    vec![psi, s, offset * angle.cos(), offset * angle.sin()]
}

/// One of the angles that solve `a cos + b sin = c`.
fn half_angle([a, b, c]: [f64; 3], sign: f64) -> f64 {
    2.0 * ((b + sign * (a * a + b * b - c * c).sqrt()) / (a + c)).atan()
}
