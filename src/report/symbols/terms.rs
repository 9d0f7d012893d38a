//! The terms of the reports: contact, the reasons not to compare, and the other words.

pub(super) const CONTACT: [(&str, &str); 7] = [
    (
        "bar beam",
        "the second beam of the pair; other codes call the two slave and master, or beam 1 and beam 2",
    ),
    ("centroid", "the curve of the cross-section centres; a beam is this curve with a radius"),
    ("slip", "the tangential gap g_T of friction: t times the parameter increment since first contact"),
    (
        "frozen projection",
        "a tangent with fixed closest points: the motion of the closest points is left out",
    ),
    ("held", "a parameter at an end of its beam, where the closest point stays; it does not vary"),
    ("family", "a type of curve with its dofs, such as `hermite` or `bspline`"),
    ("jet", "a point of a curve with its derivatives by the parameter and by the dofs"),
];

pub(super) const NOT_COMPARED: [(&str, &str); 10] = [
    (
        "kink: a parameter just leaves an end",
        "the multiplier of the constraint is zero to rounding, so only one-sided derivatives exist",
    ),
    (
        "crossing centroids: d = 0 to rounding",
        "the distance is not differentiable there; the library returns derivatives of the signed distance, which are not compared",
    ),
    (
        "nearly parallel: the search left regions open",
        "regions remain that may contain a closest point; also called unresolved",
    ),
    ("singular: D = 0 to rounding", "the closest points do not depend smoothly on the dofs"),
    ("a tangent has no length", "t = 0 or t_bar = 0 to rounding"),
    ("the search for closest points failed", "the search ended with an error, such as a zero tangent"),
    (
        "the closest point is not known well enough",
        "Newton's method in double-double encloses no point that is accurate enough",
    ),
    (
        "the rounding bound exceeds 1e-3 of a scale",
        "the tolerance is larger than a thousandth of the sum of the absolute values of the terms; also called not meaningful",
    ),
    (
        "overflow or underflow: beyond the range of f64",
        "a number or a product in its computation is not representable",
    ),
    ("degenerate", "a closest point with one of the other reasons, in answers of programs"),
];

pub(super) const TERMS: [(&str, &str); 21] = [
    (
        "adapter",
        "a small program that reads the exported cases, calls the code of a user, and writes its answers",
    ),
    (
        "chord",
        "Newton's method with a fixed matrix: one step gives all derivatives of d, two steps those of all quantities",
    ),
    ("double-double", "a number stored as the sum of two `f64`, with about 32 decimal digits"),
    ("equivalent formula", "a formula that is written in another way and has the same value"),
    ("fault", "a term or an operation that is made wrong on purpose"),
    ("gate", "`beamgap check`: closed form against automatic differentiation in `f64`"),
    ("golden file", "a file with the expected output of a test"),
    ("hyper-dual number", "a number with two directions: it contains value, delta, Delta and Delta-delta"),
    ("kernel", "the fast code for gradients and Hessians, in vector arithmetic"),
    ("lanes", "the numbers of one vector register: here four pairs are computed at once"),
    (
        "layout",
        "how a Hessian is stored: its blocks on and above the diagonal, the full matrix, or packed: the entries on and above the \
         diagonal",
    ),
    ("lift", "to give the closest point its derivatives by the dofs"),
    (
        "layer",
        "what `prove` compares: values, first and second variations, matrices contracted with the directions, and the kernel",
    ),
    (
        "oracle, reference",
        "a method whose number is compared with that of the closed form: automatic differentiation, and as the third oracle \
         central differences in double-double",
    ),
    (
        "prime field",
        "the integers modulo the prime 2^61 - 1: nothing is rounded, so two formulas are equal or not",
    ),
    (
        "routes of automatic differentiation",
        "hyper-dual, Newton: by num-dual through Newton's iteration; hyper-dual, stationary: by num-dual at the stationary point; \
         own hyper-dual, chord: by the numbers of this crate with two chord steps",
    ),
    ("roofline bound", "the least time that the arithmetic or the stores of a method take on the machine"),
    ("scale", "the sum of the absolute values of the terms of a number"),
    ("tolerance of check", "the sum of the rounding bounds of the two numbers that are compared"),
    (
        "tolerance of verify",
        "8 times the rounding bound of the textbook formulas, and the bounds of the closest point and of the reference",
    ),
    ("ulp", "the distance of two neighbouring floating-point numbers"),
];
