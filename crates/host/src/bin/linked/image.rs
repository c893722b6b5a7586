//! What is in a linked file: the bytes of its sections and the names in its symbol table. ELF of 32 bits and WASM.

use microwarp_host::upkeep::Outcome;
use std::path::Path;

#[derive(Default)]
pub struct Image {
    sections: Vec<(String, u64)>,
    /// Functions and data. Of WASM, the functions in its section of names.
    pub names: Vec<String>,
    /// Of ELF: the halfwords of Thumb code, without the constants between.
    pub code: Vec<u16>,
    /// Of WASM: everything but what is there for people, and how many functions there are.
    wasm: Option<(u64, usize)>,
}

impl Image {
    pub fn read(path: &Path) -> Outcome<Self> {
        let bytes = std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()))?;
        let image = match bytes.get(..4) {
            Some(b"\x7fELF") => elf(&bytes),
            Some(b"\0asm") => wasm(&bytes),
            _ => None,
        };
        image.ok_or_else(|| format!("{}: no ELF of 32 bits, nor WASM with names", path.display()))
    }

    /// Bytes of some sections together.
    pub fn bytes(&self, sections: &[&str]) -> u64 {
        let wanted = |(name, _): &&(String, u64)| sections.contains(&name.as_str());
        self.sections
            .iter()
            .filter(wanted)
            .map(|(_, size)| size)
            .sum()
    }

    pub fn ram(&self) -> u64 {
        self.bytes(&[".data", ".bss", ".uninit"])
    }

    /// Bytes in flash or of a module, and how many symbols or functions.
    pub fn size(&self) -> (u64, usize) {
        let flash = [
            ".vectors",
            ".vector_table",
            ".text",
            ".rodata",
            ".data",
            ".gnu.sgstubs",
        ];
        self.wasm.unwrap_or((self.bytes(&flash), self.names.len()))
    }
}

fn half(bytes: &[u8], at: usize) -> Option<usize> {
    Some(u16::from_le_bytes(bytes.get(at..at + 2)?.try_into().ok()?).into())
}

fn word(bytes: &[u8], at: usize) -> Option<usize> {
    Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?) as usize)
}

/// The text at an offset into a table of strings, up to its end.
fn string(table: &[u8], at: usize) -> Option<String> {
    let rest = table.get(at..)?;
    let end = rest.iter().position(|&byte| byte == 0)?;
    Some(String::from_utf8_lossy(&rest[..end]).into_owned())
}

/// The symbol table is what LTO and the collection of sections have left. Debug sections are not symbols and play no
/// part; `$t` and `$d` mark code and data.
fn elf(bytes: &[u8]) -> Option<Image> {
    const FUNCTION_OR_DATA: usize = 2;
    const SYMTAB: usize = 2;
    const NOBITS: usize = 8;
    let (table, size, count) = (word(bytes, 32)?, half(bytes, 46)?, half(bytes, 48)?);
    let header = |i: usize, field: usize| word(bytes, table + i * size + 4 * field);
    let content = |i: usize| match header(i, 1)? {
        NOBITS => Some(&[][..]),
        _ => bytes.get(header(i, 4)?..header(i, 4)? + header(i, 5)?),
    };
    let titles = content(half(bytes, 50)?)?;
    let mut image = Image::default();
    // Where code and data begin, by section.
    let mut marks: Vec<(usize, usize, bool)> = Vec::new();
    for i in 0..count {
        let name = string(titles, header(i, 0)?)?;
        image.sections.push((name, header(i, 5)? as u64));
        if header(i, 1)? != SYMTAB {
            continue;
        }
        let strings = content(header(i, 6)?)?;
        for symbol in content(i)?.chunks_exact(16) {
            let name = string(strings, word(symbol, 0)?)?;
            let kind = usize::from(symbol[12] & 15);
            if matches!(name.get(..2), Some("$t" | "$d")) {
                marks.push((half(symbol, 14)?, word(symbol, 4)?, name.starts_with("$t")));
            }
            if kind <= FUNCTION_OR_DATA && !name.is_empty() && !name.starts_with('$') {
                image.names.push(name);
            }
        }
    }
    marks.sort_unstable();
    for (mark, next) in marks
        .iter()
        .zip(marks.iter().skip(1).map(Some).chain([None]))
    {
        let &(section, start, true) = mark else {
            continue;
        };
        let (bytes, origin) = (content(section)?, header(section, 3)?);
        let end = next
            .filter(|next| next.0 == section)
            .map_or(origin + bytes.len(), |next| next.1);
        let code = bytes.get(start - origin..end - origin)?.chunks_exact(2);
        image
            .code
            .extend(code.map(|half| u16::from_le_bytes([half[0], half[1]])));
    }
    Some(image)
}

/// The number at the start, seven bits a byte, and what follows.
fn number(bytes: &[u8]) -> Option<(usize, &[u8])> {
    let mut value = 0;
    for (i, byte) in bytes.iter().enumerate().take(5) {
        value |= usize::from(byte & 127) << (7 * i);
        if byte & 128 == 0 {
            return Some((value, &bytes[i + 1..]));
        }
    }
    None
}

/// What has its length in front, and what follows.
fn counted(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let (length, rest) = number(bytes)?;
    rest.split_at_checked(length)
}

fn wasm(bytes: &[u8]) -> Option<Image> {
    const CUSTOM: u8 = 0;
    const FUNCTION: u8 = 3;
    const FUNCTION_NAMES: u8 = 1;
    let (mut rest, mut size, mut functions, mut names) = (bytes.get(8..)?, 8, 0, None);
    while let [kind, after @ ..] = rest {
        let (content, next) = counted(after)?;
        if *kind != CUSTOM {
            size += rest.len() - next.len();
        }
        if *kind == FUNCTION {
            functions = number(content)?.0;
        }
        if *kind == CUSTOM {
            let (title, mut part) = counted(content)?;
            while let (b"name", [kind, after @ ..]) = (title, part) {
                let (content, next) = counted(after)?;
                if *kind == FUNCTION_NAMES {
                    names = Some(function_names(content)?);
                }
                part = next;
            }
        }
        rest = next;
    }
    Some(Image {
        names: names?,
        wasm: Some((size as u64, functions)),
        ..Image::default()
    })
}

fn function_names(bytes: &[u8]) -> Option<Vec<String>> {
    let (count, mut rest) = number(bytes)?;
    let mut names = Vec::new();
    for _ in 0..count {
        let (name, next) = counted(number(rest)?.1)?;
        names.push(String::from_utf8_lossy(name).into_owned());
        rest = next;
    }
    Some(names)
}
