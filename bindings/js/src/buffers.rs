//! The two buffers through which the caller's numbers pass, and the generator in front of them. Their length is known here, so
//! that no count of a caller leads beyond them.

use microwarp_js_hot::Pcg32;

/// The numbers of a buffer.
pub const BLOCK: usize = 8192;

/// As they lie in memory; the caller says where.
#[repr(C)]
pub struct Buffers {
    pub rng: Pcg32,
    apart: [u32; 60],
    pub input: [u32; BLOCK],
    pub output: [u32; BLOCK],
}

/// Where something comes from and goes to, and how far apart two elements lie.
pub struct Arrays {
    pub input: *const f32,
    pub output: *mut f32,
    pub inputs: usize,
    pub outputs: usize,
    pub count: usize,
}

impl Buffers {
    /// Draws so many words to the input.
    pub fn random(&mut self, words: usize) {
        if let Some(words) = self.input.get_mut(..words) {
            self.rng.fill(words);
        }
    }

    /// So many numbers of the input.
    pub fn input(&mut self, count: usize) -> &mut [u32] {
        self.input.get_mut(..count).unwrap_or_default()
    }

    /// Elements of so many numbers; none where the buffers do not hold them.
    pub fn arrays(&mut self, inputs: usize, outputs: usize, count: usize) -> Arrays {
        let hold = |each: usize| each.checked_mul(count).is_some_and(|all| all <= BLOCK);
        Arrays {
            input: self.input.as_ptr().cast(),
            output: self.output.as_mut_ptr().cast(),
            inputs,
            outputs,
            count: if hold(inputs) && hold(outputs) {
                count
            } else {
                0
            },
        }
    }
}

impl Arrays {
    /// The arrays behind their first element.
    pub fn next(&mut self) {
        self.input = self.input.wrapping_add(self.inputs);
        self.output = self.output.wrapping_add(self.outputs);
        self.count = self.count.wrapping_sub(1);
    }
}
