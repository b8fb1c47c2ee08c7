//! The public items of `integrator-core`, with their signatures, as reviewed text: what programs of users compile
//! against changes deliberately or not at all.
//!
//! Comes in: the sources, from `lib.rs` on. Goes out: every item that is exported, without bodies, documentation and
//! private parts. Items that macros write are not seen, but for the names of compositions.

use quote::ToTokens;
use std::{collections::BTreeSet, fs, path::Path};
use syn::{Fields, ImplItem, Item, TraitItem, Type, UseTree, Visibility};

#[path = "support/kept.rs"]
mod kept;

use kept::assert_kept;

/// The items at the top of every file of a folder, without those of unit tests.
fn items(folder: &Path) -> Vec<Item> {
    let mut entries: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    let mut found = Vec::new();
    for path in entries {
        if path.is_dir() {
            found.extend(items(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.extend(file(&path));
        }
    }
    found
}

fn file(path: &Path) -> Vec<Item> {
    let text = fs::read_to_string(path).expect("text");
    syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display())).items
}

/// The names that `pub use` gives to the outside, those of `*` left out.
fn exported(items: &[Item]) -> BTreeSet<String> {
    fn names(tree: &UseTree, into: &mut BTreeSet<String>) {
        match tree {
            UseTree::Path(path) => names(&path.tree, into),
            UseTree::Name(name) => into.extend([name.ident.to_string()]),
            UseTree::Rename(rename) => into.extend([rename.rename.to_string()]),
            UseTree::Glob(_) => {}
            UseTree::Group(group) => group.items.iter().for_each(|tree| names(tree, into)),
        }
    }
    let mut found = BTreeSet::new();
    for item in items {
        if let Item::Use(item) = item
            && is_public(&item.vis)
        {
            names(&item.tree, &mut found);
        }
    }
    found
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The items in a module that is written in place.
fn inside(items: &[Item], name: &str) -> Vec<Item> {
    let content = items.iter().find_map(|item| match item {
        Item::Mod(module) if module.ident == name => module.content.as_ref(),
        _ => None,
    });
    content.unwrap_or_else(|| panic!("no module {name}")).1.clone()
}

/// What attributes say to users: whether they may match exhaustively, and whether they have to look at the value.
fn of_use(attributes: &mut Vec<syn::Attribute>) {
    attributes.retain(|attribute| {
        ["derive", "must_use", "non_exhaustive"].iter().any(|kept| attribute.path().is_ident(kept))
    });
}

fn without_private(fields: &mut Fields) {
    if let Fields::Named(fields) = fields {
        let public = std::mem::take(&mut fields.named).into_iter().filter(|field| is_public(&field.vis));
        fields.named = public.collect();
    }
    fields.iter_mut().for_each(|field| of_use(&mut field.attrs));
}

fn nothing() -> syn::Block {
    syn::parse_quote!({})
}

/// An item as its users see it, if its name is one of those exported.
fn seen(item: &Item, exported: &BTreeSet<String>) -> Option<(String, Item)> {
    let mut item = item.clone();
    let name = match &mut item {
        Item::Struct(item) if is_public(&item.vis) => {
            of_use(&mut item.attrs);
            without_private(&mut item.fields);
            item.ident.to_string()
        }
        Item::Enum(item) if is_public(&item.vis) => {
            of_use(&mut item.attrs);
            for variant in &mut item.variants {
                of_use(&mut variant.attrs);
                variant.fields.iter_mut().for_each(|field| of_use(&mut field.attrs));
            }
            item.ident.to_string()
        }
        Item::Fn(item) if is_public(&item.vis) => {
            of_use(&mut item.attrs);
            *item.block = nothing();
            item.sig.ident.to_string()
        }
        Item::Trait(item) if is_public(&item.vis) => {
            of_use(&mut item.attrs);
            item.items.iter_mut().for_each(of_trait);
            item.ident.to_string()
        }
        Item::Impl(item) => {
            of_use(&mut item.attrs);
            item.items.retain_mut(|inner| of_impl(inner, item.trait_.is_some()));
            let Type::Path(path) = &*item.self_ty else { return None };
            let owner = path.path.segments.last()?.ident.to_string();
            if item.trait_.is_none() && item.items.is_empty() {
                return None;
            }
            owner
        }
        _ => return None,
    };
    exported.contains(&name).then_some((name, item))
}

fn of_trait(item: &mut TraitItem) {
    match item {
        TraitItem::Fn(function) => {
            of_use(&mut function.attrs);
            function.default = function.default.as_ref().map(|_| nothing());
        }
        TraitItem::Const(constant) => of_use(&mut constant.attrs),
        TraitItem::Type(kind) => of_use(&mut kind.attrs),
        _ => {}
    }
}

/// Strips what is in an impl; of traits, the head alone tells what it is.
fn of_impl(item: &mut ImplItem, of_trait: bool) -> bool {
    match item {
        ImplItem::Fn(function) if !of_trait && is_public(&function.vis) => {
            of_use(&mut function.attrs);
            function.block = nothing();
            true
        }
        ImplItem::Const(constant) if !of_trait && is_public(&constant.vis) => {
            of_use(&mut constant.attrs);
            true
        }
        _ => false,
    }
}

/// The compositions that macros declare in the catalogue.
fn compositions(items: &[Item]) -> BTreeSet<String> {
    let declared = items.iter().filter_map(|item| match item {
        Item::Macro(call) if call.mac.path.is_ident("composition") => Some(call.mac.tokens.to_string()),
        _ => None,
    });
    let names = declared.flat_map(|text| {
        text.split("pub struct ")
            .skip(1)
            .filter_map(|rest| rest.split([' ', ':']).next().map(str::to_owned))
            .collect::<Vec<_>>()
    });
    names.collect()
}

fn listed(names: &BTreeSet<String>) -> String {
    names.iter().map(|name| format!("    {name}\n")).collect()
}

#[test]
fn public_items() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("integrator-core/src");
    let root = file(&source.join("lib.rs"));
    let [check, output, taylor] =
        ["check", "output", "methods/taylor"].map(|module| exported(&file(&source.join(module).join("mod.rs"))));
    let mut names = exported(&root);
    names.extend(check.iter().chain(&output).chain(&taylor).cloned());
    let mut found: Vec<(String, Item)> = items(&source).iter().filter_map(|item| seen(item, &names)).collect();
    // Its names are words that private items have as well.
    let orbit = exported(&file(&source.join("orbit/mod.rs")));
    found.extend(items(&source.join("orbit")).iter().filter_map(|item| seen(item, &orbit)));
    // Heads of impls after the item that they belong to, in the order of their text.
    found.sort_by_cached_key(|(name, item)| {
        (name.clone(), matches!(item, Item::Impl(_)), item.to_token_stream().to_string())
    });
    let items = found.into_iter().map(|(_, item)| item).collect();
    let shown = prettyplease::unparse(&syn::File { shebang: None, frontmatter: None, attrs: Vec::new(), items });
    let text = format!(
        "compositions:\n{}\nprelude:\n{}\ncheck:\n{}\norbit:\n{}\noutput:\n{}\ntaylor:\n{}\nitems:\n\n{shown}",
        listed(&compositions(&self::items(&source.join("composition/catalogue")))),
        listed(&exported(&inside(&root, "prelude"))),
        listed(&check),
        listed(&orbit),
        listed(&output),
        listed(&taylor),
    );
    assert_kept(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/public_items.txt"), &text);
}
