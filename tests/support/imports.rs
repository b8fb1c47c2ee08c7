//! The files of a crate as a graph: which of them imports what from which.

use crate::sources::sources;
use std::{collections::BTreeMap, path::Path};

/// A module by its path in its crate, such as `["graph", "index"]`; empty for the crate itself.
pub(crate) type Module = Vec<String>;

/// The modules of a crate, each with the modules that it imports from, without unit tests.
pub(crate) type Imports = BTreeMap<Module, Vec<Module>>;

/// The imports of all files below a source folder.
pub(crate) fn imports(source: &Path) -> Imports {
    let files = sources(source).into_iter().filter(|(path, _)| !path.iter().any(|folder| folder == "tests"));
    let texts: BTreeMap<Module, String> = files
        .map(|(path, text)| (module_of(path.strip_prefix(source).expect("a path below")), without_tests(&text)))
        .filter(|(module, _)| module.last().is_none_or(|name| name != "tests"))
        .collect();
    let found = |(module, text): (&Module, &String)| {
        let named = paths(text, module).into_iter().map(|path| file_of(&path, &texts));
        let mut named: Vec<_> = named.filter(|named| named != module && !named.is_empty()).collect();
        named.sort_unstable();
        named.dedup();
        (module.clone(), named)
    };
    texts.iter().map(found).collect()
}

/// The module of a file, by its path below the source folder.
fn module_of(path: &Path) -> Module {
    let mut module: Module = path.with_extension("").iter().map(|name| name.to_string_lossy().into_owned()).collect();
    if module.last().is_some_and(|last| ["mod", "lib"].contains(&last.as_str())) {
        module.pop();
    }
    module
}

/// The code of a file without comments and without what only tests compile.
fn without_tests(text: &str) -> String {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let code: String = code.flat_map(|line| [line, "\n"]).collect();
    let mut pieces = code.split("#[cfg(test)]");
    let mut kept = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find([';', '{']).unwrap_or(piece.len());
        match piece.as_bytes().get(end) {
            Some(b';') => kept.push_str(&piece[end..]),
            // Unit tests are the end of a file.
            _ if piece.starts_with("\nmod ") => break,
            _ => kept.push_str(&piece[end + block(&piece[end..])..]),
        }
    }
    kept
}

/// The length of the block that a text begins with.
fn block(text: &str) -> usize {
    let mut depth = 0_usize;
    for (at, character) in text.char_indices() {
        match character {
            '{' => depth += 1,
            '}' if depth == 1 => return at + 1,
            '}' => depth -= 1,
            _ => {}
        }
    }
    text.len()
}

/// The file that a path leads into: the longest part of it that is a module with a file.
fn file_of(path: &[String], files: &BTreeMap<Module, String>) -> Module {
    (0..=path.len())
        .rev()
        .map(|length| &path[..length])
        .find(|part| files.contains_key(*part))
        .map_or_else(Vec::new, <[String]>::to_vec)
}

/// The paths of the crate that the text of a module names: from `crate`, from the modules around it, and in groups.
pub(crate) fn paths(text: &str, module: &[String]) -> Vec<Module> {
    let mut found = Vec::new();
    for root in ["crate::", "super::", "self::"] {
        for (at, _) in text.match_indices(root) {
            let before = &text[..at];
            let continues = before.ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':');
            // Indented, it is an import of a module inside the file.
            if continues || root == "super::" && before.ends_with("    use ") {
                continue;
            }
            let (mut rest, mut base) = (&text[at..], if root == "crate::" { Vec::new() } else { module.to_vec() });
            while let Some(further) = rest.strip_prefix("super::") {
                (rest, _) = (further, base.pop());
            }
            let rest = rest.trim_start_matches("crate::").trim_start_matches("self::");
            found.extend(grouped(rest).iter().map(|path| base.iter().cloned().chain(names(path)).collect()));
        }
    }
    found
}

fn names(path: &str) -> impl Iterator<Item = String> {
    path.split("::").filter(|name| !name.is_empty()).map(str::to_owned)
}

/// The paths of the group, or the one path, that a text begins with.
fn grouped(text: &str) -> Vec<String> {
    let (mut found, mut groups, mut path) = (Vec::new(), Vec::<String>::new(), String::new());
    let mut renamed = false;
    for character in text.chars() {
        match character {
            '{' => groups.push(path.clone()),
            ',' | '}' => {
                renamed = false;
                found.push(std::mem::take(&mut path));
                let Some(group) = groups.last() else { break };
                path.clone_from(group);
                if character == '}' {
                    groups.pop();
                }
            }
            _ if character.is_whitespace() && groups.last().is_some() => {
                renamed = groups.last().is_some_and(|group| group.len() < path.len());
            }
            _ if renamed => {}
            ':' | '_' | 'a'..='z' | 'A'..='Z' | '0'..='9' => path.push(character),
            '*' => {}
            _ => break,
        }
    }
    found.push(path);
    // What follows a group is no path.
    found.retain(|path| !path.is_empty() && !path.ends_with(':'));
    found
}

/// The sets of more than one module that import each other, directly or through others.
pub(crate) fn circles(imports: &Imports) -> Vec<Vec<Module>> {
    let reached: BTreeMap<_, _> = imports.keys().map(|module| (module, reached_from(module, imports))).collect();
    let mut found: Vec<Vec<Module>> = Vec::new();
    for module in imports.keys().filter(|module| reached[module].contains(*module)) {
        if !found.iter().any(|circle| circle.contains(module)) {
            found.push(reached[module].iter().filter(|other| reached[other].contains(module)).cloned().collect());
        }
    }
    found
}

/// The modules that a module imports, directly or through others.
fn reached_from(module: &Module, imports: &Imports) -> Vec<Module> {
    let (mut found, mut waiting) = (Vec::new(), imports[module].clone());
    while let Some(next) = waiting.pop() {
        if !found.contains(&next) {
            waiting.extend(imports.get(&next).into_iter().flatten().cloned());
            found.push(next);
        }
    }
    found
}
