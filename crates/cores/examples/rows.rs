//! A program for Linux on AArch64 without a library: it prints the rows of `tests/golden/golden.csv`, which `.ci/cross` compares.
#![no_std]
#![no_main]
#![allow(unsafe_code)]

use core::fmt::{self, Write};
use core::panic::PanicInfo;
use microwarp_list::{cases, describe, evaluate};

/// A call of the system: `write` is 64, `exit` 93.
fn call(number: usize, arguments: [usize; 3]) -> usize {
    let [first, second, third] = arguments;
    let result;
    #[cfg(target_arch = "aarch64")]
    // SAFETY: the system reads the bytes that it is told to write, and changes none.
    unsafe {
        core::arch::asm!(
            "svc 0",
            in("x8") number,
            inlateout("x0") first => result,
            in("x1") second,
            in("x2") third,
            options(nostack, readonly)
        );
    }
    #[cfg(not(target_arch = "aarch64"))]
    {
        result = number ^ first ^ second ^ third;
    }
    result
}

fn exit(status: usize) -> ! {
    loop {
        call(93, [status, 0, 0]);
    }
}

/// A row, which is printed in one piece.
struct Row {
    bytes: [u8; 256],
    len: usize,
}

impl Write for Row {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let end = self.len + text.len();
        let place = self.bytes.get_mut(self.len..end).ok_or(fmt::Error)?;
        place.copy_from_slice(text.as_bytes());
        self.len = end;
        Ok(())
    }
}

fn print(index: usize) -> fmt::Result {
    let mut words = [0; 16];
    let len = evaluate(index, &mut words);
    let (name, input, tier) = describe(index);
    let mut row = Row {
        bytes: [0; 256],
        len: 0,
    };
    write!(row, "{tier} {name} #{input}")?;
    for word in words.iter().take(len) {
        write!(row, ",{word:08x}")?;
    }
    writeln!(row)?;
    let written = call(64, [1, row.bytes.as_ptr().addr(), row.len]);
    if written == row.len {
        Ok(())
    } else {
        Err(fmt::Error)
    }
}

#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    let printed = (0..cases()).try_for_each(print);
    exit(printed.is_err().into())
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    exit(2)
}
