//! Every function of the larger examples, one position at a time, and their sweeps: in long runs only, since most of the time goes into
//! optimising them.
//!
//! The workspace builds this package with optimisation in every profile.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

#[macro_use]
mod judge;

mechanisms! {
    delta_robot,
    double_double,
    eye_needle,
    favorit,
    favorit_forces,
    machine,
    needle_drive,
    spatial_crank_rocker,
    spatial_crank_rocker_published,
    spatial_slider_crank,
    universal_joint,
}

check!(delta_robot_: delta_robot::Delta, delta_robot::DeltaAssembly:
    platform [platform_sweep platform_sweep_sets] (phi1, phi2, phi3),
    motion [motion_sweep motion_sweep_sets] (phi1, phi2, phi3),
    joints [joints_sweep joints_sweep_sets] (phi1, phi2, phi3),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi1, phi2, phi3));
check!(delta_robot_back: delta_robot::Back, delta_robot::BackAssembly:
    drives [drives_sweep drives_sweep_sets] (x, y, z));
check!(double_double_: double_double::CrankRocker, double_double::CrankRockerAssembly:
    motion [motion_sweep motion_sweep_sets] (phi));
check!(eye_needle_: eye_needle::EyeNeedle, eye_needle::EyeNeedleAssembly:
    needle [needle_sweep needle_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi),
    picture [picture_sweep picture_sweep_sets] (phi),
    rocker [rocker_sweep rocker_sweep_sets] (phi),
    posture [posture_sweep posture_sweep_sets] (phi));
check!(favorit_: favorit::Favorit, favorit::FavoritAssembly:
    needle [needle_sweep needle_sweep_sets] (phi12),
    height [height_sweep height_sweep_sets] (phi12),
    transmission [transmission_sweep transmission_sweep_sets] (phi12),
    picture [picture_sweep picture_sweep_sets] (phi12),
    motion [motion_sweep motion_sweep_sets] (phi12));
check!(favorit_forces_: favorit_forces::Favorit, favorit_forces::FavoritAssembly:
    forces [forces_sweep forces_sweep_sets] (phi12, omega),
    accelerations [accelerations_sweep accelerations_sweep_sets] (phi12),
    energy [energy_sweep energy_sweep_sets] (phi12, omega),
    motion [motion_sweep motion_sweep_sets] (phi12, omega),
    picture [picture_sweep picture_sweep_sets] (phi12),
    shaking [shaking_sweep shaking_sweep_sets] (phi12, omega));
check!(machine_needles: machine::NeedleDrive, machine::NeedleDriveAssembly:
    needle [needle_sweep needle_sweep_sets] (phi),
    tongue [tongue_sweep tongue_sweep_sets] (phi),
    heights [heights_sweep heights_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi));
check!(machine_sinkers: machine::SinkerDrive, machine::SinkerDriveAssembly:
    position [position_sweep position_sweep_sets] (phi));
check!(machine_press: machine::PressDrive, machine::PressDriveAssembly:
    position [position_sweep position_sweep_sets] (phi));
check!(needle_drive_: needle_drive::NeedleDrive, needle_drive::NeedleDriveAssembly:
    needle [needle_sweep needle_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    joints [joints_sweep joints_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(spatial_crank_rocker_: spatial_crank_rocker::SpatialCrankRocker, spatial_crank_rocker::SpatialCrankRockerAssembly:
    motion [motion_sweep motion_sweep_sets] (phi),
    picture [picture_sweep picture_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi),
    pose [pose_sweep pose_sweep_sets] (phi));
check!(spatial_crank_rocker_published: spatial_crank_rocker_published::Published, spatial_crank_rocker_published::PublishedAssembly:
    rocker [rocker_sweep rocker_sweep_sets] (theta));
check!(spatial_crank_rocker_flat: spatial_crank_rocker_published::Flat, spatial_crank_rocker_published::FlatAssembly:
    rocker [rocker_sweep rocker_sweep_sets] (theta));
check!(spatial_slider_crank_: spatial_slider_crank::SpatialSlider, spatial_slider_crank::SpatialSliderAssembly:
    joints [joints_sweep joints_sweep_sets] (phi),
    stroke [stroke_sweep stroke_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(universal_joint_: universal_joint::Cardan, universal_joint::CardanAssembly:
    single [single_sweep single_sweep_sets] (phi),
    double [double_sweep double_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi),
    bending [bending_sweep bending_sweep_sets] (phi));
