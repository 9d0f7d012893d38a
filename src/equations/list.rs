//! The equations that are lists, (16), (17) and (22), and the terms that they omit.

/// The variations of a quantity, as the paper prints them.
const VARIATIONS: [&str; 3] = [r"\delta", r"\Delta", r"\Delta\delta"];
/// The variables of (15).
const VARIABLES: [&str; 3] = ["g_N", "g_T", r"\bar{g}_T"];

/// The terms that the list with this number omits, given the LaTeX of (16), (17) or (22); none for other equations.
pub(super) fn omitted(number: u8, printed: &str) -> Vec<String> {
    let printed = printed.replace(r"\ ", "").replace("\\\n", "").replace([' ', '\n'], "");
    let terms: Vec<&str> = printed.split(',').collect();
    let named = |term: &str| match number {
        16 => terms.contains(&term),
        // A barred term and a term with Δ are represented by the other term of their pair.
        17 => {
            let twin = term.replace(r"\bar{g}_T", "g_T");
            let twin = if twin.contains(r"\delta") { twin } else { twin.replace(r"\Delta", r"\delta") };
            terms.contains(&twin.as_str())
        }
        // All terms of (17), each with an arrow to the terms that it needs.
        22 => {
            term.contains("bar")
                || !term.contains(r"\delta")
                || printed.contains(&format!(r"{term}\Rightarrow"))
        }
        _ => true,
    };
    let all =
        VARIABLES.iter().flat_map(|variable| VARIATIONS.map(|variation| format!("{variation}{variable}")));
    all.filter(|term| !named(&term.replace(' ', ""))).collect()
}
