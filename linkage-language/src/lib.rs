//! The language of linkage: from tokens to mechanisms with names, dimensions and types, or messages.
//!
//! `syntax` parses, `model` resolves names and checks dimensions, `diagnostic` collects messages with
//! their places. An editor needs no more. The mechanisms go on to `linkage-compiler`.

pub mod diagnostic;
pub mod model;
pub mod syntax;
