// SPDX-License-Identifier: MIT
// What other programs on an X screen do to a window.
#include "host/x_peer.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <chrono>
#include <cstdlib>

namespace vides::test {

struct XPeer::Connection {
  Display* display = XOpenDisplay(nullptr);

  Atom atom(const char* name) const { return XInternAtom(display, name, False); }

  void send(Window window, const char* type, long a, long b, long c, long d, long e) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    const long data[5] = {a, b, c, d, e};
    for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
    XSendEvent(display, window, False, NoEventMask, &event);
    XFlush(display);
  }

  // Gives the dropped text to whom asks for it.
  void answer(const XSelectionRequestEvent& request, const std::string& text) const {
    XChangeProperty(display, request.requestor, request.property, request.target, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(text.data()),
                    static_cast<int>(text.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(display, request.requestor, False, NoEventMask, &event);
    XFlush(display);
  }
};

XPeer::XPeer() : connection_(new Connection) {
  if (connection_->display == nullptr) std::abort();
}

XPeer::~XPeer() {
  XCloseDisplay(connection_->display);
  delete connection_;
}

void XPeer::setDotsPerInch(int dots) {
  const std::string resources = "Xft.dpi:\t" + std::to_string(dots) + "\n";
  Display* const display = connection_->display;
  XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8,
                  PropModeReplace, reinterpret_cast<const unsigned char*>(resources.data()),
                  static_cast<int>(resources.size()));
  XSync(display, False);
}

Picture XPeer::screenshot(unsigned long window) {
  Display* const display = connection_->display;
  XWindowAttributes attributes{};
  XGetWindowAttributes(display, window, &attributes);
  Picture picture(attributes.width, attributes.height);
  XImage* const image = XGetImage(display, window, 0, 0, static_cast<unsigned>(picture.width),
                                  static_cast<unsigned>(picture.height), AllPlanes, ZPixmap);
  if (image == nullptr) return {};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const unsigned long value = XGetPixel(image, x, y);  // 24 bits: red, green, blue
      const auto pixel = picture.pixel(x, y);
      for (unsigned i = 0; i < 3; ++i) {
        pixel[i] = static_cast<std::uint8_t>((value >> (16 - 8 * i)) & 0xFF);
      }
      pixel[3] = 255;
    }
  }
  XDestroyImage(image);
  return picture;
}

void XPeer::requestClose(unsigned long window) {
  const auto atom = static_cast<long>(connection_->atom("WM_DELETE_WINDOW"));
  connection_->send(window, "WM_PROTOCOLS", atom, CurrentTime, 0, 0, 0);
}

bool XPeer::drop(unsigned long window, const std::string& uris,
                 const std::function<void()>& letWindowWork) {
  Display* const display = connection_->display;
  const Window source =
      XCreateSimpleWindow(display, DefaultRootWindow(display), 900, 700, 10, 10, 0, 0, 0);
  XSetSelectionOwner(display, connection_->atom("XdndSelection"), source, CurrentTime);
  const auto from = static_cast<long>(source);
  const auto type = static_cast<long>(connection_->atom("text/uri-list"));
  const auto copy = static_cast<long>(connection_->atom("XdndActionCopy"));
  connection_->send(window, "XdndEnter", from, 5L << 24, type, 0, 0);
  connection_->send(window, "XdndPosition", from, 0, (10L << 16) | 10L, CurrentTime, copy);
  connection_->send(window, "XdndDrop", from, 0, CurrentTime, 0, 0);
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::seconds(30)) {
    letWindowWork();
    while (XPending(display) > 0) {
      XEvent event;
      XNextEvent(display, &event);
      if (event.type == SelectionRequest) connection_->answer(event.xselectionrequest, uris);
      if (event.type == ClientMessage &&
          event.xclient.message_type == connection_->atom("XdndFinished")) {
        XDestroyWindow(display, source);
        return true;
      }
    }
  }
  return false;
}

}  // namespace vides::test
