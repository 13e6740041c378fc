//! The program of the language page, word for word, and what comes out of it.

use linkage::mechanism;

mechanism! {
    /// Crank-rocker four-bar with a coupler point.        // becomes the struct's documentation
    pub struct CrankRocker {
        unit mm;                                   // length unit of every stored and returned length

        const pivot_a = (0mm, 0mm);                // baked into the code
        param pivot_d = (140mm +- 0.02mm, 0mm +- 0.02mm);
        param crank   = 50mm  +- 12um;             // a public field; this default; a tolerance in PARAMETERS
        param coupler = 120mm +- 20um;
        param rocker  = 100mm +- 20um;
        param arm     = 70mm;                      // no tolerance: zero
        param lift    = 25deg +- 30arcsec;

        input phi = 30deg in 0deg..360deg;         // driving coordinate: reference value, working range

        unknown theta = 40deg;                     // start estimate at the reference input:
        unknown psi   = 80deg;                     // it picks the assembly mode

        let a = pivot_a + polar(crank, phi);
        loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }

    impl CrankRocker {
        /// Path of the tracer point.
        pub fn path(phi) -> Path { tracer }
        pub fn motion(phi) -> Motion { tracer, v: velocity(tracer), a: acceleration(tracer), psi }
        pub fn accuracy(phi) -> Accuracy { tracer, e: sensitivity(tracer) }
    }
}

fn main() -> Result<(), linkage::AssemblyError> {
    let mechanism = CrankRocker {
        crank: 50.01,
        ..CrankRocker::default()
    };
    let linkage = mechanism.assemble()?;
    let m = linkage.motion(1.2);
    println!("{} {} {}", m.tracer, m.v, m.a);

    let angles = [0.0, 1.2, 6.0];
    let cycle = linkage.path_sweep(&angles);
    let mut columns = linkage.path_sweep(&[]);
    linkage.path_sweep_into(&angles, &mut columns);
    assert_eq!(cycle, columns);
    assert!((linkage.path(1.2).tracer - m.tracer).norm() < 1e-12);

    let names: Vec<&str> = CrankRocker::PARAMETERS.iter().map(|p| p.name).collect();
    let known = [
        "pivot_d.x",
        "pivot_d.y",
        "crank",
        "coupler",
        "rocker",
        "arm",
        "lift",
    ];
    assert_eq!(names, known);
    let crank = &CrankRocker::PARAMETERS[2];
    assert_eq!((crank.unit, crank.nominal), ("mm", 50.0));
    assert!((crank.tolerance - 0.012).abs() < 1e-15);
    assert_eq!(linkage.accuracy(1.2).e.len(), names.len());
    assert_eq!(CrankRocker::STRUCTURE.groups[0].kind, "RRR");

    assert_eq!(mechanism.assemblies()?.len(), 2);
    let others = mechanism.assemblies_at(2.0)?;
    assert_eq!(others.len(), 2);
    let single: CrankRocker<f32> = mechanism.cast::<f32>();
    let p = single.assemble()?.path(1.2f32).tracer;
    assert!((f64::from(p.x) - m.tracer.x).abs() < 1e-3);
    Ok(())
}
