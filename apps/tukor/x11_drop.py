"""Drops files onto a window of the X Window System as a file manager does: the source's half of XDND, version 5.

drop(WINDOW, PATH...) returns when the window has taken them. Specification: https://freedesktop.org/wiki/Specifications/XDND
"""
import ctypes
import pathlib
import time

SELECTION_REQUEST, SELECTION_NOTIFY, CLIENT_MESSAGE = 30, 31, 33
long, ulong = ctypes.c_long, ctypes.c_ulong


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ulong), ("send_event", ctypes.c_int), ("display", ctypes.c_void_p),
                ("window", ulong), ("message_type", ulong), ("format", ctypes.c_int), ("data", long * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ulong), ("send_event", ctypes.c_int), ("display", ctypes.c_void_p),
                ("owner", ulong), ("requestor", ulong), ("selection", ulong), ("target", ulong), ("property", ulong),
                ("time", ulong)]


class Selection(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ulong), ("send_event", ctypes.c_int), ("display", ctypes.c_void_p),
                ("requestor", ulong), ("selection", ulong), ("target", ulong), ("property", ulong), ("time", ulong)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("client", ClientMessage), ("request", SelectionRequest),
                ("selection", Selection), ("size", long * 24)]


def library():
    x = ctypes.CDLL("libX11.so.6")
    pointer, integer = ctypes.c_void_p, ctypes.c_int
    for name, result, arguments in [
            ("XOpenDisplay", pointer, [ctypes.c_char_p]), ("XDefaultRootWindow", ulong, [pointer]),
            ("XCreateSimpleWindow", ulong, [pointer, ulong] + [integer] * 5 + [ulong] * 2),
            ("XInternAtom", ulong, [pointer, ctypes.c_char_p, integer]),
            ("XSetSelectionOwner", integer, [pointer, ulong, ulong, ulong]),
            ("XSendEvent", integer, [pointer, ulong, integer, long, pointer]), ("XPending", integer, [pointer]),
            ("XNextEvent", integer, [pointer, pointer]), ("XFlush", integer, [pointer]),
            ("XChangeProperty", integer, [pointer, ulong, ulong, ulong, integer, integer, ctypes.c_char_p, integer]),
            ("XCloseDisplay", integer, [pointer])]:
        function = getattr(x, name)
        function.restype, function.argtypes = result, arguments
    return x


def drop(window, *paths, at=(200, 200), patience=60.0):
    x = library()
    display = x.XOpenDisplay(None)
    assert display, "no display"
    atom = {name: x.XInternAtom(display, name.encode(), 0)
            for name in ("XdndSelection", "XdndEnter", "XdndPosition", "XdndStatus", "XdndDrop", "XdndFinished",
                         "XdndActionCopy", "text/uri-list")}
    source = x.XCreateSimpleWindow(display, x.XDefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)
    x.XSetSelectionOwner(display, atom["XdndSelection"], source, 0)
    uris = "".join(pathlib.Path(path).resolve().as_uri() + "\r\n" for path in paths).encode()
    end = time.monotonic() + patience

    def send(kind, *data):
        event = Event()
        event.client = ClientMessage(CLIENT_MESSAGE, 0, 1, display, window, atom[kind], 32,
                                     (long * 5)(source, *data, *[0] * (4 - len(data))))
        x.XSendEvent(display, window, 0, 0, ctypes.byref(event))
        x.XFlush(display)

    def serve(request):
        x.XChangeProperty(display, request.requestor, request.property, request.target, 8, 0, uris, len(uris))
        event = Event()
        event.selection = Selection(SELECTION_NOTIFY, 0, 1, display, request.requestor, request.selection,
                                    request.target, request.property, request.time)
        x.XSendEvent(display, request.requestor, 0, 0, ctypes.byref(event))
        x.XFlush(display)

    def wait_for(answer):
        event = Event()
        while time.monotonic() < end:
            if not x.XPending(display):
                time.sleep(0.02)
                continue
            x.XNextEvent(display, ctypes.byref(event))
            if event.type == SELECTION_REQUEST:
                serve(event.request)
            elif event.type == CLIENT_MESSAGE and event.client.message_type == atom[answer]:
                return event.client.data[1] & 1
        raise AssertionError(f"no {answer} within {patience} s")

    send("XdndEnter", 5 << 24, atom["text/uri-list"])
    send("XdndPosition", 0, at[0] << 16 | at[1], 0, atom["XdndActionCopy"])
    assert wait_for("XdndStatus"), "the window takes no files"
    send("XdndDrop", 0, 0)
    wait_for("XdndFinished")
    x.XCloseDisplay(display)
