//! No circle of files: which file stands on which, read from the paths in the sources.
//!
//! A name counts for the file that defines it, through re-exports. A re-export makes a file stand on another only
//! where the file uses the name itself; what a macro lists as `file::Name` is re-exported too.

use std::collections::{BTreeMap, BTreeSet};

/// A module, as the names on the way from the root of the crate.
type Module = Vec<String>;

/// The files of a house: their modules and texts.
pub struct House {
    /// The file of each module, as the module it is the file of. Modules without a file lie in that of another.
    files: BTreeMap<Module, Module>,
    /// What each module re-exports or imports, by name: the full path.
    names: BTreeMap<(Module, String), Module>,
    /// What each file mentions: the full path.
    mentions: BTreeSet<(Module, Module)>,
}

/// Where a token stands.
struct Place<'a> {
    file: &'a Module,
    /// The module, which may be one within the file.
    module: &'a Module,
    /// Whether it is part of a macro.
    listed: bool,
}

/// The words and signs of a source, without comments and strings.
fn tokens(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if first == '"' {
            let mut escaped = false;
            let end = rest[1..].find(|c| {
                let ends = c == '"' && !escaped;
                escaped = c == '\\' && !escaped;
                ends
            });
            end.map_or(rest.len(), |end| end + 2)
        } else if first.is_alphanumeric() || first == '_' {
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
            let length = end.unwrap_or(rest.len());
            found.push(rest[..length].to_owned());
            length
        } else if rest.starts_with("::") {
            found.push("::".to_owned());
            2
        } else {
            if !first.is_whitespace() && first != '$' {
                found.push(first.to_string());
            }
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    found
}

/// The paths of a tree of imports, each with the name it is given; and the tokens that follow.
fn tree<'a>(tokens: &'a [String], stem: &[String], to: &mut Vec<(Module, String)>) -> &'a [String] {
    let mut path = stem.to_vec();
    let mut rest = tokens;
    loop {
        match rest {
            [open, inner @ ..] if open == "{" => {
                rest = inner;
                while rest[0] != "}" {
                    rest = tree(rest, &path, to);
                    if rest[0] == "," {
                        rest = &rest[1..];
                    }
                }
                return &rest[1..];
            }
            [name, colons, after @ ..] if colons == "::" => {
                path.push(name.clone());
                rest = after;
            }
            [name, renamed, alias, after @ ..] if renamed == "as" => {
                path.push(name.clone());
                to.push((path, alias.clone()));
                return after;
            }
            [name, after @ ..] => {
                if name != "*" && name != "self" {
                    path.push(name.clone());
                }
                let given = path.last().unwrap().clone();
                to.push((path, given));
                return after;
            }
            [] => return rest,
        }
    }
}

impl House {
    /// Of the texts of files, by their paths below `src` ("lib.rs", "warp/disk.rs").
    pub fn new(sources: &[(String, String)]) -> Self {
        let module_of = |path: &str| -> Module {
            let inside = path.strip_suffix(".rs").unwrap().split('/');
            inside.filter(|n| *n != "lib").map(str::to_owned).collect()
        };
        let modules: Vec<Module> = sources.iter().map(|(path, _)| module_of(path)).collect();
        let mut house = Self {
            files: modules.iter().map(|m| (m.clone(), m.clone())).collect(),
            names: BTreeMap::new(),
            mentions: BTreeSet::new(),
        };
        let texts: Vec<_> = sources.iter().map(|(_, text)| tokens(text)).collect();
        // Modules first, so that a path is known by where it begins.
        for (module, text) in modules.iter().zip(&texts) {
            house.walk(module, text, Self::inner_module);
        }
        for (module, text) in modules.iter().zip(&texts) {
            house.walk(module, text, Self::read);
        }
        house
    }

    /// Goes over the tokens of a file, with the module at each place.
    fn walk(
        &mut self,
        file: &Module,
        text: &[String],
        visit: impl Fn(&mut Self, &Place, &[String], &[String]) -> usize,
    ) {
        let mut open: Vec<Option<String>> = Vec::new();
        // How many braces are open around the macro that this is within.
        let mut macros: Option<usize> = None;
        let mut at = 0;
        while at < text.len() {
            let inner = open.iter().flatten().cloned();
            let module: Module = file.iter().cloned().chain(inner).collect();
            match &text[at..] {
                [word, name, brace, ..] if word == "mod" && brace == "{" => {
                    open.push(Some(name.clone()));
                    let here = Place {
                        file,
                        module: &module,
                        listed: false,
                    };
                    visit(self, &here, &text[..at], &text[at..]);
                    at += 3;
                }
                [brace, ..] if brace == "{" => {
                    open.push(None);
                    at += 1;
                }
                [brace, ..] if brace == "}" => {
                    open.pop();
                    macros = macros.filter(|outside| open.len() > *outside);
                    at += 1;
                }
                rest => {
                    if rest[0] == "macro_rules" {
                        macros = Some(open.len());
                    }
                    let here = Place {
                        file,
                        module: &module,
                        listed: macros.is_some(),
                    };
                    at += visit(self, &here, &text[..at], rest);
                }
            }
        }
    }

