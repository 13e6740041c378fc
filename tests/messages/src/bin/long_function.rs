// A function of some thousand operations compiles in a debug build, too.
use linkage::mechanism;

mechanism! {
    struct Chain {
        unit mm;
        param a = 40mm; param b = 120mm; param c = 80mm; param d = 100mm; param e = 70mm;
        param f = 110mm; param g = 90mm; param h = 150mm; param lift = 25deg;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 57deg;
        unknown alpha = 10deg;
        unknown beta = 80deg;
        let pin = polar(a, phi);
        loop pin + polar(b, theta) = (d, 0) + polar(c, psi);
        let tracer = pin + polar(e, theta + lift);
        loop tracer + polar(f, alpha) = (h, 0) + polar(g, beta);
        let tip = tracer + polar(e, alpha - lift);
    }
    impl Chain {
        fn everything(phi) -> Everything {
            tip: sensitivity(acceleration(tip)),
            alpha: sensitivity(acceleration(alpha)),
            beta: sensitivity(jerk(beta)),
            tip_jerk: sensitivity(jerk(tip)),
            tracer: sensitivity(jerk(tracer)),
            psi: sensitivity(jerk(psi)),
            mixed: d(sensitivity(jerk(beta)), a),
        }
    }
}

fn main() {
    let function = &Chain::STRUCTURE.functions[0];
    assert!(
        function.operations.total() > 3000,
        "{}",
        function.operations.total()
    );
    let linkage = Chain::default().assemble().unwrap();
    assert!(linkage.everything(1.0).tip.iter().all(|e| e.x.is_finite()));
}
