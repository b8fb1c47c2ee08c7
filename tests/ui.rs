//! Mistakes as a user sees them: what the compiler prints, in full. One file per kind of mistake in `tests/ui`.
//!
//! Line, column and wording of every single message stand in a faster table beside the generator. The texts here change
//! with the compiler, whose version is pinned.

#[test]
fn mistakes_are_explained() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
