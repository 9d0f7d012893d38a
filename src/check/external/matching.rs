//! Matches answers with their cases, while both are streamed.

use super::answers::{Answers, Program};
use super::compare::{Demands, compare_case};
use super::error::ExternalError;
use super::no_dof::without;
use super::only::Only;
use super::recent::Recent;
use super::report::Report;
use super::vectors::Vector;
use rayon::prelude::*;
use std::collections::VecDeque;

/// The number of cases that are compared at a time, by all cores.
const AT_ONCE: usize = 64;

/// Matches answers with cases, and compares them.
///
/// Cases may be left out. Answers may come in another order, if no more cases are open than the look-ahead allows.
#[derive(Debug)]
pub struct Matching {
    demands: Demands,
    look_ahead: usize,
    open: VecDeque<Vector>,
    /// The last answered cases, with the lines of their answers.
    answered: Recent,
    /// The last cases whose answers would come too late.
    late: Recent,
    /// The file of the cases, if they are read from one.
    file: Option<String>,
    ready: Vec<(Vector, Option<Answers>)>,
    only: Only,
    report: Report,
}

impl Matching {
    /// A matching without any answers.
    pub fn new(demands: Demands, look_ahead: usize) -> Self {
        Self {
            demands,
            look_ahead,
            open: VecDeque::new(),
            answered: Recent::default(),
            late: Recent::default(),
            file: None,
            ready: Vec::new(),
            report: Report::of_program(
                &Program::default(),
                &Only::default(),
                demands.conventions.penalty.is_some(),
            ),
            only: Only::default(),
        }
    }

    /// Sets the program and what it answers, as the head of its answers describes it.
    #[must_use]
    pub fn of_program(mut self, program: &Program, only: &Only) -> Self {
        self.report = Report::of_program(program, only, self.demands.conventions.penalty.is_some());
        self.only = only.clone();
        self
    }

    /// Adds the answers to a case; `next` yields the cases that follow.
    ///
    /// # Errors
    /// If there is no such case, it is answered already, or an answer has the wrong number of entries.
    pub fn take<E: From<ExternalError>>(
        &mut self,
        answers: Answers,
        mut next: impl FnMut() -> Result<Option<Vector>, E>,
    ) -> Result<(), E> {
        if let Some(line) = self.answered.line(&answers.id) {
            let expected =
                format!("case {:?}: one answer expected, found another in line {line}", answers.id);
            return Err(answers.place.error(expected).into());
        }
        let vector = match self.open.iter().position(|vector| vector.id == answers.id) {
            Some(at) => self.open.remove(at),
            None => loop {
                let vector = next()?;
                if let (None, Some(place)) = (&self.file, vector.as_ref().and_then(|of| of.place.as_ref())) {
                    self.file = Some(place.file.clone());
                }
                match vector {
                    Some(vector) if vector.id == answers.id => break Some(vector),
                    Some(vector) => self.leave_open(vector)?,
                    None => break None,
                }
            },
        };
        let Some(vector) = vector else { return Err(self.without_case(answers).into()) };
        self.answered.insert(&answers.id, answers.place.line);
        Ok(self.add((vector, Some(answers)))?)
    }

    fn add(&mut self, case: (Vector, Option<Answers>)) -> Result<(), ExternalError> {
        self.ready.push(case);
        if self.ready.len() >= AT_ONCE { self.compare() } else { Ok(()) }
    }

    /// The error for an answer whose case is not open.
    fn without_case(&self, answers: Answers) -> ExternalError {
        let id = &answers.id;
        let expected = if self.late.line(id).is_some() {
            format!(
                "case {id:?}: its answer expected earlier, in the order of the cases or at most {} out of it",
                self.look_ahead
            )
        } else {
            let of = self.file.as_ref().map_or_else(String::new, |file| format!(" of {file}"));
            format!("the id of a case{of} expected, found {id:?}")
        };
        answers.place.error(expected)
    }

    fn leave_open(&mut self, vector: Vector) -> Result<(), ExternalError> {
        self.open.push_back(vector);
        if self.open.len() > self.look_ahead
            && let Some(oldest) = self.open.pop_front()
        {
            self.late.insert(&oldest.id, 0);
            self.add((oldest, None))?;
        }
        Ok(())
    }

    /// Compares the matched answers.
    ///
    /// # Errors
    /// If an answer has the wrong number of entries.
    pub fn compare(&mut self) -> Result<(), ExternalError> {
        let ready = std::mem::take(&mut self.ready);
        let compare = |(vector, answers): (Vector, Option<Answers>)| {
            let searched = vector.case.searched().unwrap_or_default();
            let conventions = &self.demands.conventions;
            let (vector, answers) = match answers {
                Some(answers) if conventions.null_is_no_dof => {
                    let place = answers.place.clone();
                    let id = answers.id.clone();
                    let (vector, answers) = without(vector, answers, conventions)
                        .map_err(|wrong| place.error(format!("case {id}: {wrong}")))?;
                    (vector, Some(answers))
                }
                answers => (vector, answers),
            };
            let found = compare_case(&vector, answers.as_ref(), &self.demands, &self.only)?;
            Ok((vector, answers, found, searched))
        };
        let found: Vec<Result<_, ExternalError>> = ready.into_par_iter().map(compare).collect();
        for found in found {
            let (vector, answers, found, searched) = found?;
            self.report.search.add(&vector.id, &searched);
            self.report.add(vector, answers, found);
        }
        Ok(())
    }

    /// The result so far.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Adds the remaining cases, which are not answered.
    ///
    /// # Errors
    /// If an answer has the wrong number of entries, or a case cannot be read.
    pub fn finish<E: From<ExternalError>>(
        mut self,
        mut next: impl FnMut() -> Result<Option<Vector>, E>,
    ) -> Result<Report, E> {
        for vector in std::mem::take(&mut self.open) {
            self.add((vector, None))?;
        }
        while let Some(vector) = next()? {
            self.add((vector, None))?;
        }
        self.compare()?;
        Ok(self.report)
    }
}
