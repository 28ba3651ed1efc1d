#include "formats/pdf/finish.h"

#include <qpdf/qpdf-c.h>  // clang 14 does not take qpdf's C++ headers as C++20

#include <memory>
#include <stdexcept>
#include <type_traits>

namespace toile {
namespace {

struct Close {
  void operator()(qpdf_data pdf) const { qpdf_cleanup(&pdf); }
};
using Pdf = std::unique_ptr<std::remove_pointer_t<qpdf_data>, Close>;

void check(const Pdf& pdf, QPDF_ERROR_CODE code) {
  if ((code & QPDF_ERRORS) == 0) return;
  const qpdf_error error = qpdf_get_error(pdf.get());
  throw std::invalid_argument(std::string("PDF: ") + (error ? qpdf_get_error_full_text(pdf.get(), error) : "unknown error"));
}

}  // namespace

std::string ready_for_print(const std::string& bytes) {
  const Pdf pdf(qpdf_init());
  qpdf_data data = pdf.get();
  qpdf_silence_errors(data);
  qpdf_set_suppress_warnings(data, QPDF_TRUE);
  check(pdf, qpdf_read_memory(data, "cut sheet", bytes.data(), bytes.size(), nullptr));
  qpdf_oh_replace_key(data, qpdf_get_root(data), "/ViewerPreferences", qpdf_oh_parse(data, "<< /PrintScaling /None >>"));
  const qpdf_oh information = qpdf_oh_get_key(data, qpdf_get_trailer(data), "/Info");
  if (qpdf_oh_is_dictionary(data, information))
    for (const char* date : {"/CreationDate", "/ModDate"}) qpdf_oh_remove_key(data, information, date);
  check(pdf, qpdf_init_write_memory(data));
  qpdf_set_minimum_pdf_version(data, "1.6");
  qpdf_set_object_stream_mode(data, qpdf_o_generate);
  qpdf_set_deterministic_ID(data, QPDF_TRUE);
  check(pdf, qpdf_write(data));
  return {reinterpret_cast<const char*>(qpdf_get_buffer(data)), qpdf_get_buffer_length(data)};
}

}  // namespace toile
