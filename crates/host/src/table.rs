//! Tables on the terminal, as Markdown that a README can take over.

use comfy_table::{CellAlignment, Table, presets};

/// A table whose columns are aligned to the right, but for so many.
pub fn print(header: &[&str], rows: Vec<Vec<String>>, left: usize) {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN);
    table.set_header(header.to_vec());
    table.add_rows(rows);
    for column in table.column_iter_mut().skip(left) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    println!("{table}\n");
}

/// A p-value, in scientific notation where it is extreme.
pub fn p_text(p: f64) -> String {
    match p {
        0.0 => "< 1e-300".into(),
        p if p < 1e-3 => format!("{p:.1e}"),
        p => format!("{p:.3}"),
    }
}
