//! What pages of reports show and do, in a real browser.

mod checks;
mod colours;
mod compare;
mod cyclogram;
mod drawing;
mod exports;
mod gallery;
mod gaps;
mod grip;
mod machine;
mod names;
mod parts;
mod photo;
mod playing;
mod plots;
mod signs;
mod tables;
mod vectors;
