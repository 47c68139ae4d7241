//! The thread that renders, so that the window never waits: it takes the latest wish and forgets older ones.

use super::studio::Studio;
use super::truth;
use super::wish::{Layer, Overlay, Shown, Wish};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;

/// What happened since the last time somebody asked.
#[derive(Debug, Default)]
pub(super) struct News {
    /// A picture.
    pub shown: Option<Shown>,
    /// A better layer for the picture that was shown for this wish.
    pub layer: Option<(Wish, Layer)>,
    /// What takes long, and the part of it that is done.
    pub busy: Option<(String, f32)>,
    /// Why there is no picture: a sentence.
    pub error: Option<String>,
}

#[derive(Default)]
struct Inbox {
    wish: Option<Wish>,
    stop: bool,
}

/// What both sides hold.
struct Desk {
    inbox: Mutex<Inbox>,
    bell: Condvar,
    news: Mutex<News>,
    /// Tells the window that there is news.
    wake: Box<dyn Fn() + Send + Sync>,
}

fn open<T>(lock: &Mutex<T>) -> MutexGuard<'_, T> {
    lock.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Desk {
    /// Whether somebody wishes for something else.
    fn waits(&self) -> bool {
        let inbox = open(&self.inbox);
        inbox.stop || inbox.wish.is_some()
    }

    /// The next wish; none at the end.
    fn next(&self) -> Option<Wish> {
        let mut inbox = open(&self.inbox);
        loop {
            if inbox.stop {
                return None;
            }
            if let Some(wish) = inbox.wish.take() {
                return Some(wish);
            }
            inbox = self
                .bell
                .wait(inbox)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn tell(&self, write: impl FnOnce(&mut News)) {
        write(&mut open(&self.news));
        (self.wake)();
    }
}

/// A thread that grants wishes. It ends when this is dropped.
pub(super) struct Worker {
    desk: Arc<Desk>,
    thread: Option<JoinHandle<()>>,
}

impl Worker {
    /// Starts the thread. `wake` is called, from any thread, when there is news.
    pub fn new(studio: Studio, wake: impl Fn() + Send + Sync + 'static) -> Self {
        let desk = Arc::new(Desk {
            inbox: Mutex::default(),
            bell: Condvar::new(),
            news: Mutex::default(),
            wake: Box::new(wake),
        });
        let its = Arc::clone(&desk);
        Self {
            desk,
            thread: Some(std::thread::spawn(move || work(studio, &its))),
        }
    }

    /// Wishes for a picture in the place of any that was not begun.
    pub fn wish(&self, wish: Wish) {
        open(&self.desk.inbox).wish = Some(wish);
        self.desk.bell.notify_one();
    }

    /// What happened since the last time.
    pub fn news(&self) -> News {
        let mut news = open(&self.desk.news);
        let mut latest = std::mem::take(&mut *news);
        // It is busy until it says otherwise.
        news.busy.clone_from(&latest.busy);
        // The panic has told its own story.
        if self.thread.as_ref().is_some_and(JoinHandle::is_finished) {
            latest.error = Some("the thread that renders has broken down".into());
        }
        latest
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        open(&self.desk.inbox).stop = true;
        self.desk.bell.notify_one();
        if let Some(thread) = self.thread.take() {
            // A panic has been told already.
            let _ = thread.join();
        }
    }
}

fn work(mut studio: Studio, desk: &Desk) {
    while let Some(wish) = desk.next() {
        let done = grant(&mut studio, desk, &wish);
        desk.tell(|news| {
            news.busy = None;
            news.error = done.err().map(|error| error.to_string());
        });
    }
}

fn grant(studio: &mut Studio, desk: &Desk, wish: &Wish) -> Result<(), crate::Error> {
    let tell = |step: sh_bake::Progress| {
        let part = step.done as f32 / step.total.max(1) as f32;
        let stage = step.stage.to_string();
        desk.tell(|news| news.busy = Some((stage, part)));
    };
    studio.load(wish, &tell)?;
    let shown = studio.render(wish)?;
    desk.tell(|news| {
        (news.busy, news.error) = (None, None);
        news.shown = Some(shown);
        news.layer = None;
    });
    if wish.overlay == Overlay::Error && wish.rests {
        let improve = |layer| desk.tell(|news| news.layer = Some((*wish, layer)));
        truth::trace(&studio.scene, wish, &|| desk.waits(), &improve)?;
    }
    Ok(())
}
