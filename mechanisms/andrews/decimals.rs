// Andrews' squeezing mechanism with all digits of its decimals, for scalars of more digits than `f64`.

/// The angle of the crank at the start, rad (Test set for IVP solvers, release 2.4, problem "Andrews' squeezing
/// mechanism").
const START: &str = "-0.0617138900142764496358948458001";
/// The angle of the crank after 0.03 s, rad, by quadrature with 50 digits: `benches/dynamics_rivals/solutions.py`. The
/// test set has 15.81077119629904.
const ANGLE: &str = "15.8107711951537070971193873047";

/// Returns the mechanism with dimensions that are read from their decimals, which are the shortest texts of the doubles.
fn decimals<T: linkage::Scalar + std::str::FromStr>(mechanism: &Andrews) -> Result<Andrews<T>, T::Err> {
    let mut wide = mechanism.cast::<T>();
    macro_rules! all {
        ($($($name:ident).+),+ $(,)?) => {
            $(wide.$($name).+ = mechanism.$($name).+.to_string().parse()?;)+
        };
    }
    all!(
        a.x, a.y, b.x, b.y, c.x, c.y, rr, ra, d, da, ss, sa, sb, sc, sd, e, ea, zt, ta, tb, zf
    );
    all!(
        fa, u, ua, ub, m1, m2, m3, m4, m5, m6, m7, i1, i2, i3, i4, i5, i6, i7, stiffness, l0
    );
    Ok(wide)
}
