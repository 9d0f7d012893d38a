//! What the gate prints as a test is one: it compiles, and it is green.

include!("../golden/pasted.rs");
