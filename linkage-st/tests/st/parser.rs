//! Reads structured text.

use crate::syntax::{Expression, File, Initial, Kind, Statement, Step, Unit, Variable};
use crate::tokens::{Token, tokens};

/// Words that are no names.
const KEYWORDS: &str = "type end_type struct end_struct function end_function function_block end_function_block var \
    var_input var_output var_in_out var_temp end_var if then elsif else end_if array of lreal int bool not and or xor true false";

/// Operators by their precedence, the lowest first.
const LEVELS: [&[&str]; 6] = [
    &["or"],
    &["xor"],
    &["and"],
    &["=", "<>"],
    &["<", ">", "<=", ">="],
    &["+", "-"],
];

/// Reads a file.
pub(crate) fn file(text: &str) -> File {
    let mut parser = Parser {
        tokens: tokens(text),
        next: 0,
    };
    let mut file = File::default();
    while parser.next < parser.tokens.len() {
        if parser.takes_word("type") {
            let name = parser.name();
            parser.sign(":");
            parser.word("struct");
            let members = parser.variables("end_struct");
            parser.sign(";");
            parser.word("end_type");
            assert!(!members.is_empty(), "{name} has members");
            assert!(
                file.types.insert(name, members).is_none(),
                "types have different names"
            );
        } else if parser.takes_word("function_block") {
            let name = parser.name();
            let block = parser.unit(name.clone(), "end_function_block");
            assert!(
                file.blocks.insert(name, block).is_none(),
                "blocks have different names"
            );
        } else {
            parser.word("function");
            let name = parser.name();
            parser.sign(":");
            assert_eq!(parser.kind(), Kind::Real);
            let function = parser.unit(name.clone(), "end_function");
            assert!(
                file.functions.insert(name, function).is_none(),
                "functions have different names"
            );
        }
    }
    file
}

struct Parser {
    tokens: Vec<Token>,
    next: usize,
}

impl Parser {
    fn unit(&mut self, name: String, end: &str) -> Unit {
        let mut unit = Unit {
            name,
            ..Unit::default()
        };
        loop {
            let section = if self.takes_word("var_input") {
                &mut unit.inputs
            } else if self.takes_word("var_in_out") || self.takes_word("var_output") {
                &mut unit.others
            } else if self.takes_word("var") || self.takes_word("var_temp") {
                &mut unit.variables
            } else {
                break;
            };
            section.extend(self.variables("end_var"));
        }
        let all = [&unit.inputs, &unit.others, &unit.variables];
        let mut names: Vec<&String> = all.into_iter().flatten().map(|own| &own.name).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!(
            names.len(),
            count,
            "{}: variables have different names",
            unit.name
        );
        unit.body = self.statements(&[end]);
        self.word(end);
        unit
    }

    fn variables(&mut self, end: &str) -> Vec<Variable> {
        let mut variables = Vec::new();
        while !self.takes_word(end) {
            let mut names = vec![self.name()];
            while self.takes(",") {
                names.push(self.name());
            }
            self.sign(":");
            let kind = self.kind();
            let initial = self.takes(":=").then(|| self.initial());
            self.sign(";");
            variables.extend(names.into_iter().map(|name| Variable {
                name,
                kind: kind.clone(),
                initial: initial.clone(),
            }));
        }
        variables
    }

    fn kind(&mut self) -> Kind {
        let Token::Word(word) = self.token() else {
            panic!("a type")
        };
        match &word[..] {
            "lreal" => Kind::Real,
            "int" => Kind::Integer,
            "bool" => Kind::Boolean,
            "array" => {
                self.sign("[");
                let mut sizes = Vec::new();
                loop {
                    assert_eq!(self.integer(), 0);
                    self.sign("..");
                    sizes.push(self.integer() + 1);
                    if !self.takes(",") {
                        break;
                    }
                }
                self.sign("]");
                self.word("of");
                let entry = self.kind();
                assert!(!matches!(entry, Kind::Array(..)), "entries are no arrays");
                Kind::Array(sizes, Box::new(entry))
            }
            _ => Kind::Named(word),
        }
    }

    fn initial(&mut self) -> Initial {
        if !self.takes("(") {
            return match self.token() {
                Token::Real(x) => Initial::Number(x),
                other => panic!("{other:?} is no initial value"),
            };
        }
        if self.takes("-") {
            let Token::Real(x) = self.token() else {
                panic!("a number")
            };
            self.sign(")");
            return Initial::Number(-x);
        }
        let mut members = Vec::new();
        loop {
            let name = self.name();
            self.sign(":=");
            members.push((name, self.initial()));
            if !self.takes(",") {
                break;
            }
        }
        self.sign(")");
        Initial::Members(members)
    }

