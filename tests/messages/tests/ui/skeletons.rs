//! Skeletons: a program that uses a mechanism has its types after a mistake of each kind, so that one mistake causes one message.

/// A program that uses the mechanism `M` of its module.
macro_rules! used {
    () => {
        fn user() {
            let linkage = M::default().assemble().expect("the links reach each other");
            let motion = linkage.motion(1.0);
            let speed: f64 = motion.v.x.hypot(motion.v.y);
            let columns = linkage.motion_sweep(&[0.0, 1.0]);
            println!("{speed} {} {:?} {:?}", motion.psi.sin(), columns.psi(), M::PARAMETERS);
            println!("{:?}", M::default().circuits().map(|circuits| circuits.branches.len()));
            let _ = M { crank: 41.0, ..M::default() };
        }
    };
}

/// After a mistake of syntax the rest of the code has its types: one message.
mod after_syntax {
    use linkage::mechanism;

    mechanism! {
        pub struct M {
            unit mm;
            param crank = 40mm;
            input phi = 40deg in 0deg..360deg;
            unknown theta = 20deg;
            unknown psi = 60deg;
            loop polar(crank, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
            let a = polar(crank phi);
            let b = polar(crank, phi);
        }

        impl M {
            pub fn motion(phi) -> Motion { v: velocity(b), psi }
        }
    }

    used!();
}

/// After a wrong dimension the rest of the code has its types: one message.
mod after_dimensions {
    use linkage::mechanism;

    mechanism! {
        pub struct M {
            unit mm;
            param crank = 40mm;
            input phi = 40deg in 0deg..360deg;
            unknown theta = 20deg;
            unknown psi = 60deg;
            loop polar(crank, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
            let a = crank + phi;
            let b = polar(crank, phi);
        }

        impl M {
            pub fn motion(phi) -> Motion { v: velocity(b), psi }
        }
    }

    used!();
}

/// After loops that do not close the rest of the code has its types: one message.
mod after_open_loops {
    use linkage::mechanism;

    mechanism! {
        pub struct M {
            unit mm;
            param crank = 40mm;
            input phi = 40deg in 0deg..360deg;
            unknown theta = 20deg;
            unknown psi = 60deg;
            loop polar(crank, phi) + polar(120mm, theta) = (100mm, 0) + polar(10mm, psi);
            let b = polar(crank, phi);
        }

        impl M {
            pub fn motion(phi) -> Motion { v: velocity(b), psi }
        }
    }

    used!();
}

/// The types of the function with the mistake itself.
mod of_faulty_function {
    use linkage::mechanism;

    mechanism! {
        pub struct M {
            unit mm;
            param crank = 40mm;
            input phi = 40deg in 0deg..360deg;
            unknown theta = 20deg;
            unknown psi = 60deg;
            loop polar(crank, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
            let b = polar(crank, phi);
        }

        impl M {
            pub fn motion(phi) -> Motion { v: velocity(b), psi, e: sensitivity(b, [phi]) }
        }
    }

    used!();
}

/// After a mistake frames and what is computed from them still have their types: one message.
mod with_frames {
    use linkage::{Frame, Vector3, mechanism};

    mechanism! {
        pub struct M {
            unit mm;
            param place = (10mm, 20mm, 30mm);
            input phi = 30deg;
            let body = frame(place, (cos(phi), sin(phi), 0), (0, 0, 1));
            let wrong = place + phi;
        }

        impl M {
            fn pose(phi) -> Pose { body, tool: point_in(body, (1mm, 0, 0)), up: body.y }
        }
    }

    fn user() {
        let linkage = M::default().assemble().expect("there is nothing to close");
        let pose = linkage.pose(1.0);
        let body: Frame = pose.body;
        let tool: Vector3<f64> = pose.tool + pose.up;
        let columns = linkage.pose_sweep(&[0.0, 1.0]);
        let [origin, ..]: [[&[f64]; 3]; 4] = columns.body();
        println!("{} {tool} {:?}", body.isometry(), origin[0]);
    }
}

/// `picture()` stands alone, once; the links that it lists join points.
mod with_pictures {
    use linkage::mechanism;

    mechanism! {
        struct FourBar {
            unit mm;
            param crank = 50mm;
            param coupler = 120mm;
            param rocker = 100mm;
            input phi = 30deg in 0deg..360deg;
            unknown theta = 40deg;
            unknown psi = 80deg;
            let pin = polar(crank, phi);
            loop pin + polar(coupler, theta) = (140mm, 0) + polar(rocker, psi);
        }
        impl FourBar {
            fn one(phi) -> One { shape: picture([pin, theta], [pin], crank) }
            fn two(phi) -> Two { shape: picture(), again: picture() }
            fn three(phi) -> Three { speed: velocity(picture()) }
        }
    }

    fn user() {
        let shape = FourBar::default().assemble().unwrap().two(1.0).shape;
        let _ = (shape[3].x, FourBar::PICTURE.points);
    }
}

fn main() {}
