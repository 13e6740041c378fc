//! Motion under forces of mechanisms of the macro, against published numbers, energies and closed forms.

mod andrews;
mod dead_point;
mod five_bar;
mod friction;
mod lid;
