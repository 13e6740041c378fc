//! Several linkages on one shaft, evaluated together.

mod entry;
mod handle;
mod handles;

pub use handle::Handle;
pub use handles::Handles;

use alloc::borrow::ToOwned;
use alloc::vec::Vec;
use core::borrow::Borrow;
use core::fmt;
use core::marker::PhantomData;
use core::sync::atomic::{AtomicUsize, Ordering};
use entry::{Filling, Joining, Returning, SceneEntry};

/// A machine: functions of one argument, such as the angle of the main shaft, each of which can be
/// switched on and off.
///
/// [`update`](Self::update) evaluates the functions that are on, and each only if the argument has
/// changed since its last evaluation (NaN always has). The choice is made between whole functions:
/// a function that is off costs nothing, and inside of a function there is no branch.
///
/// A scene stays on its thread; several threads have a scene each.
///
/// `X` is the argument: an angle, an array of the inputs of several shafts, the angles of a sweep.
/// Linkages on another shaft that turns for itself are another scene, so that the rest of this one
/// does not become out of date with it.
///
/// ```
/// use linkage_runtime::Scene;
///
/// let mut scene = Scene::new();
/// let needle = scene.add(|phi: &f64| 12.0 * phi.cos());
/// let press = scene.add(|phi: &f64| [phi.cos(), phi.sin()]);
/// scene.switch_off(press);
///
/// assert_eq!(scene.update(0.0), 1); // one function was evaluated
/// assert_eq!(scene.get(needle), Some(&12.0));
/// assert_eq!(scene.get(press), None);
///
/// scene.switch_on(press);
/// assert_eq!(scene.update(0.0), 1); // the needle has not moved
/// assert_eq!(scene.get(press), Some(&[1.0, 0.0]));
/// ```
///
/// A function may own its captures, or borrow them for `'a`. A linkage that is assembled later than
/// the scene is moved in (`move |phi| ..`), which copies it. If the linkage changes, for example to
/// other dimensions, [`set`](Self::set) replaces the function.
///
/// # Sweeps
///
/// [`add_into`](Self::add_into) is for functions that fill a buffer, which is kept from frame to
/// frame: then nothing is allocated, if [`update_from`](Self::update_from) brings the angles.
///
/// ```
/// use linkage_runtime::{Columns, Scene};
///
/// let mut scene = Scene::<Vec<f64>>::new();
/// let path = scene.add_into(Columns::<f64>::new(1, 0), |angles, columns| {
///     columns.resize(angles.len());
///     for (height, angle) in columns.column_mut(0).iter_mut().zip(angles) {
///         *height = 12.0 * angle.cos();
///     }
/// });
/// let angles = [0.0, 1.0, 2.0];
/// scene.update_from(&angles[..]);
/// assert_eq!(scene.get(path).unwrap().column(0)[0], 12.0);
/// ```
pub struct Scene<'a, X> {
    id: usize,
    argument: Option<X>,
    /// Counts the arguments; 0 before the first one.
    frame: u64,
    entries: Vec<SceneEntry<'a, X>>,
    /// The places that are on, in ascending order.
    on: Vec<usize>,
}

const OTHER: &str = "the handle is of another scene";

impl<'a, X: PartialEq> Scene<'a, X> {
    /// A scene without functions.
    #[must_use]
    pub fn new() -> Self {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        Self {
            id: NEXT.fetch_add(1, Ordering::Relaxed),
            argument: None,
            frame: 0,
            entries: Vec::new(),
            on: Vec::new(),
        }
    }

