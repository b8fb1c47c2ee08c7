//! Formulas as MathML, from a notation that is readable in the source. `_` lowers and `^` raises a letter, a number or
//! a group in braces, `{a}/{b}` is a fraction, and `;` separates formulas.

/// Formulas as elements of a page, between which a line may be broken.
pub(crate) fn math(formulas: &str) -> String {
    let one = |formula: &str| {
        let characters = formula.chars().filter(|letter| *letter != ' ').collect();
        format!("<math>{}</math>", Rest { characters, place: 0 }.row())
    };
    formulas.split(';').map(one).collect::<Vec<_>>().join(" ")
}

struct Rest {
    characters: Vec<char>,
    place: usize,
}

impl Rest {
    fn peek(&self) -> Option<char> {
        self.characters.get(self.place).copied()
    }

    /// Takes a character if it comes next.
    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        self.place += usize::from(found);
        found
    }

    /// Everything up to a closing brace or the end.
    fn row(&mut self) -> String {
        let mut row = String::new();
        while self.peek().is_some_and(|next| next != '}') {
            row.push_str(&self.item());
        }
        format!("<mrow>{row}</mrow>")
    }

    /// Reads a base with its subscript and superscript, or a fraction.
    fn item(&mut self) -> String {
        let braced = self.peek() == Some('{');
        let base = self.atom();
        let lower = if self.take('_') { Some(self.atom()) } else { None };
        let upper = if self.take('^') { Some(self.atom()) } else { None };
        match (lower, upper) {
            (Some(lower), Some(upper)) => format!("<msubsup>{base}{lower}{upper}</msubsup>"),
            (Some(lower), None) => format!("<msub>{base}{lower}</msub>"),
            (None, Some(upper)) => format!("<msup>{base}{upper}</msup>"),
            (None, None) if braced && self.take('/') => format!("<mfrac>{base}{}</mfrac>", self.atom()),
            (None, None) => base,
        }
    }

    fn atom(&mut self) -> String {
        if self.take('{') {
            let row = self.row();
            self.take('}');
            return row;
        }
        let begin = self.place;
        while self.peek().is_some_and(|next| next.is_ascii_digit()) {
            self.place += 1;
        }
        if self.place > begin {
            return format!("<mn>{}</mn>", self.characters[begin..self.place].iter().collect::<String>());
        }
        let Some(character) = self.peek() else { return String::new() };
        self.place += 1;
        match character {
            '(' | ')' => format!("<mo stretchy=\"false\">{character}</mo>"),
            '\'' => "<mo>′</mo>".to_owned(),
            '<' => "<mo>&lt;</mo>".to_owned(),
            '>' => "<mo>&gt;</mo>".to_owned(),
            '&' => "<mo>&amp;</mo>".to_owned(),
            character if character.is_alphabetic() => format!("<mi>{character}</mi>"),
            character => format!("<mo>{character}</mo>"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::math;

    #[test]
    fn formulas_become_elements() {
        let inner = |text: &str| math(text).replace("<math><mrow>", "").replace("</mrow></math>", "");
        assert_eq!(inner("z_1"), "<msub><mi>z</mi><mn>1</mn></msub>");
        assert_eq!(inner("h^2"), "<msup><mi>h</mi><mn>2</mn></msup>");
        assert_eq!(inner("{h}/{24}x"), "<mfrac><mrow><mi>h</mi></mrow><mrow><mn>24</mn></mrow></mfrac><mi>x</mi>");
        assert_eq!(inner("f_n^*"), "<msubsup><mi>f</mi><mi>n</mi><mo>*</mo></msubsup>");
        assert_eq!(inner("V'"), "<mi>V</mi><mo>′</mo>");
        assert_eq!(math("a;b").matches("<math>").count(), 2);
        assert_eq!(inner("n/2"), "<mi>n</mi><mo>/</mo><mn>2</mn>");
        // What does not close ends with the formula.
        for text in ["", "{", "x_", "}", "{a}/", "a<b"] {
            assert!(math(text).ends_with("</math>"), "{text}");
        }
    }
}
