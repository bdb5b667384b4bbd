//! The stylus button, real or a key, and what it asks for.

use crate::Mode;

/// The first button of every device.
pub(crate) const STYLUS: u32 = 1;

/// Turns presses into modes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Button {
    /// It has been up, so that the next press is one.
    armed: bool,
    /// A key is down.
    key: bool,
    /// A script's wish, which goes before the button.
    forced: Option<Mode>,
    /// A script wants normal mode, whatever is down.
    ended: bool,
}

impl Button {
    pub(super) fn press(&mut self, is_down: bool) {
        self.key = is_down;
    }

    /// Whether a key is down for it.
    pub(super) fn is_key_down(&self) -> bool {
        self.key
    }

    pub(super) fn force(&mut self, mode: Mode) {
        self.ended = mode == Mode::Normal;
        self.forced = (!self.ended).then_some(mode);
    }

    /// Touch begins anew, where `was_on` out of a mode that a script may have wished for.
    pub(super) fn begin(&mut self, was_on: bool) {
        self.armed = false;
        if was_on {
            self.forced = None;
        }
    }

    /// The mode of this tick.
    pub(super) fn asked(&mut self, buttons: u32, mode: Mode, in_contact: bool) -> Mode {
        let is_down = self.key || buttons & STYLUS != 0;
        let is_pressed = is_down && self.armed;
        // A press that brought one mode brings no other.
        self.armed = !is_down;
        if std::mem::take(&mut self.ended) {
            return Mode::Normal;
        }
        if let Some(forced) = self.forced {
            return forced;
        }
        match mode {
            Mode::Normal if is_pressed && in_contact => Mode::Pan,
            Mode::Normal if is_pressed => Mode::Zoom,
            Mode::Pan | Mode::Zoom if !is_down => Mode::Normal,
            mode => mode,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_button_that_is_down_from_the_beginning_does_nothing_until_it_was_up() {
        let mut button = Button::default();
        assert_eq!(button.asked(1, Mode::Normal, true), Mode::Normal);
        assert_eq!(button.asked(0, Mode::Normal, true), Mode::Normal);
        assert_eq!(button.asked(1, Mode::Normal, true), Mode::Pan);
    }

    #[test]
    fn where_it_is_pressed_tells_the_mode_and_where_it_is_moved_then_does_not() {
        for (in_contact, mode) in [(true, Mode::Pan), (false, Mode::Zoom)] {
            let mut button = Button::default();
            button.asked(0, Mode::Normal, in_contact);
            assert_eq!(button.asked(1, Mode::Normal, in_contact), mode);
            assert_eq!(button.asked(1, mode, !in_contact), mode);
            assert_eq!(button.asked(0, mode, !in_contact), Mode::Normal);
        }
    }

    #[test]
    fn other_buttons_change_nothing() {
        let mut button = Button::default();
        button.asked(0, Mode::Normal, false);
        assert_eq!(button.asked(0b1110, Mode::Normal, false), Mode::Normal);
    }

    #[test]
    fn a_key_is_a_stylus_button() {
        let mut button = Button::default();
        button.asked(0, Mode::Normal, false);
        button.press(true);
        assert_eq!(button.asked(0, Mode::Normal, false), Mode::Zoom);
        button.press(false);
        assert_eq!(button.asked(0, Mode::Zoom, false), Mode::Normal);
    }

    #[test]
    fn a_script_goes_before_the_button_and_ends_what_it_holds() {
        let mut button = Button::default();
        button.force(Mode::Pan);
        assert_eq!(button.asked(0, Mode::Normal, false), Mode::Pan);
        assert_eq!(button.asked(1, Mode::Pan, false), Mode::Pan);
        button.force(Mode::Normal);
        assert_eq!(button.asked(1, Mode::Pan, false), Mode::Normal);
        assert_eq!(button.asked(1, Mode::Normal, false), Mode::Normal, "it is down still");
    }

    #[test]
    fn a_wish_waits_for_touch_to_begin_and_does_not_outlive_it() {
        let mut button = Button::default();
        button.force(Mode::Zoom);
        button.begin(false);
        assert_eq!(button.asked(0, Mode::Normal, false), Mode::Zoom);
        button.begin(true);
        assert_eq!(button.asked(0, Mode::Normal, false), Mode::Normal);
    }
}
