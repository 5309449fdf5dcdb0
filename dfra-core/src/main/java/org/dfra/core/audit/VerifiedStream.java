package org.dfra.core.audit;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What the check of a stream came to.
 *
 * @param stream its name
 * @param files number of its files
 * @param lines number of lines that were read, up to the first broken one
 * @param first number of the first line; 0 if there is none
 * @param last number of the last line that was read; 0 if there is none
 * @param broken the first broken line; empty if the chain is whole
 * @param notes what else a reader should know, in sentences
 */
public record VerifiedStream(
    String stream,
    int files,
    long lines,
    long first,
    long last,
    Optional<Break> broken,
    List<String> notes) {

  /** How a chain is broken. */
  public enum Kind {
    /** A line is not what it was when it was written. */
    CHANGED,
    /** Lines are missing before this one. */
    MISSING,
    /** Lines have another order, or one occurs twice. */
    OUT_OF_ORDER,
    /** The end of the stream is missing. */
    CUT,
    /** Its owner has signed this line and another one with the same number. */
    FORKED
  }

  /**
   * The first broken line.
   *
   * @param file in which it is
   * @param line from 1
   * @param kind how it is broken
   * @param sentence what is wrong with it
   */
  public record Break(Path file, long line, Kind kind, String sentence) {

    /** {@code FILE:LINE: what is wrong}. */
    @Override
    public String toString() {
      return file + ":" + line + ": " + sentence;
    }
  }

  /** Copies the list. */
  public VerifiedStream {
    notes = List.copyOf(notes);
  }
}
