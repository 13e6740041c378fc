//! Names of the language and of generated code as names of quantities.

#![deny(warnings)]

use linkage::mechanism;

mechanism! {
    pub struct Four {
        unit cm;
        param d = 3cm;
        param unit = 2;
        param dot = (1cm, 2cm);
        param x = 30deg;
        param polar = 4cm;
        param mm = 1mm;
        param deg = 1deg;
        param param = 2;
        param input = 2;
        #[allow(unused)]
        param tolerance = 3cm +- 1mm;
        param self_ = 2;
        param T = 2;
        param modes = 2;
        input t = 0deg in 0deg..360deg;
        unknown y = 40deg;
        unknown z = 80deg;
        let velocity = polar(d, t);
        let sin = unit * sin(x) + param * input;
        loop velocity + polar(8cm, y) = (9cm, 0) + polar(6cm, z);
        let norm = norm(dot) + polar + mm;
        let margin = dot(dot, dot) / d;
    }

    impl Four {
        pub fn unit(t) -> Unit { velocity, d: d(velocity, d), norm, x: sin, dot: dot(velocity, dot), y, len: z }
        pub fn d(t) -> D { t, margin, v: velocity(velocity), self_: self_ * T * modes + deg }
        pub fn new(t) -> New { column: y }
        pub fn get(t) -> Get { value: z, m: margin() }
    }
}

fn main() {
    let four = Four::default();
    assert_eq!((four.d, four.unit, four.dot.y), (3.0, 2.0, 2.0));
    let linkage = four.assemble().expect("it closes");
    let unit = linkage.unit(0.0);
    assert!((unit.x - 5.0).abs() < 1e-12);
    assert_eq!((unit.d.x, unit.d.y), (1.0, 0.0));
    let d = linkage.d(1.0);
    assert!((d.margin - 5.0 / 3.0).abs() < 1e-12);
    assert_eq!(d.t, 1.0);
    assert_eq!(linkage.new(0.5).column, unit_y(&linkage));
    assert!(linkage.get(0.0).m > 0.0);
    assert_eq!(linkage.unit_sweep(&[0.0, 1.0]).d()[0].len(), 2);
}

fn unit_y(linkage: &FourAssembly) -> f64 {
    linkage.unit(0.5).y
}
