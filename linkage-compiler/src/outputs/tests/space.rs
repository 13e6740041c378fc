//! Groups in space.

use super::expect_all;

#[test]
fn groups_in_space() {
    let rocker = "let axis = turn(turn((0, 0, 1), (0, 1, 0), lift), (1, 0, 0), 0.3rad);
        let pin = turn((a, e, 0mm), (0, 0, 1), phi) + (e, 0mm, e);
        let pivot = (d, e, -2 * e);";
    for (items, quantities) in [
        (
            "unknown p = 57deg; let end = pivot + turn((c, e, 0mm), axis, p);
             loop distance(pin, end) = b;",
            &["p", "end"][..],
        ),
        (
            "unknown x = 50mm; let end = pivot + x * axis; loop distance(pin, end) = b;",
            &["x", "end"],
        ),
        (
            "unknown q = (60mm, 20mm, 60mm); loop distance(q, pin) = b / 2 + e;
             loop norm(q - pivot) = c; loop distance((0mm, c, 0mm), q) = d;",
            &["q"],
        ),
        (
            "unknown q = (60mm, 20mm, 60mm); loop distance(q, pin) = c;
             loop norm(2 * (q - pivot)) = d + c; loop dot(axis, q) = b / 2;",
            &["q", "q.x * q.z"],
        ),
        (
            "unknown q = (60mm, 20mm, 60mm); loop distance(q, pin) = c; loop q.y = e;
             loop dot(axis, q) = b / 2;",
            &["q"],
        ),
        (
            "unknown n = (0, 0, 1); loop norm(n) = 1; loop dot(n, axis) = cos(lift + 1);
             loop dot(n, pin) = e;",
            &["n"],
        ),
        (
            "unknown x = 50mm; unknown y = 50mm; unknown z = 10mm;
             loop pin + x * axis + y * (0, 1, 0.1) = pivot + z * turn((1, 0, 0), axis, phi);",
            &["x", "z", "y * axis"],
        ),
        (
            "unknown x = 50mm; unknown y = 50mm; unknown p = 10deg;
             loop pin + x * axis + y * (0, 1, 0.1) = pivot + turn((b, 0mm, e), (0, 0.6, 0.8), p);",
            &["x", "p", "y * axis"],
        ),
        (
            "unknown p = 44deg; unknown r = -2deg; unknown s = -6deg;
             let u = pin + turn((c, 0mm, 0mm), (0, 1, 0), -p);
             let v = pivot + turn((c, e, 0mm), axis, r);
             let w = (d / 2, b, 0mm) + turn((c, 0mm, 0mm), (0, 1, 0), -s);
             loop distance(u, v) = b; loop distance(v, w) = b; loop distance(w, u) = b;",
            &["p", "w"],
        ),
    ] {
        expect_all(&format!("{rocker} {items}"), quantities);
    }
}
