#include "parallel/first_rank.hpp"

namespace burnish {

void share_text(std::string& text) {
  std::size_t size = text.size();
  ranks().broadcast(&size, sizeof size, 0);
  text.resize(size);
  if (size > 0) ranks().broadcast(text.data(), size, 0);
}

WorkEnd caught_end() {
  try {
    throw;
  } catch (const ArgumentError& error) {
    const std::string all = error.what(), said = error.said();
    const std::size_t before = all.size() - said.size(); // of "function: "
    return {WorkEnd::ARGUMENT_ERROR, before > 2 ? all.substr(0, before - 2) : "", said};
  } catch (const FileError& error) {
    return {WorkEnd::FILE_ERROR, "", error.what()};
  } catch (const std::exception& error) {
    return {WorkEnd::OTHER_ERROR, "", error.what()};
  }
}

void share_end(WorkEnd end) {
  ranks().broadcast(&end.kind, sizeof end.kind, 0);
  if (end.kind == WorkEnd::DONE) return;
  share_text(end.where);
  share_text(end.what);
  if (end.kind == WorkEnd::FILE_ERROR) throw FileError(end.what);
  if (end.kind == WorkEnd::OTHER_ERROR) throw std::runtime_error(end.what);
  if (end.where.empty()) throw ArgumentError(end.what);
  fail(end.where, end.what);
}

} // namespace burnish
