//! After a mistake frames and what is computed from them still have their types: one message.

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

fn main() {
    let linkage = M::default().assemble().expect("there is nothing to close");
    let pose = linkage.pose(1.0);
    let body: Frame = pose.body;
    let tool: Vector3<f64> = pose.tool + pose.up;
    let columns = linkage.pose_sweep(&[0.0, 1.0]);
    let [origin, ..]: [[&[f64]; 3]; 4] = columns.body();
    println!("{} {tool} {:?}", body.isometry(), origin[0]);
}
