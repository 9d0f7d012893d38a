//! Properties of the library, one module an object; inputs come from [`strategies`].

mod jets;
mod numbers;
mod scalars;
mod strategies;
