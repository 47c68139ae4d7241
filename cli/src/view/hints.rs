//! What options mean, in the command line's own words.

use std::collections::BTreeMap;

/// What options mean, by their names: the command line's own help.
#[derive(Clone, Debug, Default)]
pub struct Hints(BTreeMap<String, String>);

impl Hints {
    /// From the definition of options: the help of each, and of each of their values.
    ///
    /// ```
    /// let arg = clap::Arg::new("order").help("SH order");
    /// let hints = gaunt::view::Hints::new(&clap::Command::new("test").arg(arg));
    /// assert_eq!(hints.of("order"), "SH order");
    /// assert_eq!(hints.of("other"), "");
    /// ```
    pub fn new(command: &clap::Command) -> Self {
        let mut hints = BTreeMap::new();
        for arg in command.get_arguments() {
            let help = arg.get_long_help().or(arg.get_help());
            hints.extend(help.map(|help| (arg.get_id().to_string(), help.to_string())));
            for value in arg.get_possible_values() {
                let help = value.get_help().map(ToString::to_string);
                hints.extend(help.map(|help| (value.get_name().to_string(), help)));
            }
        }
        Self(hints)
    }

    /// What an option or one of its values means; empty where nothing is known.
    pub fn of(&self, name: &str) -> &str {
        self.0.get(name).map_or("", String::as_str)
    }
}
