"""Colours of code that everyone can read: on light and on dark, each has a contrast of at least 4.5 with what is behind it, as level
AA of the Web Content Accessibility Guidelines asks for. A test of the pages computes it."""

from pygments.styles import get_style_by_name


class Light(get_style_by_name("xcode")):
    background_color = "#f8f8f8"


class Dark(get_style_by_name("github-dark")):
    background_color = "#1a1c1e"
