//! Texts that leave the program: hostile words in every written format, and formulas read back.

mod html;
mod round_trips;
mod written;
