//! Messages in the order in which they are printed.

use super::suggestion::Message;

/// The key by which messages are sorted, whenever they are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Section {
    /// The text, the dimensions, the loops and the assembly at the reference.
    Mechanism,
    /// Bodies and joints.
    Bodies,
    /// Functions and pictures.
    Functions,
    /// Declared ranges and redundant loops.
    Ranges,
}

/// Messages sorted by section, in the order in which they were found within one.
#[derive(Clone, Debug, Default)]
pub(super) struct Sorted(pub(super) Vec<(Section, Message)>);

impl Sorted {
    pub(super) fn insert(&mut self, section: Section, message: Message) -> &mut Message {
        let end = self.0.partition_point(|(other, _)| *other <= section);
        self.0.insert(end, (section, message));
        &mut self.0[end].1
    }

    pub(super) fn append(&mut self, other: Self) {
        for (section, message) in other.0 {
            self.insert(section, message);
        }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Message> {
        self.0.iter().map(|(_, message)| message)
    }

    pub(super) fn into_messages(self) -> Vec<Message> {
        self.0.into_iter().map(|(_, message)| message).collect()
    }
}
