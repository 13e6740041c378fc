//! Names of one letter: those of type parameters elsewhere.

linkage::mechanism! {
    pub struct U {
        unit mm;
        param T = 3mm;
        param U = 4mm;
        input F = 90deg;
        let p = (T, 0) + polar(U, F);
    }
    impl U {
        pub fn V(F) -> F { p, T, U }
        pub fn W(F) -> X { at: p, U }
    }
}

fn main() {
    let u = U::default();
    let f = u
        .assemble()
        .expect("no loop")
        .V(std::f64::consts::FRAC_PI_2);
    assert!((f.p.x - 3.0).abs() < 1e-15 && f.p.y == 4.0 && f.T == 3.0 && f.U == 4.0);
    assert_eq!(u.cast::<f32>().U, 4.0_f32);
    assert_eq!(u.assemble().expect("no loop").W_sweep(&[0.0]).len(), 1);
}
