//! Items around the mechanism that have the names generated code might use.

#![allow(
    dead_code,
    non_camel_case_types,
    non_upper_case_globals,
    non_snake_case,
    unused_macros
)]

mod hostile {
    pub mod core {}
    pub mod std {}
    pub mod alloc {}
    pub mod linkage {}
    pub struct Vec;
    pub struct Vector2;
    pub struct Option;
    pub struct String;
    pub struct T;
    pub struct Self_;
    pub struct f64;
    pub struct f32;
    pub struct usize;
    pub struct bool;
    pub struct str;
    pub type Result = ();
    pub struct Some;
    pub struct Ok;
    pub struct Err;
    pub const None: () = ();
    pub trait Default {}
    pub trait Clone {}
    pub trait Copy {}
    pub trait Iterator {}
    pub trait Scalar {}
    pub trait From {}
    pub fn sin() {}
    pub fn cos() {}
    pub fn sqrt() {}
    pub fn drop() {}
    pub const a: u8 = 1;
    pub const x: u8 = 1;
    pub const v1: u8 = 1;
    pub const crank: u8 = 1;
    pub static theta: u8 = 1;
    pub static mechanism_: u8 = 1;
    pub struct s;
    pub struct tracer;

    macro_rules! panic {
        () => {};
    }
    macro_rules! assert {
        () => {};
    }
    macro_rules! vec {
        () => {};
    }

    ::linkage::mechanism! {
        pub struct SliderCrank {
            unit mm;
            param crank = 30mm +- 1um;
            param pivot = (1mm, 2mm);
            const x = 0.5mm;
            input phi = 30deg in 0deg..360deg;
            unknown theta = -10deg;
            unknown s = 150mm;
            let a = pivot + polar(crank, phi);
            loop a + polar(120mm, theta) = (s, x);
            let tracer = a + rotate((10mm, 2mm), theta);
        }

        impl SliderCrank {
            pub fn motion(phi) -> Motion {
                tracer, s, v: velocity(tracer), a: acceleration(tracer), e: sensitivity(tracer), m: margin(),
            }
        }
    }
}

fn main() {
    let linkage = hostile::SliderCrank::default()
        .assemble()
        .expect("it closes");
    let motion = linkage.motion(0.5);
    assert!((motion.tracer.x - (motion.s - 120.0)).abs() < 200.0 && motion.m > 0.5);
    assert_eq!(linkage.motion_sweep(&[0.5, 0.6]).len(), 2);
}
