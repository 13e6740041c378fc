//! The playground as it is built: values to the last bit, and the page in a real browser, opened
//! from disk.

mod built;
mod dragged;
mod node;
mod page;
mod shown;
mod speed;
mod values;
