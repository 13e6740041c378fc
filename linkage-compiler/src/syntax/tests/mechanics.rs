//! Bodies, joints and loads.

use super::read;

#[test]
fn the_press() {
    let (text, messages) = read(
        "struct Press { unit mm;
    argument press = 500mm;
    input phi = 30deg in 0deg..360deg at omega, epsilon;
    gravity = (0, -9.80665m/s^2);
    body crank   = pin b1 on frame at pivot_1, turns phi12, mass 129.94mm at c1, inertia 31114.78mm*mm^2 at pivot_1;
    body coupler = pin b2 on crank at p2, turns phi23, mass 91.15mm at c2, inertia 49663.7mm*mm^2;
    body needle  = slide b11 on rocker at p9 along dir(phi56), turns phi56, mass m2 at p2 + polar(r, phi), inertia i;
    pin b3 = coupler on rocker at p3;
    force (0, -press) on needle at p10;
    torque 3mm*mm on crank from rocker;
    spring 2.5mm/mm from frame at q to rocker at p3, free 40mm;
    spring 300mm*mm on b4, free 20deg;
    damper 0.2mm*s/mm from frame at q to rocker at p3;
    damper 5mm*mm*s on b4;
    } impl Press { fn statics(phi12, press) -> Statics { t: torque(phi12) } }",
    );
    assert_eq!(messages, Vec::<String>::new());
    let expected = "struct Press
  unit mm
  argument press = 500mm
  input phi = 30deg in 0deg..360deg at omega, epsilon
  gravity = (0, ((-9.80665m) / s^2))
  body crank = pin b1 on frame at pivot_1, turns phi12, mass 129.94mm at c1, inertia (31114.78mm * mm^2) at pivot_1
  body coupler = pin b2 on crank at p2, turns phi23, mass 91.15mm at c2, inertia (49663.7mm * mm^2)
  body needle = slide b11 on rocker at p9 along dir(phi56), turns phi56, mass m2 at (p2 + polar(r, phi)), inertia i
  pin b3 = coupler on rocker at p3
  force (0, (-press)) on needle at p10
  torque (3mm * mm) on crank from rocker
  spring (2.5mm / mm) from frame at q to rocker at p3, free 40mm
  spring (300mm * mm) on b4, free 20deg
  damper ((0.2mm * s) / mm) from frame at q to rocker at p3
  damper ((5mm * mm) * s) on b4
fn statics(phi12, press) -> Statics
  t: torque(phi12)
";
    assert_eq!(text, expected);
}
