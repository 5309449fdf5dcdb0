package org.dfra.core.audit;

import java.io.IOException;
import java.nio.file.Path;
import org.dfra.core.audit.LineReader.RawLine;
import org.dfra.core.audit.VerifiedStream.Break;
import org.dfra.core.audit.VerifiedStream.Kind;
import org.jspecify.annotations.Nullable;

/**
 * A line as the verifier sees it.
 *
 * @param file in which it is
 * @param at its number in the file, from 1
 * @param hash of its bytes
 * @param line what it says; null if it cannot be read
 * @param fault why it cannot be read; empty if it can
 * @param isComplete whether it has an end
 */
record ChainLine(
    TrailFile file,
    long at,
    String hash,
    @Nullable AuditLine line,
    String fault,
    boolean isComplete) {

  static ChainLine of(TrailFile file, long at, RawLine raw) {
    String hash = TrailPosition.hash(raw.bytes());
    if (raw.isTooLong()) {
      String fault = "it has more than " + LineReader.LONGEST_LINE + " bytes";
      return new ChainLine(file, at, hash, null, fault, raw.isComplete());
    }
    try {
      AuditLine line = LineDecoder.decode(raw.bytes());
      return new ChainLine(file, at, hash, line, "", raw.isComplete());
    } catch (IOException e) {
      String fault = String.valueOf(e.getMessage());
      return new ChainLine(file, at, hash, null, fault, raw.isComplete());
    }
  }

  Path path() {
    return file.path();
  }

  /** Whether another line continues the chain after this one. */
  boolean isContinuedBy(@Nullable ChainLine next) {
    return next != null && next.line != null && next.line.previous().equals(hash);
  }

  Break broken(Kind kind, String sentence) {
    return new Break(path(), at, kind, sentence);
  }
}
