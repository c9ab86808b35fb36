# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Types on the keyboard of an X display, by Xlib alone: into the topmost window."""

import ctypes
import ctypes.util
import time

X11 = ctypes.CDLL(ctypes.util.find_library("X11"))
Window = ctypes.c_ulong
KEY_PRESS, KEY_RELEASE = 2, 3
KEY_PRESS_MASK, KEY_RELEASE_MASK = 1, 2
CONTROL = 1 << 2
IS_VIEWABLE = 2
NAMES = {" ": b"space", "-": b"minus", "\n": b"Return"}


class Attributes(ctypes.Structure):
    """XWindowAttributes."""

    _fields_ = ([(name, ctypes.c_int) for name in ("x", "y", "width", "height", "border", "depth")]
        + [("visual", ctypes.c_void_p), ("root", Window)]
        + [(name, ctypes.c_int) for name in ("kind", "bit_gravity", "win_gravity", "backing_store")]
        + [("backing_planes", ctypes.c_ulong), ("backing_pixel", ctypes.c_ulong),
            ("save_under", ctypes.c_int), ("colormap", ctypes.c_ulong),
            ("map_installed", ctypes.c_int), ("map_state", ctypes.c_int)]
        + [("rest", ctypes.c_long * 8)])


class KeyEvent(ctypes.Structure):
    """XKeyEvent, as long as any XEvent."""

    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
        ("display", ctypes.c_void_p), ("window", Window), ("root", Window), ("subwindow", Window),
        ("time", ctypes.c_ulong), ("x", ctypes.c_int), ("y", ctypes.c_int),
        ("x_root", ctypes.c_int), ("y_root", ctypes.c_int), ("state", ctypes.c_uint),
        ("keycode", ctypes.c_uint), ("same_screen", ctypes.c_int), ("rest", ctypes.c_long * 24)]


X11.XOpenDisplay.restype = ctypes.c_void_p
X11.XDefaultRootWindow.restype = Window
X11.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
X11.XQueryTree.argtypes = [ctypes.c_void_p, Window] + [ctypes.c_void_p] * 4
X11.XGetWindowAttributes.argtypes = [ctypes.c_void_p, Window, ctypes.c_void_p]
X11.XSetInputFocus.argtypes = [ctypes.c_void_p, Window, ctypes.c_int, ctypes.c_ulong]
X11.XSendEvent.argtypes = [ctypes.c_void_p, Window, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]
X11.XStringToKeysym.restype = ctypes.c_ulong
X11.XKeysymToKeycode.argtypes = [ctypes.c_void_p, ctypes.c_ulong]
X11.XKeysymToKeycode.restype = ctypes.c_ubyte
X11.XSync.argtypes = [ctypes.c_void_p, ctypes.c_int]
X11.XFree.argtypes = [ctypes.c_void_p]

# Windows may close between two requests: that is no error here.
Handler = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)
ignore_error = Handler(lambda display, error: 0)
X11.XSetErrorHandler(ignore_error)


class Keyboard:
    """The keyboard of the display in $DISPLAY."""

    def __init__(self):
        self.display = X11.XOpenDisplay(None)
        assert self.display, "no X display"
        self.root = X11.XDefaultRootWindow(self.display)

    def topmost(self, smallest=100):
        """The topmost visible window at least so many pixels wide, or None."""
        ignored = Window()
        children = ctypes.POINTER(Window)()
        count = ctypes.c_uint()
        X11.XQueryTree(self.display, self.root, ctypes.byref(ignored), ctypes.byref(ignored),
            ctypes.byref(children), ctypes.byref(count))
        found = None
        for i in range(count.value):
            attributes = Attributes()
            X11.XGetWindowAttributes(self.display, children[i], ctypes.byref(attributes))
            if attributes.map_state == IS_VIEWABLE and attributes.width >= smallest:
                found = children[i]
        if count.value:
            X11.XFree(children)
        return found

    def press(self, key, state=0):
        """Presses and releases one key in the topmost window."""
        window = self.topmost()
        X11.XSetInputFocus(self.display, window, 1, 0)
        X11.XSync(self.display, 0)
        name = NAMES.get(key, key.encode())
        event = KeyEvent(window=window, root=self.root, display=self.display, state=state,
            same_screen=1, keycode=X11.XKeysymToKeycode(self.display, X11.XStringToKeysym(name)))
        for event.type, mask in ((KEY_PRESS, KEY_PRESS_MASK), (KEY_RELEASE, KEY_RELEASE_MASK)):
            X11.XSendEvent(self.display, window, 1, mask, ctypes.byref(event))
        X11.XSync(self.display, 0)
        time.sleep(0.05)

    def type(self, text):
        for key in text:
            self.press(key)
