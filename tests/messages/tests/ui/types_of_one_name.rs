//! Two types of one name in a module: rustc reports them at the words of the user.

/// A result type is made in the module of the call, which has a type of that name from elsewhere: rustc says so at the word.
mod imported {
    use linkage::mechanism;

    mod other {
        pub struct Motion;
    }

    use other::Motion;

    mechanism! {
        struct Crank {
            unit mm;
            param crank = 50mm;
            input phi = 30deg;
        }
        impl Crank {
            pub fn motion(phi) -> Motion { p: polar(crank, phi) }
        }
    }
}

/// Two mechanisms of one module cannot both make a type `Motion`. Nothing else is told of it.
mod of_another_mechanism {
    use linkage::mechanism;

    mechanism! {
        pub struct Crank {
            unit mm;
            param crank = 50mm;
            input phi = 30deg;
        }
        impl Crank {
            pub fn motion(phi) -> Motion { p: polar(crank, phi) }
        }
    }

    mechanism! {
        pub struct Guide {
            unit mm;
            input s = 30mm;
        }
        impl Guide {
            pub fn motion(s) -> Motion { end: (s, 0), twice: 2 * s }
        }
    }

    fn user() {
        let guide = Guide::default().assemble().unwrap();
        println!("{}", guide.motion(20.0).twice);
        println!("{}", guide.motion_sweep(&[20.0]).twice()[0]);
    }
}

fn main() {}
