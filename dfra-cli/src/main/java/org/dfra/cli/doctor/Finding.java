package org.dfra.cli.doctor;

import org.jspecify.annotations.Nullable;

/**
 * The result of a check.
 *
 * @param what the state, in one clause without a full stop
 * @param remedy what the user should do, in one sentence; null if all is well
 */
record Finding(Subject subject, Finding.Verdict verdict, String what, @Nullable String remedy) {

  static Finding ok(Subject subject, String what) {
    return new Finding(subject, Verdict.OK, what, null);
  }

  static Finding warn(Subject subject, String what, String remedy) {
    return new Finding(subject, Verdict.WARN, what, remedy);
  }

  static Finding fail(Subject subject, String what, String remedy) {
    return new Finding(subject, Verdict.FAIL, what, remedy);
  }

  /**
   * A failure whose exception gives the cause and, after a semicolon, the remedy.
   *
   * @param otherwise the remedy if the message has none
   */
  static Finding fail(Subject subject, Exception failure, String otherwise) {
    String sentence = failure.getMessage() == null ? failure.toString() : failure.getMessage();
    int semicolon = sentence.indexOf("; ");
    return semicolon < 0
        ? fail(subject, sentence, otherwise)
        : fail(
            subject,
            sentence.substring(0, semicolon),
            Character.toUpperCase(sentence.charAt(semicolon + 2))
                + sentence.substring(semicolon + 3)
                + ".");
  }

  /** The severity of a finding. */
  enum Verdict {
    /** As expected. */
    OK,
    /** It works, but not under all conditions. */
    WARN,
    /** It does not work. */
    FAIL
  }
}
