//! Real mechanisms against known answers, a module for each.

mod andrews;
mod ankle;
mod beyond_examples;
mod burmester;
mod calibrate;
#[path = "../../examples/check/comparison.rs"]
mod check;
mod crank_rocker;
mod delta_robot;
mod digits;
mod double_double;
mod eye_needle_accuracy;
mod folders;
mod four_bar_paths;
mod hexapod;
mod machine;
mod needle_drive;
mod spatial_slider_crank;
mod stability;
mod trammel;
mod tutorial;
