package org.dfra.core.audit;

import java.util.Optional;
import org.dfra.core.audit.AuditLine.Header;
import org.dfra.core.audit.VerifiedStream.Break;
import org.dfra.core.audit.VerifiedStream.Kind;
import org.jspecify.annotations.Nullable;

/** What is wrong with a line, seen with its neighbours. */
final class ChainCheck {

  private ChainCheck() {}

  /**
   * What is wrong with a line.
   *
   * @param before the line before, which is good; null if there is none
   * @param after the line after; null if there is none
   */
  static Optional<Break> check(
      @Nullable ChainLine before, ChainLine current, @Nullable ChainLine after) {
    @Nullable AuditLine line = current.line();
    if (!current.isComplete()) {
      return broken(
          current,
          Kind.CUT,
          "the line has no end: it was cut, or its process was killed or is just writing it; the"
              + " next start of the process moves a torn line to a file beside");
    }
    if (line == null) {
      return broken(current, Kind.CHANGED, "the line was changed: " + current.fault());
    }
    Optional<Break> link =
        before == null || before.line() == null
            ? first(current, line)
            : link(before, before.line(), current, line, after);
    return link.isPresent() ? link : header(current, line);
  }

  /** The first line that is left; that older files were removed is checked with the headers. */
  private static Optional<Break> first(ChainLine current, AuditLine line) {
    if (line.number() == 1) {
      return line.previous().equals(TrailPosition.START.hash())
          ? Optional.empty()
          : broken(current, Kind.CHANGED, "the line was changed: line 1 follows no other line");
    }
    return current.file().number() == 1 || current.at() != 1
        ? broken(current, Kind.MISSING, range(1, line.number() - 1) + " missing before this line")
        : Optional.empty();
  }

  private static Optional<Break> link(
      ChainLine before,
      AuditLine last,
      ChainLine current,
      AuditLine line,
      @Nullable ChainLine after) {
    boolean isLinked = before.isContinuedBy(current);
    long step = line.number() - last.number();
    if (isLinked && step == 1) {
      return Optional.empty();
    } else if (isLinked) {
      return broken(
          current,
          Kind.CHANGED,
          "the line was changed: it has number " + line.number() + " after " + last.number());
    } else if (step == 1) {
      return changed(before, current, after);
    } else if (step > 1 && !isNumber(last.number() + 1, after)) {
      return broken(
          current,
          Kind.MISSING,
          range(last.number() + 1, line.number() - 1) + " missing before this line");
    }
    return broken(
        current,
        Kind.OUT_OF_ORDER,
        "lines are out of order: " + line.number() + " follows " + last.number());
  }

  /** The hash does not fit: one of two lines was changed, and the third one says which. */
  private static Optional<Break> changed(
      ChainLine before, ChainLine current, @Nullable ChainLine after) {
    if (after != null && !current.isContinuedBy(after)) {
      return broken(current, Kind.CHANGED, "the line was changed: the hashes around it do not fit");
    }
    return broken(
        before,
        Kind.CHANGED,
        after == null
            ? "this line or the next one was changed: its hash is not that in the next line"
            : "the line was changed: its hash is not that in the next line");
  }

  private static boolean isNumber(long number, @Nullable ChainLine line) {
    return line != null && line.line() != null && line.line().number() == number;
  }

  /** The first line of a file, and no other, says which file it is. */
  private static Optional<Break> header(ChainLine current, AuditLine line) {
    if ((current.at() == 1) != line.header().isPresent()) {
      return broken(
          current,
          Kind.MISSING,
          current.at() == 1
              ? "the first line of the file is missing"
              : "the first line of a file is in the middle of one: its end is missing");
    }
    if (line.header().isEmpty()) {
      return Optional.empty();
    }
    Header header = line.header().get();
    TrailFile file = current.file();
    boolean isSame = header.stream().equals(file.stream()) && header.file() == file.number();
    return isSame
        ? Optional.empty()
        : broken(
            current,
            Kind.CHANGED,
            "the file has another name: its first line says file "
                + header.file()
                + " of stream "
                + header.stream());
  }

  static String range(long from, long to) {
    return from == to
        ? "line " + from + " of the stream is"
        : "lines " + from + " to " + to + " of the stream are";
  }

  private static Optional<Break> broken(ChainLine line, Kind kind, String sentence) {
    return Optional.of(line.broken(kind, sentence));
  }
}