    /// Notes a module that has no file of its own.
    fn inner_module(&mut self, at: &Place, _: &[String], rest: &[String]) -> usize {
        if rest[0] == "mod" && rest[2] == "{" {
            let inner = at.module.iter().chain(&rest[1..2]).cloned().collect();
            self.files.insert(inner, at.file.clone());
        }
        1
    }

    /// Notes the path that begins here, if one does; and how many tokens it has.
    fn read(&mut self, at: &Place, before: &[String], rest: &[String]) -> usize {
        let Place {
            file,
            module,
            listed,
        } = *at;
        if rest[0] == "use" {
            let mut imports = Vec::new();
            let after = tree(&rest[1..], &[], &mut imports);
            let handed_on = matches!(before, [.., last] if last == "pub" || last == ")");
            let text: Vec<_> = before.iter().chain(after).collect();
            for (path, name) in imports {
                // A module may be called as the function that it defines.
                let used = |pair: &[&String]| pair[0] != "mod" && *pair[1] == name;
                if let Some(path) = self.absolute(module, &path) {
                    if !handed_on || text.windows(2).any(used) {
                        self.mentions.insert((file.clone(), path.clone()));
                    }
                    self.names.insert((module.clone(), name), path);
                }
            }
            return rest.len() - after.len();
        }
        // A path goes on, or says where something is visible.
        let continues = matches!(before, [.., last] if last == "::")
            || matches!(before, [.., open, last] if open == "(" && last == "in");
        let words = rest
            .chunks(2)
            .take_while(|pair| pair.len() == 2 && pair[1] == "::");
        let length = words.count();
        if length == 0 || continues {
            return 1;
        }
        let path: Module = rest.iter().step_by(2).take(length + 1).cloned().collect();
        let Some(full) = self.absolute(module, &path) else {
            return 2 * length;
        };
        match &path[..] {
            [_, name] if listed && full.len() == module.len() + 2 => {
                self.names.insert((module.clone(), name.clone()), full);
            }
            _ => {
                self.mentions.insert((file.clone(), full));
            }
        }
        2 * length
    }

    /// The path from the root; nothing for one into another crate.
    fn absolute(&self, module: &Module, path: &[String]) -> Option<Module> {
        let mut from = module.clone();
        let mut rest = path;
        match rest.first()?.as_str() {
            "crate" => {
                from.clear();
                rest = &rest[1..];
            }
            "self" => rest = &rest[1..],
            "super" => {
                while rest.first().is_some_and(|name| name == "super") {
                    from.pop();
                    rest = &rest[1..];
                }
            }
            name => {
                from.push(name.to_owned());
                self.files.get(&from)?;
                from.pop();
            }
        }
        from.extend(rest.iter().cloned());
        Some(from)
    }

    /// The file that defines what a path names.
    fn definition(&self, path: &[String]) -> &Module {
        let mut module = Module::new();
        for (i, name) in path.iter().enumerate() {
            module.push(name.clone());
            if self.files.contains_key(&module) {
                continue;
            }
            module.pop();
            if let Some(source) = self.names.get(&(module.clone(), name.clone())) {
                let further: Module = source.iter().chain(&path[i + 1..]).cloned().collect();
                return self.definition(&further);
            }
            break;
        }
        &self.files[&module]
    }

    /// Which file stands on which.
    pub fn edges(&self) -> BTreeSet<(String, String)> {
        let name = |module: &Module| module.join("/");
        let edges = self
            .mentions
            .iter()
            .map(|(file, path)| (file, self.definition(path)));
        edges
            .filter(|(file, on)| file != on)
            .map(|(file, on)| (name(file), name(on)))
            .collect()
    }

    /// The files that stand on themselves by way of others, in groups that stand on one another.
    pub fn circles(&self) -> Vec<Vec<String>> {
        let edges = self.edges();
        let mut below: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for (file, on) in &edges {
            below.entry(file).or_default().insert(on);
        }
        // All that a file stands on, by however many steps.
        let reach = |start: &str| {
            let mut seen: BTreeSet<&str> = BTreeSet::new();
            let mut open: Vec<&str> = below.get(start).into_iter().flatten().copied().collect();
            while let Some(file) = open.pop() {
                if seen.insert(file) {
                    open.extend(below.get(file).into_iter().flatten());
                }
            }
            seen
        };
        let reached: BTreeMap<&str, _> = below.keys().map(|file| (*file, reach(file))).collect();
        let mut circles: Vec<Vec<String>> = Vec::new();
        for (file, on) in &reached {
            if on.contains(file) {
                let together = on
                    .iter()
                    .filter(|o| reached.get(*o).is_some_and(|r| r.contains(file)));
                let circle: Vec<String> = together.map(|o| (*o).to_owned()).collect();
                if !circles.contains(&circle) {
                    circles.push(circle);
                }
            }
        }
        circles
    }
}
