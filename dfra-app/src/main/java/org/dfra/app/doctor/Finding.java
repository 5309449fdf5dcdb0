package org.dfra.app.doctor;

import org.jspecify.annotations.Nullable;

/**
 * What a check has found.
 *
 * @param what is, in one clause without a full stop
 * @param remedy what to do about it, in one sentence; null where all is well
 */
record Finding(Subject subject, Verdict verdict, String what, @Nullable String remedy) {

  static Finding ok(Subject subject, String what) {
    return new Finding(subject, Verdict.OK, what, null);
  }

  static Finding warn(Subject subject, String what, String mend) {
    return new Finding(subject, Verdict.WARN, what, mend);
  }

  static Finding fail(Subject subject, String what, String mend) {
    return new Finding(subject, Verdict.FAIL, what, mend);
  }

  /**
   * A failure that tells itself what is wrong and, after a semicolon, what to do.
   *
   * @param otherwise what to do where it does not tell
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
}
