//! The tests that the check prints compile and pass.

include!("../golden/pasted.rs");
