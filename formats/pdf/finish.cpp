#include "formats/pdf/finish.h"

#define POINTERHOLDER_TRANSITION 4  // std::shared_ptr
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>
#include <stdexcept>

namespace toile {

std::string ready_for_print(const std::string& bytes) try {
  QPDF pdf;
  pdf.setSuppressWarnings(true);
  pdf.processMemoryFile("cut sheet", bytes.data(), bytes.size());
  pdf.getRoot().replaceKey("/ViewerPreferences", QPDFObjectHandle::parse("<< /PrintScaling /None >>"));
  QPDFObjectHandle information = pdf.getTrailer().getKey("/Info");
  if (information.isDictionary())
    for (const char* date : {"/CreationDate", "/ModDate"}) information.removeKey(date);
  QPDFWriter writer(pdf);
  writer.setOutputMemory();
  writer.setMinimumPDFVersion("1.6");
  writer.setObjectStreamMode(qpdf_o_generate);
  writer.setDeterministicID(true);
  writer.write();
  const auto written = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(written->getBuffer()), written->getSize()};
} catch (const QPDFExc& wrong) {
  throw std::invalid_argument(std::string("PDF: ") + wrong.what());
}

}  // namespace toile
