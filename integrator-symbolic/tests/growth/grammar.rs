//! Texts of systems. In the text of a part, `I` is the number of the part and `N` that of the next one, around the end.

use crate::choice::Choices;

/// Choices that share nothing with those of other seeds: near ones draw the same numbers, shifted by one.
fn choices(seed: u64) -> Choices {
    Choices::new(seed << 20)
}

/// A part of each function, to be repeated.
pub(crate) struct System {
    kinetic: Option<Part>,
    potential: Part,
    /// Whether each part has two coordinates of its own, or all parts share three.
    has_more_coordinates: bool,
}

/// Statements that change `a`, `b` and `sum`.
struct Part(Vec<String>);

impl System {
    pub(crate) fn drawn(seed: u64) -> Self {
        let mut writer = Writer { choices: choices(seed), numbers: Vec::new() };
        let has_more_coordinates = writer.choices.percent(60);
        let potential = writer.part("q");
        let kinetic = writer.choices.percent(25).then(|| writer.part("p"));
        Self { kinetic, potential, has_more_coordinates }
    }

    pub(crate) fn of_parts(&self, parts: usize) -> String {
        let coordinates = if self.has_more_coordinates { 2 * parts } else { 3 };
        let kinetic = match &self.kinetic {
            Some(part) => part.repeated("p", parts, coordinates),
            None => "p.iter().map(|p| p * p / 2.0).sum()".to_owned(),
        };
        let potential = self.potential.repeated("q", parts, coordinates);
        format!(
            "impl Growing {{
                fn kinetic(&self, p: [f64; {coordinates}]) -> f64 {{ {kinetic} }}
                fn potential(&self, q: [f64; {coordinates}]) -> f64 {{ {potential} }}
            }}"
        )
    }
}

impl Part {
    fn repeated(&self, letter: &str, parts: usize, coordinates: usize) -> String {
        let mut text = format!("let (mut a, mut b, mut sum) = ({letter}[0], {letter}[1], 0.0);\n");
        for part in 0..parts {
            for statement in &self.0 {
                let next = ((part + 1) % coordinates).to_string();
                let here = (part % coordinates).to_string();
                let statement = statement.replace("[I]", &format!("[{here}]")).replace("[N]", &format!("[{next}]"));
                text += &(statement.replace('I', &part.to_string()) + "\n");
            }
        }
        text + "sum + a * b"
    }
}

/// Pairs of bodies, whose energy is a random function of their distance, with a cutoff or without.
pub(crate) fn bodies(seed: u64, bodies: usize) -> String {
    let mut writer = Writer { choices: choices(seed), numbers: Vec::new() };
    for (number, weight) in [("x", 1), ("y", 1), ("z", 1), ("square", 3), ("self.weight[i]", 1), ("self.weight[j]", 1)]
    {
        writer.numbers.extend(std::iter::repeat_n(number.to_owned(), weight));
    }
    let term = writer.number(3);
    let guard = if writer.choices.percent(50) { "if square < 6.25" } else { "" };
    format!(
        "impl Growing {{
            fn kinetic(&self, p: [[f64; 3]; {bodies}]) -> f64 {{ p.iter().flatten().map(|p| p * p / 2.0).sum() }}
            fn potential(&self, q: [[f64; 3]; {bodies}]) -> f64 {{
                let mut energy = 0.0;
                for i in 0..{bodies} {{
                    for j in 0..i {{
                        let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                        let square = x * x + y * y + z * z;
                        {guard} {{ energy += self.strength * {}; }}
                    }}
                }}
                energy
            }}
        }}",
        term.replace('I', "1")
    )
}

/// Writes random expressions of the numbers that are known.
struct Writer {
    choices: Choices,
    numbers: Vec<String>,
}

impl Writer {
    fn part(&mut self, letter: &str) -> Part {
        let here = format!("{letter}[I]");
        self.numbers = [&here, &here, &format!("{letter}[N]"), "self.weight[I]", "a", "b"].map(str::to_owned).to_vec();
        let mut statements = Vec::new();
        for index in 0..1 + self.choices.below(2) {
            let depth = 1 + self.choices.below(2);
            let number = self.number(depth);
            statements.push(match self.choices.below(8) {
                0..3 => {
                    self.numbers.push(format!("v{index}_I"));
                    format!("let v{index}_I = {number};")
                }
                3 => format!("a = {number} - 0.5 * a;"),
                4 => format!("if {} {{ b += {number}; }}", self.condition()),
                5 => format!("if {} {{ a += {number}; }} else {{ b -= {}; }}", self.condition(), self.number(1)),
                6 => format!("for k in 0..2 {{ b += {letter}[k] * {number}; }}"),
                _ => format!("sum += {number};"),
            });
        }
        // A value that is used twice in each part: written out, it would double with every part.
        if self.choices.percent(60) {
            statements.push(format!("a = {} + a * (0.5 * a).cos();", self.leaf()));
        }
        statements.push(format!("sum += self.strength * {};", self.number(1)));
        Part(statements)
    }

    fn leaf(&mut self) -> String {
        match self.choices.below(8) {
            0 => format!("{:?}", self.choices.between(0.1, 3.0)),
            1 => "I.5".to_owned(),
            _ => self.numbers[self.choices.below(self.numbers.len())].clone(),
        }
    }

    fn number(&mut self, depth: usize) -> String {
        if depth == 0 {
            return self.leaf();
        }
        let first = self.number(depth - 1);
        match self.choices.below(14) {
            0..3 => format!("({first} + {})", self.number(depth - 1)),
            3 => format!("({first} - {})", self.number(depth - 1)),
            4..6 => format!("({first} * {})", self.number(depth - 1)),
            6 => format!("({first} / (1.5 + ({}).powi(2)))", self.number(depth - 1)),
            7 => format!("({first}).powi({})", 2 + self.choices.below(3)),
            8 => format!("(1.25 + ({first}).powi(2)).sqrt()"),
            9 => format!("(self.strength * {first}).{}()", self.choices.of(&["sin", "cos", "exp"])),
            10 => format!("({first}).{}()", self.choices.of(&["sin", "tanh", "cos", "atan"])),
            11 => format!("(1.5 + ({first}).powi(2)).ln()"),
            12 => format!("({first}).{}({})", self.choices.of(&["max", "min"]), self.number(depth - 1)),
            _ => format!("(if {} {{ {first} }} else {{ {} }})", self.condition(), self.number(depth - 1)),
        }
    }

    fn condition(&mut self) -> String {
        format!("{} {} {} + I.5", self.leaf(), self.choices.of(&["<", ">"]), self.leaf())
    }
}
