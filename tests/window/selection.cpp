#include "window/selection.hpp"

namespace terrella::test {

bool give_selection(const XSelectionRequestEvent& request, Atom type, const std::string& bytes) {
  _XDisplay* const connection = request.display;
  const bool given = request.target == type;
  if (given) {
    XChangeProperty(connection, request.requestor, request.property, type, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  }
  XEvent answer = {};
  answer.xselection.type = SelectionNotify;
  answer.xselection.requestor = request.requestor;
  answer.xselection.selection = request.selection;
  answer.xselection.target = request.target;
  answer.xselection.property = given ? request.property : None;
  answer.xselection.time = request.time;
  XSendEvent(connection, request.requestor, False, NoEventMask, &answer);
  XFlush(connection);
  return given;
}

}  // namespace terrella::test
