//! Mutation testing of the kit: which changes of its code no test notices.
//!
//! A change needs a build of minutes where it is tried by itself. Here all changes are in one program,
//! each behind a switch that a variable of the environment turns on, and a change is tried only with the
//! tests that reach it.

pub mod blame;
pub mod compile;
pub mod error;
pub mod judge;
pub mod lines;
pub mod mutant;
pub mod mutant_switch;
pub mod outcomes;
pub mod pool;
pub mod process;
pub mod programs;
pub mod project;
pub mod reach;
pub mod records;
pub mod report;
pub mod rewrite;
pub mod sites;
pub mod tree;
