//! What a file of Rust says of modules: which it declares, what it imports, which paths it names.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::BTreeSet;

/// A path, `crate`, `self` and `super` included, and the line that it is on.
#[derive(Clone, Debug)]
pub struct Named {
    pub path: Vec<String>,
    pub line: usize,
}

/// A path that is imported.
#[derive(Clone, Debug)]
pub struct Import {
    /// What it is called here; nothing: everything in it is.
    pub name: Option<String>,
    pub of: Named,
}

/// What a file says.
#[derive(Debug, Default)]
pub struct Source {
    /// Modules that are files of their own.
    pub children: BTreeSet<String>,
    pub items: BTreeSet<String>,
    pub imports: Vec<Import>,
    /// Paths elsewhere than in imports of the file's own module.
    pub named: Vec<Named>,
    /// Whether it declares and imports, and nothing else.
    pub declares_only: bool,
}

impl Source {
    /// # Panics
    /// If it is no Rust.
    pub fn parse(text: &str) -> Self {
        let tokens = text.parse::<TokenStream>().expect("tokens of Rust");
        let mut source = Self {
            declares_only: true,
            ..Self::default()
        };
        source.module(&tokens.into_iter().collect::<Vec<_>>());
        source
    }

    /// The file's own module, item by item.
    fn module(&mut self, tokens: &[TokenTree]) {
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let word = word(Some(token));
            let next = self::word(tokens.get(at + 1));
            let ends = is(tokens.get(at + 2), ';');
            at += match (word.as_str(), next) {
                ("mod", child) if ends => {
                    self.children.insert(child);
                    3
                }
                ("use", _) => {
                    let end = semicolon(tokens, at);
                    self.imports
                        .extend(tree(&tokens[at + 1..end], &mut Vec::new()));
                    end + 1 - at
                }
                ("pub", _) => match tokens.get(at + 1) {
                    Some(TokenTree::Group(g)) if g.delimiter() == Delimiter::Parenthesis => 2,
                    _ => 1,
                },
                _ if is(Some(token), '#') => attribute(tokens, at),
                (keyword, name) => {
                    self.declares_only = false;
                    if INTRODUCES.contains(&keyword) && !INTRODUCES.contains(&name.as_str()) {
                        self.items.insert(name);
                    }
                    self.anywhere(tokens, at, 0)
                }
            };
        }
    }

    /// Takes in what begins at a token, `depth` modules deep within the file; how many tokens that were.
    fn anywhere(&mut self, tokens: &[TokenTree], at: usize, depth: usize) -> usize {
        match &tokens[at] {
            TokenTree::Group(group) => {
                let module = at > 1 && word(tokens.get(at - 2)) == "mod";
                let held: Vec<TokenTree> = group.stream().into_iter().collect();
                let mut inner = 0;
                while inner < held.len() {
                    inner += self.anywhere(&held, inner, depth + usize::from(module));
                }
                1
            }
            TokenTree::Ident(ident) if ident == "use" => {
                let end = semicolon(tokens, at);
                for import in tree(&tokens[at + 1..end], &mut Vec::new()) {
                    self.name(import.of, depth);
                }
                end + 1 - at
            }
            token if is(Some(token), '#') => attribute(tokens, at),
            _ => self.path_at(tokens, at, depth),
        }
    }

    /// Takes in the path that begins here, if one does; how many tokens that were.
    fn path_at(&mut self, tokens: &[TokenTree], at: usize, depth: usize) -> usize {
        let after_path =
            at > 0 && is(tokens.get(at - 1), ':') && at > 1 && is(tokens.get(at - 2), ':');
        let mut path = Vec::new();
        let mut end = at;
        while let Some(TokenTree::Ident(ident)) = tokens.get(end) {
            path.push(ident.to_string());
            end += 1;
            if !(is(tokens.get(end), ':') && is(tokens.get(end + 1), ':')) {
                break;
            }
            end += 2;
        }
        if path.len() > 1 && !after_path {
            let line = tokens[at].span().start().line;
            self.name(Named { path, line }, depth);
        }
        (end - at).max(1)
    }

    /// A path `depth` modules within the file: what leads out of these leads to the file's own.
    fn name(&mut self, mut of: Named, depth: usize) {
        let out = of.path.iter().take_while(|s| *s == "super").count();
        if depth > 0 && out > 0 {
            of.path.drain(..out.min(depth));
            if out <= depth {
                of.path.insert(0, "self".into());
            }
        }
        self.named.push(of);
    }
}

/// Words before the name of what they introduce.
const INTRODUCES: [&str; 12] = [
    "fn",
    "struct",
    "enum",
    "union",
    "trait",
    "type",
    "const",
    "static",
    "mod",
    "macro_rules",
    "mut",
    "unsafe",
];

fn word(token: Option<&TokenTree>) -> String {
    match token {
        Some(TokenTree::Ident(ident)) => ident.to_string(),
        _ => String::new(),
    }
}

fn is(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

/// How many tokens an attribute takes; with what follows, where that is built for tests alone, which may look at the house
/// from above.
fn attribute(tokens: &[TokenTree], at: usize) -> usize {
    let whole = usize::from(is(tokens.get(at + 1), '!'));
    let end = at + 2 + whole;
    let text = tokens.get(end - 1).map(ToString::to_string);
    if text.is_none_or(|text| text.replace(' ', "") != "[cfg(test)]") || whole > 0 {
        return end - at;
    }
    let last = |token: &TokenTree| match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        token => is(Some(token), ';'),
    };
    let item = tokens[end.min(tokens.len())..].iter().position(last);
    item.map_or(tokens.len(), |item| end + item + 1) - at
}

fn semicolon(tokens: &[TokenTree], from: usize) -> usize {
    let found = (from..tokens.len()).find(|&at| is(tokens.get(at), ';'));
    found.unwrap_or(tokens.len())
}

/// What the tree of an import names, below `path`.
fn tree(tokens: &[TokenTree], path: &mut Vec<String>) -> Vec<Import> {
    let mut all = Vec::new();
    for branch in tokens.split(|token| is(Some(token), ',')) {
        let depth = path.len();
        let mut name = None;
        let mut renamed = false;
        for token in branch {
            let line = token.span().start().line;
            match token {
                TokenTree::Ident(ident) if ident == "as" => renamed = true,
                TokenTree::Ident(ident) if renamed => name = Some(ident.to_string()),
                TokenTree::Ident(ident) if ident == "self" && !path.is_empty() => {}
                TokenTree::Ident(ident) => path.push(ident.to_string()),
                TokenTree::Group(group) => {
                    let below: Vec<TokenTree> = group.stream().into_iter().collect();
                    all.extend(tree(&below, path));
                }
                TokenTree::Punct(punct) if punct.as_char() == '*' => all.push(Import {
                    name: None,
                    of: Named {
                        path: path.clone(),
                        line,
                    },
                }),
                _ => {}
            }
        }
        let ends_here = !matches!(branch.last(), Some(TokenTree::Group(_)))
            && !is(branch.last(), '*')
            && !branch.is_empty();
        if ends_here {
            let line = branch[0].span().start().line;
            all.push(Import {
                name: Some(name.unwrap_or_else(|| path[path.len() - 1].clone())),
                of: Named {
                    path: path.clone(),
                    line,
                },
            });
        }
        path.truncate(depth);
    }
    all
}
