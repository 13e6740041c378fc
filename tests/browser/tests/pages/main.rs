//! What pages of reports show and do, in a real browser.

mod checks;
mod colours;
mod compare;
mod cyclogram;
mod drawing;
mod exports;
mod follow;
mod gallery;
mod gaps;
mod grip;
mod machine;
mod names;
mod one_colour;
mod parts;
mod phone;
mod photo;
mod playing;
mod plots;
mod print;
mod signs;
mod slots;
mod space;
mod tables;
mod thinned;
mod vectors;