    fn statements(&mut self, ends: &[&str]) -> Vec<Statement> {
        let mut statements = Vec::new();
        while !ends.iter().any(|end| self.is_word(end)) {
            let statement = if self.takes_word("if") {
                let mut branches = Vec::new();
                loop {
                    let condition = self.expression(0);
                    self.word("then");
                    branches.push((condition, self.statements(&["elsif", "end_if"])));
                    if !self.takes_word("elsif") {
                        break;
                    }
                }
                self.word("end_if");
                Statement::If(branches)
            } else {
                let path = self.path();
                self.sign(":=");
                Statement::Assign(path, self.expression(0))
            };
            self.sign(";");
            statements.push(statement);
        }
        statements
    }

    fn path(&mut self) -> Vec<Step> {
        let mut path = vec![Step::Name(self.name())];
        loop {
            if self.takes(".") {
                path.push(Step::Name(self.name()));
            } else if self.takes("[") {
                let mut entry = vec![self.integer()];
                while self.takes(",") {
                    entry.push(self.integer());
                }
                self.sign("]");
                path.push(Step::Entry(entry));
            } else {
                return path;
            }
        }
    }

    fn expression(&mut self, level: usize) -> Expression {
        let Some(operators) = LEVELS.get(level) else {
            return self.product();
        };
        let mut left = self.expression(level + 1);
        while let Some(operator) = self.operator(operators) {
            let right = self.expression(level + 1);
            left = Expression::Binary(operator, Box::new([left, right]));
        }
        left
    }

    fn product(&mut self) -> Expression {
        let mut left = self.unary();
        while let Some(operator) = self.operator(&["*", "/"]) {
            let right = self.unary();
            left = Expression::Binary(operator, Box::new([left, right]));
        }
        left
    }

    fn unary(&mut self) -> Expression {
        match self.operator(&["-", "not"]) {
            Some(operator) => Expression::Unary(operator, Box::new(self.primary())),
            None => self.primary(),
        }
    }

    fn primary(&mut self) -> Expression {
        if self.takes("(") {
            let inner = self.expression(0);
            self.sign(")");
            return inner;
        }
        match self.tokens[self.next].clone() {
            Token::Real(x) => {
                self.next += 1;
                Expression::Real(x)
            }
            Token::Integer(x) => {
                self.next += 1;
                Expression::Integer(x)
            }
            Token::Word(word) if word == "true" || word == "false" => {
                self.next += 1;
                Expression::Boolean(word == "true")
            }
            Token::Word(word) if self.tokens.get(self.next + 1) == Some(&Token::Sign("(")) => {
                self.next += 2;
                let mut operands = Vec::new();
                while !self.takes(")") {
                    operands.push(self.expression(0));
                    assert!(self.takes(",") || self.tokens[self.next] == Token::Sign(")"));
                }
                Expression::Call(word, operands)
            }
            Token::Word(_) => Expression::Path(self.path()),
            other => panic!("{other:?} is no expression"),
        }
    }

    fn operator(&mut self, operators: &[&'static str]) -> Option<&'static str> {
        let operators = operators.iter().copied();
        let mut taken = operators.filter(|own| match own.starts_with(char::is_alphabetic) {
            true => self.is_word(own),
            false => self.tokens.get(self.next) == Some(&Token::Sign(own)),
        });
        let operator = taken.next()?;
        self.next += 1;
        Some(operator)
    }

    fn token(&mut self) -> Token {
        self.next += 1;
        self.tokens[self.next - 1].clone()
    }

    fn name(&mut self) -> String {
        match self.token() {
            Token::Word(word) => {
                assert!(
                    !KEYWORDS.split_whitespace().any(|own| own == word),
                    "{word} is no name"
                );
                word
            }
            other => panic!("{other:?} is no name"),
        }
    }

    fn integer(&mut self) -> usize {
        match self.token() {
            Token::Integer(x) => usize::try_from(x).expect("it is not negative"),
            other => panic!("{other:?} is no integer"),
        }
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(self.tokens.get(self.next), Some(Token::Word(own)) if own == word)
    }

    fn takes_word(&mut self, word: &str) -> bool {
        let takes = self.is_word(word);
        self.next += usize::from(takes);
        takes
    }

    fn word(&mut self, word: &str) {
        assert!(
            self.takes_word(word),
            "{word} before {:?}",
            self.tokens.get(self.next)
        );
    }

    fn takes(&mut self, sign: &str) -> bool {
        let takes = matches!(self.tokens.get(self.next), Some(Token::Sign(own)) if *own == sign);
        self.next += usize::from(takes);
        takes
    }

    fn sign(&mut self, sign: &str) {
        assert!(
            self.takes(sign),
            "{sign} before {:?}",
            self.tokens.get(self.next)
        );
    }
}
