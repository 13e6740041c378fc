//! Motion under forces of mechanisms of the macro, against published numbers, energies and closed forms.

mod andrews;
mod dead_point;
mod derivatives;
mod engine;
mod five_bar;
mod four_bars;
mod friction;
mod lid;
