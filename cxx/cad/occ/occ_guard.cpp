#define OCC_CONVERT_SIGNALS // for OCC_CATCH_SIGNALS
#include "cad/occ/occ_guard.hpp"
#include "cad/cad_text.hpp"
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <OSD.hxx>
#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <clocale>
#include <iostream>
#include <regex>

namespace burnish {

namespace {

/// Takes what OpenCASCADE tells of warnings and errors.
class Printer : public Message_Printer {
public:
  explicit Printer(std::ostream& stream) : m_stream(stream) {}

protected:
  void send(const TCollection_AsciiString& text, const Message_Gravity gravity) const override {
    if (gravity >= Message_Warning) m_stream << text.ToCString() << "\n";
  }

private:
  std::ostream& m_stream;
};

} // namespace

OccGuard::OccGuard() : m_signals(NSIG), m_locale(std::setlocale(LC_ALL, nullptr)) {
  for (int signal = 1; signal < NSIG; ++signal)
    sigaction(signal, nullptr, &m_signals[static_cast<std::size_t>(signal)]);
  fegetenv(&m_floating);
  OSD::SetSignal(false);
  std::setlocale(LC_NUMERIC, "C");
  m_cout = std::cout.rdbuf(m_printed.rdbuf());
  m_cerr = std::cerr.rdbuf(m_printed.rdbuf());
  auto& printers = Message::DefaultMessenger()->ChangePrinters();
  m_printers = printers;
  printers.Clear();
  printers.Append(new Printer(m_printed));
}

OccGuard::~OccGuard() {
  Message::DefaultMessenger()->ChangePrinters() = m_printers;
  std::cout.rdbuf(m_cout);
  std::cerr.rdbuf(m_cerr);
  std::setlocale(LC_ALL, m_locale.c_str());
  fesetenv(&m_floating);
  for (int signal = 1; signal < NSIG; ++signal)
    sigaction(signal, &m_signals[static_cast<std::size_t>(signal)], nullptr);
}

std::string OccGuard::run(const std::function<void()>& f) const {
  try {
    OCC_CATCH_SIGNALS
    f();
    return "";
  } catch (const Standard_Failure& failure) {
    const std::string text = failure.GetMessageString();
    return text.empty() ? failure.DynamicType()->Name() : text;
  } catch (const std::bad_alloc&) {
    return "not enough memory";
  } catch (const std::exception& failure) {
    return failure.what();
  }
}

std::string OccGuard::printed() const {
  return std::regex_replace(trimmed(m_printed.str()), std::regex("\\s*\n\\s*"), "; ");
}

} // namespace burnish