    /// Adds a function, switched on. It is evaluated at the next update.
    pub fn add<R: 'static>(&mut self, function: impl FnMut(&X) -> R + 'a) -> Handle<R> {
        self.push(SceneEntry::new(Returning::new(function)))
    }

    /// Adds a function that writes its result into `buffer`, switched on.
    ///
    /// The buffer contains the result of the last evaluation.
    pub fn add_into<R: 'static>(
        &mut self,
        buffer: R,
        function: impl FnMut(&X, &mut R) + 'a,
    ) -> Handle<R> {
        self.push(SceneEntry::new(Filling::new(buffer, function)))
    }

    /// Adds a function of the results of others, one handle or a tuple of two to four, switched on.
    /// It computes quantities of several parts from results that each of them already has.
    ///
    /// It is evaluated after them, and only if one of them was evaluated again. While one of them
    /// is off, or has no result, it has none and costs nothing.
    ///
    /// ```
    /// use linkage_runtime::Scene;
    ///
    /// let mut scene = Scene::new();
    /// let hook = scene.add(|x: &f64| 10.0 * x.cos());
    /// let eye = scene.add(|x| 12.0 * x.sin());
    /// let gap = scene.add_of((hook, eye), |(hook, eye)| eye - hook);
    /// assert_eq!(scene.update(0.0), 3);
    /// assert_eq!(scene.get(gap), Some(&-10.0));
    ///
    /// scene.switch_off(eye);
    /// assert_eq!(scene.update(1.0), 1); // the hook alone
    /// assert_eq!(scene.get(gap), None);
    /// ```
    ///
    /// # Panics
    /// If a handle is of another scene.
    pub fn add_of<S: Handles + 'a, R: 'static>(
        &mut self,
        sources: S,
        function: impl FnMut(S::Results<'_>) -> R + 'a,
    ) -> Handle<R> {
        let entries = sources.entries();
        let entries = entries.into_iter().map(|(scene, index)| {
            assert!(scene == self.id, "{OTHER}");
            index
        });
        let entries = entries.collect();
        self.push(SceneEntry::made_of(
            entries,
            Joining::new(sources, function),
        ))
    }

    /// Puts another function with the same type of result in the place of one; whether it is on
    /// does not change.
    ///
    /// # Panics
    /// If the handle is of another scene.
    pub fn set<R: 'static>(&mut self, handle: Handle<R>, function: impl FnMut(&X) -> R + 'a) {
        self.place_mut(handle).put(Returning::new(function));
    }

    /// Works as [`set`](Self::set), with a function that writes its result into `buffer`.
    ///
    /// # Panics
    /// If the handle is of another scene.
    pub fn set_into<R: 'static>(
        &mut self,
        handle: Handle<R>,
        buffer: R,
        function: impl FnMut(&X, &mut R) + 'a,
    ) {
        self.place_mut(handle).put(Filling::new(buffer, function));
    }

    /// Has the function evaluated from the next update on.
    ///
    /// # Panics
    /// If the handle is of another scene.
    pub fn switch_on<R>(&mut self, handle: Handle<R>) {
        let index = self.index(handle);
        if let Err(at) = self.on.binary_search(&index) {
            self.on.insert(at, index);
        }
    }

    /// Has the function evaluated no longer; it has no result until it is on again.
    ///
    /// # Panics
    /// If the handle is of another scene.
    pub fn switch_off<R>(&mut self, handle: Handle<R>) {
        let index = self.index(handle);
        if let Ok(at) = self.on.binary_search(&index) {
            self.on.remove(at);
        }
    }

    /// Returns true if the function is on.
    ///
    /// # Panics
    /// If the handle is of another scene.
    #[must_use]
    pub fn is_on<R>(&self, handle: Handle<R>) -> bool {
        self.on.binary_search(&self.index(handle)).is_ok()
    }

    /// Forgets the function's result, because something else than the argument has changed on which
    /// it depends.
    ///
    /// # Panics
    /// If the handle is of another scene.
    pub fn invalidate<R>(&mut self, handle: Handle<R>) {
        self.place_mut(handle).invalidate();
    }

    /// Evaluates, in the order in which they were added, all functions that are on and have no
    /// result for this argument yet. Returns how many these are.
    pub fn update(&mut self, argument: X) -> usize {
        if self.argument.as_ref() != Some(&argument) {
            self.argument = Some(argument);
            self.frame += 1;
        }
        self.evaluate()
    }

    /// Works as [`update`](Self::update), with an argument that is copied only if it differs from
    /// the last one, and then into the memory of that one: angles of a sweep.
    pub fn update_from<B>(&mut self, argument: &B) -> usize
    where
        B: ToOwned<Owned = X> + PartialEq + ?Sized,
        X: Borrow<B>,
    {
        match &mut self.argument {
            Some(last) if (*last).borrow() == argument => {}
            Some(last) => {
                argument.clone_into(last);
                self.frame += 1;
            }
            None => {
                self.argument = Some(argument.to_owned());
                self.frame += 1;
            }
        }
        self.evaluate()
    }

    /// The argument of the last update.
    #[must_use]
    pub fn argument(&self) -> Option<&X> {
        self.argument.as_ref()
    }

    /// The function's result for the argument of the last update; `None` if the function is off or
    /// has not been evaluated for that argument.
    ///
    /// # Panics
    /// If the handle is of another scene.
    #[must_use]
    pub fn get<R: 'static>(&self, handle: Handle<R>) -> Option<&R> {
        let index = self.index(handle);
        let is_current = self.frame != 0 && self.is_current(index);
        is_current.then(|| self.entries[index].result()?.downcast_ref())?
    }

    /// Returns true if the function is on and its result is that of this frame, and of the results
    /// that it is made of.
    fn is_current(&self, index: usize) -> bool {
        let entry = &self.entries[index];
        let seen = |(source, version): &(usize, u64)| {
            self.is_current(*source) && self.entries[*source].version == *version
        };
        self.on.binary_search(&index).is_ok()
            && entry.frame == self.frame
            && entry.sources.iter().all(seen)
    }

    fn evaluate(&mut self) -> usize {
        let mut evaluated = 0;
        for at in 0..self.on.len() {
            let index = self.on[at];
            let mut sources = self.entries[index].sources.iter();
            if self.is_current(index) || !sources.all(|(source, _)| self.is_current(*source)) {
                continue;
            }
            let (earlier, rest) = self.entries.split_at_mut(index);
            if let (Some(argument), [entry, ..]) = (&self.argument, rest) {
                entry.evaluate(argument, self.frame, earlier);
                evaluated += 1;
            }
        }
        evaluated
    }

    fn push<R>(&mut self, entry: SceneEntry<'a, X>) -> Handle<R> {
        let index = self.entries.len();
        self.entries.push(entry);
        self.on.push(index);
        Handle {
            scene: self.id,
            index,
            result: PhantomData,
        }
    }

    fn place_mut<R>(&mut self, handle: Handle<R>) -> &mut SceneEntry<'a, X> {
        let index = self.index(handle);
        &mut self.entries[index]
    }

    fn index<R>(&self, handle: Handle<R>) -> usize {
        assert!(handle.scene == self.id, "{OTHER}");
        handle.index
    }
}

impl<X: PartialEq> Default for Scene<'_, X> {
    fn default() -> Self {
        Self::new()
    }
}

impl<X: fmt::Debug> fmt::Debug for Scene<'_, X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Scene")
            .field("argument", &self.argument)
            .field("functions", &self.entries.len())
            .finish_non_exhaustive()
    }
}
