//! The table of the equations on the page of the explorer.

use crate::escaped;
use beamgap_explorer::EquationCells;
use serde_json::Value;
use std::error::Error;
use std::fmt::Write;

/// The table, with the numbers of the standard case.
///
/// # Errors
/// A record that does not fit the cells.
pub(crate) fn rows(equations: &Value, cells: &[EquationCells]) -> Result<String, Box<dyn Error>> {
    let mut rows = String::new();
    for row in equations["equations"].as_array().ok_or("equations.json has no equations")? {
        let (Some(number), Some(says), Some(verdict)) =
            (row["number"].as_u64(), row["says"].as_str(), row["verdict"].as_str())
        else {
            return Err("an equation has no number, words or verdict".into());
        };
        let cell =
            cells.iter().find(|cell| u64::from(cell.number) == number).ok_or("an equation is missing")?;
        let class = if verdict == "misprint" { "bad" } else { "good" };
        write!(
            rows,
            "<tr data-equation=\"{number}\"><th scope=\"row\"><a href=\"derivation.html#eq-{number}\">({number})</a></th>\
             <td class=\"words\">{}</td><td class=\"{class}\">{}</td>",
            escaped(says),
            verdict.replace('-', " ")
        )?;
        for (name, text) in [
            ("formula", &cell.formula),
            ("hyper_dual", &cell.hyper_dual),
            ("digits", &cell.digits),
            ("printed", &cell.printed),
        ] {
            write!(rows, "<td data-cell=\"{name}\">{}</td>", escaped(text))?;
        }
        rows += "</tr>\n";
    }
    let heads = [
        "equation",
        "what it says",
        "verdict",
        "formula, corrected",
        "hyper-dual",
        "digits",
        "digits of the print",
    ];
    let heads = heads.map(|head| format!("<th scope=\"col\">{head}</th>")).concat();
    Ok(format!(
        "<div class=\"wide\"><table><thead><tr>{heads}</tr></thead><tbody>\n{rows}</tbody></table></div>\n"
    ))
}
