//! The evaluators' programs contain no operation that could have been done once in `assemble()`, and none without use.

use linkage_symbolic::program::{Instruction, Program, Source, Value};

/// Every operation depends on an input.
fn check_early_work(program: &Program, name: &str) {
    let mut late: Vec<bool> = Vec::new();
    for instruction in &program.instructions {
        let operands: Vec<Value> = instruction.operands().collect();
        let is_late = matches!(instruction, Instruction::Load(Source::Input(_)))
            || operands.iter().any(|operand| late[operand.0]);
        // What is made of constants is one for the compiler.
        let constant = |x: &Value| matches!(program.instructions[x.0], Instruction::Constant(_));
        assert!(
            is_late || operands.iter().all(constant),
            "{name}: {instruction:?} belongs into assemble()\n{program}"
        );
        late.push(is_late);
    }
}

/// Every operation is used by a later one or is a result; constants cost nothing.
fn check_use(program: &Program, name: &str) {
    let mut used = vec![false; program.instructions.len()];
    program
        .outputs
        .iter()
        .for_each(|output| used[output.0] = true);
    for (place, instruction) in program.instructions.iter().enumerate().rev() {
        let free = matches!(instruction, Instruction::Constant(_));
        assert!(
            free || used[place],
            "{name}: nobody needs {instruction:?}\n{program}"
        );
        instruction
            .operands()
            .for_each(|operand| used[operand.0] = true);
    }
}

#[test]
fn programs_are_sliced() {
    for seed in 0..80 {
        let case = super::case(seed).unwrap_or_else(|message| panic!("{message}"));
        let unit = &case.subject.unit;
        let name = format!("seed {seed}");
        for function in &unit.functions {
            check_early_work(&function.called.program, &name);
            check_use(&function.called.program, &name);
        }
        check_early_work(&unit.gaps, &name);
        check_use(&unit.gaps, &name);
        check_use(&unit.prepare, &name);
    }
}
