//! The compiler from tokens to tokens: one program, so that it is linked once.

mod arithmetic;
mod directions;
mod forms;
mod forms_space;
mod golden;
mod growth;
mod margins;
mod proposals;
mod robust;
mod speed;
