//! The mechanisms of the library and one of this file, by way of `lk`.

use linkage_renamed::{SliderCrank, reexported::Gears};
use lk::mechanism;

mechanism! {
    struct Crank {
        param length = 2;
        input phi = 0deg;
        let tip = polar(length, phi);
    }

    impl Crank {
        fn tip(phi) -> Tip { tip }
    }
}

#[test]
fn a_loop() -> Result<(), lk::AssemblyError> {
    let linkage = SliderCrank::default().assemble()?;
    let motion = linkage.motion(0.0);
    assert_eq!((motion.s, motion.pin.x, motion.e[0]), (150.0, 30.0, 1.0));
    assert_eq!(linkage.motion_sweep(&[0.0, 0.1]).get(0), motion);
    Ok(())
}

#[test]
fn a_macro_of_another_name() -> Result<(), lk::AssemblyError> {
    let driven = Gears::default().assemble()?.angle(3.0).driven;
    assert!((driven + 1.0).abs() < 1e-15);
    Ok(())
}

#[test]
fn in_the_test_itself() -> Result<(), lk::AssemblyError> {
    assert_eq!(Crank::default().assemble()?.tip(0.0).tip.x, 2.0);
    Ok(())
}
