//! Threads that wait for the next job.
//!
//! Starting a thread takes tens of microseconds, as long as a thousand bodies take for a kick. So a thread that was started once
//! waits for more, awake, since one kick follows another. It ends when nothing comes for a moment: to wake a thread that sleeps
//! takes as long as to start one, and systems wake it on a processor that is busy where they would start it on an idle one.

use super::Job;
use std::{
    any::Any,
    boxed::Box,
    panic::{AssertUnwindSafe, catch_unwind, resume_unwind},
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering},
        mpsc::{Receiver, Sender, channel},
    },
    thread,
    time::{Duration, Instant},
    vec::Vec,
};

/// The time that a thread waits awake: longer than what one thread does alone between two kicks of some thousand
/// bodies.
const AWAKE: Duration = Duration::from_micros(50);

/// The number of checks for a message before a waiting thread reads the clock.
const LOOKS: usize = 64;

/// A thread that runs one job after the other and reports how each of them ended.
struct Worker {
    jobs: Sender<Job<'static>>,
    outcomes: Receiver<thread::Result<()>>,
    asleep: Arc<AtomicBool>,
}

/// The workers that wait for a job, all of them awake: who falls asleep, and who lets a worker wait, holds the lock.
fn waiting() -> MutexGuard<'static, Vec<Worker>> {
    static WAITING: Mutex<Vec<Worker>> = Mutex::new(Vec::new());
    WAITING.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Worker {
    /// A new one, if the system has a thread.
    fn start() -> Option<Self> {
        let ((jobs, taken), (ended, outcomes)) = (channel::<Job<'static>>(), channel());
        let asleep = Arc::new(AtomicBool::new(false));
        let sleeps = asleep.clone();
        let work = move || {
            while let Some(job) = next_job(&taken, &sleeps) {
                let outcome = catch_unwind(AssertUnwindSafe(job));
                if ended.send(outcome).is_err() {
                    return;
                }
            }
        };
        thread::Builder::new().name("integrator".to_owned()).spawn(work).ok()?;
        Some(Self { jobs, outcomes, asleep })
    }
}

/// Waits for the next job of a worker; returns none if no job arrives for a while.
fn next_job(jobs: &Receiver<Job<'static>>, asleep: &Arc<AtomicBool>) -> Option<Job<'static>> {
    if let Some(job) = soon(jobs) {
        return Some(job);
    }
    let mut waiting = waiting();
    if let Some(place) = waiting.iter().position(|worker| Arc::ptr_eq(&worker.asleep, asleep)) {
        waiting.remove(place);
        return None;
    }
    // Somebody has the worker, who has work for it, or has not heard yet how the last job ended.
    asleep.store(true, Ordering::Relaxed);
    drop(waiting);
    let job = jobs.recv().ok();
    asleep.store(false, Ordering::Relaxed);
    job
}

/// Waits awake for a message.
fn soon<T>(messages: &Receiver<T>) -> Option<T> {
    let since = Instant::now();
    while since.elapsed() < AWAKE {
        for _ in 0..LOOKS {
            if let Ok(message) = messages.try_recv() {
                return Some(message);
            }
            core::hint::spin_loop();
        }
        // Somebody else may need the processor.
        thread::yield_now();
    }
    None
}

/// Jobs that workers do, for as long as this is there.
pub(super) struct HandedOver {
    workers: Vec<Worker>,
    panics: Vec<Box<dyn Any + Send>>,
}

impl HandedOver {
    /// Creates an empty list, with room for this number of workers.
    pub(super) fn with_room_for(workers: usize) -> Self {
        Self { workers: Vec::with_capacity(workers), panics: Vec::new() }
    }

    /// Hands a job over, or runs it here if no worker is free.
    #[allow(unsafe_code, reason = "workers outlive what a job borrows, and end it before")]
    pub(super) fn hand_over(&mut self, job: Job<'_>) {
        // A separate statement, so that no thread waits for the lock while a thread starts.
        let waiting = waiting().pop();
        let Some(worker) = waiting.or_else(Worker::start) else { return job() };
        // SAFETY: The types differ in a lifetime alone. The worker drops the job before it tells how the job ended, and `wait`,
        // which runs before this value is gone, even in a panic, does not return before it was told. Nobody can forget the
        // value: it is private to `at_once`.
        let job = unsafe { core::mem::transmute::<Job<'_>, Job<'static>>(job) };
        match worker.jobs.send(job) {
            Ok(()) => self.workers.push(worker),
            Err(returned) => (returned.0)(),
        }
    }

    /// Waits until all are done.
    ///
    /// # Panics
    /// If one of them did.
    pub(super) fn finish(mut self) {
        self.wait();
        if let Some(panic) = self.panics.pop() {
            resume_unwind(panic);
        }
    }

    fn wait(&mut self) {
        // In the opposite order, so that the next jobs go to the threads whose caches have what these read.
        for worker in self.workers.drain(..).rev() {
            let outcome = soon(&worker.outcomes).or_else(|| worker.outcomes.recv().ok());
            // Kept, since to drop what somebody panicked with may panic, and others have not ended yet.
            self.panics.extend(outcome.and_then(Result::err));
            let mut waiting = waiting();
            // A worker that sleeps ends when it is dropped.
            if !worker.asleep.load(Ordering::Relaxed) {
                waiting.push(worker);
            }
        }
    }
}

impl Drop for HandedOver {
    fn drop(&mut self) {
        self.wait();
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Job, at_once, on_threads};
    use std::{
        boxed::Box,
        collections::HashSet,
        panic::{AssertUnwindSafe, catch_unwind, panic_any},
        sync::{
            Barrier, Mutex,
            atomic::{AtomicUsize, Ordering},
        },
        thread,
        time::Duration,
        vec::Vec,
    };

    #[test]
    fn jobs_run_at_once_on_threads_that_stay() {
        let threads = Mutex::new(HashSet::new());
        for _ in 0..50 {
            // Nobody passes before all are there.
            let (barrier, mut numbers) = (Barrier::new(3), [0; 3]);
            let jobs = numbers.iter_mut().enumerate().map(|(number, to)| {
                let (barrier, threads) = (&barrier, &threads);
                Box::new(move || {
                    barrier.wait();
                    threads.lock().unwrap().insert(thread::current().id());
                    *to = number + 1;
                }) as Job<'_>
            });
            at_once(jobs.collect());
            assert_eq!(numbers, [1, 2, 3]);
        }
        // If none had stayed, two for each time and this one.
        assert!(threads.into_inner().unwrap().len() < 2 * 50 + 1);
    }

    #[test]
    fn jobs_have_jobs() {
        let count = AtomicUsize::new(0);
        let inner = || {
            on_threads(3, &|| {
                count.fetch_add(1, Ordering::Relaxed);
            });
        };
        on_threads(3, &inner);
        assert_eq!(count.into_inner(), 9);
    }

    /// Panics when it is dropped, unless a panic is in progress.
    struct PanicsOnDrop;

    impl Drop for PanicsOnDrop {
        fn drop(&mut self) {
            assert!(thread::panicking());
        }
    }

    #[test]
    fn no_panic_payload_ends_the_wait_for_other_jobs() {
        let ended = AtomicUsize::new(0);
        let jobs: Vec<Job<'_>> = (0..4)
            .map(|number| {
                let ended = &ended;
                Box::new(move || {
                    if [1, 2].contains(&number) {
                        panic_any(PanicsOnDrop);
                    }
                    // Long after the others, those that write where they panicked among them.
                    thread::sleep(Duration::from_millis(if number == 0 { 300 } else { 1 }));
                    ended.fetch_add(1, Ordering::Relaxed);
                }) as Job<'_>
            })
            .collect();
        let panic = catch_unwind(AssertUnwindSafe(|| at_once(jobs))).unwrap_err();
        assert_eq!(ended.load(Ordering::Relaxed), 2);
        assert!(panic.is::<PanicsOnDrop>());
        core::mem::forget(panic);
    }

    #[test]
    fn a_panic_resumes_when_all_jobs_have_ended() {
        for panics in 0..3 {
            let ended = AtomicUsize::new(0);
            let jobs: Vec<Job<'_>> = (0..3)
                .map(|number| {
                    let ended = &ended;
                    Box::new(move || {
                        assert!(number != panics, "number {number}");
                        thread::sleep(Duration::from_millis(5));
                        ended.fetch_add(1, Ordering::Relaxed);
                    }) as Job<'_>
                })
                .collect();
            let panic = catch_unwind(AssertUnwindSafe(|| at_once(jobs))).unwrap_err();
            assert_eq!(panic.downcast_ref::<String>().unwrap(), &std::format!("number {panics}"));
            assert_eq!(ended.into_inner(), 2);
        }
    }
}
