//! Pictures: a canvas, text, axes, panels and colours.

pub mod canvas;
pub mod colour;
pub mod panel;
pub mod plot;
pub mod scale;
pub mod text;
