//! A plugin of QEMU that counts what the calls of a kernel of `crates/cores` take: instructions, and cycles by the
//! manuals' tables. `decode.rs` reads instructions, `timing.rs` has the tables, `tally.rs` sums over calls.
//!
//! ```text
//! qemu-system-arm ... -plugin libmicrowarp_cores_counter.so,core=m0,image=FILE,out=FILE
//! ```
//!
//! QEMU translates rows of instructions without a branch inside, and says which row is executed. So a row is summed
//! once for each way of arriving at it, and where the next one begins tells whether its branch was taken.

pub mod decode;
mod tally;
pub mod timing;

use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::sync::Mutex;
use tally::{Row, Tally};

// The interface of QEMU 7.2, as far as it is used (its documentation: "QEMU TCG Plugins").
type Id = u64;
#[repr(C)]
struct QemuRow(c_void);
#[repr(C)]
struct QemuInstruction(c_void);

unsafe extern "C" {
    fn qemu_plugin_register_vcpu_tb_trans_cb(id: Id, translated: extern "C" fn(Id, *mut QemuRow));
    fn qemu_plugin_register_vcpu_tb_exec_cb(
        row: *mut QemuRow,
        executed: extern "C" fn(c_uint, *mut c_void),
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_register_atexit_cb(
        id: Id,
        ended: extern "C" fn(Id, *mut c_void),
        data: *mut c_void,
    );
    fn qemu_plugin_tb_n_insns(row: *const QemuRow) -> usize;
    fn qemu_plugin_tb_get_insn(row: *const QemuRow, index: usize) -> *mut QemuInstruction;
    fn qemu_plugin_insn_data(one: *const QemuInstruction) -> *const u8;
    fn qemu_plugin_insn_size(one: *const QemuInstruction) -> usize;
    fn qemu_plugin_insn_vaddr(one: *const QemuInstruction) -> u64;
}

/// The version of that interface.
#[unsafe(no_mangle)]
pub static qemu_plugin_version: c_int = 1;

/// What is counted, and where the figures go.
static COUNTED: Mutex<Option<(Tally, String)>> = Mutex::new(None);

fn with(action: impl FnOnce(&mut Tally) -> Result<(), String>) {
    let mut counted = COUNTED
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    let outcome = counted.as_mut().map_or(Ok(()), |(tally, _)| action(tally));
    drop(counted);
    if let Err(error) = outcome {
        eprintln!("{error}");
        std::process::abort();
    }
}

/// QEMU calls this when it loads the plugin.
///
/// # Safety
/// `arguments` has `count` strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn qemu_plugin_install(
    id: Id,
    _: *const c_void,
    count: c_int,
    arguments: *const *const c_char,
) -> c_int {
    // SAFETY: QEMU's arguments, which end in a zero.
    let texts = (0..count as usize).map(|i| {
        unsafe { CStr::from_ptr(*arguments.add(i)) }
            .to_string_lossy()
            .into_owned()
    });
    let texts: Vec<String> = texts.collect();
    let value = |key: &str| {
        let found = texts
            .iter()
            .find_map(|text| text.strip_prefix(key)?.strip_prefix('=').map(String::from));
        found.ok_or_else(|| format!("which {key}?"))
    };
    let tally = || {
        Ok::<_, String>((
            Tally::new(&value("core")?, &value("image")?)?,
            value("out")?,
        ))
    };
    match tally() {
        Ok(tally) => {
            *COUNTED
                .lock()
                .unwrap_or_else(|poisoned| poisoned.into_inner()) = Some(tally)
        }
        Err(error) => {
            eprintln!("{error}");
            return 1;
        }
    }
    // SAFETY: the functions live as long as the plugin.
    unsafe {
        qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
        qemu_plugin_register_atexit_cb(id, ended, std::ptr::null_mut());
    }
    0
}

extern "C" fn translated(_: Id, row: *mut QemuRow) {
    // SAFETY: QEMU lends the row, its instructions and their bytes for this call.
    let code: Vec<(u32, &[u8])> = unsafe {
        (0..qemu_plugin_tb_n_insns(row))
            .map(|i| qemu_plugin_tb_get_insn(row, i))
            .map(|one| {
                let bytes = std::slice::from_raw_parts(
                    qemu_plugin_insn_data(one),
                    qemu_plugin_insn_size(one),
                );
                (qemu_plugin_insn_vaddr(one) as u32, bytes)
            })
            .collect()
    };
    with(|tally| {
        let known = Box::leak(Box::new(tally.read(&code)));
        // SAFETY: the row that was lent; what is leaked is there for ever.
        unsafe {
            qemu_plugin_register_vcpu_tb_exec_cb(row, executed, 0, std::ptr::from_mut(known).cast())
        };
        Ok(())
    });
}

extern "C" fn executed(_: c_uint, row: *mut c_void) {
    // SAFETY: what `translated` has leaked, and the one processor does one thing at a time.
    let row = unsafe { &mut *row.cast::<Row>() };
    with(|tally| tally.execute(row));
}

extern "C" fn ended(_: Id, _: *mut c_void) {
    let counted = COUNTED
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner())
        .take();
    if let Some((tally, file)) = counted {
        if let Err(error) = tally
            .report()
            .and_then(|text| std::fs::write(&file, text).map_err(|e| e.to_string()))
        {
            eprintln!("{error}");
        }
    }
}
