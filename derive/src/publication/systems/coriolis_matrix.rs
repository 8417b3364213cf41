//! Reading of the matrix C of M(q) q̈ + C(q, q̇) q̇ + g(q) = τ as entries that can be judged.
//!
//! C is not unique. Each row is therefore judged by its product with q̇. Two claims about C can be judged, too: that C
//! is the choice by Christoffel symbols, and that Ṁ − 2 C is skew-symmetric, so that C + Cᵀ = Ṁ.

use crate::algebra::Expr;
use crate::diagnostic::{nearest_name_advice, shortened_for_message};
use crate::mechanics::{Quantity, QuantityKind, RowQuantity};
use crate::model::TIME;
use crate::publication::EntryKind;
use crate::publication::entries::EntryTable;
use crate::publication::publication_reader::PublicationReader;
use crate::toml_reader::Located;

/// Names of the claims about the matrix C that a publication may make.
const CLAIMS: [&str; 2] = ["christoffel", "skew-symmetric"];

/// Entry of a printed matrix: its value as a term, and its printed text.
pub type Cell = (Expr, String);

impl<'a> PublicationReader<'a, '_> {
    /// Entries with which a printed matrix C is judged, each with the suffix of its id. Reports an error and returns
    /// `None` unless C has one row and one column for each coordinate.
    pub fn coriolis_entries(
        &mut self,
        item: &EntryTable<'a>,
        cells: &[Vec<Cell>],
        printed: &Located,
    ) -> Option<Vec<(String, EntryKind)>> {
        let claims = self.coriolis_claims(item)?;
        if !self.coordinates.is_empty() {
            let message = "C is judged in the coordinates of the model, and the publication has its own";
            let help = "print each row of C q' as an equation of motion, or leave `[coordinates]` out";
            self.reader.error(printed.span.clone(), message, help);
            return None;
        }
        let coordinates: Vec<(String, Expr)> =
            self.model.coordinates.iter().filter(|c| c.name != TIME).map(|c| (c.name.clone(), c.rate)).collect();
        let n = coordinates.len();
        if cells.len() != n || cells[0].len() != n {
            let message = format!("C is a matrix of {} by {} for {n} coordinates", cells.len(), cells[0].len());
            self.reader.error(printed.span.clone(), message, "C has a row and a column for each coordinate");
            return None;
        }
        let mut list = Vec::new();
        for (i, row) in cells.iter().enumerate() {
            let arena = &mut self.model.arena;
            let terms: Vec<Expr> =
                row.iter().zip(&coordinates).map(|((e, _), (_, rate))| arena.mul(*e, *rate)).collect();
            let sum = arena.sum(&terms);
            let texts = row.iter().zip(&coordinates).filter(|((e, _), _)| *e != Expr::ZERO);
            let texts: Vec<String> = texts.map(|((_, text), (name, _))| format!("({text})*{name}'")).collect();
            let text = if texts.is_empty() { "0".to_owned() } else { texts.join(" + ") };
            list.push((
                format!("row{}", i + 1),
                self.coriolis_component(QuantityKind::Row(RowQuantity::VelocityTerms, i), sum, text),
            ));
        }
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let (e, text) = &cells[i][j];
            if claims.contains(&CLAIMS[0]) {
                let kind = self.coriolis_component(QuantityKind::Christoffel(i, j), *e, text.clone());
                list.push((format!("christoffel-{}{}", i + 1, j + 1), kind));
            }
            if claims.contains(&CLAIMS[1]) && i <= j {
                let (other, other_text) = &cells[j][i];
                let sum = self.model.arena.add(*e, *other);
                let kind = self.coriolis_component(QuantityKind::MassRate(i, j), sum, format!("{text} + {other_text}"));
                list.push((format!("skew-{}{}", i + 1, j + 1), kind));
            }
        }
        Some(list)
    }

    /// Creates an equation entry with the printed value of a quantity.
    fn coriolis_component(&self, kind: QuantityKind, printed: Expr, text: String) -> EntryKind {
        EntryKind::Equation { quantity: Quantity::new(kind, self.model), printed, text }
    }

    /// Reads the claims about C under the key `claims` of an entry. Reports an unknown claim and returns `None`.
    fn coriolis_claims(&mut self, item: &EntryTable<'a>) -> Option<Vec<&'static str>> {
        let Some(value) = self.reader.get(item.table, "claims") else { return Some(Vec::new()) };
        let array = self.require_array(value, "`claims`", "claims = [\"skew-symmetric\"]")?;
        let mut list = Vec::new();
        for value in array {
            let claim = self.reader.string(value, "a claim")?;
            let Some(known) = CLAIMS.iter().find(|known| **known == claim.text) else {
                let message = format!("there is no claim `{}`", shortened_for_message(&claim.text));
                self.reader.error(claim.span, message, nearest_name_advice(&claim.text, CLAIMS));
                return None;
            };
            list.push(*known);
        }
        Some(list)
    }
}
