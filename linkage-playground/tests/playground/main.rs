//! The playground as it is built: values to the last bit, and the page in a real browser, opened
//! from disk.

mod assist;
mod broken;
mod built;
mod dragged;
mod kept;
mod node;
mod page;
mod phone;
mod renewed;
mod shown;
mod size;
mod speed;
mod stopped;
mod values;
