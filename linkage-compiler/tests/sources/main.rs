//! What the sources keep to: tests that read them.

mod host;
mod private_names;
mod surface;
mod where_to_add;
