//! Mistakes as a user sees them: what the compiler prints, in full. One file per kind of mistake, in folders by subject.
//!
//! Line, column and wording of every single message stand in a faster table beside the generator. The texts here change
//! with the compiler, whose version is pinned. It is a package of its own, because trybuild builds all dependencies of the one
//! that it is called from a second time: here the crates that users have, and nothing else.

#[test]
fn mistakes_are_explained() {
    trybuild::TestCases::new().compile_fail("cases/*/*.rs");
}
