//! The value of a parameter at which an event is at a wanted angle.

mod error;
mod search;
mod set_event;
mod value;

pub use error::SettingError;
pub use set_event::set_event;
pub use value::Setting;
